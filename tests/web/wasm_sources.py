#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Compiles for WebAssembly the file of web/wasm that includes the headers of the reader of glTF files, which `make web`
builds; the fitter itself is built before the tests.

    wasm_sources.py WORK

Exit code 0: they compile; 1: they do not; 77: a program is missing, and which."""

import os
import shutil
import subprocess
import sys

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def main():
    work = os.path.join(sys.argv[1], "wasm")
    for program in ("clang++-22", "ninja", "cmake"):
        if not shutil.which(program):
            print("skipped: %s not found; tools/packages.txt names what the fitter in WebAssembly needs" % program)
            sys.exit(77)
    if not os.path.exists("/usr/lib/wasm32-wasi/libc.a") or not os.path.isdir("/usr/include/wasm32-wasi/c++"):
        print("skipped: the libraries for WebAssembly are missing (packages wasi-libc, libc++-22-dev-wasm32)")
        sys.exit(77)
    source = os.path.join(k_root, "web", "wasm")
    for command in (["cmake", "-S", source, "-B", work, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                     "-DCMAKE_TOOLCHAIN_FILE=" + os.path.join(source, "toolchain.cmake")],
                    ["ninja", "-C", work, "CMakeFiles/lights.dir/lights.cpp.obj"]):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            print(done.stdout)
            sys.exit(1)
    print("compiled")


if __name__ == "__main__":
    main()
