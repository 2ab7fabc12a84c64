// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Reading OpenEXR files of any number of parts and layers. What the layers are is layer.h's
// business; here they become an Image in linear Rec.709.
//
// Lines go through a buffer of a few into the display window; nothing holds the file as a whole.

#include "openltc/image/codec.h"
#include "openltc/image/exr/exr_chroma.h"
#include "openltc/image/exr/exr_input.h"
#include "openltc/image/primaries.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace openltc::image {

namespace {

// A rectangle of the library's, whose corners may be anything, in numbers that do not overflow.
struct Box {
  std::int64_t x0 = 0, y0 = 0, x1 = 0, y1 = 0; // x1, y1 belong to it
  explicit Box(const Imath::Box2i& box)
      : x0(box.min.x), y0(box.min.y), x1(box.max.x), y1(box.max.y) {}
  std::int64_t width() const { return x1 - x0 + 1; }
  std::int64_t height() const { return y1 - y0 + 1; }
};

Result<Window> window_of(const Imath::Box2i& imath, const std::string& name) {
  const Box box(imath);
  if (Status ok = codec::check_size(name, box.width(), box.height()); !ok) return ok.error();
  return Window{int(box.x0), int(box.y0), int(box.width()), int(box.height())};
}

bool is_flat(const Imf::Header& header) {
  return !header.hasType() || header.type() == Imf::SCANLINEIMAGE ||
         header.type() == Imf::TILEDIMAGE;
}

Primaries primaries_of(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return {};
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  const auto pair = [](const Imath::V2f& v) -> std::array<double, 2> {
    return {double(v.x), double(v.y)};
  };
  return {pair(c.red), pair(c.green), pair(c.blue), pair(c.white)};
}

Result<std::vector<LayerInfo>> layers_of(const Imf::MultiPartInputFile& file,
                                         const std::string& name) {
  std::vector<PartChannels> parts;
  for (int p = 0; p < file.parts(); ++p) {
    const Imf::Header& header = file.header(p);
    PartChannels& part = parts.emplace_back();
    if (header.hasName()) part.name = header.name();
    part.flat = is_flat(header);
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
      part.channels.emplace_back(c.name());
  }
  std::vector<LayerInfo> layers = sort_into_layers(parts);
  for (LayerInfo& layer : layers) {
    const Imf::Header& header = file.header(layer.part);
    const Result<Window> display = window_of(header.displayWindow(), name);
    if (!display) return display.error();
    const Result<Window> data = window_of(header.dataWindow(), name);
    if (!data) return data.error();
    layer.display = *display;
    layer.data = *data;
    layer.pixel_aspect = double(header.pixelAspectRatio());
    layer.other_primaries =
        layer.kind == LayerKind::xyz || (is_picture(layer.kind) && layer.kind != LayerKind::grey &&
                                         !is_rec709(primaries_of(header)));
  }
  return layers;
}

// Whether a file of this size can have so many pixels, asked before memory is taken for them.
// Deflate, the core of the common compressions, shrinks by a factor of 1032 at most, run lengths by
// less; a pixel has at least one channel of two bytes, or of a quarter of that.
bool can_hold(std::uint64_t file_bytes, Imf::Compression compression, const Window& window) {
  switch (compression) {
  case Imf::NO_COMPRESSION:
  case Imf::RLE_COMPRESSION:
  case Imf::ZIPS_COMPRESSION:
  case Imf::ZIP_COMPRESSION:
  case Imf::PXR24_COMPRESSION:
    break;
  default:
    return true;
  }
  return std::uint64_t(window.width) * std::uint64_t(window.height) / 2 / 1032 <= file_bytes;
}

// Reads `names`, each in all pixels, into the display window; 0 where there are no data.
Image read_channels(Imf::InputPart& part, const std::vector<std::string>& names,
                    const LayerInfo& layer) {
  const int channels = int(names.size());
  const Window &data = layer.data, &display = layer.display;
  Image image(display.width, display.height, channels);
  // What is seen, in pixels of the file: corners that belong to it. Windows may lie anywhere.
  const std::int64_t x0 = std::max(data.x, display.x), y0 = std::max(data.y, display.y);
  const std::int64_t x1 =
      std::min(std::int64_t(data.x) + data.width, std::int64_t(display.x) + display.width) - 1;
  const std::int64_t y1 =
      std::min(std::int64_t(data.y) + data.height, std::int64_t(display.y) + display.height) - 1;
  if (x0 > x1 || y0 > y1) return image;

  constexpr std::int64_t lines = 32; // as many as most compressions keep together
  std::vector<float> buffer(std::size_t(data.width) * names.size() * std::size_t(lines));
  const std::size_t x_stride = sizeof(float) * names.size();
  for (std::int64_t y = y0; y <= y1; y += lines) {
    const std::int64_t end = std::min(y + lines - 1, y1);
    const Imath::Box2i box(Imath::V2i(data.x, int(y)),
                           Imath::V2i(int(std::int64_t(data.x) + data.width - 1), int(end)));
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < names.size(); ++c)
      frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, buffer.data() + c, box, x_stride,
                                              x_stride * std::size_t(data.width)));
    part.setFrameBuffer(frame);
    part.readPixels(int(y), int(end));
    for (std::int64_t line = y; line <= end; ++line)
      std::copy_n(buffer.data() +
                      (std::size_t(line - y) * std::size_t(data.width) + std::size_t(x0 - data.x)) *
                          names.size(),
                  std::size_t(x1 - x0 + 1) * names.size(),
                  image.pixel(int(x0 - display.x), int(line - display.y)));
  }
  return image;
}

// Chroma in the whole data window, each sample at its pixel, the pixels between them filled.
Image read_chroma(Imf::InputPart& part, const std::string& name, const Imf::Channel& channel,
                  const Window& data) {
  const int step_x = channel.xSampling, step_y = channel.ySampling;
  Image plane(data.width, data.height, 1);
  Imf::FrameBuffer frame;
  // The library refuses windows that do not begin at a sample, so all of them lie at even places.
  const Imath::Box2i box(Imath::V2i(data.x, data.y),
                         Imath::V2i(data.x + data.width - 1, data.y + data.height - 1));
  frame.insert(name, Imf::Slice::Make(Imf::FLOAT, plane.data.data(), box,
                                      sizeof(float) * std::size_t(step_x),
                                      sizeof(float) * std::size_t(data.width) * std::size_t(step_y),
                                      step_x, step_y));
  part.setFrameBuffer(frame);
  part.readPixels(data.y, data.y + data.height - 1);
  reconstruct_chroma(plane, step_x, step_y);
  return plane;
}

// Y RY BY (A) in the display window, not yet RGB.
Image read_luminance_chroma(Imf::InputPart& part, const LayerInfo& layer) {
  std::vector<std::string> full = {layer.channels[0]};
  if (layer.channels.size() == 4) full.push_back(layer.channels[3]);
  const Image luminance = read_channels(part, full, layer);
  Image image(luminance.width, luminance.height, int(layer.channels.size()));
  for (std::size_t i = 0; i < image.pixel_count(); ++i) {
    image.data[i * std::size_t(image.channels)] = luminance.data[i * full.size()];
    if (full.size() == 2) image.data[i * 4 + 3] = luminance.data[i * 2 + 1];
  }
  const Window &data = layer.data, &display = layer.display;
  for (int c = 1; c <= 2; ++c) {
    const std::string& name = layer.channels[std::size_t(c)];
    const Image plane = read_chroma(part, name, *part.header().channels().findChannel(name), data);
    for (int y = 0; y < plane.height; ++y)
      for (int x = 0; x < plane.width; ++x) {
        const std::int64_t to_x = std::int64_t(x) + data.x - display.x;
        const std::int64_t to_y = std::int64_t(y) + data.y - display.y;
        if (to_x >= 0 && to_x < display.width && to_y >= 0 && to_y < display.height)
          image.pixel(int(to_x), int(to_y))[c] = *plane.pixel(x, y);
      }
  }
  return image;
}

Status check_sampling(const Imf::ChannelList& list, const LayerInfo& layer,
                      const std::string& name) {
  for (std::size_t c = 0; c < layer.channels.size(); ++c) {
    const Imf::Channel* channel = list.findChannel(layer.channels[c]);
    const bool chroma = layer.kind == LayerKind::luminance_chroma && (c == 1 || c == 2);
    const int most = chroma ? 2 : 1;
    if (channel->xSampling < 1 || channel->xSampling > most || channel->ySampling < 1 ||
        channel->ySampling > most)
      return Error{fmt::format("{}: channel '{}' has one value for {}x{} pixels, which is not "
                               "supported; save it in full resolution",
                               name, layer.channels[c], channel->xSampling, channel->ySampling)};
  }
  return Success{};
}

// The colours of the file to those of an Image.
Status convert_colors(const Imf::Header& header, const LayerInfo& layer, const std::string& name,
                      Image& image) {
  if (layer.kind == LayerKind::xyz) multiply_colors(rec709_from_xyz(), image);
  if (layer.kind != LayerKind::color && layer.kind != LayerKind::luminance_chroma) return Success{};
  const Primaries primaries = primaries_of(header);
  const auto to_xyz = xyz_from_rgb(primaries);
  const auto to_rec709 = rec709_from_rgb(primaries);
  const bool chroma = layer.kind == LayerKind::luminance_chroma;
  if (!to_xyz || !to_rec709 || (chroma && !((*to_xyz)[1][1] > 1e-3)))
    return Error{fmt::format("{}: its chromaticities are no colour space, so its colours are not "
                             "known; mend or remove the attribute",
                             name)};
  if (chroma) rgb_from_luminance_chroma(image, *to_xyz);
  if (layer.other_primaries) multiply_colors(*to_rec709, image);
  return Success{};
}

Result<Image> read_chosen(ExrFile& file, const LayerInfo& layer, const std::string& name) {
  if (!file.parts->partComplete(layer.part))
    return Error{fmt::format("{}: the file is cut short", name)};
  const Imf::Header& header = file.parts->header(layer.part);
  if (Status ok = check_sampling(header.channels(), layer, name); !ok) return ok.error();
  if (!can_hold(file.stream->size(), header.compression(), layer.data))
    return Error{fmt::format("{}: too small a file for its {}x{} pixels: cut short or damaged",
                             name, layer.data.width, layer.data.height)};
  // Floats; where they are put together from several, these as well.
  const bool is_made = layer.kind == LayerKind::luminance_chroma || layer.channels.size() == 2;
  const std::size_t bytes =
      sizeof(float) * (is_made ? 8 : std::max<std::size_t>(layer.channels.size(), 3));
  for (const Window& window : {layer.display, layer.data})
    if (Status ok = codec::check_readable(name, window.width, window.height, bytes); !ok)
      return ok.error();
  Imf::InputPart part(*file.parts, layer.part);
  if (layer.kind == LayerKind::grey && layer.channels.size() == 2) { // grey with alpha
    const Image both = read_channels(part, layer.channels, layer);
    Image image(both.width, both.height, 4);
    for (std::size_t i = 0; i < both.pixel_count(); ++i) {
      std::fill_n(&image.data[4 * i], 3, both.data[2 * i]);
      image.data[4 * i + 3] = both.data[2 * i + 1];
    }
    return image;
  }
  Image image = layer.kind == LayerKind::luminance_chroma
                    ? read_luminance_chroma(part, layer)
                    : read_channels(part, layer.channels, layer);
  if (Status ok = convert_colors(header, layer, name, image); !ok) return ok.error();
  return image;
}

Result<Picture> read_from(Result<ExrFile> file, const std::string& wanted,
                          const std::string& name) {
  if (!file) return file.error();
  return guarded_exr<Picture>(name, "read", [&]() -> Result<Picture> {
    const Result<std::vector<LayerInfo>> layers = layers_of(*file->parts, name);
    if (!layers) return layers.error();
    Result<LayerInfo> layer = choose_layer(*layers, wanted, name);
    if (!layer) return layer.error();
    Result<Image> image = read_chosen(*file, *layer, name);
    if (!image) return image.error();
    return Picture{std::move(*layer), std::move(*image)};
  });
}

Result<std::vector<LayerInfo>> layers_from(Result<ExrFile> file, const std::string& name) {
  if (!file) return file.error();
  return guarded_exr<std::vector<LayerInfo>>(name, "read",
                                             [&] { return layers_of(*file->parts, name); });
}

} // namespace

Result<Picture> codec::read_exr(const std::string& path, const std::string& layer) {
  return read_from(open_exr(path), layer, path);
}

Result<Picture> codec::decode_exr(std::span<const std::uint8_t> bytes, const std::string& layer,
                                  const std::string& name) {
  return read_from(open_exr(bytes, name), layer, name);
}

Result<std::vector<LayerInfo>> codec::exr_layers(std::span<const std::uint8_t> bytes,
                                                 const std::string& name) {
  return layers_from(open_exr(bytes, name), name);
}

Result<std::vector<LayerInfo>> list_layers(const std::string& path) {
  return layers_from(open_exr(path), path);
}

} // namespace openltc::image
