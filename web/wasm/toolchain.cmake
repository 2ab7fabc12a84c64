# Copyright (c) 2026 The OpenLTC authors
# SPDX-License-Identifier: MIT
#
# WebAssembly by the distribution's clang: wasm32 with WASI's C library and libc++, of one thread,
# without exceptions.

set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-22)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi) # the name of the packages, which clang calls deprecated
set(CMAKE_CXX_COMPILER_WORKS ON) # CMake's own test wants a main, which a module has not
