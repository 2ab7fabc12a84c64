# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The figures of the docs are what the tool draws today: test_figures.py OPENLTC. And the comparison
notices a breach: without the tool, these tests alone run."""

import base64
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(k_root, "tools"))

import compare_figures  # noqa: E402  the folder is on the path only now

k_make = os.path.join(k_root, "tools/make_figures.sh")
k_pictures = os.path.join(k_root, "docs/images/plot")
k_largest = 320 * 1024  # bytes of a picture of the docs
tool = None


def listed():
    with open(os.path.join(k_root, "tools/figures.txt"), encoding="utf-8") as stream:
        return [line.split()[0] for line in stream if line.strip() and not line.startswith("#")]


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def filtered(kind, line, above, step):
    """A scan line as an encoder filters it."""
    result = bytearray([kind])
    for i, value in enumerate(line):
        left = line[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        up = above[i]
        nearest = min((left, up, corner), key=lambda x: abs(left + up - corner - x))
        guess = (0, left, up, (left + up) // 2, nearest)[kind]
        result.append((value - guess) % 256)
    return bytes(result)


def encode(width, color, raw, kinds, palette=b"", alphas=b""):
    channels = {2: 3, 3: 1, 6: 4}[color]
    size = width * channels
    lines = [raw[i:i + size] for i in range(0, len(raw), size)]
    body, above = b"", bytes(size)
    for i, line in enumerate(lines):
        body += filtered(kinds[i % len(kinds)], line, above, channels)
        above = line
    header = struct.pack(">IIBBBBB", width, len(lines), 8, color, 0, 0, 0)
    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
    if color == 3:
        png += chunk(b"PLTE", palette) + chunk(b"tRNS", alphas)
    return png + chunk(b"IDAT", zlib.compress(body)) + chunk(b"IEND", b"")


def noise(count):
    """The same bytes each time: a multiplicative congruence, Lewis, Goodman, Miller 1969."""
    state, result = 1, bytearray()
    for _ in range(count):
        state = 16807 * state % 2147483647
        result.append(state >> 8 & 255)
    return bytes(result)


def figure(label="mean 0.0370", y=10.0, png=None):
    png = png or encode(8, 6, bytes([100, 150, 200, 255]) * 64, [0])
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="100"><path d="M0 0L20 {y}"/>'
            f'<text x="3" y="4">{label}</text><image x="0" y="0" '
            f'href="data:image/png;base64,{base64.b64encode(png).decode()}"/></svg>')


class Pictures(unittest.TestCase):
    def test_all_filters_and_colour_types_are_decoded(self):
        for color, channels in ((2, 3), (6, 4)):
            raw = noise(7 * 10 * channels)
            width, height, pixels = compare_figures.decode_png(
                encode(7, color, raw, [0, 1, 2, 3, 4]))
            self.assertEqual((width, height), (7, 10))
            for c in range(channels):
                self.assertEqual(pixels[c::4], raw[c::channels])
            if channels == 3:
                self.assertEqual(pixels[3::4], b"\xff" * 70)

    def test_palettes_are_decoded_with_their_alpha(self):
        palette = noise(3 * 16)
        raw = bytes(b % 16 for b in noise(70))
        _, _, pixels = compare_figures.decode_png(
            encode(7, 3, raw, [0, 1, 2, 3, 4], palette, b"\x00\x80"))
        for i, index in enumerate(raw):
            self.assertEqual(pixels[4 * i:4 * i + 3], palette[3 * index:3 * index + 3])
            self.assertEqual(pixels[4 * i + 3], {0: 0, 1: 128}.get(index, 255))

    def test_the_encoding_does_not_matter(self):
        raw = noise(8 * 8 * 4)
        self.assertIsNone(compare_figures.compare_pictures(encode(8, 6, raw, [0]),
                                                           encode(8, 6, raw, [4, 3])))

    def test_rounding_passes_and_a_changed_patch_does_not(self):
        raw = bytes([100, 150, 200, 255]) * 400
        rounded = bytes([101]) + raw[1:800] + bytes([99]) + raw[801:]
        self.assertIsNone(compare_figures.compare_pictures(encode(20, 6, raw, [0]),
                                                           encode(20, 6, rounded, [0])))
        patch = raw[:800] + bytes([100, 150, 220, 255]) * 4 + raw[816:]
        for changed in (patch, bytes([101, 151, 201, 255]) * 400):
            self.assertIn("another picture", compare_figures.compare_pictures(
                encode(20, 6, raw, [0]), encode(20, 6, changed, [0])))
        self.assertIn("size", compare_figures.compare_pictures(encode(20, 6, raw, [0]),
                                                               encode(40, 6, raw, [0])))


class Comparison(unittest.TestCase):
    def differences(self, **changes):
        return compare_figures.compare(figure(), figure(**changes))

    def test_equal_and_rounded_figures_pass(self):
        self.assertEqual(self.differences(), [])
        self.assertEqual(self.differences(label="mean 0.0371", y=10.2), [])
        self.assertEqual(compare_figures.compare(figure("1.2e-15"), figure("3.4e-16")), [])

    def test_a_changed_label_is_noticed(self):
        for label in ("maen 0.0370", "mean 0.0373", "mean 0.0370 m", "mean −0.0370", "mean"):
            self.assertIn("text", self.differences(label=label)[0])
        for before, after in (("20", "21"), ("0.05", "0.06"), ("10³", "10⁴")):
            self.assertEqual(len(compare_figures.compare(figure(before), figure(after))), 1)

    def test_a_moved_curve_is_noticed(self):
        self.assertIn("d was", self.differences(y=10.5)[0])
        self.assertIn("d was", self.differences(y="10L21 10")[0])

    def test_a_changed_picture_is_noticed(self):
        other = encode(8, 6, bytes([100, 150, 190, 255]) * 64, [0])
        self.assertIn("another picture", self.differences(png=other)[0])

    def test_missing_and_other_elements_are_noticed(self):
        without = re.sub("<text.*</text>", "", figure())
        self.assertTrue(compare_figures.compare(figure(), without))
        self.assertTrue(compare_figures.compare(figure(), figure().replace("<path", '<path id="a"')))


class Figures(unittest.TestCase):
    def test_every_figure_is_listed_and_every_listed_one_is_there(self):
        names = listed()
        self.assertEqual(len(names), len(set(names)))
        there = [name[:-4] for name in os.listdir(k_pictures) if name.endswith(".svg")]
        self.assertEqual(sorted(names), sorted(there))
        for name in names:
            self.assertLess(os.path.getsize(os.path.join(k_pictures, name + ".svg")), k_largest)

    def test_captions_say_the_command(self):
        with open(os.path.join(k_root, "tools/figures.txt"), encoding="utf-8") as stream:
            rows = [line.split(None, 1) for line in stream if not line.startswith("#")]
        for name, command in rows:
            with open(os.path.join(k_pictures, name + ".svg"), encoding="utf-8") as stream:
                text = re.sub(r"\s*</text>\s*<text[^>]*>", " ", stream.read())
            self.assertIn("openltc " + command.strip(), text)

    def make(self, *arguments):
        return subprocess.run([k_make, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, env={**os.environ, "OPENLTC": tool})

    def test_the_checked_in_figures_are_what_the_tool_draws(self):
        if tool is None:
            self.skipTest("no tool given")
        with tempfile.TemporaryDirectory() as folder:
            run = self.make("--out", folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            for name in listed():
                texts = []
                for place in (k_pictures, folder):
                    with open(os.path.join(place, name + ".svg"), encoding="utf-8") as stream:
                        texts.append(stream.read())
                with self.subTest(name):
                    self.assertEqual(compare_figures.compare(*texts), [],
                                     "make figures, look at them, and check them in")

    def test_an_unknown_figure_or_option_is_refused(self):
        if tool is None:
            self.skipTest("no tool given")
        with tempfile.TemporaryDirectory() as folder:
            run = self.make("--out", folder, "nonesuch")
            self.assertEqual(run.returncode, 1)
            self.assertIn("nonesuch", run.stderr)
            self.assertEqual(self.make("--chekc").returncode, 2)
            self.assertEqual(os.listdir(folder), [])


if __name__ == "__main__":
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-"):
        tool = os.path.abspath(sys.argv.pop(1))
    unittest.main()
