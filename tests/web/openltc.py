#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Runs the npm package `openltc` of web/wasm in Node and compares what it makes with the command line's.

    openltc.py --openltc PROGRAM --package FOLDER --work DIR [--types]

--types: a TypeScript program that uses all of it compiles too, by the compiler of tests/web/releases. FOLDER is what `make web` makes. Every table of openltc.mjs equals the native one to 1e-6, number by number, and
passes `openltc inspect`; what a caller may do wrong is tried by openltc.mjs itself. The times that are printed are
those of a table of 64 x 64 nodes; the command line's is on as many cores as WebAssembly has threads: one.

Exit code 0: all is well; 1: it is not; 77: nothing could run, and why."""

import argparse
import gzip
import json
import math
import os
import re
import shutil
import struct
import subprocess
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(k_here)), "tools", "npm"))
import npm_packages

k_apart = 1e-6
k_number = re.compile(r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
k_layouts = ("native", "ltc_code", "unity", "godot", "o3de")


# Every name that the types have, and mistakes that they must see.
k_program = """
import {OpenltcError, loadLightReader, loadOpenltc} from 'openltc';
import type {AreaLight, BatchFunction, BrdfSource, Cell, FileLights, Fit, FitFile, FitOptions, LightReader, LobeError, Openltc,
             PolygonFigure, PolygonSpace, Texture} from 'openltc';

const openltc: Openltc = await loadOpenltc({wasm: new Uint8Array()});
const lambert: BatchFunction = (wo, wi, roughness, out) => { out.fill(wo[2] * wi[0] * roughness); };
const source: BrdfSource = {evaluate: lambert, name: 'mine', width: 'one', parameter: false};
const options: FitOptions = {brdf: source, form: 'two-lobe', size: 16, degree: 4, objective: 'tv', layout: 'native',
                             precision: 'float16', refine: 'on', clipAware: true, engine: 'godot', progress: share => share < 1};
const fit: Fit = openltc.fit(options);
const error: LobeError = fit.mean, [texture]: Texture[] = fit.textures, [file]: FitFile[] = fit.files('a.json');
const [cell]: Cell[] = fit.cells({roughness: [0.5], thetaDegrees: new Set([45]), side: 64});
const figure: PolygonFigure = fit.polygon({roughness: 0.5, thetaDegrees: 45, corners: [[0, 0, 1], [1, 0, 1], [0, 1, 1]], samples: 9});
const space: PolygonSpace = figure.shading;
const numbers: number = error.tv + texture.values[0] + file.bytes.length + cell.brdf[0] + space.integral + openltc.memoryBytes
    + fit.map.tv[0] + openltc.colormaps.magma[0] + fit.report({lights: 0, limit: true}).regions.length;
fit.free();
for (const brdf of ['ggx', lambert, {merl: new ArrayBuffer(8), name: 'x.binary'}]) openltc.fit({brdf});

const reader: LightReader = await loadLightReader();
const found: FileLights = reader.readLights(new ArrayBuffer(4), {name: 'a.glb', recogniseShapes: true});
const size = (light: AreaLight): number => {
  switch (light.type) {
    case 'polygon': return light.rings.length + light.normal[0] + light.radiance[0];
    case 'ellipse': return light.center[0] + light.halfU[1] + light.halfV[2] + light.cosinePower;
    case 'sphere': return light.twoSided ? light.radius : light.center[0];
    case 'tube': return light.caps === 'flat' ? light.radius : light.from[0] - light.to[0];
    case 'line': return light.intensityPerMetre[0];
  }
};
console.log(numbers, found.lights.map(size), found.warnings.join(), found.describesLights, reader.memoryBytes, OpenltcError.name);
// @ts-expect-error: no such form
openltc.fit({form: 'three-lobe'});
// @ts-expect-error: a function of numbers, not of words
openltc.fit({brdf: () => 'red'});
// @ts-expect-error: a line has no surface
found.lights.forEach(light => light.type === 'line' && light.radiance);
// @ts-expect-error: a file's bytes, not its name
reader.readLights('a.glb');
"""


def skip(reason):
    print("skipped: " + reason)
    sys.exit(77)


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        print("%s failed:\n%s" % (" ".join(command), done.stdout))
        sys.exit(1)
    return done.stdout


def write_merl(path):
    """A material of the MERL format that nobody measured: a glossy lobe over a diffuse one."""
    theta_half, theta_difference, phi_difference = 12, 10, 20
    values = []
    for scale in (1500.0, 1500.0 / 1.15, 1500.0 / 1.66):
        for h in range(theta_half):
            angle = (h / theta_half) ** 2 * math.pi / 2
            value = 0.1 + 3 * math.exp(-12 * angle * angle)
            values += [value * scale] * (theta_difference * phi_difference)
    with open(path, "wb") as out:
        out.write(struct.pack("<3i", theta_half, theta_difference, phi_difference))
        out.write(struct.pack("<%dd" % len(values), *values))


def numbers_apart(ours, theirs):
    """The greatest difference of two files of JSON, whose words must be the same."""
    texts = [json.dumps(json.loads(open(path, encoding="utf-8").read())) for path in (ours, theirs)]
    words = [k_number.sub("#", text) for text in texts]
    if words[0] != words[1]:
        at = next((i for i, (a, b) in enumerate(zip(*words)) if a != b), min(map(len, words)))
        return "other words: %r, %r" % (words[0][at - 60:at + 60], words[1][at - 60:at + 60])
    first, second = ([float(x) for x in k_number.findall(text)] for text in texts)
    return max(abs(a - b) for a, b in zip(first, second))


def check_package(node, folder, work):
    """What npm packs works in a project that has nothing else."""
    npm = shutil.which("npm")
    if not npm:
        print("not tried without npm: the package in an empty project")
        return
    project = os.path.join(work, "project")
    os.makedirs(project)
    packed = json.loads(subprocess.run([npm, "pack", "--json", "--pack-destination", work, os.path.abspath(folder)],
                                       check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout)[0]
    with open(os.path.join(project, "package.json"), "w", encoding="utf-8") as out:
        out.write('{"private": true, "type": "module"}')
    run(npm, "install", "--prefix", project, "--offline", "--no-audit", "--no-fund", os.path.join(work, packed["filename"]))
    with open(os.path.join(project, "use.js"), "w", encoding="utf-8") as out:
        out.write("import {loadOpenltc} from 'openltc';\nconsole.log((await loadOpenltc()).fit({size: 4}).columns);\n")
    print("npm pack: %d files, %d KiB" % (len(packed["files"]), packed["size"] / 1024))
    if run(node, os.path.join(project, "use.js")).strip() != "4":
        print("FAILED: the installed package does not fit")
        sys.exit(1)


def check_types(node, work):
    """A program of TypeScript compiles beside the installed package."""
    why = npm_packages.install(os.path.join(k_here, "releases"), os.path.join(os.path.dirname(work), "releases"))
    if why:
        skip(why)
    project = os.path.join(work, "project")
    with open(os.path.join(project, "program.ts"), "w", encoding="utf-8") as out:
        out.write(k_program)
    run(node, os.path.join(os.path.dirname(work), "releases/node_modules/typescript/bin/tsc"), "--noEmit", "--strict", "--target", "es2022",
        "--lib", "es2022,dom", "--module", "nodenext", os.path.join(project, "program.ts"))
    print("a TypeScript program that uses all of it compiles")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--openltc", required=True)
    parser.add_argument("--package", required=True)
    parser.add_argument("--work", required=True)
    parser.add_argument("--types", action="store_true", help="a TypeScript program too")
    arguments = parser.parse_args()
    arguments.openltc = os.path.abspath(arguments.openltc)
    node = shutil.which("node")
    if not node:
        skip("node not found (package nodejs)")
    module = os.path.abspath(os.path.join(arguments.package, "openltc.wasm"))
    if not os.path.exists(module):
        skip("%s is not there; make web builds it, with clang-22" % module)
    work = os.path.abspath(arguments.work)
    shutil.rmtree(work, ignore_errors=True)
    native = os.path.join(work, "native")
    for name in k_layouts + ("containers", "two-lobe", "o3de_engine", "merl", "full"):
        os.makedirs(os.path.join(native, name))
    merl = os.path.join(native, "made.binary")
    write_merl(merl)

    print(run(node, "--version").strip(), end=" ")
    out = run(node, os.path.join(k_here, "openltc.mjs"), arguments.package, work, merl)
    facts = json.loads(out.strip().splitlines()[-1])

    def fit(*options):
        return run(arguments.openltc, "fit", "--quiet", *options)

    for layout in k_layouts:
        fit("--size", "16", "--layout", layout, "-o", os.path.join(native, layout, "table.json"))
    fit("--form", "two-lobe", "--size", "8", "-o", os.path.join(native, "two-lobe", "table.json"))
    os.chdir(native)
    fit("--brdf", "made.binary", "--size", "16", "-o", os.path.join(native, "merl", "table.json"))
    fit("--size", "64", "-o", os.path.join(native, "full", "table.json"))
    seconds = min(float(re.search(r"fitted ggx in ([\d.]+) s", run("taskset", "-c", "0", arguments.openltc, "fit")).group(1))
                  for _ in range(3))

    failures = 0
    for name in k_layouts + ("two-lobe", "merl", "full"):
        apart = numbers_apart(os.path.join(work, name, "table.json"), os.path.join(native, name, "table.json"))
        bad = isinstance(apart, str) or apart > k_apart
        failures += bad
        print("%s%s: %s from the native table" % ("FAILED " if bad else "", name,
                                                  apart if isinstance(apart, str) else "%.1e" % apart))
    for name in sorted(os.listdir(os.path.join(work, "containers"))):
        path = os.path.join(work, "containers", name)
        if name.endswith((".dds", ".ktx2", ".exr", ".npy")) and "_2" not in name:
            text = run(arguments.openltc, "inspect", path)
            if "ggx" not in text:
                failures += 1
                print("FAILED inspect %s says:\n%s" % (name, text))
    for name in k_layouts + ("two-lobe", "merl", "full"):
        run(arguments.openltc, "inspect", os.path.join(work, name, "table.json"))
    for name in ("ltc_mat_lutrgba32f.dds", "ltc_amp_lutrg32f.dds"):
        if os.path.getsize(os.path.join(work, "o3de", name)) < 8000:
            failures += 1
            print("FAILED o3de/%s is too short" % name)

    check_package(node, os.path.dirname(module), work)
    if arguments.types:
        check_types(node, work)
    size = os.path.getsize(module)
    packed = len(gzip.compress(open(module, "rb").read(), 9))
    print("openltc.wasm: %d KiB, %d KiB gzip; memory %.1f MiB after 200 refits" %
          (size / 1024, packed / 1024, facts["memory"] / 2**20))
    print("64 x 64: %.2f s, BRDF in JavaScript %.2f s; native, on one core %.2f s; the best of three each" %
          (facts["seconds"], facts["seconds_own"], seconds))
    sys.exit(1 if failures or facts["failures"] else 0)


if __name__ == "__main__":
    main()
