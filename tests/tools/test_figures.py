# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Checked-in figures are what their commands make, and the comparison notices each kind of change.

    test_figures.py [TOOL]     without the tool, the comparison alone
"""

import base64
import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(k_root, "tools"))
import compare_figures  # noqa: E402

k_tool = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1][0] != "-" else None


def png(width, height, color_of, kind=6, row_filter=0):
    """An 8-bit PNG; color_of(x, y) gives the samples of a pixel."""
    step = compare_figures.k_samples[kind]
    raw, above = b"", bytes(width * step)
    for y in range(height):
        row = b"".join(bytes(color_of(x, y)) for x in range(width))
        left = bytes(step) + row[:len(row) - step]
        corner = bytes(step) + above[:len(row) - step]
        coded = bytearray()
        for v, a, b, c in zip(row, left, above, corner):
            p = a + b - c
            nearest = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            coded.append((v - (0, a, b, (a + b) // 2, nearest)[row_filter]) & 255)
        raw += bytes((row_filter,)) + bytes(coded)
        above = row
    data = b"\x89PNG\r\n\x1a\n"
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0))]
    if kind == 3:
        chunks += [(b"PLTE", bytes((10, 20, 30, 200, 150, 100))), (b"tRNS", bytes((128,)))]
    for name, body in chunks + [(b"IDAT", zlib.compress(raw)), (b"IEND", b"")]:
        data += struct.pack(">I", len(body)) + name + body
        data += struct.pack(">I", zlib.crc32(name + body))
    return data


def gradient(x, y):
    return 4 * x, 4 * y, 128, 255


def figure(text="TV 0.0361", x="12.3", color="#0068a8", picture=None, more=""):
    data = base64.b64encode(picture or png(50, 40, gradient)).decode()
    return ('<svg>\n<text x="%s" y="55" fill="%s">%s</text>\n<image width="300" height="240" '
            'href="data:image/png;base64,%s"/>%s\n</svg>\n' % (x, color, text, data, more))


class Comparison(unittest.TestCase):
    def same(self, **changes):
        self.assertEqual(compare_figures.figure_differences(figure(), figure(**changes)), [])

    def differs(self, part, **changes):
        for pair in ((figure(), figure(**changes)), (figure(**changes), figure())):
            found = compare_figures.figure_differences(*pair)
            self.assertEqual(len(found), 1, found)
            self.assertIn(part, found[0])

    def test_last_digits_may_differ(self):
        self.same()
        self.same(x="12.4")
        self.same(text="TV 0.0362")
        self.same(text="TV 0.036")  # 0.0360, whose zero is not printed

    def test_numbers_may_not_differ_more(self):
        self.differs("line 2", x="12.5")
        self.differs("line 2", x="12")
        self.differs("line 2", x="-12.3")
        self.differs("line 2", text="TV 0.0363")
        self.differs("line 2", text="TV 0.04")

    def test_text_structure_and_colours_are_exact(self):
        self.differs("line 2", text="L2 0.0361")
        self.differs("line 2", text="TW 0.0361")
        self.differs("line 2", color="#0068a9")
        self.differs("line 2", color="#a8555a")
        self.differs("rest", more="<path/>")
        self.differs("rest", more='<path width="1"/>')

    def test_pictures_may_differ_by_rounding(self):
        self.same(picture=png(50, 40, lambda x, y: (4 * x, 4 * y + (x + y) % 2, 128, 255)))
        self.same(picture=png(50, 40, lambda x, y: (4 * x, 4 * y, 0 if x == y == 7 else 128, 255)))

    def test_pictures_may_not_differ_visibly(self):
        shifted = png(50, 40, lambda x, y: (4 * max(x - 1, 0), 4 * y, 128, 255))
        spot = png(50, 40, lambda x, y: (4 * x, 4 * y, 0 if x in (7, 8, 9) and y < 2 else 128, 255))
        self.differs("picture 1", picture=shifted)
        self.differs("picture 1", picture=spot)
        self.differs("picture 1", picture=png(50, 40, lambda x, y: (*gradient(x, y)[:3], 250)))
        self.differs("50x40", picture=png(40, 50, gradient))
        self.differs("pictures", more='<image href="data:image/png;base64,AAAA"/>')

    def test_colours_that_nobody_sees_do_not_count(self):
        clear = [png(9, 9, lambda x, y: (v, v, v, 0)) for v in (0, 255)]
        self.assertEqual(compare_figures.picture_difference(*clear), None)

    def test_every_filter_and_colour_type_is_read(self):
        _, _, wanted = compare_figures.decode_png(png(9, 7, gradient))
        self.assertEqual(wanted[:12], bytes((0, 0, 128, 255, 4, 0, 128, 255, 8, 0, 128, 255)))
        for row_filter in range(5):
            read = compare_figures.decode_png(png(9, 7, gradient, row_filter=row_filter))
            self.assertEqual(read, (9, 7, wanted))
        for kind, color, wanted in ((0, (9,), (9, 9, 9, 255)), (2, (1, 2, 3), (1, 2, 3, 255)),
                                    (3, (1,), (200, 150, 100, 255)), (3, (0,), (5, 10, 15, 128)),
                                    (4, (100, 51), (20, 20, 20, 51))):
            read = compare_figures.decode_png(png(1, 1, lambda x, y: color, kind))
            self.assertEqual(tuple(read[2]), wanted)

    def test_damaged_pictures_are_named(self):
        whole = png(50, 40, gradient)
        for bad in (b"GIF89a", whole[:60], whole[:8]):
            self.assertRaises(compare_figures.BadFigure, compare_figures.decode_png, bad)

    def test_a_figure_that_is_missing_on_one_side_is_named(self):
        with tempfile.TemporaryDirectory() as old, tempfile.TemporaryDirectory() as new:
            for folder, name in ((old, "a"), (old, "b"), (new, "b"), (new, "c")):
                with open(os.path.join(folder, name + ".svg"), "w", encoding="utf-8") as stream:
                    stream.write(figure())
            self.assertEqual(compare_figures.folder_differences(old, new),
                             ["c.svg: is not checked in", "a.svg: no command makes it"])


@unittest.skipUnless(k_tool, "no tool given")
class Figures(unittest.TestCase):
    def make(self, *arguments, **environment):
        return subprocess.run(["tools/make_figures.sh", *arguments], cwd=k_root, text=True,
                              capture_output=True, env={**os.environ, "OPENLTC": k_tool,
                                                        **environment})

    def test_checked_in_figures_are_what_their_commands_make(self):
        run = self.make("--check")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_captions_say_the_command(self):
        rows = [line.split(None, 1) for line in self.make("--list").stdout.splitlines()]
        self.assertGreater(len(rows), 0)
        for file, command in rows:
            with open(os.path.join(k_root, "docs/images/plot", file), encoding="utf-8") as stream:
                self.assertIn("openltc plot %s<" % command.strip(), stream.read())
            self.assertLess(os.path.getsize(stream.name), 310000, file)

    def test_a_tool_that_draws_something_else_or_nothing_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            tool = os.path.join(folder, "openltc")
            run = self.make("--check", OPENLTC=tool)
            self.assertEqual(run.returncode, 1)
            self.assertIn("make build", run.stderr)
            for draw, part in (("echo '<svg/>' > \"${@: -1}\"", "literal.svg: line 1"),
                               ("true", "literal.svg: no command makes it"), ("exit 3", "")):
                with open(tool, "w", encoding="utf-8") as stream:
                    stream.write("#!/bin/bash\n%s\n" % draw)
                os.chmod(tool, 0o755)
                run = self.make("--check", OPENLTC=tool)
                self.assertNotEqual(run.returncode, 0)
                self.assertIn(part, run.stdout)
        self.assertEqual(self.make("--no-such").returncode, 2)



if __name__ == "__main__":
    unittest.main()
