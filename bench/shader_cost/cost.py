#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Measures what shader files cost, beside the usual formulation, and prints the tables of shaders/README.md.

    cost.py [PART...] --bin DIR --work DIR

PART: static, what SPIR-V and AMD's instructions come to, and registers; variants, what a shader keeps of a light
that it has none of; processor, time of a quad by lavapipe; chromium, time to compile. All without any.
DIR of --bin has openltc, shader_statistics and vkrun.

Beside OpenLTC stands a quad as engines have it (usual.glsl). AMD's instructions and registers are those of Mesa's
driver, which compiles for a processor that is not there. What cannot be measured is named, and no reason to fail.
Nothing is asserted about times."""

import argparse
import glob
import json
import math
import os
import sys
from statistics import median

k_root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [os.path.join(k_root, "tests/parity"), os.path.join(k_root, "tools/shaders")]
import browser  # noqa: E402
import cases  # noqa: E402
import kernels  # noqa: E402
import parity  # noqa: E402
import rows as lights  # noqa: E402
import spirv  # noqa: E402

k_driver = "/usr/share/vulkan/icd.d/radeon_icd*.json"
k_family = "navi21"                # RDNA 2
k_registers, k_waves = 512, 16     # of a lane there, with 64 lanes to a wave; waves share them, so many at most
k_repeats = 3                      # of what a browser compiles; the best counts
k_runs = 25                        # of what a processor runs


def statistics(folder, paths):
    """The driver for AMD, and what it tells of each shader."""
    drivers = sorted(glob.glob(k_driver))
    if not drivers:
        raise parity.Skipped("no driver for AMD (package mesa-vulkan-drivers)")
    lines = folder.call_vulkan("shader_statistics", *paths, RADV_FORCE_FAMILY=k_family, VK_ICD_FILENAMES=drivers[0],
                               VK_DRIVER_FILES=drivers[0]).splitlines()
    return lines[0], [json.loads(line) for line in lines[1:]]


def amd_cells(told):
    """Instructions, bytes of code, registers, waves, spilled registers."""
    if not told:
        return ["not measured"] * 5
    return ["%d" % told["Instructions"], "%d" % told["Code size"], "%d" % told["VGPRs"],
            "%d" % min(k_waves, k_registers // told["VGPRs"]), "%d" % (told["Spilled VGPRs"] + told["Spilled SGPRs"])]


def print_table(head, lines):
    print("\n| %s |\n|%s" % (" | ".join(head), "---|" * len(head)))
    for line in lines:
        print("| %s |" % " | ".join(line))
    sys.stdout.flush()


def measure_amd(folder, paths):
    """What the driver tells of each shader, None where there is none."""
    try:
        name, told = statistics(folder, paths)
        print("AMD: %s" % name)
        return told
    except parity.Skipped as reason:
        print("AMD: not measured: %s" % reason)
        return [None] * len(paths)


k_amd_head = ["AMD", "bytes of code", "VGPRs", "waves", "spilled"]


def print_static(folder, rows=None):
    rows = rows or lights.all_rows()
    modules = [spirv.compile_shader(lights.shader(row, folder), folder.path(row.file_name)) for row in rows]
    told = measure_amd(folder, [optimised for _, optimised in modules])
    lines = [[row.title, row.lobe, "%d" % spirv.count_instructions(compiled),
              "%d" % spirv.count_instructions(optimised), "%d" % spirv.count_in_functions(optimised)] + amd_cells(amd)
             + ["%d" % spirv.constant_bytes(optimised), "%d" % (row.texture_bytes // 1024)]
             for row, (compiled, optimised), amd in zip(rows, modules, told)]
    print_table(["light", "lobes", "SPIR-V", "`-O`", "in functions"] + k_amd_head
                + ["bytes of constants", "KiB of textures"], lines)


def print_variants(folder):
    paths = [spirv.compile_shader(lights.variant_shader(title, folder), folder.path("variant_%d" % i))[1]
             for i, title in enumerate(lights.k_variants)]
    told = measure_amd(folder, paths)
    print_table(["a shader with a point light and"] + k_amd_head,
                [[title] + amd_cells(amd) for title, amd in zip(lights.k_variants, told)])


def time_quads(folder, rows):
    """Nanoseconds a quad, of all processors, as [place][row][run], and the light of each, as [place][row]."""
    shaders = [spirv.compile_shader(lights.timed_shader(row, folder), folder.path("timed_" + row.file_name))[0]
               for row in rows]
    polygons = folder.path("no_polygons.bin")
    with open(polygons, "wb") as stream:
        stream.write(bytes(16))
    names = [(place, row, folder.path("light_%d_%d.bin" % (place, row)))
             for place in range(len(cases.k_places)) for row in range(len(rows))]
    files = []
    for place, name in enumerate(cases.k_places):
        cases.write_cases(name, folder.path("cases_%d.bin" % place))
    for place, row, light in names:
        files += [shaders[row], folder.path("cases_%d.bin" % place), light]
    times = [[[] for _ in rows] for _ in cases.k_places]
    for _ in range(k_runs):
        lines = folder.call_vulkan("vkrun", "--device", "llvmpipe", polygons, *files).splitlines()
        for (place, row, _), line in zip(names, lines[1:]):
            times[place][row].append(float(line.split()[2]) / lights.k_quads_per_case)
    print("processor: %s" % lines[0])
    return times, [[cases.read_light(light) for of, _, light in names if of == place]
                   for place in range(len(cases.k_places))]


def difference(light, expected):
    """Mean difference over mean light."""
    return sum(abs(a - b) for a, b in zip(light, expected)) / sum(expected)


def median_ratio(times, others):
    """Of what was timed in the same runs, so that what slows a machine down slows down both."""
    return median(a / b for a, b in zip(times, others))


def print_processor(folder):
    rows = lights.timed_rows()
    times, light = time_quads(folder, rows)
    usual = [row.light for row in rows].index("usual, clipped")
    print_table(["light", "lobes"] + ["%s: ns" % place for place in cases.k_places] + ["light, from the first"],
                [[row.title, row.lobe] + ["%.0f" % min(of[i]) if row.light == lights.k_surface else
                                           "%.0f (%.2f)" % (min(of[i]), median_ratio(of[i], of[usual])) for of in times]
                 + ["" if row.light == lights.k_surface else
                    " / ".join("%.1f %%" % (100.0 * difference(of[i], of[0])) for of in light)]
                 for i, row in enumerate(rows)])


def time_to_compile(folder):
    """Drivers by target, and seconds by "TARGET_LIGHT", or None where one does not compile."""
    program = browser.find()
    if not program:
        raise parity.Skipped("no chromium (package chromium)")
    jobs = parity.time_jobs(folder)
    jobs += [parity.time_job(folder, target, light, lights.k_lean) for target, _, _, _ in parity.k_browser_targets
             for light in ("quad", "all")]
    for i, light in enumerate(lights.k_usual):
        jobs.append({"name": "time_webgl2_" + light, "target": "webgl2",
                     "shader": folder.write("usual_%d.frag" % i, lights.usual_fragment_shader(light))})
    drivers, best = {}, {}
    for _ in range(k_repeats):  # each with a profile of its own: nothing is kept from before
        answers = browser.run(program, parity.k_page, folder.work, jobs)
        for target, _, _, _ in parity.k_browser_targets:
            drivers[target] = answers.get(target, {}).get("device")
        for job in jobs:
            answer = answers.get(job["name"], {})
            if "ms" in answer:
                best[job["name"]] = min(best.get(job["name"], math.inf), 1e-3 * answer["ms"])
            elif drivers[job["target"]]:
                print("%s: %s" % (job["name"], answer.get("failed", "no answer in time")))
    if not any(drivers.values()):
        raise parity.Skipped("%s opened no page, or has neither WebGPU nor WebGL 2" % program)
    return drivers, best


def print_chromium(folder):
    drivers, best = time_to_compile(folder)
    for target, title, _, _ in parity.k_browser_targets:
        print("%s: %s" % (title, drivers[target] or "not measured: absent"))
    lines = []
    for light in ("quad", "quad_" + lights.k_lean, *lights.k_usual, *kernels.k_shapes[1:], "all", "all_" + lights.k_lean):
        seconds = [best.get("time_%s_%s" % (target, light)) for target, _, _, _ in parity.k_browser_targets]
        lines.append([light.replace("_" + lights.k_lean, ", `%s`" % lights.k_lean)]
                     + ["not measured" if s is None else "%.2f s" % s for s in seconds])
    print_table(["one call"] + [title for _, title, _, _ in parity.k_browser_targets], lines)


k_parts = {"static": print_static, "variants": print_variants, "processor": print_processor,
           "chromium": print_chromium}


def main():
    parser = argparse.ArgumentParser(description="Measures what shader files cost.")
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(k_parts))
    parser.add_argument("--bin", required=True, help="folder of openltc, shader_statistics and vkrun")
    parser.add_argument("--work", required=True, help="folder for what is made on the way")
    arguments = parser.parse_args()
    for part in arguments.parts:
        if part not in k_parts:
            parser.error("no part %s: there are %s" % (part, ", ".join(k_parts)))
    folder = parity.Folder(arguments.bin, arguments.work)
    for part in arguments.parts or k_parts:
        try:
            k_parts[part](folder)
        except parity.Skipped as reason:
            print("%s: not measured: %s" % (part, reason))


if __name__ == "__main__":
    main()
