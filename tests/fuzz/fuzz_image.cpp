// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Any bytes as a picture file: every layer ends in a picture of the size that its header gives, or
// in one line that begins with the file's name.

#include "openltc/image/codec.h"

#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

using namespace openltc;
using namespace openltc::image;

namespace {

// Larger ones are only what the reader promises, not what fuzzing has time for.
constexpr std::int64_t k_most_pixels = std::int64_t(1) << 20;

void require(bool promise) {
  if (!promise) std::abort();
}

template <class T> bool fails_clearly(const Result<T>& result) {
  if (result.ok()) return false;
  require(result.error().message.rfind("fuzz: ", 0) == 0);
  require(result.error().message.find('\n') == std::string::npos);
  return true;
}

void check(const Image& image) {
  require(image.width > 0 && image.height > 0);
  require(image.data.size() == image.pixel_count() * std::size_t(image.channels));
}

void read_exr(std::span<const std::uint8_t> bytes) {
  const Result<std::vector<LayerInfo>> layers = codec::exr_layers(bytes, "fuzz");
  if (fails_clearly(layers)) return;
  int read = 0;
  for (const LayerInfo& layer : *layers) {
    const auto pixels = [](const Window& w) { return std::int64_t(w.width) * w.height; };
    if (pixels(layer.data) > k_most_pixels || pixels(layer.display) > k_most_pixels) continue;
    if (++read > 8) break;
    const Result<LayerInfo> chosen = choose_layer(*layers, layer.name, "fuzz");
    if (layer.name.empty()) continue;
    require(chosen.ok() ? chosen->name == layer.name : layer.kind == LayerKind::not_flat);
    const Result<Picture> picture = codec::decode_exr(bytes, layer.name, "fuzz");
    if (fails_clearly(picture)) continue;
    check(picture->image);
    require(picture->image.width == layer.display.width);
    require(picture->image.height == layer.display.height);
  }
  for (const LayerInfo& layer : *layers)
    if (std::int64_t(layer.data.width) * layer.data.height > k_most_pixels ||
        std::int64_t(layer.display.width) * layer.display.height > k_most_pixels)
      return;
  const Result<Picture> picture = codec::decode_exr(bytes, "", "fuzz");
  if (!fails_clearly(picture)) check(picture->image);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  if (size >= 4 && data[0] == 0x76 && data[1] == 0x2f) {
    read_exr(bytes);
  } else if (size >= 2 && data[0] == '#' && data[1] == '?') {
    const Result<Image> image = codec::decode_radiance(bytes, "fuzz");
    if (!fails_clearly(image)) check(*image);
  } else {
    const Result<Image> image = decode(bytes, "fuzz", true);
    if (!fails_clearly(image)) check(*image);
  }
  return 0;
}
