#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Compiles the files of `openltc shaders` with real compilers, each in a shader that calls it.

    check_files.py OPENLTC glsl|wgsl|metal|hlsl WORK_DIR [--cxx COMPILER] [--shape SHAPE]

glsl    GLSL 4.50 and HLSL by glslang, each then by spirv-val; GLSL ES 3.00, and as that Godot's language, which
        is a subset of it but for uniforms
wgsl    by naga
metal   as C++14, with tests/shaders/metal/metal_stdlib for its library
hlsl    by DXC, to DXIL and to SPIR-V, and by Slang to SPIR-V; both are fetched from PyPI first, 82 MB

Files are made of each shape alone, and of all of them with each kind of lobe and with points of lights; for GLSL ES and Godot, which
differ from GLSL in few words, of a few. The calls are those that the head of each file shows, pasted. A
warning counts as an error.

Exit code 0: all compile; 1: one does not; 77: a tool is missing, which is named.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import hlsl_compilers  # noqa: E402
from check_shaders import install_naga, k_exit_skipped, k_root, need  # noqa: E402

k_shapes = ["quad", "polygon", "disk", "sphere", "tube", "line", "textured"]
k_lobes = ["polynomial", "two-lobe-polynomial", "table", "two-lobe"]
k_sampling_case = (["all"], "polynomial", ["--sampling"])
k_all_cases = [([shape], "polynomial", []) for shape in k_shapes] + [(["all"], lobe, []) for lobe in k_lobes] + [
    k_sampling_case]
k_few_cases = [(["quad"], "polynomial", []), (["all"], "polynomial", []), (["all"], "two-lobe", []), k_sampling_case]
k_languages = {"glsl": ["glsl", "glsl-es", "hlsl", "gdshader"], "wgsl": ["wgsl"], "metal": ["metal"],
               "hlsl": ["hlsl"]}
k_textures = ["coefficients", "amplitudes", "second", "picture"]
k_vectors = ["position", "normal", "view", "base_color", "center", "half_u", "half_v", "radiance", "normal_of_disk",
             "one_end", "other_end", "intensity_per_metre"]
k_numbers = ["metallic", "roughness", "radius"]


def make_file(openltc, language, shapes, lobe, more, work):
    """Lets the tool make a file. Returns its path."""
    result = subprocess.run([openltc, "shaders", "--language", language, "--shapes", ",".join(shapes), "--lobe",
                             lobe, *more, "-o", work], stderr=subprocess.PIPE, text=True, check=True)
    return re.fullmatch(r"wrote (.*)\n", result.stderr).group(1)


def calls_of(text):
    """The lines of code that the head shows."""
    head = text.split("// How to call it:\n")[1]
    lines = []
    for line in head.splitlines():
        if not line.startswith("//   "):
            break
        lines.append("  " + line[5:])
    return "\n".join(lines)


def glsl_shader(text, es):
    """A fragment shader that calls the file, and reads all that it wants from uniforms."""
    highp = "highp " if es else ""
    at = (lambda binding: "") if es else (lambda binding: "layout(set = 0, binding = %d) " % binding)
    polygons = ("uniform highp vec4 polygons[64];" if es else
                "layout(set = 0, binding = 5, std430) readonly buffer Polygons { vec4 polygons[]; };")
    head = ["#version 300 es" if es else "#version 450"]
    if es and "precision highp float;" not in text:
        head += ["precision highp %s;" % kind for kind in ("float", "int", "sampler2D")]
    head += ["%suniform %ssampler2D %s;" % (at(i), highp, name) for i, name in enumerate(k_textures)]
    head += [polygons, "%svec4 ltc_polygon_data(int i) { return polygons[i]; }" % highp,
             "%suniform Values { %s %s int outline; };" % (
                 "layout(std140) " if es else "layout(set = 0, binding = 6, std140) ",
                 " ".join("%svec4 %s_;" % (highp, name) for name in k_vectors),
                 " ".join("%sfloat %s;" % (highp, name) for name in k_numbers))]
    tail = ["%sout %svec4 color;" % ("" if es else "layout(location = 0) ", highp), "void main() {",
            "  vec3 light = vec3(0.0), sampled = vec3(0.0);", "  vec2 random = vec2(roughness, radius);"]
    tail += ["  vec3 %s = %s_.xyz;" % (name, name) for name in k_vectors]
    tail += [calls_of(text), "  color = vec4(light + sampled, 1.0);", "}"]
    return "\n".join(head + [text] + tail) + "\n"


def hlsl_shader(text):
    """A compute shader that calls the file."""
    head = ["[[vk::binding(%d)]] Texture2D<float4> %s : register(t%d);" % (i, name, i)
            for i, name in enumerate(k_textures)]
    head += ["[[vk::binding(4)]] SamplerState table_sampler : register(s0);",
             "[[vk::binding(5)]] SamplerState picture_sampler : register(s1);",
             "[[vk::binding(6)]] StructuredBuffer<float4> polygons : register(t8);",
             "[[vk::binding(7)]] RWStructuredBuffer<float4> colors : register(u0);",
             "float4 ltc_polygon_data(int i) { return polygons[i]; }",
             "[[vk::binding(8)]] cbuffer Values : register(b0) { %s int outline; };" % " ".join(
                 ["float4 %s_;" % name for name in k_vectors] + ["float %s;" % name for name in k_numbers])]
    tail = ["[numthreads(64, 1, 1)]", "void main(uint3 id : SV_DispatchThreadID) {",
            "  float3 light = float3(0.0, 0.0, 0.0), sampled = float3(0.0, 0.0, 0.0);",
            "  float2 random = float2(roughness, radius);"]
    tail += ["  float3 %s = %s_.xyz;" % (name, name) for name in k_vectors]
    tail += [calls_of(text), "  colors[id.x] = float4(light + sampled, 1.0);", "}"]
    return "\n".join(head + [text] + tail) + "\n"


def wgsl_shader(text):
    """A compute shader that calls the file."""
    head = ["@group(0) @binding(%d) var %s: texture_2d<f32>;" % (i, name) for i, name in enumerate(k_textures)]
    head += ["@group(0) @binding(4) var table_sampler: sampler;",
             "@group(0) @binding(5) var picture_sampler: sampler;",
             "@group(0) @binding(6) var<storage, read> polygons: array<vec4f>;",
             "@group(0) @binding(7) var<storage, read_write> colors: array<vec4f>;",
             "struct Values { %s outline: i32, }" % " ".join(
                 ["%s: vec3f," % name for name in k_vectors] + ["%s: f32," % name for name in k_numbers]),
             "@group(0) @binding(8) var<uniform> values: Values;",
             "fn ltc_polygon_data(i: i32) -> vec4f { return polygons[i]; }"]
    tail = ["@compute @workgroup_size(64)", "fn main(@builtin(global_invocation_id) id: vec3u) {",
            "  var light = vec3f(0.0);", "  var sampled = vec3f(0.0);",
            "  let random = vec2f(values.roughness, values.radius);"]
    tail += ["  let %s = values.%s;" % (name, name) for name in k_vectors + k_numbers + ["outline"]]
    tail += [calls_of(text), "  colors[id.x] = vec4f(light + sampled, 1.0);", "}"]
    return "\n".join(head + [text] + tail) + "\n"


def metal_shader(text, path):
    """A function that calls the file, which it includes: what it does not call is no matter."""
    parameters = ["texture2d<float> %s" % name for name in k_textures] + [
        "sampler table_sampler", "sampler picture_sampler", "constant float4* outline"] + [
        "float3 %s" % name for name in k_vectors] + ["float %s" % name for name in k_numbers]
    declared = "float3 shade(%s)" % ", ".join(parameters)
    return "\n".join(['#include "%s"' % path, declared + ";", declared + " {",
                      "  float3 light = float3(0.0, 0.0, 0.0), sampled = float3(0.0, 0.0, 0.0);",
                      "  float2 random(roughness, radius);", "  (void)random;", calls_of(text),
                      "  return light + sampled;", "}"]) + "\n"


def run(command):
    """Returns what a compiler has to say, None where it is content."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    noise = [line for line in result.stdout.splitlines() if re.search("error|warning", line, re.I)]
    return result.stdout if result.returncode != 0 or noise else None


def check_glslang(language, source):
    """Compiles a shader of GLSL or HLSL and validates its SPIR-V."""
    if language in ("glsl-es", "gdshader"):
        return run(["glslangValidator", source])
    spirv = source + ".spv"
    command = ["glslangValidator", "-V", "--target-env", "vulkan1.1", "-o", spirv]
    command += ["-D", "-S", "comp", "-e", "main"] if language == "hlsl" else []
    return run(command + [source]) or run(["spirv-val", "--target-env", "vulkan1.1", spirv])


def cases_of(language, shape):
    """What files are made, as (shapes, lobe, other options); of one shape alone where there is one."""
    if shape:
        return [([shape], "polynomial", [])]
    return k_few_cases if language in ("glsl-es", "gdshader") else k_all_cases


def hlsl_checks(work, cxx):
    """Fetches the compilers of HLSL. Returns functions from the path of a shader to what is wrong with it."""
    why = hlsl_compilers.fetch(work)
    if why:
        print("skipped: " + why)
        sys.exit(k_exit_skipped)
    checks = []
    dxc, why = hlsl_compilers.install_dxc(work, cxx)
    if dxc:
        # DXIL that nobody signs, and places that are for Vulkan, are no fault of the file.
        quiet = ["-WX", "-Wno-ignored-attributes", "-Vd"]
        checks += [lambda path: run([dxc, path, "cs_6_0", path + ".dxil"] + quiet),
                   lambda path: run([dxc, path, "cs_6_0", path + ".spv", "-spirv", "-fspv-target-env=vulkan1.1",
                                     "-WX"]) or run(["spirv-val", "--target-env", "vulkan1.1", path + ".spv"])]
    else:
        print("without DXC: " + why)
    slang = hlsl_compilers.install_slang(work)
    # -O0: its optimiser takes minutes over all shapes.
    checks.append(lambda path: run([slang, path, "-lang", "hlsl", "-target", "spirv", "-entry", "main", "-stage",
                                    "compute", "-O0", "-o", path + ".spv"]))
    return checks


def write_shaders(openltc, language, work, shape=None):
    """Writes a shader for each case. Returns (name of its file, its path)."""
    shaders = []
    for shapes, lobe, more in cases_of(language, shape):
        path = make_file(openltc, language, shapes, lobe, more, work)
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        shader = {"hlsl": hlsl_shader, "wgsl": wgsl_shader, "metal": lambda text: metal_shader(text, path)}.get(
            language, lambda text: glsl_shader(text, language != "glsl"))(text)
        endings = {"hlsl": ".hlsl", "wgsl": ".wgsl", "metal": ".cpp"}
        source = os.path.join(work, "shader_" + os.path.splitext(os.path.basename(path))[0]
                              + endings.get(language, ".frag"))
        with open(source, "w", encoding="utf-8") as stream:
            stream.write(shader)
        shaders.append((os.path.basename(path), source))
    return shaders


def check(openltc, compiler, work, cxx, shape):
    """Compiles all files of a compiler's languages. Returns messages of what failed."""
    failures = []
    others = hlsl_checks(work, cxx) if compiler == "hlsl" else []
    for language in k_languages[compiler]:
        folder = os.path.join(work, "files", language)
        os.makedirs(folder, exist_ok=True)
        shaders = write_shaders(openltc, language, folder, shape)
        if compiler == "wgsl":
            package = install_naga(work)
            script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "naga_check.mjs")
            failures += filter(None, [run(["node", script, package] + [source for _, source in shaders])])
        for name, source in shaders if compiler != "wgsl" else []:
            if compiler == "metal":
                error = run([cxx, "-std=c++14", "-fsyntax-only", "-Wall", "-Wextra", "-Wno-unused-parameter",
                             "-I", os.path.join(k_root, "tests/shaders/metal"), source])
            elif compiler == "hlsl":
                error = "\n".join(filter(None, [compile_by(source) for compile_by in others]))
            else:
                error = check_glslang(language, source)
            if error:
                failures.append("%s:\n%s" % (name, error))
        print("%s: %d files" % (language, len(shaders)), flush=True)
    return failures


def main():
    parser = argparse.ArgumentParser(description="Compiles the files of `openltc shaders`.")
    parser.add_argument("openltc", help="the tool")
    parser.add_argument("compiler", choices=sorted(k_languages))
    parser.add_argument("work", help="folder for what is made on the way")
    parser.add_argument("--cxx", default="c++", help="C++ compiler, for Metal")
    parser.add_argument("--shape", choices=k_shapes, help="this shape alone")
    arguments = parser.parse_args()
    work = os.path.abspath(arguments.work)
    if arguments.compiler in ("glsl", "hlsl"):
        need("glslangValidator", "glslang-tools")
        need("spirv-val", "spirv-tools")
    if arguments.compiler == "metal" and not shutil.which(arguments.cxx):
        print("skipped: no C++ compiler %s" % arguments.cxx)
        sys.exit(k_exit_skipped)
    failures = check(arguments.openltc, arguments.compiler, work, arguments.cxx, arguments.shape)
    for failure in failures:
        print(failure, file=sys.stderr)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
