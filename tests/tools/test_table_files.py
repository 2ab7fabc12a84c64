# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What the tool writes, other programs read: compilers the source, npm packages the textures.

    test_table_files.py source|readers OPENLTC_TOOL WORK_DIR
"""

import json
import os
import shutil
import subprocess
import sys

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
k_exit_skipped = 77
sys.path[:0] = [os.path.join(k_root, "tools/shaders"), os.path.join(k_root, "tools/npm")]
import check_shaders  # noqa: E402  installs the pinned naga
import npm_packages  # noqa: E402

k_layouts = ["native", "ltc_code", "unity", "godot", "o3de"]


def skip(reason):
    print("skipped: " + reason)
    sys.exit(k_exit_skipped)


def run(*command):
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if result.returncode != 0:
        sys.exit("%s: exit code %d\n%s%s"
                 % (" ".join(command), result.returncode, result.stdout, result.stderr))
    return result.stdout


def write(path, text):
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def make_table(tool, work):
    """A small native table; everything else is converted from it."""
    table = os.path.join(work, "table.json")
    run(tool, "fit", "--brdf", "ggx", "--size", "6", "--quiet", "-o", table)
    return table


def convert(tool, table, layout, path, *options):
    run(tool, "convert", table, path, "--layout", layout, "--quiet", *options)
    return path


def packed_values(tool, table, layout, work):
    """Textures of the layout, as (channels, values), by way of JSON."""
    path = convert(tool, table, layout, os.path.join(work, "values.json"), "--size", "5")
    root = json.loads(read(path))
    if "textures" in root:
        return [(t["channels"], t["values"]) for t in root["textures"]]
    texels = root["texels"]
    return [(4, [texels[6 * i + k] for i in range(len(texels) // 6) for k in range(4)])]


def check_source(tool, work):
    """C99, C++11, GLSL and HLSL, each as a program that uses the table."""
    table = make_table(tool, work)
    for tool_name in ("cc", "c++"):
        if not shutil.which(tool_name):
            skip("%s not found" % tool_name)
    glslang = shutil.which("glslangValidator")
    for layout in k_layouts:
        two = layout != "unity"
        header = convert(tool, table, layout, os.path.join(work, "my-table 2.h"))
        first = packed_values(tool, table, layout, work)
        assert first, layout
        use = ('#include "%s"\n#include "%s"\n' % (header, header)
               + "int main(void) { return my_table_2_1[0] == my_table_2_1[0] && "
               + ("my_table_2_channels_2 > 0 && sizeof(my_table_2_2) > 0 && " if two else "")
               + "sizeof(my_table_2_1) == sizeof(float) * my_table_2_columns * my_table_2_rows"
               + " * my_table_2_channels_1 ? 0 : 1; }\n")
        strict = ["-Wall", "-Wextra", "-Werror", "-pedantic"]
        for compiler, standard, ending in (("cc", "c99", "c"), ("c++", "c++11", "cpp")):
            source = os.path.join(work, "use." + ending)
            write(source, use)
            program = os.path.join(work, "use_" + ending)
            run(compiler, "-std=" + standard, *strict, source, "-o", program)
            run(program)
        print("%s: C99 and C++11 compile" % layout)
        if not glslang:
            continue
        # A texel picked at run time, so that the arrays are really used.
        glsl = read(convert(tool, table, layout, os.path.join(work, "t.glsl")))
        second = " + t_2[i].x" if two else ""
        for version, place in (("#version 450\n", "layout(location = 0) "),
                               ("#version 300 es\nprecision highp float;\n", "")):
            shader = os.path.join(work, "t.frag")
            write(shader, version + glsl + place + "flat in int i;\n" + place
                  + "out vec4 color;\nvoid main() { color = t_1[i]%s; }\n" % second)
            run("glslangValidator", shader)
        hlsl = read(convert(tool, table, layout, os.path.join(work, "t.hlsl")))
        shader = os.path.join(work, "t_hlsl.frag")
        write(shader, hlsl + "float4 main(nointerpolation int i : I) : SV_Target "
              "{ return t_1[i]%s; }\n" % second)
        run("glslangValidator", "-D", "-e", "main", "-S", "frag", "-V", shader, "-o",
            os.path.join(work, "t_hlsl.spv"))
        print("%s: GLSL 4.50, GLSL ES 3.00 and HLSL compile" % layout)
    if not glslang:
        print("glslangValidator not found: GLSL and HLSL left out")


def install(work):
    """Installs the pinned readers below work, once. Returns the folder of the packages."""
    prefix = os.path.join(work, "npm")
    why = npm_packages.install(os.path.join(k_root, "tools/tables"), prefix)
    if why:
        skip(why)
    return os.path.join(prefix, "node_modules")


def check_npy(path, values):
    try:
        import numpy
    except ImportError:
        return False
    array = numpy.load(path)
    assert array.shape == (5, 5, 4) and array.dtype == numpy.float32, array.shape
    assert numpy.array_equal(array.ravel(), numpy.array(values, dtype=numpy.float32))
    return True


def check_readers(tool, work):
    """KTX2, DDS, JavaScript and WGSL by programs that share no code with ours."""
    modules = install(work)
    table = make_table(tool, work)
    script = os.path.join(k_root, "tools/tables/read_textures.mjs")
    naga = check_shaders.install_naga(os.path.dirname(os.path.abspath(work)))
    for layout in k_layouts:
        want = packed_values(tool, table, layout, work)
        files = []
        for name in ("t.dds", "t.ktx2"):
            convert(tool, table, layout, os.path.join(work, name), "--size", "5")
            stem, ending = os.path.splitext(name)
            files.append(os.path.join(work, stem + ("" if layout == "unity" else "_1") + ending))
        module = convert(tool, table, layout, os.path.join(work, "t.js"), "--size", "5")
        shutil.copyfile(module, os.path.join(work, "t.mjs"))
        files.append(os.path.join(work, "t.mjs"))
        for found, path in zip(json.loads(run("node", script, modules, *files)), files):
            assert (found["width"], found["height"], found["channels"]) == (5, 5, 4), path
            assert found["precision"] == "float32", path
            same = all(abs(a - b) <= 1e-7 * abs(b) for a, b in zip(found["values"], want[0][1]))
            assert same and len(found["values"]) == len(want[0][1]), "%s: other values" % path
        ktx2 = json.loads(run("node", script, modules, files[1]))[0]
        assert ktx2["metadata"]["openltc.layout"] == layout, ktx2["metadata"]
        assert ktx2["metadata"]["openltc.brdf"] == "ggx", ktx2["metadata"]
        print("%s: parse-dds, ktx-parse and node read the same values" % layout)
        if layout == "o3de":  # whose second texture has two channels
            second = json.loads(run("node", script, modules, os.path.join(work, "t_2.ktx2")))[0]
            assert second["channels"] == 2 and len(second["values"]) == 50, second
        else:
            convert(tool, table, layout, os.path.join(work, "h.ktx2"), "--precision", "float16")
            half = os.path.join(work, "h.ktx2" if layout == "unity" else "h_2.ktx2")
            found = json.loads(run("node", script, modules, half))[0]
            assert found["precision"] == "float16", found
        convert(tool, table, layout, os.path.join(work, "t.npy"), "--size", "5")
        npy = os.path.join(work, "t.npy" if layout == "unity" else "t_1.npy")
        print("%s: numpy %s" % (layout, "reads the same" if check_npy(npy, want[0][1])
                                else "not installed, left out"))
        wgsl = convert(tool, table, layout, os.path.join(work, "t.wgsl"), "--size", "5")
        write(wgsl, read(wgsl) + "@fragment\nfn main(@location(0) @interpolate(flat) i: u32) -> "
              "@location(0) vec4<f32> {\n  return t_1[i / 5u][i % 5u];\n}\n")
        run("node", os.path.join(k_root, "tools/tables/check_wgsl.mjs"), naga, wgsl)
        print("%s: valid WGSL" % layout)


def main():
    what, tool, work = sys.argv[1:4]
    work = os.path.join(os.path.abspath(work), what)
    os.makedirs(work, exist_ok=True)
    {"source": check_source, "readers": check_readers}[what](tool, work)


if __name__ == "__main__":
    main()
