#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Packs the npm package of web/three, installs it into an empty project, and imports its entries in Node.

    pack.py --openltc PROGRAM --work DIR [--types]

--types: a TypeScript program that uses both entries compiles too, by the compiler of tests/web/releases.

Exit code 0: the package is as it should be; 1: it is not; 77: nothing could run, and why."""

import argparse
import json
import os
import shutil
import subprocess
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
k_root = os.path.dirname(os.path.dirname(k_here))
sys.path[:0] = [os.path.join(k_root, "tests", "engines"), os.path.join(k_root, "tools", "npm")]
import npm_packages
from engines import run, skip

k_source = os.path.join(k_root, "web", "three")
# What build.mjs adds to the sources, and what of them is not for users.
k_made = {"LICENSE", "shaders_glsl.js", "shaders_wgsl.js"}
k_left = {"branchless.mjs", "build.mjs"}

# Which names an entry has, beside those that its declarations have.
k_names = """
import {readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
const declared = entry => {
  const text = readFileSync(fileURLToPath(new URL('node_modules/openltc-three/' + entry + '.d.ts', import.meta.url)), 'utf8');
  const own = [...text.matchAll(/^export (?:class|function|const) (\\w+)/gm)].map(m => m[1]);
  const others = [...text.matchAll(/^export \\* from '\\.\\/(\\w+)\\.js'/gm)].flatMap(m => declared(m[1]));
  return [...new Set([...own, ...others])].sort();
};
const three = await import('three');
const entries = {index: 'openltc-three', webgpu: 'openltc-three/webgpu', shadows: 'openltc-three/shadows',
                 webgpu_shadows: 'openltc-three/webgpu/shadows'};
for (const file of process.argv.slice(2)) {
  const names = await import(entries[file]), found = Object.keys(names).sort();
  if (found.join() !== declared(file).join())
    throw new Error(`${entries[file]} exports ${found}; its types declare ${declared(file)}`);
  if (file.endsWith('shadows')) {
    names.enableAreaShadows(new three.Scene()).dispose();
    continue;
  }
  const light = new names.RectLight(0xffffff, 1, 2, 3);
  light.power = 6 * Math.PI;
  if (!(light instanceof three.Light) || Math.abs(light.luminance - 1) > 1e-12)
    throw new Error(`${entries[file]}: a RectLight is no light of the three.js beside it`);
  names.enableAreaLights(new three.Scene().add(light)).dispose();
}
"""

k_program = """
import {Scene, type Light} from 'three';
import * as webgl from 'openltc-three';
import * as webgpu from 'openltc-three/webgpu';
import {enableAreaShadows} from 'openltc-three/shadows';
import * as webgpuShadows from 'openltc-three/webgpu/shadows';
const lights: Light[] = [new webgl.RectLight(0xffffff, 1, 2, 3, true), new webgpu.TubeLight('red', 1, 1, 0.1, 'flat'),
                         new webgl.PolygonLight(0xffffff, 1, [[0, 0], [1, 0], [0, 1]])];
const scene = new Scene().add(...lights, new webgl.AreaLightHelper(new webgl.LineLight()));
for (const {enableAreaLights} of [webgl, webgpu]) enableAreaLights(scene).dispose();
if (enableAreaShadows(scene, {frames: 64}).frame === 0) lights[0].castShadow = true;
webgpuShadows.enableAreaShadows(scene).reset();
// @ts-expect-error: no such caps
new webgl.TubeLight('red', 1, 1, 0.1, 'square');
"""


def write(path, text):
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def pack(openltc, work):
    """The archive's path, after a look at what is in it."""
    folder = work + "/package"
    shutil.rmtree(folder, ignore_errors=True)
    run(shutil.which("node"), k_source + "/build.mjs", openltc, folder)
    packed = json.loads(subprocess.run([shutil.which("npm"), "pack", "--json", "--pack-destination", work], cwd=folder,
                                       check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout)[0]
    files = {one["path"] for one in packed["files"]}
    expected = k_made | set(os.listdir(k_source)) - k_left
    if files != expected:
        sys.exit("the package has other files than web/three: %s" % ", ".join(sorted(files ^ expected)))
    with open(k_source + "/package.json", encoding="utf-8") as stream:
        description = json.load(stream)
    for entry in description["exports"].values():
        for name in entry.values():
            if name[2:] not in files:
                sys.exit("package.json names %s, which the package does not have" % name)
    needed = set(description["peerDependencies"]) - set(description["peerDependenciesMeta"])
    if "dependencies" in description or needed != {"three"}:
        sys.exit("three must be the one package that is needed, and a peer")
    print("%s: %d files, %d kB packed" % (packed["filename"], len(files), packed["size"] // 1000))
    return os.path.join(work, packed["filename"])


def install(project, *packages):
    """Into a project without anything of its own."""
    if not os.path.exists(project):
        os.makedirs(project)
        write(project + "/package.json", json.dumps({"name": "empty", "private": True, "type": "module"}))
    run(shutil.which("npm"), "install", "--prefix", project, "--offline", "--ignore-scripts", "--no-audit", "--no-fund",
        *packages)
    if os.path.isdir(project + "/node_modules/openltc-three/node_modules"):
        sys.exit("the package brought a three.js of its own")
    run(shutil.which("npm"), "ls", "--prefix", project)  # a peer that is missing or too old fails


def main():
    parser = argparse.ArgumentParser(description="Installs the npm package of web/three into an empty project.")
    parser.add_argument("--openltc", required=True)
    parser.add_argument("--work", required=True, help="folder for what is made on the way")
    parser.add_argument("--types", action="store_true", help="a TypeScript program too")
    arguments = parser.parse_args()
    work = os.path.abspath(arguments.work)
    why = npm_packages.install(k_here, work + "/out/web")
    if arguments.types:
        why = why or npm_packages.install(k_here + "/releases", work + "/releases")
    if why:
        skip(why)
    project, modules = work + "/project", work + "/out/web/node_modules/"
    shutil.rmtree(project, ignore_errors=True)
    install(project, pack(arguments.openltc, work), modules + "three")
    write(project + "/names.mjs", k_names)
    run(shutil.which("node"), project + "/names.mjs", "index", "webgpu")
    install(project, modules + "three-mesh-bvh")
    run(shutil.which("node"), project + "/names.mjs", "shadows", "webgpu_shadows")
    print("installed beside three.js alone, two entries; with three-mesh-bvh, two more")
    if arguments.types:
        modules = work + "/releases/node_modules"
        shutil.copytree(modules + "/@types", project + "/node_modules/@types")
        for name in os.listdir(modules):
            if not os.path.exists(project + "/node_modules/" + name):
                os.symlink(modules + "/" + name, project + "/node_modules/" + name)
        write(project + "/program.ts", k_program)
        run(shutil.which("node"), modules + "/typescript/bin/tsc", "--noEmit", "--strict", "--skipLibCheck",
            "--target", "es2022", "--module", "nodenext", project + "/program.ts")
        print("a TypeScript program with all entries compiles")


if __name__ == "__main__":
    main()
