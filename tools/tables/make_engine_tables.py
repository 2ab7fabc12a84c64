#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes the tables of tables/ by `openltc fit --engine`, one folder for each engine.

    tools/tables/make_engine_tables.py [folder of the programs]
"""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENGINES = ("threejs", "playcanvas", "babylon", "bevy", "eevee", "unity", "godot", "o3de", "ogre-next")


def main():
    openltc = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin") / "openltc"
    for engine in ENGINES:
        folder = ROOT / "tables" / engine
        folder.mkdir(exist_ok=True)
        subprocess.run([openltc, "fit", "--quiet", "--engine", engine, "-o", folder], check=True,
                       stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    main()
