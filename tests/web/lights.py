#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Reads the lights of glTF files by the npm package `openltc` in Node, and compares them with those that `openltc
inspect --json` finds; what is wrong with a file is said in the same words.

    lights.py --openltc PROGRAM --package FOLDER --work DIR

FOLDER is what `make web` makes. Exit code 0: all is well; 1: it is not; 77: nothing could run, and why."""

import argparse
import glob
import gzip
import json
import math
import os
import shutil
import struct
import subprocess
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
k_root = os.path.dirname(os.path.dirname(k_here))
sys.path[:0] = [k_here, os.path.join(k_root, "tools")]
from openltc import run, skip
from scenes import k_scenes, write_scene

k_apart = 1e-5 # of numbers, in shares of the larger; both are made of single precision
k_failures = []
# Pictures are not decoded: warnings say so in these files, and lights that have one are left out.
k_pictures = ("scenes/demo.glb", "scenes/lights.glb")
# And what else lies beside the file, or follows.
k_beside = {"scenes/lights.glb": [
    "materials[11].emissiveTexture: without it, the material does not shine",
    "nodes[52] \"luminaire\".extras.openltc_light.ies: the file lights.ies cannot be looked up when loading from memory without a "
    "folder; embed it or give the folder; the light is left out"]}
k_no_picture = "pictures are not decoded here"


def check(holds, what):
    if not holds:
        k_failures.append(what)
        print("FAILED " + what, flush=True)


def near(a, b):
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(near(x, y) for x, y in zip(a, b))
    return abs(a - b) <= k_apart * max(abs(a), abs(b), 1e-3)


def length(v):
    return math.sqrt(sum(x * x for x in v))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def area_of_rings(rings, normal):
    """By the formula of Stokes: holes run the other way."""
    total = [0.0, 0.0, 0.0]
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1]):
            a, b = minus(a, rings[0][0]), minus(b, rings[0][0])
            for k in range(3):
                total[k] += (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]) / 2
    return sum(x * y for x, y in zip(total, normal))


def facts_of(light):
    """What `openltc inspect` says of a light of the package's reader, from its geometry."""
    kind = light["type"]
    if kind == "line":
        color = light["intensityPerMetre"]
        return {"type": kind, "name": light["name"], "from_m": light["from"], "to_m": light["to"],
                "intensity_candela_per_metre": 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]}
    facts = {"name": light["name"], "two_sided": light["twoSided"], "radiance_nits": light["radiance"]}
    if kind == "polygon":
        areas = [area_of_rings([ring], light["normal"]) for ring in light["rings"]]
        facts.update(type=kind, corners=sum(map(len, light["rings"])), holes=sum(a < 0 for a in areas),
                     area_m2=area_of_rings(light["rings"], light["normal"]))
    elif kind == "ellipse":
        x, y = length(light["halfU"]), length(light["halfV"])
        facts.update(type="disk" if abs(x - y) <= 1e-5 * max(x, y) else kind, center_m=light["center"], radii_m=[x, y],
                     area_m2=math.pi * x * y)
    elif kind == "sphere":
        facts.update(type=kind, center_m=light["center"], radius_m=light["radius"], area_m2=4 * math.pi * light["radius"] ** 2)
    else:
        facts.update(type=kind, from_m=light["from"], to_m=light["to"], radius_m=light["radius"], caps=light["caps"])
    return facts


def compare(path, found, said):
    lights = [light for light in said["lights"] if light["type"] not in ("point", "spot", "directional") and "texture" not in light]
    if "error" in found:
        return check(False, "%s: %s" % (path, found["error"]))
    check(len(found["lights"]) == len(lights), "%s has %d lights, not %d" % (path, len(lights), len(found["lights"])))
    for light, right in zip(found["lights"], lights):
        for name, value in facts_of(light).items():
            same = near(value, right[name]) if isinstance(value, (float, list)) else value == right[name]
            check(same, "%s: %s of \"%s\" is %s, not %s" % (path, name, light["name"], value, right[name]))
    check(found["describesLights"] == said["describes_lights"], path + ": whether it describes lights")
    warnings = [w for w in found["warnings"] if k_no_picture not in w]
    check((path in k_pictures) == (len(warnings) < len(found["warnings"])), "%s: a picture: %s" % (path, found["warnings"]))
    right = said["warnings"] + k_beside.get(path, [])
    check(warnings == right, "%s: warnings: %s, not %s" % (path, warnings, right))
    return len(lights)


def write_glb(path, document):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as out:
        out.write(struct.pack("<4sIIII", b"glTF", 2, 20 + len(text), len(text), 0x4E4F534A) + text)


def write_bad(work):
    """Files with something wrong, and whether they can be read all the same."""
    asset = {"version": "2.0"}
    lamp = {"type": "disk", "size": 0.3, "intensity": 5}
    scene = {"asset": asset, "scene": 0, "scenes": [{"nodes": [0, 1]}], "extensionsUsed": ["EXT_lights_area"],
             "nodes": [{"name": "a", "extensions": {"EXT_lights_area": {"light": 0}}},
                       {"name": "b", "translation": [1, 2, 3], "extensions": {"EXT_lights_area": {"light": 1}}}],
             "extensions": {"EXT_lights_area": {"lights": [dict(lamp, size=-1), lamp]}}}
    broken = {"negative": (scene, True),
              "missing": (dict(scene, extensions={"EXT_lights_area": {"lights": [lamp]}}), None),
              "future": (dict(scene, asset={"version": "3.0"}), False),
              "required": (dict(scene, extensionsRequired=["EXT_no_such"]), False),
              "outside": (dict(scene, buffers=[{"byteLength": 4, "uri": "../a.bin"}]), None),
              "extras": ({"asset": asset, "scenes": [{"nodes": [0]}], "nodes": [
                  {"extras": {"openltc_light": {"type": "sphere", "luminance_nits": 3}}}]}, True)}
    files = {}
    for name, (document, readable) in broken.items():
        files[os.path.join(work, name + ".glb")] = readable
        write_glb(os.path.join(work, name + ".glb"), document)
    for name, data in (("short.glb", b"glTF\2\0\0\0"), ("words.gltf", b"{\"asset\": {"), ("empty.glb", b""),
                       ("deep.gltf", b"[" * 100000), ("none.glb", b"\x89PNG\r\n\x1a\n" * 9)):
        files[os.path.join(work, name)] = False
        with open(os.path.join(work, name), "wb") as out:
            out.write(data)
    return files


def inspect(openltc, path):
    done = subprocess.run([openltc, "inspect", "--json", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    return json.loads(done.stdout) if done.returncode == 0 else done.stderr.strip().split("openltc inspect: ", 1)[-1]


def main():
    parser = argparse.ArgumentParser()
    for name in ("openltc", "package", "work"):
        parser.add_argument("--" + name, required=True)
    arguments = parser.parse_args()
    openltc = os.path.abspath(arguments.openltc)
    node = shutil.which("node")
    if not node:
        skip("node not found (package nodejs)")
    module = os.path.join(arguments.package, "lights.wasm")
    if not os.path.exists(module):
        skip("%s is not there; make web builds it, with clang-22" % module)
    work = os.path.abspath(arguments.work)
    os.makedirs(work, exist_ok=True)
    os.chdir(k_root)
    scenes = ["scenes/engines.glb"] + sorted(set(glob.glob("scenes/*.glb") + glob.glob("scenes/hard/*.glb")) - {"scenes/engines.glb"})
    for name in ("gltf", "line", "tube_none", "many"):
        scenes.append(os.path.join(work, name + ".glb"))
        write_scene(name, k_scenes[name], scenes[-1], False)
    bad = write_bad(work)
    package = os.path.abspath(arguments.package) if os.path.isabs(arguments.package) else os.path.join(k_root, arguments.package)
    answer = json.loads(run(node, os.path.join(k_here, "lights.mjs"), package, *scenes, *bad).strip().splitlines()[-1])
    count = 0
    for path in scenes:
        count += compare(path, answer["found"][path], inspect(openltc, path)) or 0
    for path, readable in bad.items():
        said, found = inspect(openltc, path), answer["found"][path]
        if isinstance(said, str):
            check(readable is not True, "%s is read by the command line: %s" % (path, said))
            if path.endswith("outside.glb"): # the command line has a folder, and looks there
                said = path + ": buffers[0].uri: the file ../a.bin cannot be looked up when loading from memory without a folder; " \
                    "embed it or give the folder"
            check(found.get("error", "(none)") == said, "%s: \"%s\", not \"%s\"" % (path, found.get("error"), said))
        else:
            check(readable is not False and said["warnings"], "%s: is not read, or without a word" % path)
            compare(path, found, said)
    check("a string" not in (answer["wrong"]["a string"] or "") and "is the string" in answer["wrong"]["a string"],
          "a string is no file: %s" % answer["wrong"]["a string"])
    check("name is 4" in (answer["wrong"]["a number as a name"] or ""), "a name is a text: %s" % answer["wrong"])
    before, after = answer["memory"]
    check(before == after, "memory does not grow over 200 files: %d, %d" % (before, after))
    with open(module if os.path.isabs(module) else os.path.join(k_root, module), "rb") as stream:
        data = stream.read()
    print("%d lights of %d files; lights.wasm: %d KiB, %d KiB gzip; memory %.1f MiB; %d failures" % (
        count, len(scenes), len(data) / 1024, len(gzip.compress(data, 9)) / 1024, after / 2**20, len(k_failures)))
    sys.exit(1 if k_failures else 0)


if __name__ == "__main__":
    main()
