#!/usr/bin/python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Figures of docs/fitting.md: runs `openltc fit`, rewrites the tables between the page's markers and
draws its heat maps. With --times, which wants a quiet machine, its table of times instead.

    tools/fit_figures.py [--times] [folder of the programs]

The published table is compared with when ../shared/tables is there; without it the page is left
alone, since half of its figures would be missing.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PUBLISHED = ROOT.parent / "shared" / "tables" / "ltc_code_1.dds"
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


HEAD = ["TV", "TV, .01–.06", "L2", "L3", "peak, median", "peak, p95", "leak", "bends, 10⁻⁴",
        "rectangles"]


def markdown(head, rows):
    lines = ["| " + " | ".join(["", *head]) + " |", "|---|" + "---|" * len(head)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def inferno(t):
    """A perceptually uniform map, dark to bright: anchors of matplotlib's inferno (CC0)."""
    anchors = [(0, 0, 4), (40, 11, 84), (101, 21, 110), (159, 42, 99), (212, 72, 66),
               (245, 125, 21), (250, 193, 39), (252, 255, 164)]
    x = round(48 * min(max(t, 0.0), 1.0)) / 48 * (len(anchors) - 1)  # steps: smaller files
    i = min(int(x), len(anchors) - 2)
    return "#" + "".join(f"{round(a + (b - a) * (x - i)):02x}" for a, b in zip(anchors[i], anchors[i + 1]))


def heat_maps(data, names, metric, title, path):
    """One map for each candidate over roughness and view angle, with one colour scale."""
    region = data["regions"][0]
    maps = [region["candidates"][i]["cells"][metric] for i in range(len(names))]
    thetas = region["axes"]["theta_degrees"]
    rows, columns = len(thetas), len(maps[0]) // len(thetas)
    ordered = sorted(v for m in maps for v in m)
    top = ordered[int(0.98 * (len(ordered) - 1))]
    cell, gap, left, head = 5, 34, 46, 58
    side = cell * columns
    width, height = left + len(maps) * (side + gap) + 30, head + side + 44
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
           f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="11">',
           '<style>text{fill:#222}@media(prefers-color-scheme:dark){text{fill:#ddd}}</style>',
           f'<text x="{left}" y="16" font-size="13" font-weight="bold">{title}</text>']
    for k, values in enumerate(maps):
        x0 = left + k * (side + gap)
        out.append(f'<text x="{x0}" y="{head - 10}">{names[k]}</text>')
        for j in range(rows):
            y = head + side - (j + 1) * cell
            i = 0
            while i < columns:  # runs of one colour become one rectangle
                colour, start = inferno(values[j * columns + i] / top), i
                while i < columns and inferno(values[j * columns + i] / top) == colour:
                    i += 1
                out.append(f'<rect x="{x0 + start * cell}" y="{y}" width="{(i - start) * cell}" '
                           f'height="{cell}" fill="{colour}" shape-rendering="crispEdges"/>')
        for roughness in (0.2, 0.4, 0.6, 0.8, 1.0):
            x = x0 + (roughness - 0.06) / 0.94 * side
            out.append(f'<text x="{x:.1f}" y="{head + side + 14}" text-anchor="middle">{roughness:g}</text>')
        out.append(f'<text x="{x0 + side / 2}" y="{head + side + 30}" text-anchor="middle">roughness</text>')
        if k == 0:
            end = math.sqrt(1 - math.cos(math.radians(89.7)))
            for degrees in (0, 30, 60, 90):
                share = math.sqrt(1 - math.cos(math.radians(degrees))) / end
                y = head + side * (1 - min(share, 1.0))
                out.append(f'<text x="{x0 - 6}" y="{y + 4:.1f}" text-anchor="end">{degrees}°</text>')
            out.append(f'<text x="12" y="{head + side / 2}" text-anchor="middle" '
                       f'transform="rotate(-90 12 {head + side / 2})">view angle θ</text>')
    bar = left + len(maps) * (side + gap) - gap + 12
    for step in range(50):
        y = head + side - (step + 1) * side / 50
        out.append(f'<rect x="{bar}" y="{y:.1f}" width="10" height="{side / 50 + 0.5:.1f}" fill="{inferno((step + 0.5) / 50)}"/>')
    out.append(f'<text x="{bar + 13}" y="{head + 8}">{top:.2g}</text>')
    out.append(f'<text x="{bar + 13}" y="{head + side}">0</text></svg>')
    path.write_text("\n".join(out) + "\n")


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
        name = entry["name"].removesuffix("/real_time")
        value = f"{float(f'{entry["real_time"]:.3g}'):g} {entry['time_unit'].replace('us', 'µs')}"
        if "ns/point" in entry:
            value += f" ({1e9 * entry['ns/point']:.1f} ns a point)"
        rows.append([name, value])
    PAGE.write_text(replace_block(PAGE.read_text(), "times", markdown(["wall time"], rows)))


def main():
    arguments = [a for a in sys.argv[1:] if a != "--times"]
    bin_folder = pathlib.Path(arguments[0]) if arguments else ROOT / "build" / "release" / "bin"
    openltc = bin_folder / "openltc"
    if "--times" in sys.argv[1:]:
        times(bin_folder)
        return
    if not PUBLISHED.exists():
        print(f"fit_figures: {PUBLISHED} is not there; {PAGE.name} is left as it is")
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

    text = PAGE.read_text()
    for name, block in blocks.items():
        text = replace_block(text, name, block)
    PAGE.write_text(text)
    IMAGES.mkdir(exist_ok=True)
    labels = ["balanced, 64²", "published", "limit"]
    for metric, title in (("tv", "Total variation: share of the energy misplaced"),
                          ("l2", "Relative L2 distance"), ("peak", "Error of the peak"),
                          ("leak", "Leak: share of the lobe below the surface")):
        heat_maps(main_report, labels, metric, title, IMAGES / f"fit_{metric}.svg")


if __name__ == "__main__":
    main()
