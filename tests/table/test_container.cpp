// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Containers in memory: nothing is lost, and no bytes bring a reader down.

#include "openltc/table/container/container.h"
#include "openltc/table/half.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace openltc;
using namespace openltc::table;

namespace {

struct Format {
  const char* name;
  std::function<Bytes(const Texture&)> encode;
  Result<Texture> (*decode)(ByteView, const std::string&);
  bool describes;
};
const Format k_formats[] = {
    {"dds", encode_dds, decode_dds, false},
    {"ktx2", encode_ktx2, decode_ktx2, true},
    {"exr", encode_exr, decode_exr, true},
    {"npy", encode_npy, decode_npy, false},
};

Texture some_texture(int channels, Precision precision) {
  Texture t;
  t.width = 5;
  t.height = 3;
  t.channels = channels;
  t.precision = precision;
  for (std::size_t i = 0; i < t.count(); ++i) {
    const float value = i % 4 == 3 ? -1e-6f * float(i) : float(i) / 3;
    t.values.push_back(precision == Precision::float16 ? rounded_to_half(value) : value);
  }
  t.metadata = {{"brdf", "ggx"}, {"variant", "two\nlines, \"quotes\""}};
  return t;
}

// One line that begins with the file's name, or the texture.
std::string refusal(const Format& format, ByteView bytes) {
  const Result<Texture> read = format.decode(bytes, "x");
  if (read) return {};
  CHECK(read.error().message.rfind("x: ", 0) == 0);
  CHECK(read.error().message.find('\n') == std::string::npos);
  return read.error().message;
}

void set_u32(Bytes& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i)
    bytes[at + i] = std::uint8_t(value >> (8 * i));
}

} // namespace

TEST_CASE("what is written is read, to the bit, with its metadata where there is room") {
  for (const Format& format : k_formats)
    for (const int channels : {1, 2, 4})
      for (const Precision precision : {Precision::float32, Precision::float16}) {
        CAPTURE(std::string(format.name));
        CAPTURE(channels);
        const Texture t = some_texture(channels, precision);
        const Bytes bytes = format.encode(t);
        const Result<Texture> read = format.decode(bytes, "x");
        REQUIRE(read);
        CHECK(read->width == t.width);
        CHECK(read->height == t.height);
        CHECK(read->channels == channels);
        CHECK(read->precision == precision);
        CHECK(read->values == t.values);
        if (format.describes) {
          REQUIRE(find_value(read->metadata, "variant"));
          CHECK(*find_value(read->metadata, "variant") == "two\nlines, \"quotes\"");
        }
        CHECK(format.encode(t) == bytes); // the same input, the same bytes
      }
}

TEST_CASE("table_rejects_truncated_file, of every container, at every length") {
  for (const Format& format : k_formats) {
    CAPTURE(std::string(format.name));
    const Bytes bytes = format.encode(some_texture(4, Precision::float32));
    for (std::size_t n = 0; n < bytes.size(); ++n)
      REQUIRE_FALSE(refusal(format, ByteView(bytes).first(n)).empty());
  }
  for (const Format& format : {k_formats[0], k_formats[3]}) { // those without a place for more
    CAPTURE(std::string(format.name));
    Bytes bytes = format.encode(some_texture(4, Precision::float32));
    bytes.push_back(0);
    CHECK_FALSE(refusal(format, bytes).empty());
  }
}

TEST_CASE("garbage and other formats are refused") {
  Bytes garbage(5000);
  for (std::size_t i = 0; i < garbage.size(); ++i)
    garbage[i] = std::uint8_t(i * 2654435761u >> 13);
  for (const Format& format : k_formats) {
    CAPTURE(std::string(format.name));
    CHECK_FALSE(refusal(format, garbage).empty());
    CHECK_FALSE(refusal(format, {}).empty());
    for (const Format& other : k_formats)
      if (other.decode != format.decode)
        CHECK_FALSE(refusal(format, other.encode(some_texture(4, Precision::float32))).empty());
  }
}

TEST_CASE("NaN and infinities are refused with their texel") {
  for (const Format& format : k_formats)
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      CAPTURE(std::string(format.name));
      Texture t = some_texture(4, Precision::float32);
      t.values[(2 * 5 + 3) * 4 + 1] = bad;
      CHECK(refusal(format, format.encode(t)).find("(3, 2)") != std::string::npos);
    }
}

TEST_CASE("sizes that are no table's, or overflow, are refused before memory is taken") {
  const Bytes dds = encode_dds(some_texture(4, Precision::float32));
  const Bytes ktx2 = encode_ktx2(some_texture(4, Precision::float32));
  for (const std::uint32_t size : {0u, 513u, 65536u, 0x7fffffffu, 0xffffffffu}) {
    for (const std::size_t at : {12, 16}) {
      Bytes bytes = dds;
      set_u32(bytes, at, size);
      CHECK_FALSE(refusal(k_formats[0], bytes).empty());
    }
    for (const std::size_t at : {20, 24, 28, 80, 84, 88}) {
      Bytes bytes = ktx2;
      set_u32(bytes, at, size);
      if (size == 0 && (at == 28 || at == 84)) continue; // no depth and no high word is right
      CHECK_FALSE(refusal(k_formats[1], bytes).empty());
    }
  }
  for (const char* shape : {"(0, 5, 4)", "(600, 5, 4)", "(3, 99999999999999, 4)", "(3, 5, 5)",
                            "(3, 5, 4, 1)", "(-3, 5, 4)", "()", "3", "(3, 5, 4"}) {
    CAPTURE(std::string(shape));
    Bytes bytes = encode_npy(some_texture(4, Precision::float32));
    std::string text = std::string("{'descr': '<f4', 'fortran_order': False, 'shape': ") + shape;
    text.resize(118, ' ');
    std::copy(text.begin(), text.end(), bytes.begin() + 10);
    CHECK_FALSE(refusal(k_formats[3], bytes).empty());
  }
}

TEST_CASE("an attribute of an EXR that claims more than the file is refused") {
  const Bytes good = encode_exr(some_texture(4, Precision::float32));
  // Name, type and size: "openltc.brdf" 0 "string" 0 size.
  const std::string key("openltc.brdf\0string\0", 20);
  const auto at = std::search(good.begin(), good.end(), key.begin(), key.end());
  REQUIRE(at != good.end());
  const std::size_t size_at = std::size_t(at - good.begin()) + key.size();
  for (const std::uint32_t size : {std::uint32_t(good.size()), 0x10000000u, 0x7fffffffu, ~0u}) {
    CAPTURE(size);
    Bytes bytes = good;
    set_u32(bytes, size_at, size);
    CHECK(refusal(k_formats[2], bytes).find("does not fit into the file") != std::string::npos);
  }
  // A size that is not the type's: the library would read on elsewhere than the size says.
  const std::string fixed("compression\0compression\0\1\0\0\0", 28);
  const auto found = std::search(good.begin(), good.end(), fixed.begin(), fixed.end());
  REQUIRE(found != good.end());
  Bytes bytes = good;
  set_u32(bytes, std::size_t(found - good.begin()) + 24, 5);
  CHECK(refusal(k_formats[2], bytes).find("does not fit into the file") != std::string::npos);
}

TEST_CASE("changing any byte is noticed, harmless, or changes the values") {
  for (const Format& format : k_formats) {
    CAPTURE(std::string(format.name));
    const Bytes bytes = format.encode(some_texture(2, Precision::float16));
    for (std::size_t i = 0; i < bytes.size(); ++i)
      for (const int flip : {1, 0x80, 0xff}) {
        Bytes changed = bytes;
        changed[i] = std::uint8_t(changed[i] ^ flip);
        const Result<Texture> read = format.decode(changed, "x");
        if (!read) continue;
        REQUIRE(read->values.size() == read->count());
        REQUIRE(std::all_of(read->values.begin(), read->values.end(),
                            [](float v) { return std::isfinite(v); }));
      }
  }
}
