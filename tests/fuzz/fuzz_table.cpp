// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Any bytes as a table file, the first byte choosing the reader: each ends in a texture or table
// that keeps its promises or in one line that begins with the file's name.

#include "openltc/table/container/container.h"
#include "openltc/table/container/description.h"
#include "openltc/table/container/source_code.h"
#include "openltc/table/table_file.h"

#include <cmath>
#include <cstdlib>
#include <vector>

namespace {

using namespace openltc;
using namespace openltc::table;

void require(bool promise) {
  if (!promise) std::abort();
}

void check_error(const Error& error) {
  require(error.message.rfind("fuzz: ", 0) == 0);
  require(error.message.find('\n') == std::string::npos);
}

// A table read from hostile bytes is unpacked, looked up, described and written like any other.
void use(const PackedTable& packed) {
  require(check_textures("fuzz", packed.layout, packed.textures).ok());
  const KeyValues description = describe(packed);
  require(description_from_json(description_to_json(description), "fuzz").ok());
  to_source(packed, SourceLanguage::c, "fuzz");
  const Result<LobeTable> table = unpack(packed);
  if (!table) return;
  fetch_packed(packed, 0.3, 0.7);
  fetch_packed_second(packed, 0.3, 0.7);
  require(resample(*table, 3, 5, AngleAxis::theta).ok());
  for (const Layout layout : all_layouts())
    (void)pack(*table, layout, Precision::float16);
}

void use(const LobeTable& table) {
  const Result<LobeTable> again = from_json(to_json(table), "fuzz");
  require(again.ok() && again->texels == table.texels && again->second == table.second);
  const Layout layout = table.two_lobes() ? Layout::native_two : Layout::native;
  const Result<PackedTable> packed = pack(table, layout, Precision::float32);
  if (packed) use(*packed);
}

void use(Texture texture) {
  require(texture.values.size() == texture.count());
  for (const float value : texture.values)
    require(std::isfinite(value));
  std::vector<Layout> layouts(all_layouts().begin(), all_layouts().end());
  layouts.push_back(Layout::native_two);
  for (const Layout layout : layouts) {
    PackedTable packed;
    packed.layout = layout;
    packed.angle_axis = angle_axis_of(layout);
    packed.precision = texture.precision;
    packed.textures.assign(facts_of(layout).channels.size(), texture);
    (void)apply_description(texture.metadata, "fuzz", packed);
    if (check_textures("fuzz", packed.layout, packed.textures)) use(packed);
  }
}

template <class T> void check(const Result<T>& result) {
  if (result)
    use(*result);
  else
    check_error(result.error());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const ByteView bytes(data + 1, size - 1);
  const std::string text(bytes.begin(), bytes.end());
  switch (data[0] % 7) {
  case 0:
    check(decode_dds(bytes, "fuzz"));
    break;
  case 1:
    check(decode_ktx2(bytes, "fuzz"));
    break;
  case 2:
    check(decode_exr(bytes, "fuzz"));
    break;
  case 3:
    check(decode_npy(bytes, "fuzz"));
    break;
  case 4:
    check(packed_from_json(text, "fuzz"));
    break;
  case 5: {
    const Result<LobeTable> table = from_json(text, "fuzz");
    if (!table)
      check_error(table.error());
    else
      use(*table);
    break;
  }
  default: {
    const Result<KeyValues> description = description_from_json(text, "fuzz");
    if (!description) {
      check_error(description.error());
      break;
    }
    PackedTable packed;
    if (Status status = apply_description(*description, "fuzz", packed); !status)
      check_error(status.error());
  }
  }
  return 0;
}
