// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Reading JPEG (ITU-T T.81, baseline and progressive) through stb_image.

#include "openltc/image/codec.h"

#include <climits>
#include <fmt/format.h>

#include <cstring>

// Static, because other libraries of the process (tinygltf) carry their own copy.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 65535
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

// stb_image fills up a file that ends early instead of refusing it. This walks over the markers
// (T.81, annex B) and tells whether the last one, end of image, is reached.
bool has_end_of_image(std::span<const std::uint8_t> bytes) {
  constexpr std::uint8_t start_of_scan = 0xDA, end_of_image = 0xD9;
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
    if (marker == end_of_image) return true;
    // Stuffed zeros and restart markers belong to a scan and have no length.
    if (marker == 0x00 || marker == 0x01 || (marker >= 0xD0 && marker <= 0xD7)) continue;
    if (at + 2 > bytes.size()) return false;
    const std::size_t length = std::size_t(bytes[at]) << 8 | bytes[at + 1];
    if (length < 2) return false;
    at += length;
    in_scan = marker == start_of_scan;
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
  if (!has_end_of_image(bytes))
    return Error{fmt::format("{}: the JPEG file is cut short or damaged", name)};

  const int size = int(bytes.size());
  Samples samples;
  if (!stbi_info_from_memory(bytes.data(), size, &samples.width, &samples.height,
                             &samples.channels))
    return Error{fmt::format("{}: cannot decode JPEG: {}", name, stbi_failure_reason())};
  if (Status ok = check_size(name, samples.width, samples.height); !ok) return ok.error();
  if (samples.channels != 1) samples.channels = 3;

  int channels_in_file = 0;
  stbi_uc* pixels = stbi_load_from_memory(bytes.data(), size, &samples.width, &samples.height,
                                          &channels_in_file, samples.channels);
  if (!pixels) return Error{fmt::format("{}: cannot decode JPEG: {}", name, stbi_failure_reason())};
  const std::size_t count =
      std::size_t(samples.width) * std::size_t(samples.height) * std::size_t(samples.channels);
  try {
    samples.bits8.assign(pixels, pixels + count);
  } catch (const std::bad_alloc&) {
    stbi_image_free(pixels);
    return Error{fmt::format("{}: not enough memory for the picture", name)};
  }
  stbi_image_free(pixels);
  return samples;
}

} // namespace openltc::image::codec
