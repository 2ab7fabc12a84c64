#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Compares figures: tools/compare_figures.py BEFORE.svg AFTER.svg, or two folders of them.

Prints what differs and exits with 1 if anything does. Two runs of one command may differ a little,
since the kernels of other processors round otherwise; so these pass:

  lengths       a quarter of a pixel
  text          numbers with a decimal point: one unit of the last digit, at most 2 %, and anything
                below 10^-9; the rest must be equal
  pictures      of equal size, half a level of 255 in the mean, and half a per cent of the pixels
                off by more than eight levels in a channel
"""

import base64
import pathlib
import re
import struct
import sys
import xml.etree.ElementTree
import zlib

LENGTH = 0.25
TEXT_SHARE = 0.02
TEXT_NOISE = 1e-9
PICTURE_MEAN = 0.5
PICTURE_LEVELS = 8
PICTURE_SHARE = 0.005

NUMBER = re.compile(r"[-−+]?(?:\d+\.\d+|\d+|\.\d+)(?:e[-+]?\d+)?")
PNG_URI = "data:image/png;base64,"


def unfilter(rows, width_bytes, step):
    """Scan lines without their filters; PNG (ISO/IEC 15948) 9.2, types 0 to 4."""
    above, result, at = bytearray(width_bytes), [], 0
    while at < len(rows):
        kind, line = rows[at], bytearray(rows[at + 1:at + 1 + width_bytes])
        at += 1 + width_bytes
        for i in range(width_bytes if kind else 0):
            left = line[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            up = above[i]
            if kind == 1:
                guess = left
            elif kind == 2:
                guess = up
            elif kind == 3:
                guess = (left + up) // 2
            elif kind == 4:
                p = left + up - corner
                by_left, by_up, by_corner = abs(p - left), abs(p - up), abs(p - corner)
                guess = (left if by_left <= by_up and by_left <= by_corner
                         else up if by_up <= by_corner else corner)
            else:
                raise ValueError(f"filter {kind} of a PNG file is not known")
            line[i] = (line[i] + guess) & 255
        result.append(line)
        above = line
    return result


def decode_png(data):
    """(width, height, RGBA bytes) of a PNG file, 8 bits a channel or a palette, not interlaced."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("not a PNG file")
    at, packed, palette, alphas = 8, b"", b"", b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        at += size + 12
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        elif kind == b"PLTE":
            palette = body
        elif kind == b"tRNS":
            alphas = body
        elif kind == b"IDAT":
            packed += body
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[color]
    if interlaced or depth > 8 or (depth < 8 and channels > 1):
        raise ValueError("a PNG file of a kind that figures do not hold")
    width_bytes = (width * channels * depth + 7) // 8
    lines = unfilter(zlib.decompress(packed), width_bytes, max(1, channels * depth // 8))
    if len(lines) != height:
        raise ValueError("a PNG file that is cut off")
    if depth < 8:
        mask, scale = (1 << depth) - 1, 1 if color == 3 else 255 // ((1 << depth) - 1)
        lines = [bytes(((line[i * depth // 8] >> (8 - depth - i * depth % 8)) & mask) * scale
                       for i in range(width)) for line in lines]
    raw = b"".join(bytes(line) for line in lines)
    count = width * height
    pixels = bytearray(b"\xff") * (4 * count)
    if color == 3:
        colors = [palette[3 * i:3 * i + 3] + (alphas[i:i + 1] or b"\xff")
                  for i in range(len(palette) // 3)]
        pixels = b"".join(colors[index] for index in raw)
    elif color in (0, 4):
        for c in range(3):
            pixels[c::4] = raw[0::channels]
        if color == 4:
            pixels[3::4] = raw[1::2]
    else:
        for c in range(channels):
            pixels[c::4] = raw[c::channels]
    return width, height, bytes(pixels)


def compare_pictures(before, after):
    """What differs between two PNG files, or nothing."""
    if before == after:
        return None
    width, height, a = decode_png(before)
    if (width, height) != decode_png(after)[:2]:
        return "another size of the picture"
    b = decode_png(after)[2]
    total, wrong = 0, 0
    for i in range(0, len(a), 4):
        p, q = a[i:i + 4], b[i:i + 4]
        if p == q or p[3] == q[3] == 0:
            continue
        off = [abs(x - y) for x, y in zip(p, q)]
        total += sum(off)
        wrong += max(off) > PICTURE_LEVELS
    mean, share = total / len(a), wrong / (width * height)
    if mean > PICTURE_MEAN or share > PICTURE_SHARE:
        return f"another picture: {mean:.2f} levels in the mean, {100 * share:.2f} % of the pixels"
    return None


def same_number(before, after):
    """Whether two numbers of a text are one but for rounding."""
    if before == after:
        return True
    if "." not in before or "." not in after:
        return False
    a, b = (float(x.replace("−", "-")) for x in (before, after))
    if max(abs(a), abs(b)) < TEXT_NOISE:
        return True
    unit = 0.0
    for text in (before, after):
        mantissa, _, exponent = text.partition("e")
        unit = max(unit, 10.0 ** (int(exponent or 0) - len(mantissa.split(".")[1])))
    return abs(a - b) <= min(1.001 * unit, TEXT_SHARE * max(abs(a), abs(b)))


def same_length(before, after):
    return abs(float(before.replace("−", "-")) - float(after.replace("−", "-"))) <= LENGTH + 1e-9


def same_but_for(before, after, same):
    """Whether texts are equal where they hold no numbers, and their numbers are the `same`."""
    a, b = NUMBER.findall(before), NUMBER.findall(after)
    return (NUMBER.split(before) == NUMBER.split(after) and len(a) == len(b) and
            all(same(x, y) for x, y in zip(a, b)))


def compare_elements(before, after, place, found):
    name = before.tag.rsplit("}")[-1]
    place = f"{place}/{name}"
    if before.tag != after.tag or list(before.attrib) != list(after.attrib):
        found.append(f"{place}: another element, {after.tag.rsplit('}')[-1]}")
        return
    for key, a in before.attrib.items():
        b = after.attrib[key]
        if a == b:
            continue
        if a.startswith(PNG_URI) and b.startswith(PNG_URI):
            said = compare_pictures(base64.b64decode(a[len(PNG_URI):]),
                                    base64.b64decode(b[len(PNG_URI):]))
            if said:
                found.append(f"{place}: {said}")
        elif not same_but_for(a, b, same_number if key == "aria-label" else same_length):
            found.append(f"{place}: {key} was '{a[:60]}', is '{b[:60]}'")
    a, b = (before.text or "").strip(), (after.text or "").strip()
    if not same_but_for(a, b, same_number) if name != "style" else a != b:
        found.append(f"{place}: the text was '{a[:80]}', is '{b[:80]}'")
    if len(before) != len(after):
        found.append(f"{place}: held {len(before)} elements, holds {len(after)}")
    for i, (x, y) in enumerate(zip(before, after)):
        compare_elements(x, y, f"{place}[{i}]", found)


def compare(before, after):
    """What differs between the texts of two SVG files: a list of lines."""
    found = []
    compare_elements(xml.etree.ElementTree.fromstring(before),
                     xml.etree.ElementTree.fromstring(after), "", found)
    return found


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    before, after = (pathlib.Path(p) for p in sys.argv[1:])
    pairs = [(before, after)]
    if after.is_dir():  # what was made anew
        pairs = [(before / p.name, p) for p in sorted(after.glob("*.svg"))]
    differ = not pairs
    for old, new in pairs:
        if not old.exists():
            found = [f"{old} is not there"]
        else:
            found = compare(old.read_text(encoding="utf-8"), new.read_text(encoding="utf-8"))
        print(f"{new.name}: {'as before' if not found else 'differs'}")
        for line in found[:10]:
            print(f"  {line}")
        if len(found) > 10:
            print(f"  and {len(found) - 10} more")
        differ = differ or bool(found)
    sys.exit(1 if differ else 0)


if __name__ == "__main__":
    main()
