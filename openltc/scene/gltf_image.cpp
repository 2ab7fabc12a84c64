// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf_image.h"

// The library's own copy of the decoder: other libraries link theirs.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 16384
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace openltc::scene::gltf {

namespace {

// sRGB transfer function, IEC 61966-2-1.
float linear_from_srgb(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

// One look-up per possible value of a channel.
std::vector<float> channel_values(std::size_t levels, bool srgb_to_linear) {
  std::vector<float> values(levels);
  for (std::size_t i = 0; i < levels; ++i) {
    const float v = float(i) / float(levels - 1);
    values[i] = srgb_to_linear ? linear_from_srgb(v) : v;
  }
  return values;
}

template <class T>
image::Image to_image(const T* pixels, int width, int height, bool srgb_to_linear) {
  const std::size_t levels = std::size_t(std::numeric_limits<T>::max()) + 1;
  const std::vector<float> color = channel_values(levels, srgb_to_linear);
  image::Image result(width, height, 4);
  const std::size_t count = result.pixel_count();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      result.data[4 * i + c] = color[pixels[4 * i + c]];
    result.data[4 * i + 3] = float(pixels[4 * i + 3]) / float(levels - 1);
  }
  return result;
}

struct FreePixels {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

bool read_size(std::span<const std::uint8_t> bytes, int& width, int& height) {
  int channels = 0;
  return bytes.size() <= std::size_t(std::numeric_limits<int>::max()) &&
         stbi_info_from_memory(bytes.data(), int(bytes.size()), &width, &height, &channels) != 0;
}

} // namespace

Result<image::Image> decode(std::span<const std::uint8_t> bytes, const std::string& name,
                            bool srgb_to_linear) {
  int width = 0, height = 0, channels = 0;
  if (!read_size(bytes, width, height))
    return Error{
        fmt::format("{}: is not a readable PNG or JPEG; convert it or export again", name)};
  if (width > k_max_image_side || height > k_max_image_side)
    return Error{fmt::format("{}: {} x {} pixels are too many; reduce it to at most {} x {}", name,
                             width, height, k_max_image_side, k_max_image_side)};
  const int size = int(bytes.size());
  const Error broken{fmt::format("{}: the picture is damaged; convert it or export again", name)};
  if (stbi_is_16_bit_from_memory(bytes.data(), size)) {
    const std::unique_ptr<stbi_us, FreePixels> pixels(
        stbi_load_16_from_memory(bytes.data(), size, &width, &height, &channels, 4));
    if (!pixels) return broken;
    return to_image(pixels.get(), width, height, srgb_to_linear);
  }
  const std::unique_ptr<stbi_uc, FreePixels> pixels(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4));
  if (!pixels) return broken;
  return to_image(pixels.get(), width, height, srgb_to_linear);
}

std::size_t pixel_count(std::span<const std::uint8_t> bytes) {
  int width = 0, height = 0;
  if (!read_size(bytes, width, height) || width <= 0 || height <= 0) return 0;
  return std::size_t(width) * std::size_t(height);
}

} // namespace openltc::scene::gltf
