// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// OpenEXR files as other programs write them, by the OpenEXR library and nothing of ours.

#pragma once

#include "openltc/image/primaries.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace openltc::image::test {

/// The value of a channel at a pixel of the file.
using PixelValue = std::function<float(int x, int y)>;

struct ExrChannel {
  std::string name;
  PixelValue value;
  int x_sampling = 1, y_sampling = 1;
};

/// Corners belong to their windows.
struct ExrPart {
  std::string name;
  std::vector<ExrChannel> channels;
  int data[4] = {0, 0, 7, 5};    ///< x0 y0 x1 y1
  int display[4] = {0, 0, 7, 5}; ///< x0 y0 x1 y1
  std::optional<Primaries> primaries;
  bool tiled = false;
};

/// One part by OutputFile or TiledOutputFile, more by MultiPartOutputFile; full floats, ZIP.
void make_exr(const std::string& path, const std::vector<ExrPart>& parts);

/// By RgbaOutputFile: `channels` is an Imf::RgbaChannels, such as Imf::WRITE_YC. `rgba(c, x, y)`.
void make_rgba_exr(const std::string& path, int channels, int width, int height,
                   const std::function<float(int, int, int)>& rgba,
                   const std::optional<Primaries>& primaries = {});

/// What RgbaInputFile reads: four values a pixel of its data window, row by row.
std::vector<float> read_rgba_exr(const std::string& path);

/// A scan-line file of deep data, one sample a pixel.
void make_deep_exr(const std::string& path);

/// RGB of one set of primaries to RGB of another by ImfChromaticities, without adaptation.
ColorMatrix library_matrix(const Primaries& from, const Primaries& to);

} // namespace openltc::image::test
