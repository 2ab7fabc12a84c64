# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""README.md and README.zh-CN.md stay equal in structure, and the comparison notices each breach.

Section by section both have the same blocks, links, code, typewriter words and numbers; images come
in the same order. Comments in code blocks are translated, so they are left out. What the words say
is for a reader of both languages to judge.
"""

import os
import re
import unittest

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_english = "README.md"
k_chinese = "README.zh-CN.md"

k_heading = re.compile(r"(#+) +(.+)")
k_image = re.compile(r"!\[([^\]]*)\]\(([^)]+)\)")
k_link = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)]+)\)")
k_path = re.compile(r"[A-Za-z0-9_./-]+")
k_typewriter = re.compile(r"`([^`]+)`")
k_number = re.compile(r"[0-9](?:[0-9.,]*[0-9])?")
k_comment = re.compile(r"\s+# .*$")
k_chinese_letter = re.compile("[\u4e00-\u9fff]")


class Block:
    """Lines between blank lines, or a code block."""

    def __init__(self, lines):
        self.lines = lines
        first = lines[0]
        if first.startswith("```"):
            self.kind = "code block"
        elif first.startswith("|"):
            self.kind = "table of %d rows" % len(lines)
        elif re.match(r"([-*]|[0-9]+\.) ", first):
            self.kind = "list of %d items" % sum(
                bool(re.match(r"([-*]|[0-9]+\.) ", line)) for line in lines)
        elif k_image.fullmatch(first):
            self.kind = "image"
        else:
            self.kind = "paragraph"


class Section:
    def __init__(self, level, title):
        self.level = level
        self.title = title
        self.blocks = []

    def text(self):
        """All but code blocks."""
        lines = [self.title]
        for block in self.blocks:
            if block.kind != "code block":
                lines += block.lines
        return "\n".join(lines)

    def code(self):
        return [[k_comment.sub("", line) for line in block.lines]
                for block in self.blocks if block.kind == "code block"]

    def rows(self):
        return [line for block in self.blocks if block.kind.startswith("table")
                for line in block.lines]


def read_sections(text):
    sections = [Section(0, "(before the first heading)")]
    lines, in_code = [], False

    def end_block():
        if lines:
            sections[-1].blocks.append(Block(lines[:]))
            lines.clear()

    for line in text.splitlines():
        heading = None if in_code else k_heading.fullmatch(line)
        if heading:
            end_block()
            sections.append(Section(len(heading.group(1)), heading.group(2)))
        elif line.startswith("```"):
            if not in_code:
                end_block()
            lines.append(line)
            if in_code:
                end_block()
            in_code = not in_code
        elif line.strip() or in_code:
            lines.append(line)
        else:
            end_block()
    end_block()
    return sections


def prose(text):
    """Text without what is compared by itself, nor addresses."""
    return k_typewriter.sub("", k_link.sub("", k_image.sub("", text)))


def visible(text):
    """Text as a reader sees it: words of links stay, addresses, images and typewriter go."""
    return k_typewriter.sub("", re.sub(r"\]\([^)]+\)", "]", k_image.sub("", text)))


def numbers(text):
    return sorted(k_number.findall(visible(text)))


def links(section):
    """Addresses, with the words of the link where they are a file's name."""
    found = []
    for words, address in k_link.findall(section.text()):
        if address in (k_english, k_chinese):
            found.append("(the other language)")
        elif address.startswith("#"):
            found.append("#")  # follows the page's own headings
        else:
            name = "." in words and k_path.fullmatch(words)
            found.append("[%s](%s)" % (words, address) if name else address)
    return sorted(found)


def compare(english, chinese):
    """What differs, one line each; empty when the two texts have the same structure."""
    found = []

    def expect(where, what, left, right):
        if left != right:
            found.append("%s: %s: %s has %s, %s has %s"
                         % (where, what, k_english, left, k_chinese, right))

    left, right = read_sections(english), read_sections(chinese)
    expect("headings", "number and levels", [s.level for s in left], [s.level for s in right])
    expect("images", "addresses in their order", [m[1] for m in k_image.findall(english)],
           [m[1] for m in k_image.findall(chinese)])
    if found:
        return found
    for a, b in zip(left, right):
        where = '"%s"' % a.title
        expect(where, "blocks", [block.kind for block in a.blocks], [block.kind for block in b.blocks])
        expect(where, "links", links(a), links(b))
        expect(where, "code", a.code(), b.code())
        expect(where, "typewriter words", sorted(k_typewriter.findall(a.text())),
               sorted(k_typewriter.findall(b.text())))
        for row_a, row_b in zip(a.rows(), b.rows()):
            expect(where, "columns", row_a.count("|"), row_b.count("|"))
            expect(where, "numbers of the row %s" % row_a, numbers(row_a), numbers(row_b))
        expect(where, "numbers", numbers(a.text()), numbers(b.text()))
        if k_chinese_letter.search(prose(a.text())):
            found.append("%s: %s holds Chinese" % (where, k_english))
        for block in b.blocks:
            text = prose("\n".join(block.lines))
            if block.kind == "paragraph" and not k_chinese_letter.search(text):
                found.append('%s: not translated: "%s"' % (where, block.lines[0]))
    for name, text, other in ((k_english, english, k_chinese), (k_chinese, chinese, k_english)):
        if "](%s)" % other not in "\n".join(text.splitlines()[:4]):
            found.append("%s does not link %s at its top" % (name, other))
    for alt, address in k_image.findall(english) + k_image.findall(chinese):
        if not alt.strip():
            found.append("%s has no text for those who do not see it" % address)
    return found


k_left = """# Tool

English · [简体中文](README.zh-CN.md)

Lights in 3 shapes, see [lights](docs/lights.md) and `--help`.

![A lamp](lamp.png)

## Use

```
make demo     # builds
```

- one
- two

![A table](table.png)

## Figures

| | |
|---|---|
| time | 0.13 s |
| 64 × 64 nodes | 5.5e-6 |
"""

k_right = """# Tool

[English](README.md) · 简体中文

3 种形状的光源，见[光源](docs/lights.md)和 `--help`。

![一盏灯](lamp.png)

## 用法

```
make demo     # 构建
```

- 一
- 二

![一张桌子](table.png)

## 数据

| | |
|---|---|
| 时间 | 0.13 秒 |
| 64 × 64 个节点 | 5.5e-6 |
"""


class ReadmeLanguages(unittest.TestCase):
    def assert_breach(self, old, new, expected):
        self.assertIn(old, k_right)
        found = compare(k_left, k_right.replace(old, new, 1))
        self.assertTrue(any(expected in line for line in found), found)

    def test_both_readmes_have_the_same_structure(self):
        texts = []
        for name in (k_english, k_chinese):
            with open(os.path.join(k_root, name), encoding="utf-8") as stream:
                texts.append(stream.read())
        self.assertEqual(compare(*texts), [])

    def test_the_readmes_are_really_read(self):
        with open(os.path.join(k_root, k_english), encoding="utf-8") as stream:
            sections = read_sections(stream.read())
        self.assertGreater(len(sections), 8)
        self.assertGreater(sum(len(s.code()) for s in sections), 3)
        self.assertGreater(sum(len(s.rows()) for s in sections), 15)
        self.assertGreater(sum(len(links(s)) for s in sections), 10)

    def test_a_faithful_translation_is_accepted(self):
        self.assertEqual(compare(k_left, k_right), [])

    def test_headings(self):
        self.assert_breach("## 用法\n", "", "headings")
        self.assert_breach("## 用法\n", "### 用法\n", "headings")

    def test_images(self):
        self.assert_breach("(lamp.png)", "(bulb.png)", "images")
        self.assert_breach("![一盏灯](lamp.png)\n", "", "images")
        swapped = k_right.replace("lamp.png", "x").replace("table.png", "lamp.png")
        swapped = swapped.replace("x", "table.png")
        self.assertTrue(any("images" in line for line in compare(k_left, swapped)))
        self.assert_breach("![一盏灯]", "![]", "no text")

    def test_links(self):
        self.assert_breach("docs/lights.md", "docs/fitting.md", "links")
        self.assert_breach("[光源](docs/lights.md)", "光源", "links")
        named = k_left.replace("[lights]", "[docs/lights.md]")
        self.assertEqual(compare(named, k_right.replace("[光源]", "[docs/lights.md]")), [])
        other = k_right.replace("[光源]", "[docs/fitting.md]")
        self.assertTrue(any("links" in line for line in compare(named, other)))
        self.assert_breach("[English](README.md)", "English", "does not link")

    def test_code(self):
        self.assert_breach("make demo  ", "make test  ", "code")
        self.assert_breach("make demo     # 构建\n", "make demo\nmake test\n", "code")
        self.assert_breach("`--help`", "`--version`", "typewriter")

    def test_numbers(self):
        self.assert_breach("0.13", "0.12", "numbers of the row")
        self.assert_breach("5.5e-6", "5.5e-7", "numbers of the row")
        self.assert_breach("3 种", "4 种", "numbers")
        self.assert_breach("| 时间 | 0.13 秒 |\n", "", "blocks")
        self.assert_breach("0.13 秒 |", "0.13 秒 | |", "columns")

    def test_blocks(self):
        self.assert_breach("- 二\n", "", "blocks")
        self.assert_breach("\n## 用法", "\n多一段。\n\n## 用法", "blocks")
        self.assert_breach("3 种形状的光源，见[光源](docs/lights.md)和 `--help`。",
                           "Lights in 3 shapes, see [lights](docs/lights.md) and `--help`.",
                           "not translated")


if __name__ == "__main__":
    unittest.main()
