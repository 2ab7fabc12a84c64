// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The library that scene/gltf reads files with; the distribution has its header, and its code for
// the machine itself alone. It can write files too, for which WASI's libc++ has no streams: what
// stands for them opens nothing, and the linker drops it with the functions that would.

#include <nlohmann/json.hpp>
#include <sstream>

template <> class std::basic_ofstream<char> : public std::ostringstream {
public:
  explicit basic_ofstream(const char*, std::ios::openmode = std::ios::out) {}
  bool is_open() const { return false; }
};

#define TINYGLTF_IMPLEMENTATION
#include "openltc/scene/gltf/file/tinygltf.h"
