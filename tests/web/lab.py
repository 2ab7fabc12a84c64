#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Uses the laboratory of web/app in a browser without a window, and inspects what it gives away.

    lab.py --openltc PROGRAM [--app FOLDER] --work DIR

FOLDER is what `make web` makes; without it the page is made below DIR, of the fitter that
`make test` makes. Exit code 0: all is well; 1: it is not; 77: nothing could run, and why."""

import json
import os
import subprocess
import sys
import zipfile

k_here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(os.path.dirname(k_here), "parity"), os.path.join(os.path.dirname(k_here), "engines"), k_here]
import browser
from app_pages import build_laboratory, size_of_laboratory
from devtools import app_arguments
from openltc import write_merl

k_failures = []


def check(holds, what):
    if not holds:
        k_failures.append(what)
        print("FAILED " + what)


def check_beside(found, name):
    """The picture at the point of the figure has its light; it is read a few centimetres beside the cross."""
    check(all(abs(a - b) < 6 and b > 40 for a, b in zip(found["picture"], found["figure"])),
          "%s: the picture has the figure's light: %s" % (name, found))


def check_typing(found):
    check(0.01 < found["example"] < 0.3, "the example is fitted: %s" % found["example"])
    for name, line, words in (("syntax", 2, "Line 2"), ("throws", 4, "g is not defined"),
                              ("nan", 0, "must be finite and not negative"), ("strings", 0, 'it returned the string "red"'),
                              ("no_function", 0, "there is no function brdf"), ("endless", 0, "does it loop for ever?")):
        facts = found[name]
        check(words in facts["message"] and "last fit" in facts["status"], "%s: %s" % (name, json.dumps(facts)))
        if line:
            check(facts["bad"] == str(line), "%s marks line %d: %s" % (name, line, json.dumps(facts)))
    # Lambert's BRDF is a cosine: nothing is left to be wrong.
    for name in ("mended", "alive"):
        check(found[name]["tv"] < 1e-3 and not found[name]["message"], "%s: %s" % (name, json.dumps(found[name])))


def inspect(openltc, path, words):
    done = subprocess.run([openltc, "inspect", path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    check(done.returncode == 0 and words in done.stdout, "inspect %s: %s" % (path, done.stdout[:400]))


def main():
    arguments, program = app_arguments("index.html", build_laboratory)
    page_bytes = size_of_laboratory(arguments.app)
    print("the page: %.0f KiB by gzip" % (page_bytes / 1024))
    check(page_bytes < 450 * 1024, "the page is small")
    write_merl(os.path.join(arguments.work, "made.binary"))
    found = browser.run(program, os.path.join(k_here, "lab.html"), arguments.work, [], root=os.path.abspath(arguments.app),
                        timeout=400)
    check(found.get("done", {}).get("failed") == "", "it came to its end: %s" % found.get("done"))
    if "start" in found:
        start = found["start"]
        check(abs(start["tv"] - 0.0370) < 5e-4, "GGX: %s" % start)
        check(start["no_preview"] == "" and 2 < start["brightness"] < 200, "there is a picture: %s" % start)
        check(start["worst"] == 5 and "Both integrals are" in start["polygon"], "figures: %s" % start)
        check_beside(start["beside"], "one lobe")
    if "webgpu" in found and found["webgpu"]["graphics"] == "WebGPU":
        webgpu = found["webgpu"]
        check(webgpu["no_preview"] == "" and abs(webgpu["brightness"] - found["start"]["brightness"]) < 1,
              "the picture by WebGPU is that by WebGL 2: %s" % webgpu)
        check_beside(webgpu["beside"], "one lobe by WebGPU")
        check_beside(webgpu["two"], "two lobes by WebGPU")
    elif "webgpu" in found:
        print("skipped: no WebGPU in this browser")
    if "lost" in found:
        check("lost" in found["lost"]["message"] and found["lost"]["brightness"] > 2, "a lost device: %s" % found["lost"])
    if "two_lobes" in found:
        two = found["two_lobes"]
        check(two["tv"] < 0.02 and two["no_preview"] == "", "two lobes: %s" % two)
        check_beside(two["beside"], "two lobes")
    if "type" in found:
        check_typing(found["type"])
    if "link" in found:
        link = found["link"]
        check(link["waits"], "a program of somebody else waits to be run: %s" % link)
        check(link["same"] and link["same_link"] and link["corners"][0] == link["corners"][1] and link["tv"] < 1e-3,
              "a link restores all: %s" % link)
    if "bad_link" in found:
        bad = found["bad_link"]
        check(bad["tv"] == [found["start"]["example"]] * 2 and bad["roughness"] == "0.3", "a link that is none: %s" % bad)
    if "take" in found:
        work = arguments.work
        with zipfile.ZipFile(os.path.join(work, "ltc_code.bin")) as archive:
            check(archive.testzip() is None, "the archive is whole")
            archive.extractall(os.path.join(work, "taken"))
        with zipfile.ZipFile(os.path.join(work, "o3de.bin")) as archive:
            check(sorted(archive.namelist()) == ["ltc_amp_lutrg32f.dds", "ltc_mat_lutrgba32f.dds", "ltc_table.json"],
                  "files of an engine: %s" % archive.namelist())
        os.replace(os.path.join(work, "native.bin"), os.path.join(work, "taken", "native.json"))
        inspect(arguments.openltc, os.path.join(work, "taken", "ggx_1.dds"), "ltc_code")
        inspect(arguments.openltc, os.path.join(work, "taken", "native.json"), "ggx")
    if "merl" in found:
        merl = found["merl"]
        check(merl["good"]["message"] == "" and "measured" in merl["good"]["about"] and 0 < merl["good"]["tv"] < 0.5,
              "a measured material: %s" % merl)
        check("short.binary" in merl["bad"], "a file that is none: %s" % merl)
    check(len(found) == 13, "every step was taken: %s" % sorted(found))
    print("%d steps, %d failures" % (len(found), len(k_failures)))
    sys.exit(1 if k_failures else 0)


if __name__ == "__main__":
    main()
