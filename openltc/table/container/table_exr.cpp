// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

//
// Reads OpenEXR through the OpenEXR library, version 2.5 or 3, in memory; table_exr_writer.cpp
// writes.

#include "openltc/image/exr/exr_header.h"
#include "openltc/table/container/container.h"
#include "openltc/table/half.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace openltc::table {

namespace {

const std::string k_prefix = "openltc."; // of the attributes that are ours
constexpr const char* k_channels[] = {"R", "G", "B", "A"};

// A position in a file; OpenEXR 2 and 3 spell the type differently.
using Offset = decltype(std::declval<Imf::IStream&>().tellg());

class MemoryInput : public Imf::IStream {
public:
  explicit MemoryInput(ByteView bytes) : Imf::IStream("memory"), bytes_(bytes) {}
  bool read(char data[], int count) override {
    if (count < 0 || at_ > bytes_.size() || std::size_t(count) > bytes_.size() - at_)
      throw std::runtime_error("unexpected end of file");
    std::memcpy(data, bytes_.data() + at_, std::size_t(count));
    at_ += std::size_t(count);
    return at_ < bytes_.size();
  }
  Offset tellg() override { return Offset(at_); }
  void seekg(Offset to) override { at_ = std::size_t(to); }
  void clear() override {}

private:
  ByteView bytes_;
  std::size_t at_ = 0;
};

// Where the library finds channel c of texel (x, y): base + x * x_stride + y * y_stride.
Imf::Slice slice(Imf::PixelType type, char* base, std::size_t texel, int width) {
  return {type, base, texel, texel * std::size_t(width)};
}

// The library makes its own tables before it can be asked for a file's size. The limits are those
// of image/exr/exr.cpp, since they hold for the whole process.
void limit_header_sizes() {
  static const bool done = [] {
    Imf::Header::setMaxImageSize(65535, 65535);
    Imf::Header::setMaxTileSize(8192, 8192);
    return true;
  }();
  (void)done;
}

// Whatever OpenEXR throws becomes one line.
template <class Function> Result<Texture> guarded(const std::string& name, Function&& function) {
  try {
    return function();
  } catch (const std::exception& e) {
    std::string text = e.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return Error{fmt::format("{}: cannot read OpenEXR: {}", name, text)};
  } catch (...) {
    return Error{fmt::format("{}: cannot read OpenEXR", name)};
  }
}

} // namespace

Result<Texture> decode_exr(ByteView bytes, const std::string& name) {
  static constexpr std::uint8_t magic[] = {0x76, 0x2f, 0x31, 0x01};
  if (bytes.size() < 4 || !std::equal(magic, magic + 4, bytes.begin()))
    return Error{fmt::format("{}: not an OpenEXR file", name)};
  if (!image::exr_header_fits(bytes, bytes.size()))
    return Error{fmt::format("{}: an attribute of the OpenEXR file's header does not fit into the "
                             "file; was it cut off?",
                             name)};
  return guarded(name, [&]() -> Result<Texture> {
    limit_header_sizes();
    MemoryInput stream(bytes);
    Imf::InputFile file(stream, 0);
    const Imf::Header& header = file.header();
    const Imath::Box2i box = header.dataWindow();
    Texture texture;
    for (const char* channel : k_channels)
      if (header.channels().findChannel(channel)) ++texture.channels;
    const std::uint64_t width = std::uint64_t(std::int64_t(box.max.x) - box.min.x + 1);
    const std::uint64_t height = std::uint64_t(std::int64_t(box.max.y) - box.min.y + 1);
    if (Status status = check_texture_size(name, width, height, std::uint64_t(texture.channels));
        !status)
      return status.error();
    if (!file.isComplete()) return Error{fmt::format("{}: the OpenEXR file is cut short", name)};
    texture.width = int(width);
    texture.height = int(height);
    texture.precision = Precision::float16;
    texture.values.assign(texture.count(), 0.0f);
    // The library wants the address of texel (0, 0), wherever the data window lies.
    if (box.min.x != 0 || box.min.y != 0)
      return Error{
          fmt::format("{}: the data window of the OpenEXR file does not begin at 0, 0", name)};
    Imf::FrameBuffer frame;
    for (int c = 0; c < texture.channels; ++c) {
      const Imf::Channel* channel = header.channels().findChannel(k_channels[c]);
      if (!channel || channel->xSampling != 1 || channel->ySampling != 1)
        return Error{
            fmt::format("{}: the OpenEXR file's channels are not R, R G or R G B A", name)};
      if (channel->type != Imf::HALF) texture.precision = Precision::float32;
      frame.insert(k_channels[c],
                   slice(Imf::FLOAT, reinterpret_cast<char*>(texture.values.data() + c),
                         std::size_t(texture.channels) * sizeof(float), texture.width));
    }
    file.setFrameBuffer(frame);
    file.readPixels(box.min.y, box.max.y);
    for (auto i = header.begin(); i != header.end(); ++i) {
      const std::string key = i.name();
      const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
      if (text && key.compare(0, k_prefix.size(), k_prefix) == 0)
        texture.metadata.emplace_back(key.substr(k_prefix.size()), text->value());
    }
    if (Status status = check_finite(name, texture); !status) return status.error();
    return texture;
  });
}

} // namespace openltc::table
