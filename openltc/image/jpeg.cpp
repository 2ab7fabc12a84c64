// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Reading JPEG (ITU-T T.81, baseline and progressive) through stb_image.

#include "openltc/image/codec.h"

#include <climits>
#include <fmt/format.h>

#include <cstring>
#include <memory>

// Static, because other libraries of the process (tinygltf) carry their own copy.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 65535
// Zeroed memory: a file that uses tables which it does not define must not read what lay there.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(pointer, size) std::realloc(pointer, size)
#define STBI_FREE(pointer) std::free(pointer)
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace openltc::image::codec {

namespace {

enum Marker : std::uint8_t {
  k_progressive_frame = 0xC2,
  k_huffman_tables = 0xC4,
  k_first_restart = 0xD0,
  k_last_restart = 0xD7,
  k_end_of_image = 0xD9,
  k_start_of_scan = 0xDA,
};

// Huffman tables (T.81, B.2.4.2): one byte of class and number, 16 counts of codes by length, then
// one value for each code, of which there are at most 256. stb_image before 2.28 takes the counts
// on trust and writes beyond its table.
bool are_huffman_tables_sound(std::span<const std::uint8_t> tables) {
  while (!tables.empty()) {
    if (tables.size() < 17) return false;
    std::size_t codes = 0;
    for (std::size_t i = 1; i <= 16; ++i)
      codes += tables[i];
    if (codes > 256 || tables.size() < 17 + codes) return false;
    tables = tables.subspan(17 + codes);
  }
  return true;
}

// stb_image fills up a file that ends early instead of refusing it. This walks over the markers
// (T.81, annex B) and tells whether the last one, end of image, is reached by sound segments, and
// whether one said that the picture is progressive.
bool is_whole(std::span<const std::uint8_t> bytes, bool& is_progressive) {
  std::size_t at = 2; // behind the start-of-image marker
  bool in_scan = false;
  while (at + 1 < bytes.size()) {
    if (bytes[at] != 0xFF) {
      if (!in_scan) return false;
      ++at;
      continue;
    }
    const std::uint8_t marker = bytes[at + 1];
    if (marker == 0xFF) { // fill byte
      ++at;
      continue;
    }
    at += 2;
    if (marker == k_end_of_image) return true;
    // Stuffed zeros and restart markers belong to a scan and have no length.
    const bool is_restart = marker >= k_first_restart && marker <= k_last_restart;
    if (marker == 0x00 || is_restart) {
      if (!in_scan) return false;
      continue;
    }
    if (at + 2 > bytes.size()) return false;
    const std::size_t length = std::size_t(bytes[at]) << 8 | bytes[at + 1];
    if (length < 2 || length > bytes.size() - at) return false;
    if (marker == k_huffman_tables && !are_huffman_tables_sound(bytes.subspan(at + 2, length - 2)))
      return false;
    at += length;
    in_scan = marker == k_start_of_scan;
    is_progressive = is_progressive || marker == k_progressive_frame;
  }
  return false;
}

} // namespace

bool is_jpeg(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF;
}

Result<Samples> decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (!is_jpeg(bytes)) return Error{fmt::format("{}: not a JPEG file", name)};
  if (bytes.size() > INT_MAX) return Error{fmt::format("{}: JPEG file too large", name)};
  bool is_progressive = false;
  if (!is_whole(bytes, is_progressive))
    return Error{fmt::format("{}: the JPEG file is cut short or damaged", name)};

  const int size = int(bytes.size());
  Samples samples;
  if (!stbi_info_from_memory(bytes.data(), size, &samples.width, &samples.height,
                             &samples.channels))
    return Error{fmt::format("{}: cannot decode JPEG: {}", name, stbi_failure_reason())};
  // A byte for each sample of the file (of colours, there may be four), two more for the
  // coefficients of progressive ones, and the picture.
  const std::size_t in_file = (samples.channels == 1 ? 1 : 4) * (is_progressive ? 3 : 1);
  const std::size_t decoded = samples.channels == 1 ? 1 : 3;
  if (Status ok = check_readable(name, samples.width, samples.height, in_file + decoded); !ok)
    return ok.error();
  if (samples.channels != 1) samples.channels = 3;

  int channels_in_file = 0;
  samples.bits8 = std::shared_ptr<const std::uint8_t>(
      stbi_load_from_memory(bytes.data(), size, &samples.width, &samples.height, &channels_in_file,
                            samples.channels),
      [](const stbi_uc* pixels) { stbi_image_free(const_cast<stbi_uc*>(pixels)); });
  if (!samples.bits8)
    return Error{fmt::format("{}: cannot decode JPEG: {}", name, stbi_failure_reason())};
  return samples;
}

} // namespace openltc::image::codec
