#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Runs the engine examples and compares their pictures with that of `openltc render`.

    engines.py web|vulkan --openltc PROGRAM --work DIR [--example PROGRAM] [--picture PNG]

web: the pages docs/examples/engines/webgl2.html and webgpu.html in a browser without a window, and there the
shaders of Godot and Bevy with stand-ins for the engines (stand_ins.py); vulkan: the program --example, and with it
the includes for Unity and Unreal. All show scenes/engines.glb, which is made here a second time. Expected is what the
renderer's kernel makes of the same closed form, by polynomials of one lobe, one ray through the middle of each pixel,
no shadows.

Exit code 0: all pictures agree; 1: one does not; 77: nothing could run, and why."""

import argparse
import array
import itertools
import math
import os
import shutil
import struct
import subprocess
import sys
import zlib

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_examples = os.path.join(k_root, "docs", "examples", "engines")
sys.path[:0] = [os.path.join(k_root, "tests", "parity"), os.path.join(k_root, "tools")]
import browser
import stand_ins
from demo_scene import glb

k_exit_skipped = 77
k_size = (960, 540)
k_driver = "llvmpipe"  # of Vulkan, whatever else there is

k_lamp = 6.0  # the largest radiance of the scene

# Differences in the mean, of the light of the picture, and at the worst pixel, of a lamp's: measured are at most 3.3e-7
# and 1.3e-5, and a lamp that is moved by a millimetre makes 1e-3 and 1. A pixel through whose middle the outline of a
# lamp goes may show it or not: so many numbers, three each, may be off by more than a hundredth of a lamp.
k_mean, k_largest, k_edges = 1e-6, 4e-5, 12


def run(*command):
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if result.returncode != 0:
        sys.exit("%s: exit code %d\n%s" % (" ".join(command), result.returncode, result.stdout + result.stderr))
    return result.stdout


def skip(why):
    print("skipped: " + why)
    sys.exit(k_exit_skipped)


def read_exr(path):
    """The picture of an OpenEXR file as `openltc render` writes it, floats by ZIP: rows from the top, R G B R G B ...

    Source: Industrial Light & Magic, OpenEXR File Layout."""
    with open(path, "rb") as stream:
        data = stream.read()
    at, attributes = 8, {}
    while data[at]:
        name, kind = data[at:].split(b"\0", 2)[:2]
        at += len(name) + len(kind) + 2
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    x0, y0, x1, y1 = struct.unpack("<4i", attributes[b"dataWindow"])
    width, height, lines = x1 - x0 + 1, y1 - y0 + 1, 16
    names = [part.strip(b"\0") for part in attributes[b"channels"].split(struct.pack("<iiii", 2, 0, 1, 1))[:-1]]
    assert attributes[b"compression"] == b"\3" and names == [b"B", b"G", b"R"], attributes
    rows = []
    for (begin,) in struct.iter_unpack("<Q", data[at + 1:at + 1 + 8 * ((height + lines - 1) // lines)]):
        (size,) = struct.unpack_from("<i", data, begin + 4)
        coded = data[begin + 8:begin + 8 + size]
        if size < 12 * width * min(lines, height - len(rows)):  # else it stands there as it is
            coded = undo_prediction(zlib.decompress(coded))
        values = array.array("f", coded)
        for first in range(0, len(values), 3 * width):
            row = array.array("f", bytes(12 * width))
            for k in range(3):
                row[2 - k::3] = values[first + k * width:first + (k + 1) * width]
            rows.append(row)
    return rows


def undo_prediction(coded):
    """Bytes t[i] = t[i - 1] + coded[i] - 128; then those of the first half are the even ones."""
    sums = array.array("Q", itertools.accumulate(coded)).tobytes()[::8]
    plain = bytearray(sums)
    plain[1::2] = sums[1::2].translate(bytes(i ^ 128 for i in range(256)))
    half = (len(plain) + 1) // 2
    mixed = bytearray(len(plain))
    mixed[0::2], mixed[1::2] = plain[:half], plain[half:]
    return bytes(mixed)


def read_rows(path, size, channels, bottom_up, skipped=0):
    """Rows from the top of a file of floats, without alpha."""
    values = array.array("f")
    with open(path, "rb") as stream:
        stream.seek(skipped)
        values.frombytes(stream.read())
    width, height = size
    assert len(values) == width * height * channels, "%s: %d numbers" % (path, len(values))
    rows = []
    for y in range(height):
        row = values[y * width * channels:(y + 1) * width * channels]
        if channels == 4:
            rgb = array.array("f", bytes(12 * width))
            for k in range(3):
                rgb[k::3] = row[k::4]
            row = rgb
        rows.append(row)
    return rows[::-1] if bottom_up else rows


class Judge:
    def __init__(self, arguments):
        self.openltc, self.work, self.picture = arguments.openltc, arguments.work, arguments.picture
        os.makedirs(self.work, exist_ok=True)
        scene = self.path("engines.glb")
        run(sys.executable, "-B", k_examples + "/make_scene.py", "-o", scene)
        with open(scene, "rb") as made, open(os.path.join(k_root, "scenes", "engines.glb"), "rb") as there:
            if made.read() != there.read():
                sys.exit("scenes/engines.glb differs: run docs/examples/engines/make_scene.py")
        self.pictures = {}

    def expected(self, size):
        """The picture of `openltc render`."""
        if size not in self.pictures:
            self.pictures[size] = self.rendered("%dx%d" % size)
        return self.pictures[size]

    def rendered(self, size):
        picture = self.path("expected_%s.exr" % size)
        run(self.openltc, "render", self.path("engines.glb"), "--lobes", "polynomial", "--specular", "lobe", "--samples", "1",
            "--filter", "none", "--shadow-samples", "0", "--size", size, "-o", picture)
        return read_exr(picture)

    def path(self, name):
        return os.path.join(self.work, name)

    def judge(self, name, rows):
        """What is wrong, in words."""
        expected = self.expected((len(rows[0]) // 3, len(rows)))
        values = [abs(a - b) for row, right in zip(rows, expected) for a, b in zip(row, right)]
        if not math.isfinite(sum(values)):
            return ["%s: infinite, or no number" % name]
        edges = sum(x > 0.01 * k_lamp for x in values)
        rest = [x for x in values if x <= 0.01 * k_lamp]
        mean, largest = sum(rest) / sum(map(sum, expected)), max(rest) / k_lamp
        if self.picture and name == "webgpu":
            write_picture(self.picture, rows)
        print("%s: off by %.1e of the picture's light in the mean, by %.1e of a lamp's at most; beside that %d numbers"
              % (name, mean, largest, edges))
        right = mean <= k_mean and largest <= k_largest and edges <= k_edges
        return [] if right else ["%s differs from openltc render; bounds are %g, %g and %d" % (name, k_mean, k_largest, k_edges)]


def check_the_check(judge):
    """A picture that is too bright by a ten-thousandth must be refused."""
    if not judge.judge("a spoiled picture", [array.array("f", [1.0001 * x for x in row]) for row in judge.expected(k_size)]):
        sys.exit("a picture that is too bright by a ten-thousandth was taken")


def shown(radiance):
    """What a screen is given of it, 0 to 255: displayed() of the examples."""
    x = 1.0 - math.exp(-0.5 * radiance)
    return 255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055)


def check_displayed(name, path, rows):
    """The canvas shows those numbers: a pixel in a hundred, within rounding to 8 bits."""
    width, height = k_size
    with open(path, "rb") as stream:
        pixels = stream.read()
    worst = max(abs(pixels[4 * (y * width + x) + k] - shown(rows[y][3 * x + k]))
                for y in range(0, height, 10) for x in range(0, width, 10) for k in range(3))
    return [] if worst <= 0.6 else ["%s: the page displays something else, off by %.1f of 255" % (name, worst)]


def check_packed(elements):
    """A rectangle of 3 by 2, turned: what "polygon data" says of it."""
    area, normal, center, radius = elements[2], elements[16:19], elements[20:23], elements[23]
    spreads = sorted(math.hypot(*elements[k:k + 3]) for k in (24, 28))
    expected = [1.0 * math.sqrt(2 / 3), 1.5 * math.sqrt(2 / 3)]
    right = (elements[0] == 5 and abs(area - 6) < 1e-9 and abs(radius - math.hypot(1.5, 1)) < 1e-9
             and all(abs(a - b) < 1e-9 for a, b in zip(spreads + center + normal, expected + [1, 2, 3] + [0, -0.6, 0.8])))
    return [] if right else ["polygon.js: a rectangle's numbers are %s" % elements]


def write_picture(path, rows):
    """A PNG of half the size, each pixel the mean of four."""
    width, height = k_size[0] // 2, k_size[1] // 2

    def row(y):
        four = [rows[2 * y + j][k::6] for j in (0, 1) for k in range(6)]  # columns of even and of odd pixels, two rows
        light = [[sum(x) / 4 for x in zip(four[k], four[k + 3], four[k + 6], four[k + 9])] for k in range(3)]
        return bytes(int(shown(light[k][x]) + 0.5) for x in range(width) for k in range(3))

    with open(path, "wb") as out:
        out.write(glb.png(width, height, 3, map(row, range(height))))


def rectangle():
    u, v = (1.5, 0, 0), (0, 0.8, 0.6)  # their product is along (0, -0.6, 0.8)
    return [[c + a * x + b * y for c, x, y in zip((1, 2, 3), u, v)] for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def run_web(judge, _):
    program = browser.find()
    if not program:
        skip("no chromium (package chromium)")
    whole = ("webgl2", "webgpu")
    pages = {name: "/docs/examples/engines/%s.html" % name for name in whole}
    stand_ins.write_scene(k_examples, judge.work)
    pages["godot"] = stand_ins.godot_page(k_examples, judge.work)
    pages["bevy"] = stand_ins.bevy_page(k_examples, judge.work)
    jobs = [{"name": "packed", "points": rectangle()}] + [
        {"name": name, "page": pages[name], "displayed": name in whole} for name in pages]
    page = os.path.join(k_root, "tests", "engines", "frame.html")
    answers = browser.run(program, page, judge.work, jobs, root=k_root)
    if "packed" not in answers:
        skip("%s opened no page" % program)
    failures, absent = check_packed(answers["packed"]["elements"]), []
    for name in pages:
        answer = answers.get(name, {"failed": "no answer in time"})
        if answer.get("failed", "").startswith("no Web"):
            absent.append(answer["failed"])
            print("not run: " + answer["failed"])
        elif "failed" in answer:
            failures.append("%s: %s" % (name, answer["failed"]))
        else:
            rows = read_rows(judge.path(name + ".bin"), (answer["width"], answer["height"]), 4, answer["rows"] == "up")
            failures += judge.judge(name, rows)
            if name in whole:
                failures += check_displayed(name, judge.path(name + "_displayed.bin"), rows)
    if len(absent) == len(pages):
        skip("; ".join(absent))
    return failures


def run_vulkan(judge, example):
    if not example:
        skip("built without Vulkan (package libvulkan-dev)")
    glslang = shutil.which("glslangValidator")
    if not glslang:
        skip("glslangValidator not found (package glslang-tools)")
    os.environ.setdefault("XDG_RUNTIME_DIR", judge.work)  # lavapipe asks for one
    sources = {"vulkan": ["-V", os.path.join(k_examples, "vulkan.comp")],
               "hlsl": ["-D", "-V", "-e", "main", "-S", "comp", stand_ins.hlsl_shader(k_examples, judge.work)]}
    failures = []
    for name in sources:
        spirv, picture = judge.path(name + ".spv"), judge.path(name + ".pfm")
        run(glslang, *sources[name], "-o", spirv)
        result = subprocess.run([example, spirv, picture, k_driver], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if result.returncode == 2:
            skip(result.stderr.strip())
        if result.returncode != 0:
            sys.exit("%s: exit code %d\n%s" % (example, result.returncode, result.stderr))
        with open(picture, "rb") as stream:
            head = b"".join(stream.readline() for _ in range(3))
        assert head == b"PF\n%d %d\n-1.0\n" % k_size, head
        failures += judge.judge(name, read_rows(picture, k_size, 3, True, len(head)))
    return failures


def main():
    parser = argparse.ArgumentParser(description="Runs the engine examples and compares their pictures.")
    parser.add_argument("target", choices=["web", "vulkan"])
    parser.add_argument("--openltc", required=True)
    parser.add_argument("--work", required=True, help="folder for what is made on the way")
    parser.add_argument("--example", default="", help="the program of Vulkan")
    parser.add_argument("--picture", default="", help="docs/images/engines.png: that of the WebGPU page, at half its size")
    arguments = parser.parse_args()
    arguments.work = os.path.abspath(arguments.work)
    judge = Judge(arguments)
    check_the_check(judge)
    failures = {"web": run_web, "vulkan": run_vulkan}[arguments.target](judge, arguments.example)
    for failure in failures:
        print(failure, file=sys.stderr)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
