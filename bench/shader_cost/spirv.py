# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Compiles GLSL by glslang and counts what is in SPIR-V."""

import array
import os
import shutil
import subprocess
import sys

import parity

# Opcodes of what a program does not execute and a driver does not keep: names, decorations, sources.
k_annotations = {2, 3, 4, 5, 6, 7, 8, 71, 72, 73, 74, 75}
k_type_float, k_constant = 22, 43
k_function, k_function_end = 54, 56


def run(command, package):
    """Runs a tool of a package."""
    if not shutil.which(command[0]):
        raise parity.Skipped("no %s (package %s)" % (command[0], package))
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0:
        sys.exit("%s:\n%s" % (" ".join(command), result.stdout))


def compile_shader(text, path):
    """Writes a compute shader beside `path`. Returns the paths of its SPIR-V, as compiled and after spirv-opt -O."""
    with open(path + ".comp", "w", encoding="utf-8") as stream:
        stream.write(text)
    compiled, optimised = path + ".spv", path + ".opt.spv"
    run(["glslangValidator", "-V", "--target-env", "vulkan1.1", path + ".comp", "-o", compiled], "glslang-tools")
    run(["spirv-opt", "-O", "--target-env=vulkan1.1", compiled, "-o", optimised], "spirv-tools")
    return compiled, optimised


def instructions(path):
    """Each instruction of a module, as its words."""
    words = array.array("I")
    with open(path, "rb") as stream:
        words.fromfile(stream, os.path.getsize(path) // 4)
    at = 5  # after the header
    while at < len(words):
        count = words[at] >> 16
        yield words[at:at + count]
        at += count


def count_instructions(path):
    """Instructions, types and constants among them, without names and decorations."""
    return sum(1 for words in instructions(path) if words[0] & 0xffff not in k_annotations)


def count_in_functions(path):
    """Those of its functions alone: what it executes, without types and constants."""
    count, inside = 0, False
    for words in instructions(path):
        opcode = words[0] & 0xffff
        inside = inside or opcode == k_function
        count += inside and opcode not in k_annotations
        inside = inside and opcode != k_function_end
    return count


def constant_bytes(path):
    """Bytes of the numbers of a module, each once: floats of single precision."""
    floats, constants = set(), set()
    for words in instructions(path):
        if words[0] & 0xffff == k_type_float and words[2] == 32:
            floats.add(words[1])
        elif words[0] & 0xffff == k_constant and words[1] in floats:
            constants.add(words[3])
    return 4 * len(constants)
