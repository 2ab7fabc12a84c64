// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// fuzz_ies_seeds FOLDER: writes small valid LM-63 and EULUMDAT files of every version, type,
// symmetry and range of angles.

#include "ies_samples.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_ies_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code ec;
  std::filesystem::create_directories(folder, ec);
  int index = 0;
  std::vector<std::string> texts = openltc::testing::ies_samples();
  for (const std::string& text : openltc::testing::ldt_samples())
    texts.push_back(text);
  for (const std::string& text : texts) {
    std::ofstream file(folder / ("sample_" + std::to_string(index++) + ".txt"), std::ios::binary);
    file << text;
    if (!file) {
      std::fprintf(stderr, "%s: cannot write\n", folder.string().c_str());
      return 1;
    }
  }
  return 0;
}
