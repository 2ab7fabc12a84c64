#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Shows scenes by three.js with the lights of web/three, in a browser without a window, and compares the pictures
with those of `openltc render`, which reads the same files.

    three.py --openltc PROGRAM --work DIR [--all] [--spoil] [--picture PNG]

A scene is the stage of tools/make_light_shapes.py under lights of openltc_light and EXT_lights_area. The page
reads them by the package's plugin, or, for the figure beside ours, three's own RectAreaLight. Pictures are radiance as floats. They
are compared as a screen shows them: times an exposure, clipped at white, sRGB, in steps of 255.

--all: each renderer of each release of three.js draws each scene, not some of them the newest alone.

--spoil: one light of each scene is mirrored for openltc render alone, so that the check must fail.

Exit code 0: all pictures agree; 1: one does not; 77: nothing could run, and why."""

import argparse
import json
import math
import os
import shutil
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
k_root = os.path.dirname(os.path.dirname(k_here))
sys.path[:0] = [os.path.join(k_root, "tests", "parity"), os.path.join(k_root, "tests", "engines"),
                os.path.join(k_root, "tools"), os.path.join(k_root, "tools", "npm")]
import browser
import npm_packages
from demo_scene import glb
from engines import read_exr, read_rows, run, skip
from scenes import k_scenes, mirrored, write_picture, write_scene

k_example, k_react = "docs/examples/web/three.html", "docs/examples/web/react.jsx"

# Steps of 255: in the mean, without the pixels in which the two draw another surface. Measured: 0.05 at most.
k_mean = 0.1
# Such pixels are off by more than so many steps: edges of triangles go to the nearest 256th of a pixel in WebGL.
# Measured: 19 at most.
k_edge, k_edges = 8, 60
# Which scenes the page reads and writes anew, and how far `openltc render` of what it wrote may be off, over all
# pixels. Measured: 0.00001.
k_rewritten = ("gltf", "picture", "polygon", "ellipse", "tube_flat", "line")
k_rewritten_mean = 0.001
# Which scenes are drawn with shadows, after how many pictures, in what size, and how far they may be off by FLIP, and
# by which share of what they would be off without. Measured: 0.006 and 0.021; a fifth and a fourth.
k_shaded, k_shaded_all = {"rect": 16}, ("polygon", "ellipse", "sphere", "tube_round", "line", "gltf", "picture")
k_shaded_size, k_all_frames, k_flip, k_flip_share = (168, 112), 32, 0.03, 0.35
# Between a picture with a point light of three's own and the sum of those with one kind, in shares. Measured: 3e-8.
k_both = 1e-5
# What three's own rectangle must be off by at least, or the measure sees nothing. Measured: 6.
k_theirs = 1.0


# Renderers: three.js's WebGLRenderer, and its WebGPURenderer on WebGPU and on WebGL 2; and what they draw in a hurry.
k_renderers = {"webgl": list(k_scenes), "webgpu": ["rect", "gltf", "coat"], "webgpu_gl": ["polygon"]}
# Folders of three.js: the newest is that of `make web`.
k_newest = "out/web/node_modules/three"
k_releases = ("three-186", "three-182")


def size_of(scene):
    """Width and height; the software driver takes seconds for many lights."""
    return {"rect": (480, 320), "many": (180, 120), "round": (120, 80)}.get(scene, (240, 160))


def jobs_of(scenes):
    """Which files the page draws: by each renderer its scenes, and three's own rectangle."""
    jobs = []
    for renderer, names in scenes.items():
        jobs += [dict(name="%s, %s" % (renderer, name), scene=name, renderer=renderer, own=True) for name in names]
        jobs.append(dict(name="%s, three's own rect" % renderer, scene="rect", renderer=renderer, own=False))
    jobs.append(dict(name="webgl, gltf rewritten", scene="gltf", file="rewritten_gltf.bin", renderer="webgl", own=True))
    return [dict({"file": job["scene"] + ".glb"}, **job, task="draw", size=size_of(job["scene"]),
                 alone=job["renderer"] == "webgl" or job["scene"] == "rect") for job in jobs]


def judge_rewritten(openltc, work, scene, expected, answer):
    """What is wrong with a file that the page wrote, in words."""
    if "failed" in answer:
        return ["%s rewritten: %s" % (scene, answer["failed"])]
    path = os.path.join(work, "rewritten_%s.glb" % scene)
    shutil.move(os.path.join(work, "rewritten_%s.bin" % scene), path)
    whole, mean, edges, _ = compare(rendered(openltc, path, path + ".exr", size_of(scene)), expected)
    print("%s rewritten: openltc render is off by %.4f of 255 in the mean, by %.5f without %d pixels"
          % (scene, whole, mean, edges), flush=True)
    return [] if whole <= k_rewritten_mean else [
        "%s rewritten is another scene; the bound is %g" % (scene, k_rewritten_mean)]


def write_png(path, rows, exposure):
    with open(path, "wb") as stream:
        stream.write(glb.png(len(rows[0]) // 3, len(rows), 3,
                             (bytes(round(shown(x, exposure)) for x in row) for row in rows)))


def judge_shaded(openltc, work, scene, renderer, frames, answer):
    """What is wrong with a picture with shadows, in words. FLIP is of the displayed pictures."""
    name = "%s, %s with shadows" % (renderer, scene)
    if "failed" in answer:
        return ["%s: %s" % (name, answer["failed"])]
    rows = read_rows(os.path.join(work, "%s shaded %s.bin" % (renderer, scene)), k_shaded_size, 4, True)
    plain, expected = (rendered(openltc, "%s/%s.glb" % (work, scene), work + "/shaded.exr", k_shaded_size, samples)
                       for samples in (0, 256))
    paths = [os.path.join(work, "shaded_%s_%s.png" % (scene, one)) for one in (renderer, "plain", "expected")]
    for path, picture in zip(paths, (rows, plain, expected)):
        write_png(path, picture, exposure_of(expected))
    flip, without = (json.loads(run(openltc, "compare", "--json", path, paths[2]))["flip"]["mean"] for path in paths[:2])
    print("%s: FLIP %.4f after %d pictures, %.4f without; %.0f ms for the first, %.0f for each of the others"
          % (name, flip, frames, without, answer["ms"], answer["rest"] / (frames - 1)), flush=True)
    bound = min(k_flip, k_flip_share * without)
    return [] if flip <= bound else ["%s differs from openltc render; the bound is %g" % (name, bound)]


def judge_both(renderer, answer):
    """What is wrong with lights of ours beside three's own, in words."""
    name = "%s, beside a point light" % renderer
    if "failed" in answer:
        return ["%s: %s" % (name, answer["failed"])]
    print("%s: off by %.1e of the sum of both pictures" % (name, answer["difference"]))
    fair = answer["difference"] <= k_both and min(answer["ours"], answer["theirs"]) > 0.1
    return [] if fair else ["%s: the picture is not the sum; the bound is %g" % (name, k_both)]


def judge_changes(renderer, shadows, answer):
    """What is wrong with pictures after a change, in words."""
    name = "%s, changes%s" % (renderer, " with shadows" if shadows else "")
    if "failed" in answer:
        return ["%s: %s" % (name, answer["failed"])]
    off, changed = max(s["off"] for s in answer["steps"]), min(s["changed"] for s in answer["steps"])
    print("%s: off by %.1e of a scene that never was another; each changes %.1f of 100 at least" % (name, off, 100 * changed))
    return [] if off <= k_both and changed > (2 * k_both if shadows else 0.005) else ["%s: a change is not seen; the bound is %g" % (name, k_both)]


def make_page(work, three):
    """The page for that folder of three.js below `work`."""
    with open(os.path.join(k_here, "three.html"), encoding="utf-8") as stream:
        text = stream.read()
    page = os.path.join(work, "page.html")
    with open(page, "w", encoding="utf-8") as stream:
        stream.write(text.replace("/THREE/", "/%s/" % three))
    return page


def make_package(openltc, work):
    """What `make web` makes, and the example, where the pages look for them."""
    shutil.rmtree(work + "/out/web/openltc-three", ignore_errors=True)
    run(shutil.which("node"), os.path.join(k_root, "web/three/build.mjs"), openltc, work + "/out/web/openltc-three")
    shutil.copyfile(os.path.join(k_root, k_example), work + "/three.html")


def make_react_page(work):
    """The example for React as a page of one script, by a bundler."""
    modules = work + "/releases/node_modules/"
    run(modules + ".bin/esbuild", os.path.join(k_root, k_react), "--bundle", "--minify", "--format=esm", "--jsx=automatic",
        "--alias:openltc-three=%s/out/web/openltc-three" % work, "--alias:three=" + modules + "three",
        "--alias:three-mesh-bvh=%s/out/web/node_modules/three-mesh-bvh" % work,
        *("--alias:%s=%s%s" % (name, modules, name) for name in ("react", "react-dom", "@react-three/fiber")),
        "--outfile=%s/react.js" % work)
    with open(work + "/react.html", "w", encoding="utf-8") as stream:
        stream.write("<!doctype html><meta charset='utf-8'><title>OpenLTC in React</title>\n"
                     "<style>html, body, main { margin: 0; height: 100%; background: #000; }</style><main></main>\n"
                     "<script type='module' src='react.js'></script>\n")


def judge_example(name, facts, pixels, picture):
    """What is wrong with an example's page, in words. Writes it to `picture`, unless that is empty."""
    if "failed" in facts:
        return ["%s: %s" % (name, facts["failed"])]
    print("%s: %.0f of 100 pixels are lit" % (name, 100 * facts["lit"]))
    if picture:
        with open(pixels, "rb") as stream:
            data = stream.read()
        row = 4 * facts["width"]
        with open(picture, "wb") as out:
            out.write(glb.png(facts["width"], facts["height"], 3, (
                bytes(x for k in range(y, y + row, 4) for x in data[k:k + 3]) for y in range(0, len(data), row))))
    # Without area lights only the lamps' meshes are seen, a thirtieth of it.
    return [] if facts["lit"] > 0.3 else ["%s: its picture is dark" % name]


def rendered(openltc, scene, picture, size, shadow_samples=0):
    run(openltc, "render", scene, "--lobes", "polynomial", "--specular", "lobe", "--samples", "1", "--filter", "none",
        "--shadow-samples", str(shadow_samples), "--size", "%dx%d" % size, "-o", picture)
    return read_exr(picture)


def shown(radiance, exposure):
    """0 to 255, as a screen is given it."""
    x = min(max(radiance * exposure, 0.0), 1.0)
    return 255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055)


def exposure_of(rows):
    """By which 2 in 100 are white."""
    values = sorted(x for row in rows for x in row)
    return 1 / values[int(0.98 * len(values))]


def compare(rows, expected):
    """Mean difference in steps of 255, that without edges, how many pixels those are, how many are lit."""
    exposure = exposure_of(expected)
    whole, rest, edges, lit = 0.0, 0.0, 0, 0
    for row, right in zip(rows, expected):
        a, b = ([shown(x, exposure) for x in one] for one in (row, right))
        for k in range(0, len(a), 3):
            differences = [abs(a[k + c] - b[k + c]) for c in range(3)]
            whole += sum(differences)
            lit += max(b[k:k + 3]) > 8
            if max(differences) > k_edge:
                edges += 1
            else:
                rest += sum(differences)
    count = len(rows) * len(rows[0])
    return whole / count, rest / (count - 3 * edges), edges, lit


def judge(name, own, rows, expected, facts):
    """What is wrong, in words."""
    if not math.isfinite(sum(map(sum, rows))):
        return ["%s: infinite, or no number" % name]
    whole, mean, edges, lit = compare(rows, expected)
    pixels = len(rows) * len(rows[0]) // 3
    print("%s: off by %.3f of 255 in the mean, by %.4f without %d pixels of %d; %d are lit; %.0f ms to compile and draw"
          % (name, whole, mean, edges, pixels, lit, facts["ms"]), flush=True)
    if facts["elsewhere"] or facts["afterwards"]:
        return ["%s: light of %g in a scene that has none, of %g after the end" % (name, facts["elsewhere"], facts["afterwards"])]
    if lit < 0.2 * pixels:
        return ["%s: the scene is too dark to tell" % name]
    if not own:
        return [] if whole >= k_theirs else ["%s: as good as ours, or the measure sees nothing" % name]
    return [] if mean <= k_mean and edges <= k_edges else [
        "%s differs from openltc render; bounds are %g and %d" % (name, k_mean, k_edges)]


def check(program, openltc, work, three, pages, scenes, shaded, expected, picture):
    """Draws the scenes by a release of three.js. What is wrong, in words."""
    jobs, rewrites = jobs_of(scenes), {"rewritten_" + name: name for name in k_rewritten}
    posts = ([{"name": name, "task": "rewrite", "file": scene + ".glb"} for name, scene in rewrites.items()] + jobs
             + [dict(name="%s shaded %s" % (renderer, scene), task="shade", file=scene + ".glb", renderer=renderer,
                     frames=frames, size=k_shaded_size) for renderer in scenes for scene, frames in shaded.items()]
             + [dict(name="both_" + renderer, task="add", file="rect.glb", renderer=renderer, size=(120, 80))
                for renderer in scenes]
             + [dict(name="change_%s_%d" % (renderer, frames), task="change", file="picture.glb", renderer=renderer,
                     size=(60, 40), frames=frames) for renderer in scenes for frames in (0, 2)]
             + [{"name": "example_" + page, "task": "open", "page": "/%s.html" % page} for page in pages])
    answers = browser.run(program, make_page(work, three), work, posts, root=work, timeout=900)
    if "start" in answers:
        (skip if answers["start"]["failed"].startswith("no WebGL2") else sys.exit)(answers["start"]["failed"])
    late = {"failed": "no answer in time"}
    failures = []
    for page, source in pages.items():
        pixels = work + "/example_%s.bin" % page
        failures += judge_example(source, answers.get("example_" + page, late), pixels, picture if page == "three" else "")
    for job in jobs:
        name, scene = job["name"], job["scene"]
        answer = answers.get(name, late)
        if "failed" in answer:
            failures.append("%s: %s" % (name, answer["failed"]))
        else:
            rows = read_rows(os.path.join(work, name + ".bin"), size_of(scene), 4, True)
            failures += judge(name, job["own"], rows, expected[scene], answer)
    for name, scene in rewrites.items():
        failures += judge_rewritten(openltc, work, scene, expected[scene], answers.get(name, late))
    for renderer in scenes:
        failures += judge_both(renderer, answers.get("both_" + renderer, late))
        for frames in (0, 2):
            failures += judge_changes(renderer, frames > 0, answers.get("change_%s_%d" % (renderer, frames), late))
        for scene, frames in shaded.items():
            failures += judge_shaded(openltc, work, scene, renderer, frames,
                                     answers.get("%s shaded %s" % (renderer, scene), late))
    return failures


def main():
    parser = argparse.ArgumentParser(description="Compares three.js under our lights with openltc render.")
    parser.add_argument("--openltc", required=True)
    parser.add_argument("--work", required=True, help="folder for what is made on the way")
    parser.add_argument("--all", action="store_true", help="all scenes by all renderers of all releases of three.js")
    parser.add_argument("--spoil", action="store_true", help="mirror a light, to see the check fail")
    parser.add_argument("--picture", default="", help="docs/images/web.png: the example's page")
    arguments = parser.parse_args()
    work = os.path.abspath(arguments.work)
    program = browser.find()
    if not program:
        skip("no chromium (package chromium)")
    os.makedirs(work, exist_ok=True)
    why = npm_packages.install(k_here, work + "/out/web")
    if arguments.all:
        why = why or npm_packages.install(k_here + "/releases", work + "/releases")
    if why:
        skip(why)
    make_package(arguments.openltc, work)
    write_picture(work + "/picture.png")
    expected = {}
    for name, lights in k_scenes.items():
        write_scene(name, mirrored(lights) if arguments.spoil else lights, work + "/scene.glb", False)
        expected[name] = rendered(arguments.openltc, work + "/scene.glb", work + "/%s.exr" % name, size_of(name))
        write_scene(name, lights, work + "/%s.glb" % name, True)
    scenes = {renderer: list(k_scenes) for renderer in k_renderers} if arguments.all else k_renderers
    shaded = dict(k_shaded, **{scene: k_all_frames for scene in k_shaded_all}) if arguments.all else k_shaded
    pages = {"three": k_example}
    if arguments.all:
        make_react_page(work)
        pages["react"] = k_react
    failures = check(program, arguments.openltc, work, k_newest, pages, scenes, shaded, expected, arguments.picture)
    for release in k_releases if arguments.all else ():
        print(release)
        failures += check(program, arguments.openltc, work, "releases/node_modules/" + release, {}, scenes, k_shaded,
                          expected, "")
    for failure in failures:
        print(failure, file=sys.stderr)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
