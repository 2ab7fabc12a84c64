#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Makes the tables of tables/ by `openltc fit --engine`, one folder for each engine.

    tools/tables/make_engine_tables.py [--check] [folder of the programs]

With --check it makes them in a folder of its own and says which are not those of tables/.
"""

import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENGINES = ("threejs", "playcanvas", "babylon", "bevy", "eevee", "unity", "godot", "o3de", "ogre-next")


def make(openltc, tables):
    for engine in ENGINES:
        folder = tables / engine
        folder.mkdir(exist_ok=True)
        subprocess.run([openltc, "fit", "--quiet", "--engine", engine, "-o", folder], check=True,
                       stdout=subprocess.DEVNULL)


def main():
    words = [word for word in sys.argv[1:] if word != "--check"]
    openltc = pathlib.Path(words[0] if words else ROOT / "build/release/bin") / "openltc"
    if "--check" not in sys.argv:
        return make(openltc, ROOT / "tables")
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder)
        make(openltc, made)
        files = {path.relative_to(made) for path in made.glob("*/*")}
        files |= {path.relative_to(ROOT / "tables") for path in (ROOT / "tables").glob("*/*")}
        other = [str(name) for name in sorted(files)
                 if not (made / name).is_file() or not (ROOT / "tables" / name).is_file()
                 or (made / name).read_bytes() != (ROOT / "tables" / name).read_bytes()]
    return "not what the command makes: " + ", ".join(other) if other else None


if __name__ == "__main__":
    sys.exit(main())
