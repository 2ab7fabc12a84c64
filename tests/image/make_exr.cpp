// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/image/make_exr.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <ImfTiledOutputPart.h>

#include <deque>

namespace openltc::image::test {

namespace {

Imath::Box2i box_of(const int (&corners)[4]) {
  return {Imath::V2i(corners[0], corners[1]), Imath::V2i(corners[2], corners[3])};
}

Imf::Chromaticities to_library(const Primaries& p) {
  const auto v = [](const std::array<double, 2>& xy) {
    return Imath::V2f(float(xy[0]), float(xy[1]));
  };
  return {v(p.red), v(p.green), v(p.blue), v(p.white)};
}

Imf::Header header_of(const ExrPart& part) {
  Imf::Header header(box_of(part.display), box_of(part.data));
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const ExrChannel& c : part.channels)
    header.channels().insert(c.name, Imf::Channel(Imf::FLOAT, c.x_sampling, c.y_sampling));
  if (part.primaries) Imf::addChromaticities(header, to_library(*part.primaries));
  if (!part.name.empty()) header.setName(part.name);
  header.setType(part.tiled ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
  if (part.tiled) header.setTileDescription(Imf::TileDescription(4, 3));
  return header;
}

// The values of all channels, and where the library finds them.
struct Buffers {
  std::deque<std::vector<float>> planes;
  Imf::FrameBuffer frame;

  explicit Buffers(const ExrPart& part) {
    const Imath::Box2i box = box_of(part.data);
    for (const ExrChannel& c : part.channels) {
      const int width = (box.max.x - box.min.x) / c.x_sampling + 1;
      std::vector<float>& plane = planes.emplace_back();
      for (int y = box.min.y; y <= box.max.y; y += c.y_sampling)
        for (int x = box.min.x; x <= box.max.x; x += c.x_sampling)
          plane.push_back(c.value(x, y));
      frame.insert(c.name, Imf::Slice::Make(Imf::FLOAT, plane.data(), box, sizeof(float),
                                            sizeof(float) * std::size_t(width), c.x_sampling,
                                            c.y_sampling));
    }
  }
};

} // namespace

void make_exr(const std::string& path, const std::vector<ExrPart>& parts) {
  const int height = parts[0].data[3] - parts[0].data[1] + 1;
  if (parts.size() > 1) {
    std::vector<Imf::Header> headers;
    for (const ExrPart& part : parts)
      headers.push_back(header_of(part));
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), int(headers.size()));
    for (std::size_t p = 0; p < parts.size(); ++p) {
      Buffers buffers(parts[p]);
      if (parts[p].tiled) {
        Imf::TiledOutputPart part(file, int(p));
        part.setFrameBuffer(buffers.frame);
        part.writeTiles(0, part.numXTiles() - 1, 0, part.numYTiles() - 1);
        continue;
      }
      Imf::OutputPart part(file, int(p));
      part.setFrameBuffer(buffers.frame);
      part.writePixels(parts[p].data[3] - parts[p].data[1] + 1);
    }
    return;
  }
  Buffers buffers(parts[0]);
  if (parts[0].tiled) {
    Imf::TiledOutputFile file(path.c_str(), header_of(parts[0]));
    file.setFrameBuffer(buffers.frame);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    return;
  }
  Imf::OutputFile file(path.c_str(), header_of(parts[0]));
  file.setFrameBuffer(buffers.frame);
  file.writePixels(height);
}

void make_rgba_exr(const std::string& path, int channels, int width, int height,
                   const std::function<float(int, int, int)>& rgba,
                   const std::optional<Primaries>& primaries) {
  Imf::Header header(width, height);
  if (primaries) Imf::addChromaticities(header, to_library(*primaries));
  std::vector<Imf::Rgba> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      pixels.emplace_back(rgba(0, x, y), rgba(1, x, y), rgba(2, x, y), rgba(3, x, y));
  Imf::RgbaOutputFile file(path.c_str(), header, Imf::RgbaChannels(channels));
  file.setFrameBuffer(pixels.data(), 1, std::size_t(width));
  file.writePixels(height);
}

std::vector<float> read_rgba_exr(const std::string& path) {
  Imf::RgbaInputFile file(path.c_str());
  const Imath::Box2i box = file.dataWindow();
  const int width = box.max.x - box.min.x + 1, height = box.max.y - box.min.y + 1;
  std::vector<Imf::Rgba> pixels(std::size_t(width) * std::size_t(height));
  file.setFrameBuffer(pixels.data() - box.min.x - std::ptrdiff_t(box.min.y) * width, 1,
                      std::size_t(width));
  file.readPixels(box.min.y, box.max.y);
  std::vector<float> values;
  for (const Imf::Rgba& p : pixels)
    values.insert(values.end(), {float(p.r), float(p.g), float(p.b), float(p.a)});
  return values;
}

void make_deep_exr(const std::string& path) {
  constexpr int width = 4, height = 3;
  Imf::Header header(width, height);
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  std::vector<unsigned int> counts(width * height, 1);
  std::vector<float> values(width * height, 2.0f);
  std::vector<float*> samples;
  for (float& value : values)
    samples.push_back(&value);
  Imf::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()),
                                          sizeof(unsigned int), sizeof(unsigned int) * width));
  frame.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(samples.data()),
                                   sizeof(float*), sizeof(float*) * width, sizeof(float)));
  Imf::DeepScanLineOutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(height);
}

ColorMatrix library_matrix(const Primaries& from, const Primaries& to) {
  // The library multiplies rows from the left.
  const Imath::M44f m = Imf::RGBtoXYZ(to_library(from), 1) * Imf::XYZtoRGB(to_library(to), 1);
  ColorMatrix out{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      out[std::size_t(i)][std::size_t(j)] = double(m[j][i]);
  return out;
}

} // namespace openltc::image::test
