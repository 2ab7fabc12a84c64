#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What Doxygen reads in place of a file: filter.py FILE. Lines stay where they are.

The comment that opens a source file becomes the description of the file, in plain text, and its first
sentence the summary. The dialect (.glsl) is put into the namespace in which C++ compiles it. In a page
(.md) names in the first column of tables lead to what they name, and links to other pages, which the
reference has not, become their text."""

import re
import sys

k_name = re.compile(r"`((?:openltc_)?[A-Za-z]\w*)((?:[({][^`]*)?)`")
k_link = re.compile(r"\[([^\]]*)\]\((?!#)[^)]*\)")
k_row = re.compile(r"(\| .*?)( \| .*)")
k_special = re.compile(r"([\\@&$#<>%\"])")


def opening_of(lines):
    """How many lines the opening comment takes."""
    count = 0
    while count < len(lines) and lines[count].startswith("//") and not lines[count].startswith("///"):
        count += 1
    return count


def summary_of(lines):
    """The first sentence of the opening comment, behind the two lines of the licence."""
    paragraph = []
    for line in lines[2:]:
        text = line[2:].strip()
        if text:
            paragraph.append(text)
        elif paragraph:
            break
    sentence = re.match(r".*?\.(?=\s|$)", " ".join(paragraph))
    return k_special.sub(r"\\\1", sentence.group()) if sentence else ""


def source(path, text):
    lines = text.split("\n")
    count = opening_of(lines)
    dialect = path.endswith(".glsl")
    if count < 2 or count >= len(lines) or lines[count].strip():
        raise SystemExit("%s: no opening comment with an empty line behind it" % path)
    begin = "namespace openltc::f32 {" if dialect else ""
    opening = lines[:count]
    lines[0], lines[1] = "/** \\file", "\\brief " + summary_of(opening) if summary_of(opening) else ""
    if count > 2:
        lines[2] = "\\verbatim"
        lines[3:count] = [line[3:].replace("*/", "* /") for line in opening[3:]]
        lines[count] = "\\endverbatim */ " + begin
    else:
        lines[count] = "*/ " + begin
    return "\n".join(lines) + ("}\n" if dialect else "")


def named(match):
    name, rest = match.groups()
    whole = name if name.startswith("openltc_") else "openltc::" + name
    return "[%s](@ref %s)" % (name + rest, whole)


def page(text):
    lines, in_code = text.split("\n"), False
    for number, line in enumerate(lines):
        if line.startswith("```"):
            in_code = not in_code
        if in_code:
            continue
        line = k_link.sub(r"\1", line)
        row = k_row.match(line)
        if row:
            line = k_name.sub(named, row.group(1)) + row.group(2)
        lines[number] = line
    return "\n".join(lines)


def main(path):
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    if path.endswith(".md"):
        text = page(text)
    elif path.endswith((".h", ".glsl")):
        text = source(path, text)
    sys.stdout.write(text)


if __name__ == "__main__":
    main(sys.argv[1])
