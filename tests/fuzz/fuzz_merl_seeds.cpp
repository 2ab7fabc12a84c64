// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// fuzz_merl_seeds FOLDER: writes small valid MERL files, with and without missing samples.

#include "merl_file.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_merl_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code ec;
  std::filesystem::create_directories(folder, ec);
  int index = 0;
  for (const std::array<std::int32_t, 3> counts :
       {std::array<std::int32_t, 3>{1, 1, 1}, {2, 2, 2}, {4, 3, 6}, {8, 8, 5}}) {
    for (const char* name : {"ggx", "burley"}) {
      const auto bytes = openltc::test::merl_bytes(
          counts, openltc::test::merl_samples(counts, *openltc::brdf::find_brdf(name), 0.5));
      std::ofstream file(folder / ("sample_" + std::to_string(index++) + ".binary"),
                         std::ios::binary);
      file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
      if (!file) {
        std::fprintf(stderr, "%s: cannot write\n", folder.string().c_str());
        return 1;
      }
    }
  }
  return 0;
}
