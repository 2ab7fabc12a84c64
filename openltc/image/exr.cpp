// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// OpenEXR files through the OpenEXR library, version 2.5 or 3. A layer is a group of channels
// LAYER.R LAYER.G LAYER.B, as the OpenEXR documentation of channel names prescribes; the picture
// itself has no prefix.
//
// Pixels go straight between the file and the caller's picture; nothing holds the file as a whole.

#include "openltc/base/atomic_file.h"
#include "openltc/base/regular_file.h"
#include "openltc/image/codec.h"
#include "openltc/image/exr_header.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <half.h>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

namespace openltc::image {

namespace {

constexpr float k_half_max = 65504.0f; // largest finite value of half precision

// A position in a file; OpenEXR 2 and 3 spell the type differently.
using Offset = decltype(std::declval<Imf::OStream&>().tellp());

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
  Offset tellp() override {
    const long at = std::ftell(file_);
    if (at < 0) fail();
    return Offset(at);
  }
  void seekp(Offset to) override {
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

// The channels of the file that make up `layer`, in the order of Image; empty if it is not there.
std::vector<std::string> find_components(const Imf::ChannelList& list, const std::string& layer) {
  for (int channels : {4, 3, 1}) {
    const std::vector<std::string> names = component_names(layer, channels);
    if (std::all_of(names.begin(), names.end(),
                    [&](const std::string& n) { return list.findChannel(n) != nullptr; }))
      return names;
  }
  if (!layer.empty() && list.findChannel(layer)) return {layer};
  return {};
}

std::vector<std::string> find_layers(const Imf::ChannelList& list) {
  std::set<std::string> names;
  for (auto i = list.begin(); i != list.end(); ++i) {
    const std::string channel = i.name();
    const std::size_t dot = channel.rfind('.');
    // A channel without a dot belongs to the picture, or is a layer by itself ("Z").
    const std::string layer = dot == std::string::npos ? "" : channel.substr(0, dot);
    names.insert(find_components(list, layer).empty() ? channel : layer);
    if (dot == std::string::npos && channel.size() > 1) names.insert(channel);
  }
  std::vector<std::string> layers;
  for (const std::string& name : names)
    if (!find_components(list, name).empty()) layers.push_back(name);
  return layers;
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += fmt::format("{}'{}'", text.empty() ? "" : ", ", name);
  return text;
}

// A slice of floats whose `first` value belongs to the pixel box.min.
Imf::Slice slice_at(const float* first, const Imath::Box2i& box, std::size_t x_stride,
                    std::size_t y_stride) {
  return Imf::Slice::Make(Imf::FLOAT, first, box, x_stride, y_stride);
}

Status check_exists(const std::string& path) {
  const Result<RegularFile> file = open_regular_file(path, k_max_pixels * 64);
  if (!file) return file.error();
  std::uint8_t magic[4] = {};
  const Result<std::size_t> got = file->read_at(0, magic);
  if (!got) return got.error();
  if (*got == 0) return Error{fmt::format("{}: the file is empty", path)};
  if (*got < 4 || magic[0] != 0x76 || magic[1] != 0x2f || magic[2] != 0x31 || magic[3] != 0x01)
    return Error{fmt::format("{}: not an OpenEXR file", path)};
  return Success{};
}

void limit_header_sizes() {
  static const bool done = [] {
    Imf::Header::setMaxImageSize(k_max_side, k_max_side);
    Imf::Header::setMaxTileSize(8192, 8192); // a tile is held in memory as a whole
    return true;
  }();
  (void)done;
}

// Whether a file of this size can have so many pixels, asked before memory is taken for them.
// Deflate, the core of the common compressions, shrinks by a factor of 1032 at most, run lengths by
// less; a pixel has at least one channel of two bytes.
bool can_hold(const std::string& path, Imf::Compression compression, const Imath::Box2i& window) {
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
  std::error_code ec;
  const std::uintmax_t bytes = std::filesystem::file_size(path, ec);
  const std::uint64_t width = std::uint64_t(std::int64_t(window.max.x) - window.min.x + 1);
  const std::uint64_t height = std::uint64_t(std::int64_t(window.max.y) - window.min.y + 1);
  return ec || width * height * 2 / 1032 <= bytes;
}

// Whatever OpenEXR throws becomes one line.
template <class T, class Function>
Result<T> guarded(const std::string& path, const char* action, Function&& function) {
  try {
    return function();
  } catch (const std::bad_alloc&) {
    return Error{fmt::format("{}: not enough memory for the picture", path)};
  } catch (const std::exception& e) {
    std::string text = e.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return Error{fmt::format("{}: cannot {} OpenEXR: {}", path, action, text)};
  } catch (...) {
    return Error{fmt::format("{}: cannot {} OpenEXR", path, action)};
  }
}

Result<Image> read_components(const std::string& path, Imf::InputFile& file,
                              const std::vector<std::string>& names) {
  const Imf::ChannelList& list = file.header().channels();
  for (const std::string& name : names) {
    const Imf::Channel* channel = list.findChannel(name);
    if (channel->xSampling != 1 || channel->ySampling != 1)
      return Error{
          fmt::format("{}: channel '{}' is subsampled, which is not supported", path, name)};
  }
  const Imath::Box2i data = file.header().dataWindow();
  const Imath::Box2i display = file.header().displayWindow();
  for (const Imath::Box2i& box : {data, display}) {
    const std::int64_t width = std::int64_t(box.max.x) - box.min.x + 1;
    const std::int64_t height = std::int64_t(box.max.y) - box.min.y + 1;
    if (Status ok = codec::check_size(path, width, height); !ok) return ok.error();
  }

  if (!can_hold(path, file.header().compression(), data))
    return Error{fmt::format("{}: too small a file for its {}x{} pixels: cut short or damaged",
                             path, data.max.x - data.min.x + 1, data.max.y - data.min.y + 1)};

  const int channels = int(names.size());
  Image image(data.max.x - data.min.x + 1, data.max.y - data.min.y + 1, channels);
  Imf::FrameBuffer frame;
  const std::size_t x_stride = sizeof(float) * names.size();
  for (std::size_t c = 0; c < names.size(); ++c)
    frame.insert(names[c], slice_at(image.data.data() + c, data, x_stride,
                                    x_stride * std::size_t(image.width)));
  file.setFrameBuffer(frame);
  file.readPixels(data.min.y, data.max.y);
  if (data == display) return image;

  // Move what is visible into the display window.
  Image visible(display.max.x - display.min.x + 1, display.max.y - display.min.y + 1, channels);
  const int x0 = std::max(data.min.x, display.min.x), x1 = std::min(data.max.x, display.max.x);
  const int y0 = std::max(data.min.y, display.min.y), y1 = std::min(data.max.y, display.max.y);
  for (int y = y0; y <= y1 && x0 <= x1; ++y)
    std::copy_n(image.pixel(x0 - data.min.x, y - data.min.y), (x1 - x0 + 1) * channels,
                visible.pixel(x0 - display.min.x, y - display.min.y));
  return visible;
}

// Writes lines one after the other through a buffer of a single line in half precision.
void write_halves(Imf::OutputFile& file, std::span<const Layer> layers) {
  const int width = layers[0].image.width;
  const int height = layers[0].image.height;
  std::vector<std::vector<half>> lines;
  Imf::FrameBuffer frame;
  for (const Layer& layer : layers) {
    const std::size_t channels = std::size_t(layer.image.channels);
    const std::vector<std::string> names = component_names(layer.name, layer.image.channels);
    lines.emplace_back(std::size_t(width) * channels);
    for (std::size_t c = 0; c < channels; ++c) // a row stride of 0: every row lies in the same line
      frame.insert(names[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(lines.back().data() + c),
                                        sizeof(half) * channels, 0));
  }
  file.setFrameBuffer(frame);
  for (int y = 0; y < height; ++y) {
    for (std::size_t l = 0; l < layers.size(); ++l) {
      const float* row = layers[l].image.pixel(0, y);
      std::transform(row, row + lines[l].size(), lines[l].begin(), [](float v) {
        return half(std::isfinite(v) ? std::clamp(v, -k_half_max, k_half_max) : v);
      });
    }
    file.writePixels(1);
  }
}

void write_floats(Imf::OutputFile& file, std::span<const Layer> layers) {
  Imf::FrameBuffer frame;
  for (const Layer& layer : layers) {
    const Image& image = layer.image;
    const Imath::Box2i box(Imath::V2i(0, 0), Imath::V2i(image.width - 1, image.height - 1));
    const std::vector<std::string> names = component_names(layer.name, image.channels);
    const std::size_t x_stride = sizeof(float) * names.size();
    for (std::size_t c = 0; c < names.size(); ++c)
      frame.insert(names[c], slice_at(image.data.data() + c, box, x_stride,
                                      x_stride * std::size_t(image.width)));
  }
  file.setFrameBuffer(frame);
  file.writePixels(layers[0].image.height);
}

Status check_layers(const std::string& path, std::span<const Layer> layers) {
  if (layers.empty()) return Error{fmt::format("{}: no layer to write", path)};
  std::set<std::string> names;
  for (const Layer& layer : layers) {
    if (Status ok = codec::check_writable(path, layer.image); !ok) return ok;
    if (layer.image.width != layers[0].image.width || layer.image.height != layers[0].image.height)
      return Error{fmt::format("{}: layer '{}' has {}x{} pixels, the first layer {}x{}", path,
                               layer.name, layer.image.width, layer.image.height,
                               layers[0].image.width, layers[0].image.height)};
    if (!names.insert(layer.name).second)
      return Error{fmt::format("{}: two layers are named '{}'", path, layer.name)};
  }
  if (!layers[0].name.empty())
    return Error{
        fmt::format("{}: the first layer must have an empty name, not '{}'", path, layers[0].name)};
  return Success{};
}

// Before the library takes what the header asks for.
Status check_header(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  if (!exr_attributes_fit(bytes))
    return Error{fmt::format("{}: the header is damaged or no OpenEXR header", path)};
  return Success{};
}

} // namespace

Result<Image> read_layer(const std::string& path, const std::string& layer) {
  if (Status ok = check_exists(path); !ok) return ok.error();
  return guarded<Image>(path, "read", [&]() -> Result<Image> {
    limit_header_sizes();
    if (Status ok = check_header(path); !ok) return ok.error();
    Imf::InputFile file(path.c_str());
    if (!file.isComplete()) return Error{fmt::format("{}: the file is cut short", path)};
    const std::vector<std::string> names = find_components(file.header().channels(), layer);
    if (names.empty())
      return Error{fmt::format("{}: no {} in the file; its layers are {}", path,
                               layer.empty() ? std::string("picture (channels R, G, B or Y)")
                                             : fmt::format("layer '{}'", layer),
                               quoted_list(find_layers(file.header().channels())))};
    return read_components(path, file, names);
  });
}

Result<std::vector<std::string>> layer_names(const std::string& path) {
  if (Status ok = check_exists(path); !ok) return ok.error();
  return guarded<std::vector<std::string>>(path, "read", [&]() -> Result<std::vector<std::string>> {
    limit_header_sizes();
    if (Status ok = check_header(path); !ok) return ok.error();
    return find_layers(Imf::InputFile(path.c_str()).header().channels());
  });
}

Status write_exr(const std::string& path, std::span<const Layer> layers, ExrPrecision precision) {
  if (Status ok = check_layers(path, layers); !ok) return ok;
  const bool halves = precision == ExrPrecision::half_float;
  return write_atomically(path, [&](const std::string& temporary) {
    return guarded<Success>(path, "write", [&]() -> Status {
      Imf::Header header(layers[0].image.width, layers[0].image.height);
      header.compression() = Imf::ZIP_COMPRESSION;
      for (const Layer& layer : layers)
        for (const std::string& name : component_names(layer.name, layer.image.channels))
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
