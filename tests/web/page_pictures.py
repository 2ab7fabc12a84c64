#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Takes pictures of the viewer and the laboratory, in a browser without a window.

    page_pictures.py --app FOLDER --out DIR

FOLDER is what `make web` makes; a page that is not in it is left out. DIR gets viewer.webp and laboratory.png, which are
those of docs/images, and both pages dark and as on a phone."""

import argparse
import base64
import os
import signal
import sys
import time

k_here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [k_here, os.path.join(os.path.dirname(k_here), "parity"), os.path.join(os.path.dirname(k_here), "engines")]
import browser
from devtools import Page, Server
from engines import skip

k_wide, k_phone = (1320, 860), (390, 844)


def save(page, path, height=0):
    """A picture of what is seen, or of as many pixels from the top."""
    clip = {"clip": {"x": 0, "y": 0, "width": k_wide[0], "height": height, "scale": 1}} if height else {}
    kind = {"format": "webp", "quality": 85} if path.endswith(".webp") else {"format": "png"}
    answer = page.call("Page.captureScreenshot", 300, captureBeyondViewport=bool(height), **kind, **clip)
    with open(path, "wb") as stream:
        stream.write(base64.b64decode(answer["data"]))
    print(path, flush=True)


def show_viewer(page, address):
    """The demo, with its ring chosen."""
    page.open(address + "viewer.html")
    page.until("window.viewer && viewer.isStill", "the demo", 600)
    page.evaluate("document.querySelector('#list li:nth-child(3) button').click()")
    time.sleep(2)


def show_laboratory(page, address):
    """The example, under a light in the shape of an arrow."""
    page.open(address + "index.html?graphics=webgl") # whose fences can be told
    page.until("/up to date/.test(document.getElementById('status').textContent)", "the fit", 600)
    # Smooth edges on a busy machine too: the page takes every picture for drawn.
    page.evaluate("WebGL2RenderingContext.prototype.getSyncParameter = function() { return this.SIGNALED; }")
    page.evaluate("document.querySelector('[data-shape=arrow]').click()")
    page.until("(p => p.width > p.clientWidth)(document.getElementById('preview'))", "smooth edges")
    time.sleep(4) # the worker draws its figures


# Name and ending of the picture, file, how it is shown, pixels from the top.
k_pages = (("viewer", ".webp", "viewer.html", show_viewer, 0), ("laboratory", ".png", "index.html", show_laboratory, 606))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--app", required=True)
    parser.add_argument("--out", required=True)
    arguments = parser.parse_args()
    program = browser.find()
    if not program:
        skip("chromium not found (package chromium)")
    os.makedirs(arguments.out, exist_ok=True)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1)) # not without the browser
    server, page = Server(arguments.app), Page(program, k_wide)
    try:
        for name, ending, file, show, height in k_pages:
            if not os.path.exists(os.path.join(arguments.app, file)):
                print("left out: %s, which is not there" % file)
                continue
            show(page, server.address)
            save(page, os.path.join(arguments.out, name + ending), height)
            page.dark(True)
            time.sleep(1)
            save(page, os.path.join(arguments.out, name + "_dark.png"))
            page.dark(False)
            page.resize(*k_phone, mobile=True)
            time.sleep(3)
            save(page, os.path.join(arguments.out, name + "_phone.png"))
            page.resize(*k_wide)
    finally:
        page.close()
        server.close()


if __name__ == "__main__":
    main()
