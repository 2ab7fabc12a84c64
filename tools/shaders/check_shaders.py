#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Compiles the shading source as shaders, with real compilers.

    check_shaders.py glsl WORK_DIR [--root DIR]   Vulkan GLSL 4.50 and GLSL ES 3.00, then spirv-val
    check_shaders.py wgsl WORK_DIR [--root DIR]   the same SPIR-V by naga to WGSL, validated again

Every template in ROOT/tests/shaders (.frag, .comp) includes the prelude, openltc/target/glsl.inc,
and the list of all shading files, openltc/target/shade_all.inc. The includes are put in place
here, because the dialect itself has none. Every file of openltc/shade must be in the list.

Exit code 0: all compile; 1: one does not; 77: a tool is missing, which is named.
"""

import argparse
import glob
import os
import re
import shutil
import subprocess
import sys

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.append(os.path.join(k_root, "tools/npm"))
import npm_packages  # noqa: E402  the folder is on the path only now

k_include = re.compile(r'^\s*#include "([^"]+)"')
k_exit_skipped = 77


def expand(root, path, lines, included):
    """Appends the file to lines as (text, file, number), its includes put in place."""
    included.add(path)
    with open(os.path.join(root, path), encoding="utf-8") as stream:
        for number, text in enumerate(stream.read().splitlines(), 1):
            include = k_include.match(text)
            if include:
                expand(root, include.group(1), lines, included)
            else:
                lines.append((text, path, number))


def run(command, lines=None):
    """Runs a compiler. Returns its output, None when it is content; line numbers become places."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode == 0:
        return None

    def place(match):
        number = int(match.group(1))
        if lines and 0 < number <= len(lines):
            return "ERROR: %s:%d:" % lines[number - 1][1:]
        return match.group(0)

    return re.sub(r"ERROR: \S*?:(\d+):", place, result.stdout)


def need(tool, package):
    if not shutil.which(tool):
        print("skipped: %s not found (package %s; run tools/setup.sh)" % (tool, package))
        sys.exit(k_exit_skipped)


def compile_templates(root, work):
    """Compiles every template. Returns (SPIR-V files, messages of what failed)."""
    spirv_files, failures, included = [], [], set()
    templates = sorted(glob.glob(os.path.join(root, "tests/shaders/*.frag"))
                       + glob.glob(os.path.join(root, "tests/shaders/*.comp")))
    if not templates:
        failures.append("no template in %s/tests/shaders" % root)
    for template in templates:
        name = os.path.basename(template)
        lines = []
        expand(root, os.path.relpath(template, root), lines, included)
        source = os.path.join(work, name)
        with open(source, "w", encoding="utf-8") as stream:
            stream.write("\n".join(text for text, _, _ in lines) + "\n")
        command = ["glslangValidator", source]
        if lines[0][0].startswith("#version 450"):
            spirv = source + ".spv"
            error = run(command + ["-V", "--target-env", "vulkan1.1", "-o", spirv], lines)
            error = error or run(["spirv-val", "--target-env", "vulkan1.1", spirv])
            if not error:
                spirv_files.append(spirv)
        else:
            error = run(command, lines)
        print("%s: %s" % (name, "does not compile" if error else "compiles"), flush=True)
        if error:
            failures.append("%s:\n%s" % (name, error))
    for path in sorted(glob.glob(os.path.join(root, "openltc/shade/**/*.glsl"), recursive=True)):
        if os.path.relpath(path, root) not in included:
            failures.append("%s is not in openltc/target/shade_all.inc" % os.path.relpath(path, root))
    return spirv_files, failures


def install_naga(work):
    """Installs the pinned naga below work, once. Returns its folder or exits with 'skipped'."""
    prefix = os.path.join(work, "naga")
    why = npm_packages.install(os.path.dirname(os.path.abspath(__file__)), prefix)
    if why:
        print("skipped: " + why)
        sys.exit(k_exit_skipped)
    return os.path.join(prefix, "node_modules", "naga-wasm")


def main():
    parser = argparse.ArgumentParser(description="Compiles the shading source as shaders.")
    parser.add_argument("language", choices=["glsl", "wgsl"])
    parser.add_argument("work", help="folder for what is made on the way")
    parser.add_argument("--root", default=k_root, help="the repository")
    arguments = parser.parse_args()
    need("glslangValidator", "glslang-tools")
    need("spirv-val", "spirv-tools")
    work = os.path.join(os.path.abspath(arguments.work), arguments.language)
    os.makedirs(work, exist_ok=True)

    spirv_files, failures = compile_templates(os.path.abspath(arguments.root), work)
    if arguments.language == "wgsl":
        # Above the working folder of one run, so that all runs share one installation.
        package = install_naga(os.path.dirname(work))
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "naga_wgsl.mjs")
        for spirv in spirv_files:
            wgsl = re.sub(r"\.spv$", ".wgsl", spirv)
            error = run(["node", script, package, spirv, wgsl])
            print("%s: %s" % (os.path.basename(wgsl), "refused by naga" if error else "valid WGSL"))
            if error:
                failures.append("%s:\n%s" % (os.path.basename(wgsl), error))
    for failure in failures:
        print(failure, file=sys.stderr)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
