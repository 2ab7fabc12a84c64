#!/bin/bash
# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
#   web/wasm/build.sh fitter [JOBS]                 make the fitter alone, build/wasm/openltc.wasm
#   web/wasm/build.sh package OPENLTC OUT [JOBS]    make the npm package OUT/openltc and the laboratory, OUT/app
#
# Where clang-22 is missing it says so, and nothing is made.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
if ! command -v clang++-22 > /dev/null || [[ ! -e /usr/lib/wasm32-wasi/crt1-reactor.o ]]; then
  echo "left out: the fitter in WebAssembly; it needs clang-22, lld-22, libc++-22-dev-wasm32," \
    "libc++abi-22-dev-wasm32, libclang-rt-22-dev-wasm32 and wasi-libc" >&2
  exit 0
fi
cmake -S web/wasm -B build/wasm -G Ninja -DCMAKE_TOOLCHAIN_FILE="$PWD/web/wasm/toolchain.cmake" > /dev/null
if [[ $1 == fitter ]]; then
  cmake --build build/wasm --parallel "${2:-2}" --target openltc
else
  openltc=$2 out=$3
  cmake --build build/wasm --parallel "${4:-2}"
  node web/wasm/build.mjs build/wasm "$out/openltc"
  node web/app/build.mjs "$openltc" build/wasm/openltc.wasm "$out/app"
fi
