// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Choosing the format, and what PNG and JPEG samples become.

#include "openltc/image/file.h"

#include "openltc/base/regular_file.h"
#include "openltc/image/codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace openltc::image {

namespace {

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

Result<std::vector<std::uint8_t>> read_bytes(const std::string& path) {
  constexpr std::uint64_t max_bytes = k_max_pixels * 8; // 4 channels of 16 bits, uncompressed
  Result<std::vector<std::uint8_t>> bytes = read_regular_file(path, max_bytes);
  if (bytes && bytes->empty()) return Error{fmt::format("{}: the file is empty", path)};
  return bytes;
}

Result<codec::Samples> decode_samples(std::span<const std::uint8_t> bytes,
                                      const std::string& name) {
  if (codec::is_png(bytes)) return codec::decode_png(bytes, name);
  if (codec::is_jpeg(bytes)) return codec::decode_jpeg(bytes, name);
  if (bytes.empty()) return Error{fmt::format("{}: no data", name)};
  return Error{fmt::format("{}: neither a PNG nor a JPEG file", name)};
}

// `color` turns a sample into a colour, `scale` into alpha.
template <class T, class Color>
Image expand(const codec::Samples& from, const std::vector<T>& samples, int channels, Color color,
             float scale) {
  Image image(from.width, from.height, channels);
  const bool has_alpha = from.channels == 2 || from.channels == 4;
  const bool is_grey = from.channels <= 2;
  const T* in = samples.data();
  float* out = image.data.data();
  for (std::size_t i = image.pixel_count(); i > 0; --i) {
    out[0] = color(in[0]);
    out[1] = is_grey ? out[0] : color(in[1]);
    out[2] = is_grey ? out[0] : color(in[2]);
    if (channels == 4) out[3] = has_alpha ? float(in[from.channels - 1]) * scale : 1.0f;
    in += from.channels;
    out += channels;
  }
  return image;
}

Image to_image(const codec::Samples& from, int channels, bool srgb_to_linear) {
  if (!from.bits8.empty()) {
    const auto& linear = codec::linear_from_srgb8();
    constexpr float scale = 1.0f / 255.0f;
    if (srgb_to_linear)
      return expand(
          from, from.bits8, channels, [&](std::uint8_t v) { return linear[v]; }, scale);
    return expand(
        from, from.bits8, channels, [](std::uint8_t v) { return float(v) * scale; }, scale);
  }
  constexpr float scale = 1.0f / 65535.0f;
  if (srgb_to_linear)
    return expand(
        from, from.bits16, channels,
        [](std::uint16_t v) { return linear_from_srgb(float(v) * scale); }, scale);
  return expand(
      from, from.bits16, channels, [](std::uint16_t v) { return float(v) * scale; }, scale);
}

} // namespace

Status codec::check_size(const std::string& name, std::int64_t width, std::int64_t height) {
  if (width <= 0 || height <= 0)
    return Error{fmt::format("{}: a picture of {}x{} pixels is empty", name, width, height)};
  if (width > k_max_side || height > k_max_side ||
      std::uint64_t(width) * std::uint64_t(height) > k_max_pixels)
    return Error{fmt::format("{}: {}x{} pixels are too many; the limit is {} a side and {} in all",
                             name, width, height, k_max_side, k_max_pixels)};
  return Success{};
}

Status codec::check_writable(const std::string& path, const Image& image) {
  if (Status ok = check_size(path, image.width, image.height); !ok) return ok;
  if (image.channels != 1 && image.channels != 3 && image.channels != 4)
    return Error{fmt::format("{}: cannot write a picture of {} channels, only 1, 3 or 4", path,
                             image.channels)};
  if (image.data.size() != image.pixel_count() * std::size_t(image.channels))
    return Error{fmt::format("{}: the picture has {} values instead of {}x{}x{}", path,
                             image.data.size(), image.width, image.height, image.channels)};
  return Success{};
}

Result<Image> read(const std::string& path) try {
  const std::string extension = lower_extension(path);
  if (extension == ".exr") {
    Result<Image> image = read_layer(path, "");
    return image ? Result<Image>(grey_as_rgb(std::move(*image))) : image;
  }
  if (!is_readable_extension(path))
    return Error{fmt::format("{}: unknown picture format '{}'; .exr, .hdr, .png, .jpg and .jpeg "
                             "can be read",
                             path, extension)};
  Result<std::vector<std::uint8_t>> bytes = read_bytes(path);
  if (!bytes) return bytes.error();
  if (extension == ".hdr") return codec::decode_radiance(*bytes, path);
  Result<codec::Samples> samples = decode_samples(*bytes, path);
  if (!samples) return samples.error();
  return to_image(*samples, samples->channels % 2 == 0 ? 4 : 3, true);
} catch (const std::bad_alloc&) {
  return Error{fmt::format("{}: not enough memory for the picture", path)};
}

Image grey_as_rgb(Image image) {
  if (image.channels != 1) return image;
  Image rgb(image.width, image.height, 3);
  for (std::size_t i = 0; i < image.data.size(); ++i)
    std::fill_n(rgb.data.begin() + std::ptrdiff_t(3 * i), 3, image.data[i]);
  return rgb;
}

Result<Picture> read_picture(const std::string& path, const std::string& layer) {
  if (lower_extension(path) == ".exr") return codec::read_exr(path, layer);
  if (!layer.empty())
    return Error{
        fmt::format("{}: has no layers, so none is '{}'; only .exr files have", path, layer)};
  Result<Image> image = read(path);
  if (!image) return image.error();
  LayerInfo info;
  info.channels = {"R", "G", "B"};
  if (image->channels == 4) info.channels.emplace_back("A");
  info.display = info.data = {0, 0, image->width, image->height};
  return Picture{std::move(info), std::move(*image)};
}

Result<Image> read_layer(const std::string& path, const std::string& layer) {
  Result<Picture> picture = read_picture(path, layer);
  if (!picture) return picture.error();
  return std::move(picture->image);
}

Result<std::vector<std::string>> layer_names(const std::string& path) {
  const Result<std::vector<LayerInfo>> layers = list_layers(path);
  if (!layers) return layers.error();
  std::vector<std::string> names;
  for (const LayerInfo& layer : *layers)
    names.push_back(layer.name);
  return names;
}

PictureName split_picture_name(const std::string& name) {
  std::error_code ec;
  if (std::filesystem::exists(name, ec)) return {name, ""};
  for (std::size_t colon = name.find(':'); colon != std::string::npos;
       colon = name.find(':', colon + 1))
    if (lower_extension(name.substr(0, colon)) == ".exr")
      return {name.substr(0, colon), name.substr(colon + 1)};
  return {name, ""};
}

Result<Image> decode(std::span<const std::uint8_t> bytes, const std::string& name,
                     bool srgb_to_linear) try {
  Result<codec::Samples> samples = decode_samples(bytes, name);
  if (!samples) return samples.error();
  return to_image(*samples, 4, srgb_to_linear);
} catch (const std::bad_alloc&) {
  return Error{fmt::format("{}: not enough memory for the picture", name)};
}

bool is_readable_extension(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".exr" || extension == ".hdr" || extension == ".png" || extension == ".jpg" ||
         extension == ".jpeg";
}

bool is_writable_extension(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".exr" || extension == ".hdr" || extension == ".png";
}

bool is_scene_linear_extension(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".exr" || extension == ".hdr";
}

} // namespace openltc::image
