#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes the tables of tables/ by `openltc fit --engine` and the figures of tables/README.md.

    tools/tables/make_engine_tables.py [--figures] [folder of the programs]

With --figures also the errors before and after, between the markers of the page. The published
table, ltc_1.dds and ltc_2.dds of the code to Heitz, Dupuy, Hill, Neubelt 2016, is read from
../shared/tables as ltc_code_1.dds and ltc_code_2.dds; without it the page is left alone. Where an
engine ships that table, it is read as the engine does; otherwise it is converted to the engine's
layout.
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PUBLISHED = ROOT / "../shared/tables"
PAGE = ROOT / "tables" / "README.md"
# name: title, its size, whether it ships the published table, how its layout is converted to
ENGINES = {
    "threejs": ("three.js", 64, "ltc_code"),
    "playcanvas": ("PlayCanvas", 64, "ltc_code_alpha"),
    "babylon": ("Babylon.js", 64, "ltc_code"),
    "bevy": ("Bevy", 64, "ltc_code"),
    "eevee": ("EEVEE", 64, "ltc_code"),
    "unity": ("Unity HDRP", 64, "unity"),
    "godot": ("Godot", 64, "godot"),
    "o3de": ("O3DE", 32, "o3de"),
    "ogre-next": ("Ogre-Next", 64, "ltc_code_alpha"),
}
CONVERTED = ("unity", "godot", "o3de")


def published_for(openltc, engine, folder):
    """The published table as a file that says how the engine reads it."""
    _, size, layout = ENGINES[engine]
    for texture in (1, 2):
        shutil.copy(PUBLISHED / f"ltc_code_{texture}.dds", folder / f"published_{texture}.dds")
    description = {"format": "openltc-packed-table", "version": 1, "width": "alpha",
                   "layout": "ltc_code" if engine in CONVERTED else layout,
                   "angle_axis": "sqrt(1 - cos theta)"}
    (folder / "published.dds.json").write_text(json.dumps(description))
    if engine not in CONVERTED:
        return folder / "published.dds"
    converted = folder / "converted.json"
    subprocess.run([openltc, "convert", "--quiet", folder / "published.dds", converted, "--layout", layout,
                    "--size", str(size)], check=True)
    return converted


def errors(openltc, engine):
    """Mean total variation over roughness 0.06 to 1 and 0.01 to 0.06, before and after."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([openltc, "fit", "--quiet", "--engine", engine, "--report", folder / "report.json",
                        "--against", published_for(openltc, engine, folder)],
                       check=True, stdout=subprocess.DEVNULL)
        regions = json.loads((folder / "report.json").read_text())["regions"]
        return [[region["candidates"][which]["between_nodes"]["mean"]["tv"] for region in regions]
                for which in (1, 0)]


def main():
    arguments = [a for a in sys.argv[1:] if a != "--figures"]
    openltc = pathlib.Path(arguments[0] if arguments else ROOT / "build/release/bin") / "openltc"
    for engine in ENGINES:
        folder = ROOT / "tables" / engine
        folder.mkdir(exist_ok=True)
        subprocess.run([openltc, "fit", "--engine", engine, "-o", folder], check=True,
                       stdout=subprocess.DEVNULL)
    if "--figures" not in sys.argv or not (PUBLISHED / "ltc_code_1.dds").exists():
        return
    rows = ["| engine | before | after | | before, 0.01–0.06 | after, 0.01–0.06 |", "|---|---|---|---|---|---|"]
    for engine, (title, _, _) in ENGINES.items():
        before, after = errors(openltc, engine)
        mark = " (converted)" if engine in CONVERTED else ""
        rows.append(f"| {title} | {before[0]:.4f}{mark} | {after[0]:.4f} | {100 * (after[0] / before[0] - 1):+.0f} % "
                    f"| {before[1]:.4f} | {after[1]:.4f} |")
    text = PAGE.read_text()
    begin, end = "<!-- figures -->\n", "\n<!-- end of figures -->"
    start, stop = text.index(begin) + len(begin), text.index(end)
    PAGE.write_text(text[:start] + "\n".join(rows) + text[stop:])


if __name__ == "__main__":
    main()
