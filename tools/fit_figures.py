#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Figures of docs/fitting.md: runs `openltc fit`, rewrites the tables between the page's markers and
draws its heat maps by `openltc plot error`. With --times, which wants a quiet machine, its table of
times instead; with --maps, the heat maps alone.

    tools/fit_figures.py [--times | --maps] [folder of the programs]

The published table, ltc_1.dds and ltc_2.dds of the code to Heitz, Dupuy, Hill, Neubelt 2016, is
compared with when it lies in ../shared/tables as ltc_code_1.dds and ltc_code_2.dds; without it the
page is left alone, since half of its figures would be missing.
"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PUBLISHED = ROOT / "../shared/tables/ltc_code_1.dds"
PAGE = ROOT / "docs" / "fitting.md"
IMAGES = ROOT / "docs" / "images"


def report(openltc, *arguments):
    """The JSON report of one fit."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "report.json"
        subprocess.run([openltc, "fit", "--quiet", "--report", path, *arguments], check=True,
                       stdout=subprocess.DEVNULL)
        return json.loads(path.read_text())


def figures(data, which):
    """The figures of one candidate, by position, as a row of the tables."""
    rough, sharp = (region["candidates"][which]["between_nodes"] for region in data["regions"])
    candidate = data["candidates"][which]
    bends = candidate["second_difference"]
    return [
        f"{rough['mean']['tv']:.4f}", f"{sharp['mean']['tv']:.4f}",
        f"{rough['mean']['l2']:.4f}", f"{rough['mean']['l3']:.4f}",
        f"{rough['median']['peak']:.4f}", f"{rough['p95']['peak']:.4f}",
        f"{100 * rough['mean']['leak']:.2f} %",
        "–" if bends is None else f"{1e4 * bends:.1f}",
        f"{candidate['lights']['rmse']:.4f}",
    ]


HEAD = ["TV", "TV, 0.01–0.06", "L2", "L3", "peak, median", "peak, p95", "leak", "second difference, 10⁻⁴",
        "rectangles"]


def markdown(head, rows):
    lines = ["| " + " | ".join(["", *head]) + " |", "|---|" + "---|" * len(head)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def heat_maps(openltc):
    """The built-in table beside the published one and beside the limit of single lobes."""
    norms = [word for name in ("tv", "l2", "peak", "leak") for word in ("--norm", name)]
    with tempfile.TemporaryDirectory() as folder:
        # Under the names that the tables were published with, since captions say them.
        for number in ("1", "2"):
            shutil.copy(PUBLISHED.with_name(f"ltc_code_{number}.dds"),
                        pathlib.Path(folder) / f"ltc_{number}.dds")
        for name, other in (("fit_published", "ltc_1.dds"), ("fit_limit", "limit")):
            subprocess.run([openltc.resolve(), "plot", "error", "--quiet", "--against", other, *norms,
                            "-o", IMAGES / f"{name}.svg"], check=True, cwd=folder)


def replace_block(text, name, block):
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->"
    before, rest = text.split(begin)
    return before + begin + block + "\n" + end + rest.split(end)[1]


def times(bin_folder):
    """Rewrites the page's table of times from one run of bench_fit."""
    run = subprocess.run([bin_folder / "bench_fit", "--benchmark_format=json"], check=True,
                         capture_output=True, text=True)
    rows = []
    for entry in json.loads(run.stdout)["benchmarks"]:
        name = entry["name"].removesuffix("/real_time").replace(" x ", " × ")
        rounded = float(f"{entry['real_time']:.3g}")
        value = f"{rounded:g} {entry['time_unit'].replace('us', 'µs')}"
        if "ns/point" in entry:
            value += f" ({1e9 * entry['ns/point']:.1f} ns a point)"
        rows.append([name, value])
    PAGE.write_text(replace_block(PAGE.read_text(), "times", markdown(["wall time"], rows)))


def main():
    arguments = [a for a in sys.argv[1:] if a not in ("--times", "--maps")]
    bin_folder = pathlib.Path(arguments[0]) if arguments else ROOT / "build" / "release" / "bin"
    openltc = bin_folder / "openltc"
    if "--times" in sys.argv[1:]:
        times(bin_folder)
        return
    if not PUBLISHED.exists():
        print(f"fit_figures: {PUBLISHED} is not there; {PAGE.name} is left as it is")
        return
    IMAGES.mkdir(exist_ok=True)
    heat_maps(openltc)
    if "--maps" in sys.argv[1:]:
        return

    main_report = report(openltc, "--against", PUBLISHED)
    tv = report(openltc, "--objective", "tv")
    rows = [
        ["published, 64²", *figures(main_report, 1)],
        ["**balanced, 64²**", *figures(main_report, 0)],
        ["limit of balanced", *figures(main_report, 2)],
        ["balanced, 16²", *figures(report(openltc, "--size", "16"), 0)],
        ["balanced, 8²", *figures(report(openltc, "--size", "8"), 0)],
        ["balanced, float16", *figures(report(openltc, "--precision", "float16"), 0)],
        ["balanced, `ltc_code`", *figures(report(openltc, "--layout", "ltc_code"), 0)],
        ["tv, 64²", *figures(tv, 0)],
        ["limit of tv", *figures(tv, 1)],
        ["tv, 16²", *figures(report(openltc, "--objective", "tv", "--size", "16"), 0)],
        ["tv, `ltc_code`", *figures(report(openltc, "--objective", "tv", "--layout", "ltc_code"), 0)],
        ["l2, 64²", *figures(report(openltc, "--objective", "l2"), 0)],
        ["l3, 64²", *figures(report(openltc, "--objective", "l3"), 0)],
    ]
    for degree in (3, 4, 5, 6):
        data = report(openltc, "--form", "polynomial", "--degree", str(degree))
        rows.append([f"balanced, degree {degree}", *figures(data, 0)])
    data = report(openltc, "--form", "polynomial", "--objective", "tv")
    rows.append(["tv, degree 4", *figures(data, 0)])
    for objective, sizes in (("balanced", (8, 16, 32, 64)), ("tv", (16, 32, 64))):
        for size in sizes:
            data = report(openltc, "--form", "two-lobe", "--objective", objective, "--size", str(size))
            name = f"two lobes, {objective}, {size}²"
            built_in = objective == "balanced" and size == 32
            rows.append([f"**{name}**" if built_in else name, *figures(data, 0)])
    for objective, degrees in (("balanced", (3, 4, 5, 6)), ("tv", (4,))):
        for degree in degrees:
            data = report(openltc, "--form", "two-lobe-polynomial", "--objective", objective,
                          "--degree", str(degree))
            rows.append([f"two lobes, {objective}, degree {degree}", *figures(data, 0)])
    blocks = {"figures": markdown(HEAD, rows)}

    curve = []
    for weights in ("1,0,0", "1,0.05,0.05", "1,0.1,0.1", "1,0.22,0.22", "1,0.3,0.3", "1,0.5,0.5",
                    "1,1,1", "0,1,1"):
        curve.append([f"`{weights}`", *figures(report(openltc, "--objective", weights), 0)])
    blocks["trade-off"] = markdown(HEAD, curve)

    listed = subprocess.run([openltc, "fit", "--list"], check=True, capture_output=True, text=True)
    names = [line.split()[0] for line in listed.stdout.splitlines()
             if line and not line.startswith((" ", "FILE"))]
    rows = []
    for name in names:
        data = report(openltc, "--brdf", name)
        rows.append([f"`{name}`", *figures(data, 0), figures(data, 1)[0]])
    blocks["brdfs"] = markdown([*HEAD, "TV of the limit"], rows)
    rows = [[f"`{name}`", *figures(report(openltc, "--brdf", name, "--form", "two-lobe", "--size", "16"), 0)]
            for name in names]
    blocks["two-lobe brdfs"] = markdown(HEAD, rows)

    text = PAGE.read_text()
    for name, block in blocks.items():
        text = replace_block(text, name, block)
    PAGE.write_text(text)


if __name__ == "__main__":
    main()
