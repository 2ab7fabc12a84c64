#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Uses the viewer of web/app in a browser without a window, by real keys, pointer and files, and compares its picture
with that of `openltc render`.

    viewer.py --openltc PROGRAM [--app FOLDER] --work DIR [--short]

All of it by WebGL 2; what a renderer does by WebGPU once more. FOLDER is what `make web` makes; without it the page
is built below DIR. --short: what takes a minute: no rays, few loads, no `openltc view`. Exit code 0: all is well; 1: it is not; 77: nothing could run, and why."""

import base64
import json
import os
import shutil
import signal
import subprocess
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
k_root = os.path.dirname(os.path.dirname(k_here))
sys.path[:0] = [k_here, os.path.join(k_root, "tests", "parity"), os.path.join(k_root, "tests", "engines"),
                os.path.join(k_root, "tools"), os.path.join(k_root, "tools", "npm")]
from app_pages import build_viewer, size_of_viewer
from bad_files import bad_files
from devtools import Page, Server, app_arguments
from engines import read_exr, run
from scenes import k_scenes, write_scene
from three import shown

k_size = (820, 560)
# Steps of 255, in the mean, without edges, which the page smooths and the other does not.
k_mean, k_edge, k_edges = 0.3, 8, 0.05
# By each graphics: loads of a file, and rays of the reference, whose noise is a part of the error.
k_loads = {"WebGL 2": 50, "WebGPU": 10}
k_rays = {"WebGL 2": 128, "WebGPU": 64}
# Files of one scene by compressed meshes and pictures, and how far from the plain one they may be, in steps of 255: in
# the mean, and for 99 values of 100. Measured: a half of it or less, but for ETC1S (1.5, 8), which has one colour of 5
# bits a channel for 4 x 4 texels, in steps of brightness.
k_compressed = {"draco": (0.05, 2), "meshopt": (0.05, 2), "webp": (0.01, 0), "ktx2_uastc": (0.6, 4), "ktx2_etc1s": (2, 10)}
k_failures = []


def check(holds, what):
    if not holds:
        k_failures.append(what)
        print("FAILED " + what, flush=True)


def ready(page, name):
    """Waits until a scene is shown, and stands still."""
    page.until("document.getElementById('list').dataset.scene === %s" % json.dumps(name), "the scene " + name, 120)
    page.until("viewer.isStill", "a picture of " + name, 120)


def drop(page, path):
    """A file from outside, onto the picture."""
    data = {"items": [], "files": [path], "dragOperationsMask": 1}
    for kind in ("dragEnter", "dragOver", "drop"):
        page.call("Input.dispatchDragEvent", type=kind, x=300, y=300, data=data)


def message_after(page, path, word):
    """What the page says of a file that it does not show."""
    drop(page, path)
    page.until("!document.getElementById('message').hidden && document.getElementById('message').textContent.includes(%s)"
               % json.dumps(word), "a message with \"%s\"" % word, 60)
    return page.evaluate("document.getElementById('message').textContent")


def tab_to(page, condition, what, most=60):
    """Presses Tab until the element that has the focus is the one."""
    for _ in range(most):
        if page.evaluate("(e => Boolean(%s))(document.activeElement)" % condition):
            return True
        page.key("Tab")
    check(False, "Tab reaches " + what)
    return False


def picture(page):
    """Width, height and the bytes of what "Picture, .png" gives."""
    answer = page.evaluate("""new Promise(done => {
      addEventListener('taken', async ({detail}) => {
        const image = await createImageBitmap(detail.blob), canvas = new OffscreenCanvas(image.width, image.height);
        canvas.getContext('2d').drawImage(image, 0, 0);
        const {data} = canvas.getContext('2d').getImageData(0, 0, image.width, image.height);
        let text = '';
        for (let i = 0; i < data.length; i += 4) text += String.fromCharCode(data[i], data[i + 1], data[i + 2]);
        done([image.width, image.height, btoa(text)]);
      }, {once: true});
      document.getElementById('save-png').click();
    })""")
    return answer[0], answer[1], base64.b64decode(answer[2])


def saved_scene(page, path):
    """Writes what "Scene, .glb" gives."""
    answer = page.evaluate("""new Promise((done, failed) => {
      addEventListener('taken', async ({detail}) => {
        const reader = new FileReader();
        reader.onload = () => done(reader.result.split(',')[1]);
        reader.readAsDataURL(detail.blob);
      }, {once: true});
      document.getElementById('save-glb').click();
    })""")
    with open(path, "wb") as stream:
        stream.write(base64.b64decode(answer))


def light(page, k=0):
    return json.loads(page.evaluate("""JSON.stringify((l => ({place: l.position.toArray(), width: l.width, height: l.height,
        nits: l.luminance, color: l.color.toArray(), two: l.twoSided}))(viewer.pictures.lights[%d]))""" % k))


def step_files(page, work):
    drop(page, work + "/rect.glb")
    ready(page, "rect.glb")
    check(page.evaluate("document.getElementById('list').children.length") == 1, "a file that is dropped has its light")
    for path, word in bad_files(work):
        text = message_after(page, path, word)
        check(os.path.basename(path) in text and text.endswith(".") and "undefined" not in text, "the message: " + text)
        check(page.evaluate("viewer.pictures.lights.length") == 1, "the scene stays after " + path)
    drop(page, work + "/dark.glb")
    ready(page, "dark.glb")
    check("studio rig" in page.evaluate("document.getElementById('notes').textContent"), "a scene without lights has a rig")
    drop(page, work + "/rect.glb")
    ready(page, "rect.glb")
    check(page.evaluate("document.getElementById('message').hidden"), "a file that is read takes the message away")


def step_compressed(page):
    """The scene of tests/web/compressed, by each decoder, and its picture beside that of the plain file."""
    pictures = {}
    for name in ["plain", *k_compressed]:
        drop(page, os.path.join(k_here, "compressed", name + ".glb"))
        ready(page, name + ".glb")
        notes = page.evaluate("[document.getElementById('message').textContent, document.getElementById('notes').textContent].join('')")
        check(not notes and page.evaluate("viewer.pictures.lights.length") == 1, "%s is read whole: %s" % (name, notes))
        page.evaluate("(document.getElementById('exposure').value = 5, document.getElementById('exposure').dispatchEvent(new Event('input')))")
        pictures[name] = picture(page)[2]
    plain = pictures["plain"]
    check(sum(plain) / len(plain) > 20, "the plain file's picture is not dark")
    for name, (most_mean, most_off) in k_compressed.items():
        off = sorted(abs(a - b) for a, b in zip(pictures[name], plain))
        mean, most = sum(off) / len(off), off[len(off) * 99 // 100]
        print("%s beside the plain file: off by %.3f of 255 in the mean, 99 of 100 by %d at most" % (name, mean, most), flush=True)
        check(mean <= most_mean and most <= most_off, "%s shows the plain file's picture" % name)


def step_keys(page):
    page.evaluate("document.activeElement.blur()")
    before = light(page)
    if tab_to(page, "e.closest('#list')", "the list of lights"):
        page.key("Enter")
    if tab_to(page, "e.id === 'place-x'", "the place of a light"):
        page.type("0.25")
        page.key("Tab")
        page.type("0.35") # where the camera sees it
        page.key("Tab")
    check(abs(light(page)["place"][0] - 0.25) + abs(light(page)["place"][1] - 0.35) < 1e-6, "a number that is typed moves a light: %s" % light(page))
    if tab_to(page, "e.id === 'size-width'", "the width of a light"):
        page.key("ArrowUp")
    check(abs(light(page)["width"] - before["width"] - 0.01) < 1e-6, "an arrow key widens a light: %s" % light(page))
    if tab_to(page, "e.id === 'luminance'", "the luminance"):
        page.type("-5")
        check(light(page)["nits"] == 3, "a luminance below 0 is not taken: %s" % light(page))
        page.key("Tab")
        check(page.evaluate("document.getElementById('luminance').value") == "3", "and is written over")
    if tab_to(page, "e.id === 'two-sided'", "both sides"):
        page.key(" ")
    check(light(page)["two"] is True, "the space bar makes a light of two sides")
    page.key(" ")
    page.evaluate("document.activeElement.blur()")
    place = page.evaluate("viewer.camera.position.toArray()")
    if tab_to(page, "e.id === 'canvas'", "the picture"):
        page.key("ArrowLeft")
    moved = page.evaluate("viewer.camera.position.toArray()")
    check(moved != place and abs(sum(a * a for a in moved) - sum(a * a for a in place)) < 4, "an arrow key turns the camera")


def step_drag(page):
    page.evaluate("viewer.canvas.scrollIntoView()")
    page.until("viewer.isStill", "a picture", 120)
    # Along the x axis of the handles, until the page says that it is held.
    at = json.loads(page.evaluate("""JSON.stringify((() => {
      const box = viewer.canvas.getBoundingClientRect(), {position} = viewer.pictures.lights[0];
      return [0, 0.2].map(x => position.clone().setX(position.x + x).project(viewer.camera))
          .map(p => [box.x + (p.x + 1) / 2 * box.width, box.y + (1 - p.y) / 2 * box.height]);
    })())"""))
    along = [b - a for a, b in zip(*at)]
    length = sum(a * a for a in along) ** 0.5
    for far in range(12, 60, 3):
        begin = [a + d / length * far for a, d in zip(at[0], along)]
        page.pointer("mouseMoved", *begin, held=False)
        if page.evaluate("viewer.gizmo.axis") == "X":
            break
    check(page.evaluate("viewer.gizmo.axis") == "X", "the pointer finds the handle of x, from %s along %s: %s" % (
        at[0], along, page.evaluate("[document.elementFromPoint(%f, %f)?.id, viewer.selected?.type, viewer.gizmo.enabled, scrollY].join()" % tuple(begin))))
    before = light(page)["place"]
    page.drag(begin, [a + d / length * 60 for a, d in zip(begin, along)])
    after = light(page)["place"]
    check(after[0] - before[0] > 0.05 and abs(after[1] - before[1]) + abs(after[2] - before[2]) < 1e-6,
          "a drag moves a light along x: from %s to %s" % (before, after))
    check(abs(float(page.evaluate("document.getElementById('place-x').value")) - after[0]) < 1e-3, "and the field says so")
    page.until("viewer.isStill", "a picture")


def step_lights(page):
    for kind in ("DiskLight", "PolygonLight", "SphereLight"):
        page.evaluate("(document.getElementById('kind').value = '%s', document.getElementById('add').click())" % kind)
        page.until("viewer.isStill", "a picture with a " + kind, 120)
        check(page.evaluate("viewer.selected.type") == kind, "a new light is chosen: " + kind)
        page.evaluate("document.getElementById('delete').click()")
    check(page.evaluate("viewer.pictures.lights.length") == 1, "lights are deleted")
    page.until("viewer.isStill", "a picture")


def step_saved(page, openltc, work, width_metres):
    """What the page saves is what it shows, for itself and for openltc render."""
    page.evaluate("(document.getElementById('tonemap').value = 'none', document.getElementById('tonemap').dispatchEvent(new Event('change')))")
    width, height, before = picture(page)
    path = os.path.join(work, "saved.glb")
    saved_scene(page, path)
    described = run(openltc, "inspect", path)
    check(described.count("\nlight ") == 1 and " %s x 0.5 m" % width_metres in described, "openltc inspect: " + described)
    exposure = page.evaluate("viewer.pictures.exposure")
    ev100 = page.evaluate("document.getElementById('exposure').value")
    drop(page, path)
    ready(page, "saved.glb")
    page.evaluate("(document.getElementById('exposure').value = %s, document.getElementById('exposure').dispatchEvent(new Event('input')))" % json.dumps(ev100))
    _, _, after = picture(page)
    worst = max(abs(a - b) for a, b in zip(before, after))
    check(len(before) == len(after) and worst <= 1, "the scene that was saved is the one that is shown: off by %d of 255" % worst)
    exr = path + ".exr"
    run(openltc, "render", path, "--lobes", "polynomial", "--specular", "lobe", "--samples", "1", "--filter", "none",
        "--shadow-samples", "0", "--size", "%dx%d" % (width, height), "-o", exr)
    whole, rest, edges = 0.0, 0.0, 0
    rows = read_exr(exr)
    for y, row in enumerate(rows):
        for x in range(width):
            off = [abs(shown(row[3 * x + c], exposure) - before[3 * (y * width + x) + c]) for c in range(3)]
            whole += sum(off)
            if max(off) > k_edge:
                edges += 1
            else:
                rest += sum(off)
    pixels = width * height
    mean = rest / (3 * (pixels - edges))
    print("viewer against openltc render: off by %.3f of 255 in the mean, by %.3f without %d pixels of %d at edges"
          % (whole / (3 * pixels), mean, edges, pixels), flush=True)
    check(mean <= k_mean and edges <= k_edges * pixels, "the picture is that of openltc render: %.3f, %d edges" % (mean, edges))
    check(sum(before) / len(before) > 8, "the picture is not dark")
    page.evaluate("(document.getElementById('tonemap').value = 'neutral', document.getElementById('tonemap').dispatchEvent(new Event('change')))")


def step_views(page, rays):
    """The reference converges to what LTC shows, and three.js's own light does not."""
    page.resize(330, 330)
    means = {}
    for view in ("error", "error_theirs"):
        page.evaluate("document.querySelector('#views [value=%s]').click()" % view)
        for frames in (2, rays):
            page.until("viewer.pictures.view === '%s' && viewer.pictures.frame >= %d" % (view, frames), "%d rays" % frames, 900)
            means[view, frames] = page.evaluate("viewer.pictures.measure()")
    few, ours, theirs = means["error", 2], means["error", rays], means["error_theirs", rays]
    print("error of LTC against the reference in the page: %.2f of 255 with 2 rays, %.2f with %d; of three.js %.2f"
          % (few, ours, rays, theirs), flush=True)
    check(ours < 0.4 * few and ours < 0.5 * theirs,
          "the reference converges to the picture by LTC: %s" % means)
    check(not page.evaluate("document.getElementById('legend').hidden"), "the scale is shown")
    page.evaluate("document.querySelector('#views [value=ltc]').click()")
    page.evaluate("document.getElementById('shadows').click()")
    page.until("viewer.pictures.view === 'ltc' && viewer.pictures.frame >= 8", "shadows", 200)
    page.evaluate("document.getElementById('shadows').click()")
    page.until("viewer.pictures.isDone && viewer.isStill", "the picture without shadows")
    page.resize(*k_size)
    page.until("viewer.isStill", "a picture")


def step_lost(page):
    page.crash_graphics()
    page.until("document.getElementById('message').textContent.includes('lost')", "the message of a lost device")
    page.evaluate("document.getElementById('add').click()") # the page is alive
    check(page.evaluate("viewer.pictures.lights.length") == 2, "lights can be set meanwhile")
    page.evaluate("document.getElementById('delete').click()")
    page.until("document.getElementById('message').hidden", "the device")
    page.until("viewer.isStill", "a picture")
    _, _, data = picture(page)
    check(sum(data) / len(data) > 8, "the picture comes back")
    # Which textures it takes is asked of the new device.
    drop(page, os.path.join(k_here, "compressed", "ktx2_uastc.glb"))
    ready(page, "ktx2_uastc.glb")
    check(page.evaluate("document.getElementById('message').hidden"), "a compressed file is read after a lost device")


def step_memory(page, work, loads):
    with open(work + "/rect.glb", "rb") as stream:
        page.evaluate("window.glb = Uint8Array.from(atob('%s'), c => c.charCodeAt(0))" % base64.b64encode(stream.read()).decode())
    held = []
    for k in range(loads + 5):
        page.evaluate("""(() => {
          const transfer = new DataTransfer();
          transfer.items.add(new File([window.glb], 'load_%d.glb'));
          document.body.dispatchEvent(new DragEvent('drop', {dataTransfer: transfer, bubbles: true, cancelable: true}));
        })()""" % k)
        page.until("document.getElementById('list').dataset.scene === 'load_%d.glb'" % k, "load %d" % k)
        if k in (4, loads + 4):
            page.until("viewer.isStill", "a picture")
            page.call("HeapProfiler.collectGarbage")
            # Sizes of targets go with the pixels that are drawn just then.
            held.append({name: count for name, count in page.evaluate("({...viewer.renderer.info.memory})").items()
                         if name != "total" and not name.endswith("Size")})
            held[-1]["bytes"] = page.call("Runtime.getHeapUsage")["usedSize"]
    first, last = held
    print("after %d loads more: %s; before: %s" % (loads, last, first))
    check(all(last[name] == first[name] for name in first if name != "bytes") and last["bytes"] < 1.1 * first["bytes"] + 1e6,
          "memory does not grow")


def step_view(page, openltc, app, work):
    """`openltc view` shows a file, and shows it anew when it has changed."""
    path = work + "/watched.glb"
    shutil.copyfile(work + "/rect.glb", path)
    with subprocess.Popen([openltc, "view", path, "--no-open", "--page", app], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True) as tool:
        try:
            page.open(tool.stdout.readline().strip())
            page.until("!!window.viewer", "the page")
            ready(page, "watched.glb")
            place = page.evaluate("viewer.camera.position.toArray()")
            shutil.copyfile(work + "/dark.glb", path)
            page.until("viewer.pictures.lights.length === 3", "the changed file", 120)
            check(page.evaluate("viewer.camera.position.toArray()") == place, "the camera stays where it was")
        finally:
            tool.terminate()
    page.until("document.getElementById('message').textContent.includes('does not answer')", "that the tool has ended")


def step_without(page, server):
    """A browser without WebGPU and WebGL 2."""
    script = page.call("Page.addScriptToEvaluateOnNewDocument", source="HTMLCanvasElement.prototype.getContext = () => null; delete Navigator.prototype.gpu")
    page.open(server.address + "viewer.html")
    page.until("document.getElementById('message')?.textContent.includes('WebGL 2')", "the message without graphics")
    page.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script["identifier"])


def main():
    arguments, program = app_arguments("viewer.html", build_viewer)
    work = os.path.abspath(arguments.work)
    write_scene("rect", k_scenes["rect"], work + "/rect.glb", True)
    write_scene("rect", [], work + "/dark.glb", True)
    page_bytes, more = size_of_viewer(arguments.app)
    print("the page: %.0f KiB by gzip; decoders that some scenes need: %.0f KiB" % (page_bytes / 1024, more / 1024))
    check(page_bytes < 450 * 1024, "the page is small")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1)) # not without the browser
    server, page = Server(arguments.app), Page(program, k_size)
    try:
        for graphics in k_rays:
            page.open(server.address + "viewer.html" + ("?graphics=webgl" if graphics == "WebGL 2" else ""))
            page.until("window.viewer && viewer.isStill", "the demo", 240)
            if page.evaluate("viewer.graphics") != graphics:
                print("skipped: no %s in this browser" % graphics)
                continue
            print("%s: first picture of the demo after %s ms, at %d × %d" % (
                graphics, page.evaluate("document.documentElement.dataset.firstPicture"), *k_size), flush=True)
            check(page.evaluate("viewer.pictures.lights.length") == 4, "the demo has its lights")
            if graphics == "WebGL 2":
                step_compressed(page)
                step_files(page, work)
                step_keys(page)
                step_drag(page)
            else:
                drop(page, work + "/rect.glb")
                ready(page, "rect.glb")
            step_lights(page)
            step_saved(page, arguments.openltc, work, "0.91" if graphics == "WebGL 2" else "0.9") # widened by step_keys
            if not arguments.short:
                step_views(page, k_rays[graphics])
            step_lost(page)
            step_memory(page, work, 5 if arguments.short else k_loads[graphics])
            check(not page.errors(), "the console has no errors: %s" % page.errors())
        if not arguments.short:
            step_view(page, arguments.openltc, os.path.abspath(arguments.app), work)
        step_without(page, server)
    except (TimeoutError, RuntimeError) as error:
        check(False, "%s; message: %s" % (error, page.evaluate("document.getElementById('message')?.textContent")))
    finally:
        page.close()
        server.close()
    print("%d failures" % len(k_failures))
    sys.exit(1 if k_failures else 0)


if __name__ == "__main__":
    main()
