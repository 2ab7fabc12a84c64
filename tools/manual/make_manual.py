#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes the tool's man pages and shell completions from what its --help says.

    tools/manual/make_manual.py OPENLTC FOLDER

Writes FOLDER/man1/openltc*.1.gz, a page for each command, FOLDER/openltc.bash, FOLDER/_openltc (zsh)
and FOLDER/openltc.fish. `cmake --install` calls it, and cpack.
"""

import gzip
import os
import subprocess
import sys

from completions import bash, fish, zsh
from help_text import read_command
from man_page import man_page


def write_pages(command, version, folder, parent=None):
    # Without a time: the same tool gives the same bytes.
    with open(os.path.join(folder, "-".join(command.words) + ".1.gz"), "wb") as stream:
        stream.write(gzip.compress(man_page(command, version, parent).encode(), mtime=0))
    for below in command.commands:
        write_pages(below, version, folder, command)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    tool, folder = sys.argv[1:]
    version = subprocess.run([tool, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout.split()[-1]
    root = read_command(tool)
    os.makedirs(os.path.join(folder, "man1"), exist_ok=True)
    write_pages(root, version, os.path.join(folder, "man1"))
    for name, text in (("openltc.bash", bash(root)), ("_openltc", zsh(root)), ("openltc.fish", fish(root))):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as stream:
            stream.write(text)


if __name__ == "__main__":
    main()
