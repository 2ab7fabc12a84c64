#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Compares figures of docs/images/plot with fresh ones, or any two folders of SVG files.

    tools/compare_figures.py CHECKED_IN FRESH

Kernels differ by instruction set, so the last digit may. Two figures are the same when

1. their text, structure and colours are equal, and every number differs by one step of its last
   printed digit at most, and by less than 0.11 (a tenth of a pixel): 0.0361 and 0.0362 are the same,
   12 and 13 are not;
2. embedded pictures have equal sizes, a mean difference of at most 0.5/255 a channel, and at most
   0.2 % of pixels where a channel differs by more than 8/255 (silhouettes). Colours count by their
   alpha.

Prints a line for each difference; exit code 1 if there is any, also when a file is missing on one
side.
"""

import base64
import os
import re
import struct
import sys
import zlib

k_number_step = 1.01
k_number_most = 0.11
k_mean = 0.5
k_large = 8
k_large_share = 0.002

k_picture = re.compile(r"data:image/png;base64,([A-Za-z0-9+/=\s]*)")
k_token = re.compile(r"#[0-9a-fA-F]{6}\b|&#\d+;|-?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
k_samples = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}  # by PNG colour type


class BadFigure(Exception):
    pass


def unfilter(kind, row, above, step):
    """One scan line of a PNG file, in place (ISO/IEC 15948, 9.2)."""
    if kind == 1:
        for i in range(step, len(row)):
            row[i] = (row[i] + row[i - step]) & 255
    elif kind == 2:
        for i, b in enumerate(above):
            row[i] = (row[i] + b) & 255
    elif kind == 3:
        for i, b in enumerate(above):
            row[i] = (row[i] + ((row[i - step] if i >= step else 0) + b) // 2) & 255
    elif kind == 4:
        for i, b in enumerate(above):
            a, c = (row[i - step], above[i - step]) if i >= step else (0, 0)
            to_a, to_b, to_c = abs(b - c), abs(a - c), abs(a + b - 2 * c)
            nearest = a if to_a <= to_b and to_a <= to_c else b if to_b <= to_c else c
            row[i] = (row[i] + nearest) & 255
    elif kind != 0:
        raise BadFigure("an embedded picture has a filter that PNG does not know")


def decode_png(data):
    """(width, height, RGBA bytes, colours multiplied by alpha) of an 8-bit PNG."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise BadFigure("an embedded picture is no PNG")
    at, packed, palette, clear = 8, b"", b"", b""
    width = height = depth = kind = 0
    while at + 8 <= len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if name == b"IHDR":
            width, height, depth, kind, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            if depth != 8 or interlaced or kind not in k_samples:
                raise BadFigure("an embedded picture is not 8 bits a sample, without interlacing")
        elif name == b"PLTE":
            palette = body
        elif name == b"tRNS":
            clear = body
        elif name == b"IDAT":
            packed += body
        at += 12 + size
    step = k_samples[kind]
    try:
        raw = zlib.decompress(packed)
    except zlib.error as error:
        raise BadFigure("an embedded picture is damaged: %s" % error) from None
    if width * height == 0 or len(raw) != height * (1 + width * step):
        raise BadFigure("an embedded picture is cut short")
    pixels, above = bytearray(), bytearray(width * step)
    for y in range(height):
        begin = y * (1 + width * step)
        row = bytearray(raw[begin + 1:begin + 1 + width * step])
        unfilter(raw[begin], row, above, step)
        above = row
        for i in range(0, len(row), step):
            if kind == 3:
                color = palette[3 * row[i]:3 * row[i] + 3]
                alpha = clear[row[i]] if row[i] < len(clear) else 255
            else:
                color = row[i:i + 3] if step >= 3 else row[i:i + 1] * 3
                alpha = row[i + step - 1] if step in (2, 4) else 255
            pixels += bytes((v * alpha + 127) // 255 for v in color) + bytes((alpha,))
    return width, height, bytes(pixels)


def picture_difference(a, b):
    """What tells two PNG files apart, or None."""
    if a == b:
        return None
    width, height, one = decode_png(a)
    other_width, other_height, other = decode_png(b)
    if (width, height) != (other_width, other_height):
        return "%dx%d pixels, fresh %dx%d" % (width, height, other_width, other_height)
    steps = [abs(x - y) for x, y in zip(one, other)]
    mean = sum(steps) / len(steps)
    large = sum(max(steps[i:i + 4]) > k_large for i in range(0, len(steps), 4)) / (width * height)
    if mean > k_mean or large > k_large_share:
        return ("pixels differ by %.2f/255 in the mean, %.2f %% of them by more than %d/255"
                % (mean, 100 * large, k_large))
    return None


def last_step(number):
    """One step of the last digit of a number as it is printed."""
    digits, _, exponent = number.lower().partition("e")
    decimals = len(digits.partition(".")[2])
    return 10.0 ** (int(exponent or 0) - decimals)


def same_token(a, b):
    if a == b:
        return True
    if a[0] in "#&" or b[0] in "#&":
        return False
    # Zeros at the end are not printed: the finer of the two says how many digits there are.
    step = k_number_step * min(last_step(a), last_step(b))
    return abs(float(a) - float(b)) <= min(step, k_number_most)


def line_of(text, at):
    return text.count("\n", 0, at) + 1


def figure_differences(a, b):
    """What tells two SVG texts apart, a list of lines; the first difference of the text ends it."""
    pictures = [k_picture.findall(text) for text in (a, b)]
    if len(pictures[0]) != len(pictures[1]):
        return ["%d pictures, fresh %d" % (len(pictures[0]), len(pictures[1]))]
    found = []
    for index, (one, other) in enumerate(zip(*pictures), 1):
        what = picture_difference(base64.b64decode(one), base64.b64decode(other))
        if what:
            found.append("picture %d: %s" % (index, what))
    a, b = (k_picture.sub("PICTURE", text) for text in (a, b))
    at_a = at_b = 0
    tokens = [list(k_token.finditer(text)) for text in (a, b)]
    for one, other in zip(*tokens):
        between_a, between_b = a[at_a:one.start()], b[at_b:other.start()]
        if between_a != between_b or not same_token(one.group(), other.group()):
            return found + ["line %d: '%s', fresh '%s'" % (
                line_of(a, one.start()), a[at_a:one.end()].split("\n")[-1][-60:],
                b[at_b:other.end()].split("\n")[-1][-60:])]
        at_a, at_b = one.end(), other.end()
    if len(tokens[0]) != len(tokens[1]) or a[at_a:] != b[at_b:]:
        found.append("line %d: the rest differs" % line_of(a, at_a))
    return found


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def folder_differences(checked_in, fresh):
    names = [{n for n in os.listdir(folder) if n.endswith(".svg")} for folder in (checked_in, fresh)]
    found = ["%s: is not checked in" % n for n in sorted(names[1] - names[0])]
    found += ["%s: no command makes it" % n for n in sorted(names[0] - names[1])]
    for name in sorted(names[0] & names[1]):
        try:
            lines = figure_differences(*(read(os.path.join(d, name)) for d in (checked_in, fresh)))
        except (BadFigure, ValueError) as error:
            lines = [str(error)]
        found += ["%s: %s" % (name, line) for line in lines]
    return found


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: tools/compare_figures.py CHECKED_IN FRESH")
    found = folder_differences(*sys.argv[1:])
    for line in found:
        print(line)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
