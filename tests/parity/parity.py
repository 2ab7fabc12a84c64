#!/usr/bin/env python3
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
"""Runs shader files on what this machine has and compares the light with double precision.

    parity.py TARGET... --bin DIR --work DIR [--device NAME] [--times]

TARGET: cpp, the shading source in C++, float and lanes; vulkan, compute shaders of GLSL; chromium, WGSL by
WebGPU and GLSL ES by WebGL2 in a browser without a window. DIR of --bin has openltc, parity_cases and vkrun.

All run the same 10,240 cases of each shape: surface points under lights of fuzz_lights, half of them random and
half adversarial, a third by the lobe alone, a third with the ratio in the mean direction, a third with a triangle
that hides. Expected is what the same source gives in double (parity_cases.cpp, expected_light.cpp), which
tests/shade compares with quadrature. The table has differences of diffuse and of specular light, 0 to 1, relative
for lines where they exceed 1.

--device takes the graphics processor whose name contains NAME, in the browser whatever the system has; without it
software drivers run everything. --times prints how long a call of each shape takes to compile.

Exit code 0: all within their bounds (bounds.py); 1: something is not; 77: nothing could run, and why."""

import argparse
import json
import os
import shutil
import subprocess
import sys

import bounds
import browser
import kernels

k_exit_skipped = 77


class Skipped(Exception):
    """What is missing."""


class Folder:
    """The programs, and a folder for what is made on the way."""

    def __init__(self, programs, work):
        self.bin, self.work = os.path.abspath(programs), os.path.abspath(work)
        os.makedirs(self.work, exist_ok=True)

    def call(self, program, *arguments, **environment):
        """What a program prints."""
        result = subprocess.run([os.path.join(self.bin, program)] + list(arguments), stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, env=dict(os.environ, **environment))
        if result.returncode == k_exit_skipped:
            raise Skipped(result.stdout.strip().replace("skipped: ", ""))
        if result.returncode != 0:
            sys.exit("%s %s: exit code %d\n%s" % (program, arguments[0], result.returncode, result.stderr))
        return result.stdout

    def call_vulkan(self, program, *arguments, **environment):
        """What a program that needs Vulkan prints."""
        if not os.path.exists(os.path.join(self.bin, program)):
            raise Skipped("built without Vulkan (package libvulkan-dev)")
        os.environ.setdefault("XDG_RUNTIME_DIR", self.work)  # Mesa asks for one
        return self.call(program, *arguments, **environment)

    def path(self, name):
        return os.path.join(self.work, name)

    def source(self, language, shapes, *options):
        """The text of a shader file."""
        folder = self.path("_".join((language, shapes) + options))
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        self.call("openltc", "shaders", "--language", language, "--shapes", shapes, *options, "--quiet", "-o", folder)
        (name,) = os.listdir(folder)
        with open(os.path.join(folder, name), encoding="utf-8") as stream:
            return stream.read()

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as stream:
            stream.write(text)
        return name


class Runner(Folder):
    """A run of cases, which it writes."""

    def __init__(self, arguments):
        super().__init__(arguments.bin, arguments.work)
        self.device, self.times = arguments.device, arguments.times
        self.lanes = self.call("parity_cases", "write", self.work).split()[1:]

    def figures(self, target, shape, forms=kernels.k_forms):
        return json.loads(self.call("parity_cases", "compare", self.work, shape, target, str(forms)))


class Row:
    """What a target makes of a shape."""

    def __init__(self, target, driver, kind, shape, figures):
        self.target, self.driver, self.kind, self.shape, self.figures = target, driver, kind, shape, figures

    def text(self):
        rough, smooth, hard = (self.figures[group] for group in ("rough", "smooth", "adversarial"))
        cells = ["%.1e / %.1e / %.1e" % (group["mean"], group["p99"], group["largest"]) for group in (rough, smooth)]
        return "| %s | %s | %s | %.1f %% |" % (self.target, self.shape, " | ".join(cells),
                                              100.0 * hard["beyond"] / hard["count"])


k_head = """| target | shape | rough: mean / 99 of 100 below / largest | smooth | adversarial, beyond rounding |
|---|---|---|---|---|"""


def run_cpp(runner):
    rows = []
    for target in ["scalar"] + runner.lanes:
        name = "C++, float" if target == "scalar" else "C++, lanes of %s" % target
        rows += [Row(name, "", "exact", shape, runner.figures(target, shape)) for shape in kernels.k_shapes]
    check_the_check(runner)
    return rows


def check_the_check(runner):
    """Results that are off by a ten-thousandth must be refused."""
    import array
    values = array.array("f")
    with open(runner.path("scalar_quad.bin"), "rb") as stream:
        values.frombytes(stream.read())
    with open(runner.path("spoiled_quad.bin"), "wb") as stream:
        array.array("f", [1.0001 * x for x in values]).tofile(stream)
    if not bounds.breaches("exact", "quad", runner.figures("spoiled", "quad")):
        sys.exit("bounds: results that are off by a ten-thousandth were taken")


def run_vulkan(runner):
    if not shutil.which("glslangValidator"):
        raise Skipped("glslangValidator not found (package glslang-tools)")
    files = []
    for shape in kernels.k_shapes:
        text = kernels.case_kernel("glsl", runner.source("glsl", shape), shape)
        source, spirv = runner.path(runner.write(shape + ".comp", text)), runner.path(shape + ".spv")
        made = subprocess.run(["glslangValidator", "-V", "--target-env", "vulkan1.1", source, "-o", spirv],
                              stdout=subprocess.PIPE, text=True)
        if made.returncode != 0:
            sys.exit("glslangValidator refuses %s:\n%s" % (source, made.stdout))
        files += [spirv, runner.path("cases_%s.bin" % shape), runner.path("vulkan_%s.bin" % shape)]
    device = ["--device", runner.device or "llvmpipe"]
    lines = runner.call_vulkan("vkrun", *device, runner.path("polygons.bin"), *files).splitlines()
    kind = "unmeasured" if runner.device else "exact"
    print("Vulkan: %s; ms to make the pipeline, ns a case, of all processors: %s" % (lines[0], "; ".join(
        "%s %s" % pair for pair in zip(kernels.k_shapes, lines[1:]))))
    return [Row("Vulkan", lines[0], kind, shape, runner.figures("vulkan", shape)) for shape in kernels.k_shapes]


k_page = os.path.join(os.path.dirname(os.path.abspath(__file__)), "page.html")
k_browser_targets = (("webgpu", "WebGPU", "wgsl", ".wgsl"), ("webgl2", "WebGL2", "glsl-es", ".frag"))


def browser_forms(target, shape):
    """Forms of cases that a browser runs. A tube whose parts may be hidden takes SwiftShader a minute and 2.4 GB to
    compile for WebGL."""
    return 2 if (target, shape) == ("webgl2", "tube") else kernels.k_forms


def time_job(folder, target, shape, *options):
    """To compile one call of a shape, or of "all", in the file that `options` make."""
    (language, suffix), = [(language, suffix) for name, _, language, suffix in k_browser_targets if name == target]
    shapes = ",".join(kernels.k_shapes) if shape == "all" else shape
    text = kernels.call_kernel(language, folder.source(language, shapes, *options), shape)
    name = "_".join(("time", target, shape) + options)
    return {"name": name, "target": target, "shader": folder.write(name + suffix, text)}


def time_jobs(folder):
    """To compile one call of each shape, and of all of them."""
    return [time_job(folder, target, shape) for target, _, _, _ in k_browser_targets
            for shape in kernels.k_shapes + ("all",)]


def browser_jobs(runner):
    jobs = time_jobs(runner) if runner.times else []
    for target, _, language, suffix in k_browser_targets:
        for shape in kernels.k_shapes:
            source = runner.source(language, shape)
            name = "%s_%s" % (target, shape)
            text = kernels.case_kernel(language, source, shape, browser_forms(target, shape))
            shader = runner.write(shape + suffix, text)
            jobs.append({"name": name, "target": target, "shader": shader, "cases": "cases_%s.bin" % shape,
                         "polygons": "polygons.bin"})
    return jobs


def run_chromium(runner):
    program = browser.find()
    if not program:
        raise Skipped("no chromium (package chromium)")
    answers = browser.run(program, k_page, runner.work, browser_jobs(runner), hardware=bool(runner.device))
    if "webgpu" not in answers:
        raise Skipped("%s opened no page" % program)
    rows, absent = [], []
    for target, title, _, _ in k_browser_targets:
        if "absent" in answers.get(target, {"absent": "no answer"}):
            absent.append("%s: %s" % (title, answers.get(target, {}).get("absent", "no answer")))
            continue
        driver = answers[target]["device"]
        for shape in kernels.k_shapes:
            answer = answers.get("%s_%s" % (target, shape), {"failed": "no answer in time"})
            if "failed" in answer:
                sys.exit("%s, %s: %s" % (title, shape, answer["failed"]))
            figures = runner.figures(target, shape, browser_forms(target, shape))
            rows.append(Row(title, driver, "unmeasured" if runner.device else "swiftshader", shape, figures))
        print("%s: %s" % (title, driver))
        if runner.times:
            print("  ms to compile one call: " + ", ".join(
                "%s %.0f" % (shape, answers["time_%s_%s" % (target, shape)]["ms"])
                for shape in kernels.k_shapes + ("all",)))
    if not rows:
        raise Skipped("; ".join(absent))
    for line in absent:
        print("not run: " + line)
    return rows


def main():
    parser = argparse.ArgumentParser(description="Runs shader files and compares the light with double precision.")
    parser.add_argument("targets", nargs="+", choices=["cpp", "vulkan", "chromium"])
    parser.add_argument("--bin", required=True, help="folder of openltc, parity_cases and vkrun")
    parser.add_argument("--work", required=True, help="folder for what is made on the way")
    parser.add_argument("--device", default="", help="part of the name of a graphics processor")
    parser.add_argument("--times", action="store_true", help="say how long shaders take to compile")
    arguments = parser.parse_args()
    runner = Runner(arguments)
    rows, skipped = [], []
    for target in arguments.targets:
        try:
            rows += {"cpp": run_cpp, "vulkan": run_vulkan, "chromium": run_chromium}[target](runner)
        except Skipped as reason:
            skipped.append("%s: %s" % (target, reason))
            print("skipped: " + skipped[-1], flush=True)
    if not rows:
        sys.exit(k_exit_skipped)
    print(k_head)
    failures = []
    for row in rows:
        print(row.text())
        failures += ["%s, %s: %s" % (row.target, row.shape, breach)
                     for breach in bounds.breaches(row.kind, row.shape, row.figures)]
    for failure in failures:
        print(failure, file=sys.stderr)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
