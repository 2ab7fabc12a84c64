// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// fuzz_image_seeds FOLDER: writes small pictures of every format and kind.

#include "openltc/image/file.h"
#include "tests/image/make_exr.h"

#include <ImfRgba.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

using namespace openltc::image;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_image_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code ec;
  std::filesystem::create_directories(folder, ec);
  const auto file = [&](const char* name) { return (folder / name).string(); };
  Image picture(9, 4, 3);
  for (std::size_t i = 0; i < picture.data.size(); ++i)
    picture.data[i] = float(i % 7) / 6.0f;
  const Layer layers[] = {{"", picture}, {"stderr", picture}};
  bool ok = write_exr(file("layers.exr"), layers).ok() &&
            write_exr(file("half.exr"), layers, ExrPrecision::half_float).ok() &&
            write_hdr(file("rle.hdr"), picture).ok() && write_png(file("a.png"), picture).ok();
  std::ofstream(file("turned.hdr"), std::ios::binary)
      << "#?RADIANCE\r\nFORMAT=32-bit_rle_xyze\r\nEXPOSURE=2\r\nCOLORCORR=1 2 1\r\n"
         "PRIMARIES=.68 .32 .265 .69 .15 .06 .3127 .329\r\n\r\n+X 1 -Y 2\r\nabcdefgh";
  const auto value = [](int x, int y) { return float(x + y); };
  test::ExrPart xyz, crop, normal;
  xyz.name = "left";
  xyz.channels = {{"X", value}, {"Y", value}, {"Z", value}};
  crop.name = "right";
  crop.channels = {{"Y", value}, {"RY", value, 2, 2}, {"BY", value, 2, 2}, {"A", value}};
  crop.data[0] = 2;
  crop.data[1] = -2;
  crop.primaries = Primaries{{0.68, 0.32}, {0.265, 0.69}, {0.15, 0.06}, {0.31, 0.33}};
  normal.name = "n";
  normal.channels = {{"V.N.X", value}, {"V.N.Y", value}, {"V.N.Z", value}, {"V.Depth.Z", value}};
  normal.tiled = true;
  test::make_exr(file("xyz.exr"), {xyz});
  test::make_exr(file("crop.exr"), {crop});
  test::make_exr(file("tiled.exr"), {normal});
  crop.primaries = {}; // parts share their primaries
  test::make_exr(file("parts.exr"), {xyz, crop, normal});
  test::make_rgba_exr(file("yca.exr"), Imf::WRITE_YCA, 8, 6,
                      [](int c, int x, int y) { return float(c + x + y); });
  test::make_deep_exr(file("deep.exr"));
  if (!ok) std::fprintf(stderr, "%s: cannot write\n", folder.string().c_str());
  return ok ? 0 : 1;
}
