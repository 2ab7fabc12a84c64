#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Checks the pages and the comments of the repository: check_docs.py [ROOT].

1. Links of a page lead to a file or folder that exists, and to a heading of it.
2. A file or folder of the repository that the text of a page or a comment names exists. It may be named from
   the root, from the folder of whoever names it, or by the end of its path (`shade/edge.glsl`,
   `edge.glsl`). Placeholders (`X.cpp`, `NAME.cpp`), globs and outputs of a build are no names.
3. A page names nothing that lies outside the repository by a path (`../shared`).
4. A page writes numbers in one way: `0.5` and not `.5`, `64 × 64` and not `64 x 64`. Code, in a
   block or in typewriter, is left as it is.

docs/decisions.md tells how things were, so rules 2 to 4 leave it alone. Prints each breach as
path:line: text, and ends with 1 if there is one.
"""

import functools
import io
import os
import re
import sys
import tokenize

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_layers  # noqa: E402  the folder is on the path only now

k_history = "docs/decisions.md"
k_top_folders = ("openltc", "tests", "tools", "docs", "bench", "cli", "cmake", "scenes")
k_endings = "h|cpp|glsl|inc|comp|frag|py|sh|mjs|cmake|md"
# A name with an ending of source files, with or without folders; or a folder named from the root.
k_file = re.compile(r"(?<![\w./<>{}*+~$-])((?:\.\./)*(?:[\w-]+/)*[\w-]+(?:\.[\w-]+)*\.(?:%s))(?![\w/*{<>(-])"
                    % k_endings)
k_folder = re.compile(r"(?<![\w./<>{}*+~$:-])((?:%s)/[\w/-]*\w)(?![\w*{<>(]|[./-]+[\w*{<>(])"
                      % "|".join(k_top_folders))
k_link = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)")
k_scheme = re.compile(r"[a-z][a-z0-9+.-]*:")
k_number = re.compile(r"(?<![\w.)\]/*])\.[0-9]")
k_times = re.compile(r"[0-9](?:×| ?x ?)[0-9]")
k_outside = re.compile(r"\.\./shared")
# Files of other projects that comments speak of, and the dot products w·h.
k_foreign = {"ImfRgbaYca.h", "exp/lights.py", "area_lights_inc.glsl", "CTestTestfile.cmake",
             "servers/rendering/renderer_rd/shaders/area_lights_inc.glsl", "wo.h", "wi.h"}


def is_placeholder(name):
    """X.cpp, X_figure.cpp, NAME.cpp, tests/NAME, a.h; the pages of the root are none."""
    return name.startswith(("build/", "out/")) or any(
        re.fullmatch(r"[A-Z]+(_\w+)?|[a-z]", part.split(".")[0]) for part in name.split("/")
        if part not in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md"))


def python_comments(text):
    """The lines of a Python file with all but its comments and docstrings blanked."""
    lines, at_start = [""] * (text.count("\n") + 1), True
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT or (token.type == tokenize.STRING and at_start):
            for number, line in enumerate(token.string.splitlines(), token.start[0] - 1):
                lines[number] = line
        if token.type not in (tokenize.COMMENT, tokenize.NL):
            at_start = token.type in (tokenize.NEWLINE, tokenize.INDENT)
    return lines


def comments_of(path, text):
    """The lines of a source file with all but its comments blanked."""
    if path.endswith(".py"):
        return python_comments(text)
    mark = "//" if path.endswith((".h", ".cpp", ".glsl", ".inc", ".in", ".comp", ".frag", ".mjs")) else "#"
    begin = re.compile(r"(?:^|\s)" + mark)
    return [line[found.start():] if found else ""
            for line in text.splitlines() for found in [begin.search(line)]]


def without_blocks(text):
    """The lines of a page with its code blocks blanked: the files named there are the reader's."""
    lines, in_code = [], False
    for line in text.splitlines():
        if line.startswith("```"):
            in_code = not in_code
        lines.append("" if in_code or line.startswith(("    ", "```")) else line)
    return lines


def prose_of(text):
    """The lines of a page without code blocks, words in typewriter, links and formulas."""
    return [re.sub(r"`[^`]*`|\]\([^)]*\)|\$[^$]*\$", "` `", line) for line in without_blocks(text)]


class Names:
    """The files and folders of the repository, by every end of their paths."""

    def __init__(self, paths):
        self.ends = set()
        for path in paths:
            parts = path.split("/")
            for end in range(1, len(parts) + 1):
                for begin in range(end):
                    self.ends.add("/".join(parts[begin:end]))

    def has(self, name, folder):
        joined = os.path.normpath(os.path.join(folder, name))
        return name in self.ends or joined in self.ends


def find_pages_and_files(root):
    """All paths, and those of the pages, relative to root, in a fixed order."""
    paths = []
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in check_layers.k_skipped_folders)
        paths += [os.path.relpath(os.path.join(folder, name), root) for name in sorted(names)]
    return paths, [path for path in paths if path.endswith(".md")]


def check_names(path, lines, names):
    folder = os.path.dirname(path)
    for number, line in enumerate(lines, 1):
        for found in (*k_file.finditer(line), *k_folder.finditer(line)):
            name = found.group(1)
            if not (is_placeholder(name) or name in k_foreign or names.has(name, folder)):
                yield number, "%s: there is no such file" % name


@functools.lru_cache(maxsize=None)
def headings_of(place):
    """The names by which links reach the headings of a page, as GitHub makes them."""
    with open(place, encoding="utf-8") as stream:
        titles = [line.lstrip("#").strip() for line in without_blocks(stream.read()) if line.startswith("#")]
    titles = [re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title) for title in titles]
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def check_page(root, path, text):
    for number, line in enumerate(text.splitlines(), 1):
        for target, heading in k_link.findall(line):
            place = os.path.join(root, os.path.dirname(path), target) if target else os.path.join(root, path)
            if k_scheme.match(target):
                continue
            if not os.path.exists(place) or (heading and place.endswith(".md")
                                             and heading not in headings_of(place)):
                yield number, "the link to %s leads nowhere" % "#".join(filter(None, (target, heading)))
        if path != k_history and k_outside.search(line):
            yield number, "%s is not in the repository" % k_outside.search(line).group()
    if path == k_history:
        return
    for number, line in enumerate(prose_of(text), 1):
        for rule, what in ((k_number, "a number begins with its digit, 0.5"),
                           (k_times, "between numbers stands ×, 64 × 64")):
            if rule.search(line):
                yield number, "%s, but here: %s" % (what, line[rule.search(line).start():][:12])


def check(root):
    """All breaches as (path, line, text)."""
    paths, pages = find_pages_and_files(root)
    names = Names(paths)
    breaches = []
    for path in sorted(set(check_layers.find_sources(root)) | set(pages)):
        with open(os.path.join(root, path), encoding="utf-8") as stream:
            text = stream.read()
        if path in pages:
            breaches += [(path, *found) for found in check_page(root, path, text)]
        lines = without_blocks(text) if path in pages else comments_of(path, text)
        if path != k_history:
            breaches += [(path, *found) for found in check_names(path, lines, names)]
    return breaches


def main():
    default = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    breaches = check(sys.argv[1] if len(sys.argv) > 1 else default)
    for path, line, text in breaches:
        print("%s:%d: %s" % (path, line, text))
    sys.exit(1 if breaches else 0)


if __name__ == "__main__":
    main()
