#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""The table of errors in docs/engines.md: runs `openltc fit --engine` for every engine against the
published table, read as the engine reads it, and rewrites what stands between the page's markers.

    tools/tables/engine_figures.py [folder of the programs]

The published table, ltc_1.dds and ltc_2.dds of the code to Heitz, Dupuy, Hill, Neubelt 2016, must
lie in ../shared/tables as ltc_code_1.dds and ltc_code_2.dds.
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PUBLISHED = ROOT / "../shared/tables"
PAGE = ROOT / "docs" / "engines.md"
BEGIN, END = "<!-- figures -->\n", "<!-- end of figures -->\n"

# Engine, its name, layout in which the published table is measured, and size where it is another.
ENGINES = (("threejs", "three.js", "ltc_code"), ("eevee", "EEVEE", "ltc_code"), ("babylon", "Babylon.js", "ltc_code"),
           ("bevy", "Bevy", "ltc_code"), ("unity", "Unity HDRP", "unity"), ("godot", "Godot", "godot"),
           ("o3de", "O3DE", "o3de", "--size", "32"), ("playcanvas", "PlayCanvas", "ltc_code_alpha"),
           ("ogre-next", "Ogre-Next", "ltc_code_alpha"))


def published(openltc, folder, layout, size):
    """The published table as a file of a layout; over alpha it is the same file, read otherwise."""
    path = folder / f"{layout}.dds"
    first = folder / f"{layout}_1.dds"
    if layout.startswith("ltc_code"):
        for k in (1, 2):
            shutil.copy(PUBLISHED / f"ltc_code_{k}.dds", folder / f"{layout}_{k}.dds")
        said = {"format": "openltc-packed-table", "version": 1, "layout": layout, "brdf": "ggx",
                "angle_axis": "sqrt(1 - cos theta)", "width": "alpha", "horizon": "leaking"}
        (folder / f"{layout}.dds.json").write_text(json.dumps(said))
        return first
    subprocess.run([openltc, "convert", "--quiet", PUBLISHED / "ltc_code_1.dds", path, "--from-layout", "ltc_code",
                    "--brdf", "ggx", "--layout", layout, "--precision", "float32", *size], check=True)
    return first if first.exists() else path


def row(openltc, folder, engine, title, layout, *size):
    report = folder / "report.json"
    subprocess.run([openltc, "fit", "--quiet", "--engine", engine, "--report", report,
                    "--against", published(openltc, folder, layout, size)], check=True, stdout=subprocess.DEVNULL)
    cells = [title]
    for region in json.loads(report.read_text())["regions"]:
        after, before = (region["candidates"][k]["between_nodes"] for k in (0, 1))
        a, b = after["mean"]["tv"], before["mean"]["tv"]
        cells += [f"{b:.4f}", f"{a:.4f}", f"{100 * (a / b - 1):+.0f} %", f"{before['max']['tv']:.2f}",
                  f"{after['max']['tv']:.2f}"]
    return "| " + " | ".join(cells) + " |"


def main():
    openltc = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin") / "openltc"
    region = ["before", "after", "", "worst before", "worst after"]
    lines = ["| engine | " + " | ".join(region + [f"{word}, 0.01–0.06".lstrip(", ") for word in region]) + " |",
             "|---|" + "---|" * 10]
    with tempfile.TemporaryDirectory() as folder:
        lines += [row(openltc, pathlib.Path(folder), *engine) for engine in ENGINES]
    text = PAGE.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    PAGE.write_text(text[:begin] + "\n".join(lines) + "\n" + text[end:])


if __name__ == "__main__":
    main()
