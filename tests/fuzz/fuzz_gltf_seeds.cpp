// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// fuzz_gltf_seeds FOLDER: writes small valid files that use all that the importer reads.

#include "gltf_samples.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_gltf_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code ec;
  std::filesystem::create_directories(folder, ec);
  int index = 0;
  for (const auto& sample : openltc::test::make_samples()) {
    const std::string name = "sample_" + std::to_string(index++);
    std::ofstream text(folder / (name + ".gltf"), std::ios::binary);
    text << sample.to_text();
    const auto bytes = sample.to_glb();
    std::ofstream binary(folder / (name + ".glb"), std::ios::binary);
    binary.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!text || !binary) {
      std::fprintf(stderr, "%s: cannot write\n", folder.string().c_str());
      return 1;
    }
  }
  return 0;
}
