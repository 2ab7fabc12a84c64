# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""What `openltc convert` writes for a scene is valid glTF for the Khronos validator.

    test_gltf_export.py OPENLTC_TOOL WORK_DIR
"""

import json
import math
import os
import struct
import subprocess
import sys

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(k_root, "tools/npm"))
import npm_packages  # noqa: E402  the folder is on the path only now

k_exit_skipped = 77


def skip(reason):
    print("skipped: " + reason)
    sys.exit(k_exit_skipped)


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def install(work):
    """Installs the pinned validator below work, once. Returns the folder of the packages."""
    prefix = os.path.join(work, "npm")
    why = npm_packages.install(os.path.join(k_root, "tools/gltf"), prefix)
    if why:
        skip(why)
    return os.path.join(prefix, "node_modules")


def write_lamps(folder):
    """A .gltf with a buffer beside it: an emissive fan of 32 corners on nodes of several kinds, and
    lights in extras."""
    corners = 32
    points = [(0.0, 0.0, 0.0)]
    points += [(math.cos(2 * math.pi * i / corners), math.sin(2 * math.pi * i / corners), 0.0)
               for i in range(corners)]
    indices = [c for i in range(corners) for c in (0, 1 + i, 1 + (i + 1) % corners)]
    data = b"".join(struct.pack("<3f", *p) for p in points)
    view = len(data)
    data += struct.pack("<%dH" % len(indices), *indices)
    with open(os.path.join(folder, "lamps.bin"), "wb") as stream:
        stream.write(data)
    single = [struct.unpack("<f", struct.pack("<f", c))[0] for p in points for c in p]
    turned = [0.5, 0.5, 0.5, 0.5]
    light = {"type": "rect", "width": 2, "height": 1, "flux_lumens": 800}
    sphere = {"type": "sphere", "radius": 0.1, "luminance_nits": 4000}
    root = {
        "asset": {"version": "2.0"}, "scene": 0,
        "scenes": [{"nodes": [0, 1, 2, 3, 4]}],
        "nodes": [
            {"name": "Plain", "mesh": 0},
            {"name": "Turned", "mesh": 0, "rotation": turned, "scale": [2, 2, 2],
             "translation": [5, 0, 0]},
            {"name": "Uneven", "mesh": 0, "scale": [1, 1, 3], "translation": [0, 5, 0]},
            {"name": "Rect", "extras": {"openltc_light": light}, "rotation": turned},
            {"name": "Sphere", "extras": {"openltc_light": json.dumps(sphere)}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"emissiveFactor": [1, 0.5, 0.25], "doubleSided": True}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
             "min": [min(single[k::3]) for k in range(3)],
             "max": [max(single[k::3]) for k in range(3)]},
            {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"}],
        "bufferViews": [
            {"buffer": 0, "byteLength": view, "target": 34962},
            {"buffer": 0, "byteOffset": view, "byteLength": len(data) - view, "target": 34963}],
        "buffers": [{"byteLength": len(data), "uri": "lamps.bin"}],
    }
    path = os.path.join(folder, "lamps.gltf")
    with open(path, "w", encoding="utf-8") as stream:
        json.dump(root, stream)
    return path


def lights_of(tool, path):
    result = subprocess.run([tool, "inspect", path, "--json", "--recognise-shapes"],
                            stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(result.stdout)["lights"]


def main():
    tool, work = sys.argv[1:3]
    work = os.path.join(os.path.abspath(work), "gltf")
    os.makedirs(work, exist_ok=True)
    modules = install(work)
    script = os.path.join(k_root, "tools/gltf/validate.mjs")
    for source in (os.path.join(k_root, "scenes/demo.glb"), write_lamps(work)):
        before = run("node", script, modules, source)
        if before.returncode != 0:
            sys.exit("the source itself is not valid:\n" + before.stdout)
        written = os.path.join(work, "out.glb")
        result = run(tool, "convert", source, written, "--recognise-shapes")
        if result.returncode != 0:
            sys.exit("%s: exit code %d\n%s" % (source, result.returncode, result.stdout))
        print(result.stdout.strip())
        after = run("node", script, modules, written)
        print(after.stdout.strip())
        if after.returncode != 0:
            sys.exit("not valid: " + source)
        lumens = [sum(light["flux_lumens"] for light in lights_of(tool, path)
                      if "flux_lumens" in light) for path in (source, written)]
        if not math.isclose(*lumens, rel_tol=1e-5):
            sys.exit("%s: %g lumens became %g" % (source, *lumens))
    # The validator does notice what is wrong.
    with open(written, "rb") as stream:
        good = stream.read()
    with open(written, "wb") as stream:
        stream.write(good.replace(b'"SCALAR"', b'"SCALAX"'))
    if run("node", script, modules, written).returncode != 1:
        sys.exit("the validator takes a broken file")


if __name__ == "__main__":
    main()
