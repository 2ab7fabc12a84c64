// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Choosing the format, and what PNG and JPEG samples become.

#include "openltc/image/file.h"

#include "openltc/base/memory_budget.h"
#include "openltc/base/regular_file.h"
#include "openltc/image/codec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

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
  std::error_code ec;
  const std::uintmax_t size = std::filesystem::file_size(path, ec);
  if (!ec && size <= max_bytes)
    if (Status ok = memory_budget().check(size, path); !ok) return ok.error();
  Result<std::vector<std::uint8_t>> bytes = read_regular_file(path, max_bytes);
  if (bytes && bytes->empty()) return Error{fmt::format("{}: the file is empty", path)};
  return bytes;
}

// Formats that are recognised so that messages can name them.
std::string_view foreign_format(std::span<const std::uint8_t> bytes) {
  constexpr struct {
    std::string_view name;
    std::size_t at;
    std::string_view magic;
  } formats[] = {{"KTX2", 0, "\xABKTX 20\xBB"},
                 {"KTX", 0, "\xABKTX 11\xBB"},
                 {"Basis Universal", 0, "sB\x13"},
                 {"DDS", 0, "DDS "},
                 {"AVIF", 4, "ftypavif"},
                 {"HEIF", 4, "ftyphei"},
                 {"JPEG XL", 0, "\xFF\x0A"},
                 {"JPEG XL", 4, "JXL "},
                 {"JPEG 2000", 4, "jP  "},
                 {"GIF", 0, "GIF8"},
                 {"BMP", 0, "BM"},
                 {"TIFF", 0, "II*"},
                 {"TIFF", 0, "MM"},
                 {"OpenEXR", 0, "\x76\x2F\x31\x01"},
                 {"Radiance", 0, "#?"},
                 {"Photoshop", 0, "8BPS"},
                 {"SVG", 0, "<svg"},
                 {"HTML", 0, "<!DOCTYPE html"}};
  for (const auto& format : formats)
    if (bytes.size() >= format.at + format.magic.size() &&
        std::memcmp(bytes.data() + format.at, format.magic.data(), format.magic.size()) == 0)
      return format.name;
  return {};
}

Result<codec::Samples> decode_samples(std::span<const std::uint8_t> bytes,
                                      const std::string& name) {
  if (codec::is_png(bytes)) return codec::decode_png(bytes, name);
  if (codec::is_jpeg(bytes)) return codec::decode_jpeg(bytes, name);
  if (codec::is_webp(bytes)) return codec::decode_webp(bytes, name);
  if (bytes.empty()) return Error{fmt::format("{}: no data", name)};
  const std::string_view other = foreign_format(bytes);
  return Error{fmt::format("{}: {}; PNG, JPEG and WebP can be read", name,
                           other.empty() ? "not a picture of a known format"
                                         : fmt::format("a picture in the format {}", other))};
}

// `color` turns a sample into a colour, `scale` into alpha.
template <class T, class Color>
Image expand(const codec::Samples& from, const T* samples, int channels, Color color, float scale) {
  Image image(from.width, from.height, channels);
  const bool has_alpha = from.channels == 2 || from.channels == 4;
  const bool is_grey = from.channels <= 2;
  const T* in = samples;
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
  if (from.bits8) {
    const auto& linear = codec::linear_from_srgb8();
    constexpr float scale = 1.0f / 255.0f;
    if (srgb_to_linear)
      return expand(
          from, from.bits8.get(), channels, [&](std::uint8_t v) { return linear[v]; }, scale);
    return expand(
        from, from.bits8.get(), channels, [](std::uint8_t v) { return float(v) * scale; }, scale);
  }
  constexpr float scale = 1.0f / 65535.0f;
  if (srgb_to_linear)
    return expand(
        from, from.bits16.data(), channels,
        [](std::uint16_t v) { return linear_from_srgb(float(v) * scale); }, scale);
  return expand(
      from, from.bits16.data(), channels, [](std::uint16_t v) { return float(v) * scale; }, scale);
}

} // namespace

std::shared_ptr<std::uint8_t> codec::new_bytes(std::size_t count) {
  auto* const bytes = static_cast<std::uint8_t*>(std::calloc(std::max<std::size_t>(count, 1), 1));
  return bytes ? std::shared_ptr<std::uint8_t>(bytes, std::free) : nullptr;
}

Status codec::check_size(const std::string& name, std::int64_t width, std::int64_t height) {
  if (width <= 0 || height <= 0)
    return Error{fmt::format("{}: a picture of {}x{} pixels is empty", name, width, height)};
  if (width > k_max_side || height > k_max_side ||
      std::uint64_t(width) * std::uint64_t(height) > k_max_pixels)
    return Error{fmt::format("{}: {}x{} pixels are too many; the limit is {} a side and {} in all",
                             name, width, height, k_max_side, k_max_pixels)};
  return Success{};
}

Status codec::check_readable(const std::string& name, std::int64_t width, std::int64_t height,
                             std::size_t bytes_per_pixel) {
  if (Status ok = check_size(name, width, height); !ok) return ok;
  const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
  return memory_budget().check(pixels * bytes_per_pixel,
                               fmt::format("{}: a picture of {}x{} pixels", name, width, height));
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

namespace {

bool holds_floats(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".exr" || extension == ".hdr";
}

Result<Image> read_floats(const std::string& path) {
  if (lower_extension(path) == ".exr") {
    Result<Image> image = read_layer(path, "");
    return image ? Result<Image>(grey_as_rgb(std::move(*image))) : image;
  }
  const Result<std::vector<std::uint8_t>> bytes = read_bytes(path);
  return bytes ? codec::decode_radiance(*bytes, path) : Result<Image>(bytes.error());
}

Result<codec::Samples> read_samples(const std::string& path) {
  if (!is_readable_extension(path))
    return Error{fmt::format("{}: unknown picture format '{}'; .exr, .hdr, .png, .jpg, .jpeg and "
                             ".webp can be read",
                             path, lower_extension(path))};
  const Result<std::vector<std::uint8_t>> bytes = read_bytes(path);
  return bytes ? decode_samples(*bytes, path) : Result<codec::Samples>(bytes.error());
}

Texels texels_of(codec::Samples samples, bool srgb_to_linear) {
  const auto keep = [&](auto& values) {
    return Texels(samples.width, samples.height, samples.channels, std::move(values),
                  srgb_to_linear);
  };
  return samples.bits8 ? keep(samples.bits8) : keep(samples.bits16);
}

} // namespace

Result<Image> read(const std::string& path) try {
  if (holds_floats(path)) return read_floats(path);
  const Result<codec::Samples> samples = read_samples(path);
  if (!samples) return samples.error();
  const int channels = samples->channels % 2 == 0 ? 4 : 3;
  if (Status ok = codec::check_readable(path, samples->width, samples->height,
                                        std::size_t(channels) * sizeof(float));
      !ok)
    return ok.error();
  return to_image(*samples, channels, true);
} catch (const std::bad_alloc&) {
  return Error{fmt::format("{}: not enough memory for the picture", path)};
}

Result<Texels> read_texels(const std::string& path) try {
  if (holds_floats(path)) {
    Result<Image> image = read_floats(path);
    return image ? Result<Texels>(Texels(std::move(*image))) : Result<Texels>(image.error());
  }
  Result<codec::Samples> samples = read_samples(path);
  if (!samples) return samples.error();
  return texels_of(std::move(*samples), true);
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

Result<Texels> decode_texels(std::span<const std::uint8_t> bytes, const std::string& name,
                             bool srgb_to_linear) try {
  Result<codec::Samples> samples = decode_samples(bytes, name);
  if (!samples) return samples.error();
  return texels_of(std::move(*samples), srgb_to_linear);
} catch (const std::bad_alloc&) {
  return Error{fmt::format("{}: not enough memory for the picture", name)};
}

bool can_read_webp() { return codec::has_webp(); }

bool is_readable_extension(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".exr" || extension == ".hdr" || extension == ".png" || extension == ".jpg" ||
         extension == ".jpeg" || extension == ".webp";
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
