# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The files of `openltc shaders` compile, and the check notices when one does not.

    test_shader_files.py OPENLTC glsl|wgsl|metal WORK_DIR COMPILER
"""

import os
import subprocess
import sys
import tempfile

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def check(openltc, compiler, work, cxx, *options):
    """Returns (exit code, output)."""
    result = subprocess.run(
        [sys.executable, "-B", os.path.join(k_root, "tools/shaders/check_files.py"), openltc, compiler, work,
         "--cxx", cxx, *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return result.returncode, result.stdout


def main():
    openltc, compiler, work, cxx = sys.argv[1:]
    code, output = check(openltc, compiler, work, cxx)
    print(output, end="", flush=True)
    if code != 0:
        sys.exit(code)
    # A tool whose files have a name that nobody declared.
    with tempfile.TemporaryDirectory() as folder:
        spoiler = os.path.join(folder, "openltc")
        with open(spoiler, "w", encoding="utf-8") as stream:
            stream.write('#!/bin/sh\n"%s" "$@" || exit 1\nfor file; do :; done\n'
                         "sed -i 's/ max(/ ltc_nothing(/' \"$file\"/ltc_line.* 2>/dev/null || true\n"
                         % os.path.abspath(openltc))
        os.chmod(spoiler, 0o755)
        other = os.path.join(folder, "work")
        os.makedirs(other)
        if compiler == "wgsl":
            os.symlink(os.path.abspath(os.path.join(work, "naga")), os.path.join(other, "naga"))
        code, output = check(spoiler, compiler, other, cxx, "--shape", "line")
    if code != 1 or "ltc_nothing" not in output:
        sys.exit("a file with an unknown name: exit code %d instead of 1, or not named in\n%s" % (code, output))
    print("a file with an unknown name: noticed")


if __name__ == "__main__":
    main()
