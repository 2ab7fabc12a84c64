#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Uses the laboratory of web/app by the keys alone, which the browser is given as a keyboard gives them, and counts
what the page keeps over many fits.

    keyboard.py --openltc PROGRAM [--app FOLDER] --work DIR [--short]

FOLDER is what `make web` makes; without it the page is made below DIR, of the fitter that `make test` makes. --short:
on a small page, without the count. Exit code 0: all is well; 1: it is not; 77: nothing could run, and why."""

import glob
import json
import os
import signal
import subprocess
import sys

k_here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(os.path.dirname(k_here), "parity"), os.path.join(os.path.dirname(k_here), "engines"), k_here]
from app_pages import build_laboratory
from devtools import Page, Server, app_arguments

k_refits, k_part = 200, 20
k_small = (360, 640) # a phone: a picture of few pixels, since a processor draws it each time
# By how much JavaScript's heap may be larger after those fits than after the first two parts of them, bytes.
k_heap = 1.5e6
k_most_stops = 60
k_lambert = "function brdf(wo, wi, roughness, f) {\nf.fill(1 / Math.PI);\n}\n"
k_endless = "function brdf(wo, wi, roughness, f) {\nfor (;;) f[0] = 1;\n}\n"
# What has the focus, and whether a reader sees that: an outline of its own or of what stands for it, or another
# colour.
k_stop = """(() => {
  const at = document.activeElement, style = getComputedStyle(at), beside = at.nextElementSibling;
  const outlined = s => s.outlineStyle !== 'none' && parseFloat(s.outlineWidth) >= 1;
  const box = at.getBoundingClientRect();
  const seen = at.matches(':focus-visible') && (outlined(style) && style.opacity !== '0'
      || beside !== null && style.opacity === '0' && outlined(getComputedStyle(beside))
      || at.tagName === 'circle' && style.fill !== 'rgb(29, 28, 26)');
  return {id: at.id, tag: at.tagName.toLowerCase(), corner: at.dataset?.corner ?? '', form: at.form?.id ?? '',
          text: at.tagName === 'BUTTON' ? at.textContent.trim() : '', svg: at.closest?.('svg')?.id ?? '', seen,
          inside: box.right > 0 && box.bottom > 0 && box.left < innerWidth && box.top < innerHeight};
})()"""
k_settled = "/up to date|last fit|no fit|waiting|cancelled/.test(document.getElementById('status').textContent)"

k_failures = []


def check(holds, what):
    if not holds:
        k_failures.append(what)
        print("FAILED " + what, flush=True)


def stop_at(page, holds, what, shift=False):
    """Presses Tab until `holds` is true of what has the focus, which must be seen at each stop; the stops."""
    stops = []
    for _ in range(k_most_stops):
        page.key("Tab", shift)
        stop = page.evaluate(k_stop)
        stops.append(stop)
        if stop["tag"] != "body":
            check(stop["seen"] and stop["inside"], "the focus is seen at %s" % json.dumps(stop))
        if holds(stop):
            return stops
        if stop["id"] == "text" and not shift:
            page.key("Escape") # in the editor Tab indents
    check(False, "Tab comes to %s; it came to %s" % (what, [s["id"] or s["text"] or s["tag"] for s in stops]))
    return stops


def text_of(page, identity):
    return page.evaluate("document.getElementById('%s').textContent" % identity)


def settle(page, what, timeout=300):
    page.evaluate("new Promise(done => setTimeout(done, 500))", 300)
    page.until(k_settled, what, timeout)


def press(page, letter):
    """The key of a letter or sign; of signs the code is left out, since those of other keys look like them."""
    code = ord(letter.upper()) if letter.isalnum() else 0
    page.call("Input.dispatchKeyEvent", type="keyDown", key=letter, text=letter, windowsVirtualKeyCode=code)
    page.call("Input.dispatchKeyEvent", type="keyUp", key=letter, windowsVirtualKeyCode=code)


def write_text(page, text):
    """In place of what stands in the editor, which has the focus."""
    page.call("Input.dispatchKeyEvent", type="rawKeyDown", key="a", code="KeyA", windowsVirtualKeyCode=65, modifiers=2,
              commands=["selectAll"])
    page.call("Input.dispatchKeyEvent", type="keyUp", key="a", code="KeyA", windowsVirtualKeyCode=65, modifiers=2)
    for line in text.splitlines():
        for letter in line:
            press(page, letter)
        page.key("Enter")


def choose(page, value):
    """In the choice that has the focus, by the arrow keys."""
    for key in ("ArrowUp", "ArrowDown"):
        for _ in range(40):
            if page.evaluate("document.activeElement.value") == value:
                return
            page.key(key)
    check(page.evaluate("document.activeElement.value") == value, "arrow keys choose %s" % value)


def use(page, address, openltc, work):
    page.open(address + "index.html")
    settle(page, "the page")
    # A BRDF by its name.
    stops = stop_at(page, lambda s: s["id"] == "brdf", "the choice of a BRDF")
    check(stops[0]["tag"] == "a", "the first stop is the link to the results: %s" % stops[0])
    choose(page, "charlie")
    settle(page, "the fit of charlie")
    check(text_of(page, "status") == "up to date" and "harlie" in text_of(page, "about"), "charlie: %s" % text_of(page, "about"))
    # One's own, with a mistake that is mended.
    choose(page, "")
    settle(page, "the example")
    stop_at(page, lambda s: s["id"] == "text", "the editor")
    write_text(page, k_lambert.replace("f.fill(", "f.fill(("))
    settle(page, "the mistake")
    check(text_of(page, "message").startswith("Line 2"), "a mistake is named: %s" % text_of(page, "message"))
    write_text(page, k_lambert)
    settle(page, "the mended text")
    page.key("Escape")
    stops = stop_at(page, lambda s: s["id"] == "width", "what follows the editor")
    check(len(stops) == 1, "Escape and Tab leave the editor: %s" % stops)
    choose(page, "one")
    settle(page, "a wide lobe")
    check(float(text_of(page, "mean-tv")) < 1e-3, "Lambert is a cosine: %s" % text_of(page, "mean-tv"))
    # One that never ends, cancelled.
    stop_at(page, lambda s: s["id"] == "text", "the editor, backwards", shift=True)
    write_text(page, k_endless)
    page.until("document.getElementById('status').textContent === 'fitting'", "a fit under way")
    page.key("Escape")
    stop_at(page, lambda s: s["id"] == "cancel", "Cancel")
    page.key("Enter")
    page.until("document.getElementById('status').textContent === 'cancelled'", "the end of the fit")
    stop_at(page, lambda s: s["id"] == "text", "the editor, backwards", shift=True)
    write_text(page, k_lambert)
    settle(page, "a fit after the cancelled one")
    check(text_of(page, "status") == "up to date", "it goes on after Cancel: %s" % text_of(page, "status"))
    page.key("Escape")
    # A corner of the polygon, in the picture and in the figure; a slider.
    points = "document.querySelector('#%s polygon').getAttribute('points')"
    for svg in ("handles", "polygon-shading"):
        stop_at(page, lambda s: s["svg"] == svg and s["corner"] == "1", "a corner in " + svg)
        before = page.evaluate(points % svg)
        for key in ("ArrowUp", "ArrowUp", "ArrowRight"):
            page.key(key)
        after = page.evaluate(k_stop)
        # The figure follows when the worker has answered.
        page.until("%s !== %s" % (points % svg, json.dumps(before)), "a corner that arrow keys move in " + svg)
        check(after["corner"] == "1" and after["seen"], "it keeps the focus: %s" % after)
        if svg == "handles":
            stop_at(page, lambda s: s["id"] == "roughness", "the roughness")
            for _ in range(3):
                page.key("ArrowRight")
            settle(page, "a rougher surface")
    page.screenshot(os.path.join(work, "keyboard.png"))
    roughness = page.evaluate("document.getElementById('roughness').value")
    # Downloads.
    page.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=work)
    stop_at(page, lambda s: s["id"] == "layout", "the layout")
    stop_at(page, lambda s: s["form"] == "take-table" and s["text"] == "Download", "Download")
    page.key("Enter")
    page.until("document.getElementById('take-facts').textContent.includes('.json')", "a table")
    page.evaluate("new Promise(done => setTimeout(done, 1000))")
    files = glob.glob(os.path.join(work, "mine*.json"))
    said = subprocess.run([openltc, "inspect"] + files, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    check(len(files) == 1 and said.returncode == 0 and "mine" in said.stdout, "a table was taken: %s, %s" % (files, said.stdout[:200]))
    # The link that carries it all; a stranger's program waits for the reader.
    link = page.evaluate("location.hash")
    corners = page.evaluate(points % "handles")
    page.open("about:blank")
    page.open(address + "index.html" + link)
    page.until("!document.getElementById('trust').hidden", "the question about a program")
    stop_at(page, lambda s: s["id"] == "run", "Run it")
    page.key(" ")
    settle(page, "the fit of a link")
    check(page.evaluate("document.getElementById('text').value").strip().endswith("}") and
          page.evaluate("document.getElementById('roughness').value") == roughness and
          page.evaluate(points % "handles") == corners and float(text_of(page, "mean-tv")) < 1e-3,
          "the link restores it: roughness %s, %s" % (roughness, text_of(page, "status")))


def kept(page):
    """Bytes of JavaScript, elements and listeners that the page has."""
    for _ in range(2):
        page.call("HeapProfiler.collectGarbage")
    counters = page.call("Memory.getDOMCounters")
    return page.call("Runtime.getHeapUsage")["usedSize"], counters["nodes"], counters["jsEventListeners"]


def refit_often(page, address):
    page.open("about:blank")
    page.resize(*k_small)
    page.open(address + "index.html")
    settle(page, "the page")
    for identity, value, what in (("brdf", "ggx", "GGX"), ("size", "16", "few nodes")):
        page.evaluate("(document.getElementById('%s').value = '%s', document.getElementById('%s').dispatchEvent(new Event('change')))"
                      % (identity, value, identity))
        settle(page, what)
    # Each waits for the one before. A part at a time, for a machine that has little time for the browser.
    refit = """(async () => {
  const $ = id => document.getElementById(id);
  for (let i = 0; i < %d; ++i) {
    $('objective').value = i %% 2 ? 'tv' : 'balanced';
    $('objective').dispatchEvent(new Event('change'));
    while (!$('status').textContent.includes('up to date')) await new Promise(done => setTimeout(done, 5));
  }
})()""" % k_part
    kept_after, warm = {}, 2 * k_part
    for done in range(k_part, warm + k_refits + 1, k_part):
        page.evaluate(refit, 600)
        if done in (warm, warm + k_refits):
            page.evaluate("new Promise(done => setTimeout(done, 1500))") # the smooth picture and the figures
            kept_after[done] = kept(page)
    before, after = kept_after[warm], kept_after[warm + k_refits]
    print("%d refits of the page: JavaScript %.2f and %.2f MB, nodes %d and %d, listeners %d and %d" % (
        k_refits, before[0] / 1e6, after[0] / 1e6, before[1], after[1], before[2], after[2]))
    check(after[0] - before[0] < k_heap, "JavaScript's heap does not grow")
    check(after[1] <= before[1] + 20 and after[2] <= before[2] + 5, "no elements or listeners are kept")


def main():
    arguments, program = app_arguments("index.html", build_laboratory)
    work = os.path.abspath(arguments.work)
    for old in glob.glob(os.path.join(work, "mine*")):
        os.remove(old)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1)) # not without the browser
    server, page = Server(os.path.abspath(arguments.app)), Page(program, k_small if arguments.short else (1320, 900))
    try:
        use(page, server.address, os.path.abspath(arguments.openltc), work)
        if not arguments.short:
            refit_often(page, server.address)
        for error in page.errors():
            check(False, "the page's console: " + error)
    finally:
        page.close()
        server.close()
    print("by the keyboard alone: %d failures" % len(k_failures))
    sys.exit(1 if k_failures else 0)


if __name__ == "__main__":
    main()
