// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// fuzz_table_seeds FOLDER: writes small valid tables of every layout, precision and container, each
// after the byte that chooses the reader (fuzz_table.cpp).

#include "openltc/table/container/container.h"
#include "openltc/table/container/description.h"
#include "openltc/table/table_file.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

using namespace openltc;
using namespace openltc::table;

namespace {

bool write_seed(const std::filesystem::path& folder, int reader, const std::string& name,
                const Bytes& bytes) {
  std::ofstream file(folder / name, std::ios::binary);
  file.put(char(reader));
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  return bool(file);
}

Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_table_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code ec;
  std::filesystem::create_directories(folder, ec);
  const Result<LobeTable> small =
      resample(builtin_ggx_table(), 3, 3, AngleAxis::sqrt_one_minus_cos);
  bool good = small && write_seed(folder, 5, "native.json", bytes_of(to_json(*small)));
  const Result<LobeTable> two =
      resample(builtin_ggx_two_lobe_table(), 3, 3, AngleAxis::sqrt_one_minus_cos);
  good = good && two && write_seed(folder, 5, "native_two.json", bytes_of(to_json(*two)));
  std::vector<Layout> layouts(all_layouts().begin(), all_layouts().end());
  layouts.push_back(Layout::native_two);
  for (const Layout layout : layouts)
    for (const Precision precision : {Precision::float32, Precision::float16}) {
      const Result<PackedTable> packed =
          pack(layout == Layout::native_two ? *two : *small, layout, precision);
      if (!packed) continue; // does not fit into half precision
      const std::string name = std::string(name_of(layout)) + "_" + name_of(precision);
      Texture texture = packed->textures.back();
      texture.metadata = describe(*packed);
      good = good && write_seed(folder, 0, name + ".dds", encode_dds(texture)) &&
             write_seed(folder, 1, name + ".ktx2", encode_ktx2(texture)) &&
             write_seed(folder, 2, name + ".exr", encode_exr(texture)) &&
             write_seed(folder, 3, name + ".npy", encode_npy(texture)) &&
             write_seed(folder, 4, name + ".json", bytes_of(packed_to_json(*packed))) &&
             write_seed(folder, 6, name + ".description",
                        bytes_of(description_to_json(describe(*packed))));
    }
  if (!good) std::fprintf(stderr, "%s: cannot write\n", folder.string().c_str());
  return good ? 0 : 1;
}
