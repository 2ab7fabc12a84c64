// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Writing OpenEXR files. A layer is a group of channels LAYER.R LAYER.G LAYER.B, as the OpenEXR
// documentation of channel names prescribes; the picture itself has no prefix.

#include "openltc/base/atomic_file.h"
#include "openltc/image/codec.h"
#include "openltc/image/exr/exr_input.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <half.h>
#include <set>
#include <stdexcept>
#include <vector>

namespace openltc::image {

namespace {

constexpr float k_half_max = 65504.0f; // largest finite value of half precision

// OpenEXR's own stream drops what fails while a file is being closed, on a full disk say.
class FileStream : public Imf::OStream {
public:
  explicit FileStream(const std::string& path)
      : Imf::OStream(path.c_str()), file_(std::fopen(path.c_str(), "wb")) {
    if (!file_) throw std::runtime_error(std::strerror(errno));
  }
  ~FileStream() override {
    if (file_) std::fclose(file_);
  }
  void write(const char bytes[], int count) override {
    if (std::fwrite(bytes, 1, std::size_t(count), file_) != std::size_t(count)) fail();
  }
  ExrOffset tellp() override {
    const long at = std::ftell(file_);
    if (at < 0) fail();
    return ExrOffset(at);
  }
  void seekp(ExrOffset to) override {
    if (std::fseek(file_, long(to), SEEK_SET) != 0) fail();
  }
  /// To be called after the OutputFile is gone. Throws if anything of the file was not written.
  void close() {
    std::FILE* file = file_;
    file_ = nullptr;
    if (std::fclose(file) != 0) fail();
    if (error_ != 0) throw std::runtime_error(std::strerror(error_));
  }

private:
  void fail() {
    if (error_ == 0) error_ = errno != 0 ? errno : EIO;
    throw std::runtime_error(std::strerror(error_));
  }
  std::FILE* file_ = nullptr;
  int error_ = 0;
};

std::string channel_name(const std::string& layer, const char* component) {
  return layer.empty() ? component : layer + "." + component;
}

std::vector<std::string> component_names(const std::string& layer, int channels) {
  if (channels == 1) return {channel_name(layer, "Y")};
  std::vector<std::string> names;
  for (const char* component : {"R", "G", "B", "A"})
    if (int(names.size()) < channels) names.push_back(channel_name(layer, component));
  return names;
}

// A slice of floats whose `first` value belongs to the pixel box.min.
Imf::Slice slice_at(const float* first, const Imath::Box2i& box, std::size_t x_stride,
                    std::size_t y_stride) {
  return Imf::Slice::Make(Imf::FLOAT, first, box, x_stride, y_stride);
}

// Writes lines one after the other through a buffer of a single line in half precision.
void write_halves(Imf::OutputFile& file, std::span<const LayerView> layers) {
  const int width = layers[0].image->width;
  const int height = layers[0].image->height;
  std::vector<std::vector<half>> lines;
  Imf::FrameBuffer frame;
  for (const LayerView& layer : layers) {
    const std::size_t channels = std::size_t(layer.image->channels);
    const std::vector<std::string> names = component_names(layer.name, layer.image->channels);
    lines.emplace_back(std::size_t(width) * channels);
    for (std::size_t c = 0; c < channels; ++c) // a row stride of 0: every row lies in the same line
      frame.insert(names[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(lines.back().data() + c),
                                        sizeof(half) * channels, 0));
  }
  file.setFrameBuffer(frame);
  for (int y = 0; y < height; ++y) {
    for (std::size_t l = 0; l < layers.size(); ++l) {
      const float* row = layers[l].image->pixel(0, y);
      std::transform(row, row + lines[l].size(), lines[l].begin(), [](float v) {
        return half(std::isfinite(v) ? std::clamp(v, -k_half_max, k_half_max) : v);
      });
    }
    file.writePixels(1);
  }
}

void write_floats(Imf::OutputFile& file, std::span<const LayerView> layers) {
  Imf::FrameBuffer frame;
  for (const LayerView& layer : layers) {
    const Image& image = *layer.image;
    const Imath::Box2i box(Imath::V2i(0, 0), Imath::V2i(image.width - 1, image.height - 1));
    const std::vector<std::string> names = component_names(layer.name, image.channels);
    const std::size_t x_stride = sizeof(float) * names.size();
    for (std::size_t c = 0; c < names.size(); ++c)
      frame.insert(names[c], slice_at(image.data.data() + c, box, x_stride,
                                      x_stride * std::size_t(image.width)));
  }
  file.setFrameBuffer(frame);
  file.writePixels(layers[0].image->height);
}

Status check_layers(const std::string& path, std::span<const LayerView> layers) {
  if (layers.empty()) return Error{fmt::format("{}: no layer to write", path)};
  std::set<std::string> names;
  for (const LayerView& layer : layers) {
    if (Status ok = codec::check_writable(path, *layer.image); !ok) return ok;
    if (layer.image->width != layers[0].image->width ||
        layer.image->height != layers[0].image->height)
      return Error{fmt::format("{}: layer '{}' has {}x{} pixels, the first layer {}x{}", path,
                               layer.name, layer.image->width, layer.image->height,
                               layers[0].image->width, layers[0].image->height)};
    if (!names.insert(layer.name).second)
      return Error{fmt::format("{}: two layers are named '{}'", path, layer.name)};
  }
  if (!layers[0].name.empty())
    return Error{
        fmt::format("{}: the first layer must have an empty name, not '{}'", path, layers[0].name)};
  return Success{};
}

} // namespace

Status write_exr(const std::string& path, std::span<const Layer> layers, ExrPrecision precision) {
  std::vector<LayerView> views;
  for (const Layer& layer : layers)
    views.push_back({layer.name, &layer.image});
  return write_exr_views(path, views, precision);
}

Status write_exr_views(const std::string& path, std::span<const LayerView> layers,
                       ExrPrecision precision) {
  if (Status ok = check_layers(path, layers); !ok) return ok;
  const bool halves = precision == ExrPrecision::half_float;
  return write_atomically(path, [&](const std::string& temporary) {
    return guarded_exr<Success>(path, "write", [&]() -> Status {
      Imf::Header header(layers[0].image->width, layers[0].image->height);
      header.compression() = Imf::ZIP_COMPRESSION;
      for (const LayerView& layer : layers)
        for (const std::string& name : component_names(layer.name, layer.image->channels))
          header.channels().insert(name, Imf::Channel(halves ? Imf::HALF : Imf::FLOAT));
      FileStream stream(temporary);
      {
        Imf::OutputFile file(stream, header);
        if (halves)
          write_halves(file, layers);
        else
          write_floats(file, layers);
      }
      stream.close();
      return Success{};
    });
  });
}

} // namespace openltc::image
