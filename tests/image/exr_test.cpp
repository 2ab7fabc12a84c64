// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// OpenEXR files that the OpenEXR library wrote, of every kind that other programs make: what is
// read is what the library itself reads, or what the definitions of colour spaces say.

#include "openltc/image/file.h"
#include "openltc/image/primaries.h"
#include "tests/image/make_exr.h"
#include "tests/image/make_picture.h"

#include <ImfRgba.h>
#include <doctest/doctest.h>

#include <cmath>
#include <map>

using namespace openltc;
using namespace openltc::image;
using namespace openltc::image::test;

namespace {

// A different number for each channel and pixel, exact in any precision.
PixelValue ramp(int channel) {
  return [channel](int x, int y) { return float(channel * 1000 + y * 32 + x); };
}

std::vector<ExrChannel> channels_of(const std::string& prefix,
                                    const std::vector<std::string>& components, int first) {
  std::vector<ExrChannel> channels;
  for (const std::string& component : components)
    channels.push_back({prefix + component, ramp(first++)});
  return channels;
}

// Whether every pixel (x, y) of `image` has the ramps of these channels, where the file's pixel is
// (x + x0, y + y0).
void check_ramps(const Image& image, std::vector<int> ramps, int x0 = 0, int y0 = 0) {
  REQUIRE(image.channels == int(ramps.size()));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < ramps.size(); ++c)
        REQUIRE(image.pixel(x, y)[c] == ramp(ramps[c])(x + x0, y + y0));
}

// Smooth, coloured and bright at places: chroma at half the resolution can hold it.
float smooth(int c, int x, int y) {
  const double u = x / 64.0, v = y / 48.0;
  const double values[] = {2 + std::sin(5 * u + v), 1.5 + std::cos(4 * v), 1 + u * v,
                           0.25 + 0.5 * u};
  return float(values[c]);
}

const Primaries k_p3 = {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};
const Primaries k_ap0 = {{0.7347, 0.2653}, {0.0, 1.0}, {0.0001, -0.0770}, {0.32168, 0.33767}};

Vec3f times(const ColorMatrix& m, Vec3f v) {
  const auto row = [&](std::size_t i) {
    return float(m[i][0] * double(v.x) + m[i][1] * double(v.y) + m[i][2] * double(v.z));
  };
  return {row(0), row(1), row(2)};
}

void check_near(Vec3f got, Vec3f expected, float tolerance) {
  CAPTURE(got.x);
  CAPTURE(got.y);
  CAPTURE(got.z);
  REQUIRE(std::fabs(got.x - expected.x) <= tolerance);
  REQUIRE(std::fabs(got.y - expected.y) <= tolerance);
  REQUIRE(std::fabs(got.z - expected.z) <= tolerance);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("luminance and chroma are the colours that the library makes of them") {
  const TemporaryFolder folder;
  const std::string path = folder.file("yc.exr");
  constexpr int width = 64, height = 48;
  for (const int kind : {int(Imf::WRITE_YC), int(Imf::WRITE_YCA)}) {
    make_rgba_exr(path, kind, width, height, smooth);
    const std::vector<float> library = read_rgba_exr(path);
    const Result<Image> got = read(path);
    REQUIRE(got.ok());
    REQUIRE(got->width == width);
    REQUIRE(got->channels == (kind == Imf::WRITE_YC ? 3 : 4));
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const float* l = &library[std::size_t(y * width + x) * 4];
        // The library rounds to half precision, 2^-11, in each of its steps.
        check_near(got->rgb(x, y), {l[0], l[1], l[2]}, 8e-3f);
        // Within the picture, chroma at half the resolution keeps the smooth original, but for the
        // 5 bits to which that writer rounds RY and BY.
        if (x > 14 && y > 14 && x < width - 14 && y < height - 14)
          check_near(got->rgb(x, y), {smooth(0, x, y), smooth(1, x, y), smooth(2, x, y)}, 3e-2f);
        if (got->channels == 4) REQUIRE(got->pixel(x, y)[3] == doctest::Approx(l[3]));
      }
    const Picture picture = *read_picture(path, "");
    CHECK(picture.layer.kind == LayerKind::luminance_chroma);
  }
  // Grey, and grey with alpha.
  make_rgba_exr(path, Imf::WRITE_Y, width, height, smooth);
  CHECK(read(path)->channels == 3);
  CHECK(read_layer(path, "")->channels == 1);
  make_rgba_exr(path, Imf::WRITE_YA, width, height, smooth);
  const std::vector<float> library = read_rgba_exr(path);
  const Image grey = *read(path);
  REQUIRE(grey.channels == 4);
  for (std::size_t i = 0; i < library.size(); ++i)
    REQUIRE(grey.data[i] == library[i]);
}

TEST_CASE("luminance and chroma of other primaries, in full resolution and in a crop") {
  const TemporaryFolder folder;
  const std::string path = folder.file("yc.exr");
  make_rgba_exr(path, Imf::WRITE_YC, 64, 48, smooth, k_p3);
  const std::vector<float> library = read_rgba_exr(path); // RGB of P3
  const ColorMatrix matrix = library_matrix(k_p3, Primaries{});
  const Image got = *read(path);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const float* l = &library[std::size_t(y * 64 + x) * 4];
      check_near(got.rgb(x, y), times(matrix, {l[0], l[1], l[2]}), 1e-2f);
    }

  // The definition: RY = (R - Y) / Y, Y by the luminances of the primaries, chroma not subsampled.
  const ColorMatrix to_xyz = library_matrix(k_p3, {{1, 0}, {0, 1}, {0, 0}, {1 / 3., 1 / 3.}});
  const Vec3f color(3.0f, 0.5f, 0.25f);
  const float luminance = times(to_xyz, color).y;
  ExrPart part;
  part.channels = {{"Y", [=](int, int) { return luminance; }},
                   {"RY", [=](int, int) { return (color.x - luminance) / luminance; }},
                   {"BY", [=](int, int) { return (color.z - luminance) / luminance; }}};
  part.primaries = k_p3;
  make_exr(path, {part});
  check_near(read(path)->rgb(3, 2), times(matrix, color), 1e-5f);

  // Subsampled in a data window that is smaller than the display window and begins below 0.
  for (ExrChannel& c : part.channels)
    if (c.name != "Y") c.x_sampling = c.y_sampling = 2;
  const int data[4] = {-4, -2, 3, 1}, display[4] = {-6, -6, 9, 9};
  std::copy_n(data, 4, part.data);
  std::copy_n(display, 4, part.display);
  make_exr(path, {part});
  const Image crop = *read(path);
  REQUIRE(crop.width == 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const bool inside = x >= 2 && x < 10 && y >= 4 && y < 8;
      check_near(crop.rgb(x, y), inside ? times(matrix, color) : Vec3f(0.0f), 2e-5f);
    }
}

TEST_CASE("CIE XYZ becomes linear Rec.709") {
  const TemporaryFolder folder;
  const std::string path = folder.file("xyz.exr");
  // IEC 61966-2-1: white is D65 of x .3127, y .3290; red's XYZ are .4124 .2126 .0193.
  const auto xyz = [&](const std::string& prefix, Vec3f v) {
    ExrPart part;
    part.channels = {{prefix + "X", [=](int, int) { return v.x; }},
                     {prefix + "Y", [=](int, int) { return v.y; }},
                     {prefix + "Z", [=](int, int) { return v.z; }}};
    make_exr(path, {part});
    return read(path);
  };
  const Vec3f d65(0.3127f / 0.3290f, 1.0f, (1 - 0.3127f - 0.3290f) / 0.3290f);
  check_near(xyz("", d65)->rgb(1, 1), Vec3f(1.0f), 1e-5f);
  check_near(xyz("", {0.4124f, 0.2126f, 0.0193f})->rgb(1, 1), {1, 0, 0}, 2e-4f);
  check_near(xyz("", {0.3576f, 0.7152f, 0.1192f})->rgb(1, 1), {0, 1, 0}, 2e-4f);
  check_near(xyz("View.Combined.", d65)->rgb(1, 1), Vec3f(1.0f), 1e-5f);
  // A normal is no colour: there is no picture, and the layer has the numbers of the file.
  CHECK_FALSE(xyz("View.Normal.", {0.1f, 0.2f, 0.3f}).ok());
  check_near(read_layer(path, "Normal")->rgb(1, 1), {0.1f, 0.2f, 0.3f}, 0.0f);
}

TEST_CASE("colours of other primaries are converted, those of Rec.709 kept to the bit") {
  const TemporaryFolder folder;
  const std::string path = folder.file("p.exr");
  ExrPart part;
  part.channels = channels_of("", {"R", "G", "B"}, 1);
  part.primaries = Primaries{};
  make_exr(path, {part});
  check_ramps(*read(path), {1, 2, 3});

  part.primaries = k_p3;
  make_exr(path, {part});
  const ColorMatrix matrix = library_matrix(k_p3, Primaries{});
  const Vec3f stored(ramp(1)(3, 2), ramp(2)(3, 2), ramp(3)(3, 2));
  check_near(read(path)->rgb(3, 2), times(matrix, stored), 0.05f); // of 3000
  CHECK(read_picture(path, "")->layer.other_primaries);

  // ACES 2065-1 to Rec.709 with the Bradford transform, as published with ACES (OpenColorIO).
  part.primaries = k_ap0;
  make_exr(path, {part});
  const ColorMatrix aces = {{{2.52168619, -1.13413099, -0.38755520},
                             {-0.27647991, 1.37271909, -0.09623917},
                             {-0.01537806, -0.15297534, 1.16835340}}};
  check_near(read(path)->rgb(3, 2), times(aces, stored), 0.5f);

  for (const Primaries& bad :
       {Primaries{{0, 0}, {0, 0}, {0, 0}, {0, 0}}, Primaries{{.1, .1}, {.2, .2}, {.3, .3}},
        Primaries{{.64, .33}, {.3, .6}, {.15, .06}, {.9, .05}},
        Primaries{{NAN, .33}, {.3, .6}, {.15, .06}}}) {
    part.primaries = bad;
    make_exr(path, {part});
    const Result<Image> refused = read(path);
    REQUIRE_FALSE(refused.ok());
    CHECK(has(refused.error().message, "chromaticities"));
  }
}

TEST_CASE("every part and layer of a file can be read") {
  const TemporaryFolder folder;
  const std::string path = folder.file("parts.exr");
  ExrPart left, right, depth, aov;
  left.name = "left";
  left.channels = channels_of("", {"R", "G", "B", "A"}, 1);
  right.name = "right";
  right.channels = channels_of("", {"R", "G", "B"}, 5);
  right.tiled = true;
  depth.name = "depth";
  depth.channels = channels_of("", {"Z"}, 8);
  aov.name = "aov";
  aov.channels = channels_of("ViewLayer.Normal.", {"X", "Y", "Z"}, 9);
  const int small[4] = {2, 1, 4, 4}; // of the display window that all parts share
  std::copy_n(small, 4, aov.data);
  make_exr(path, {left, right, depth, aov});

  CHECK(*layer_names(path) ==
        std::vector<std::string>{"left", "right", "depth", "aov.ViewLayer.Normal"});
  const std::vector<LayerInfo> layers = *list_layers(path);
  CHECK(layers[1].part == 1);
  CHECK(layers[1].part_name == "right");
  CHECK(layers[3].data == Window{2, 1, 3, 4});
  CHECK(layers[3].display == Window{0, 0, 8, 6});
  check_ramps(*read_layer(path, "left"), {1, 2, 3, 4});
  check_ramps(*read_layer(path, "right"), {5, 6, 7});
  check_ramps(*read_layer(path, "depth"), {8});
  const Image normal = *read_layer(path, "Normal");
  check_near(normal.rgb(4, 4), {ramp(9)(4, 4), ramp(10)(4, 4), ramp(11)(4, 4)}, 0);
  check_near(normal.rgb(1, 1), Vec3f(0.0f), 0);
  const Result<Image> picture = read(path);
  REQUIRE_FALSE(picture.ok());
  CHECK(has(picture.error().message, "'left', 'right'"));

  // The only picture of many parts is taken by itself, wherever it stands.
  make_exr(path, {depth, right});
  check_ramps(*read(path), {5, 6, 7});
}

TEST_CASE("a Blender multilayer file is its combined layer") {
  const TemporaryFolder folder;
  const std::string path = folder.file("blender.exr");
  ExrPart part;
  part.channels = channels_of("ViewLayer.Combined.", {"R", "G", "B", "A"}, 1);
  for (const auto& more : {channels_of("ViewLayer.Depth.", {"Z"}, 5),
                           channels_of("ViewLayer.Normal.", {"X", "Y", "Z"}, 6)})
    part.channels.insert(part.channels.end(), more.begin(), more.end());
  for (const bool tiled : {false, true}) {
    part.tiled = tiled;
    make_exr(path, {part});
    check_ramps(*read(path), {1, 2, 3, 4});
    check_ramps(*read_layer(path, "ViewLayer.Combined"), {1, 2, 3, 4});
    check_ramps(*read_layer(path, "ViewLayer.Depth"), {5});
    check_ramps(*read_layer(path, "ViewLayer.Normal"), {6, 7, 8});
  }
}

TEST_CASE("the picture is the display window, with 0 where the file has no data") {
  const TemporaryFolder folder;
  const std::string path = folder.file("window.exr");
  struct Case {
    int data[4], display[4];
  };
  for (const Case& c : {Case{{2, 1, 5, 3}, {0, 0, 7, 5}},     // a crop
                        Case{{-3, -2, 12, 9}, {0, 0, 7, 5}},  // overscan
                        Case{{4, 3, 20, 90}, {0, 0, 7, 5}},   // across a corner, many lines
                        Case{{20, 20, 24, 24}, {0, 0, 7, 5}}, // wholly outside
                        Case{{102, 99, 106, 101}, {100, 98, 109, 105}},
                        // as far away as the library allows
                        Case{{-1073741800, 5, -1073741790, 9}, {-1073741805, 4, -1073741790, 12}},
                        Case{{1073741800, 0, 1073741810, 9}, {-1073741800, -5, -1073741790, 3}}})
    for (const bool tiled : {false, true}) {
      ExrPart part;
      part.channels = {{"R", [](int x, int y) { return float(x % 4096 + y); }},
                       {"G", [](int x, int y) { return float(x % 4096 - y); }},
                       {"B", [](int, int) { return 7.0f; }}};
      std::copy_n(c.data, 4, part.data);
      std::copy_n(c.display, 4, part.display);
      part.tiled = tiled;
      make_exr(path, {part});
      const Picture picture = *read_picture(path, "");
      CHECK(picture.layer.display.x == c.display[0]);
      CHECK(picture.layer.data.y == c.data[1]);
      REQUIRE(picture.image.width == c.display[2] - c.display[0] + 1);
      REQUIRE(picture.image.height == c.display[3] - c.display[1] + 1);
      for (int j = 0; j < picture.image.height; ++j)
        for (int i = 0; i < picture.image.width; ++i) {
          const int x = i + c.display[0], y = j + c.display[1];
          const bool inside = x >= c.data[0] && x <= c.data[2] && y >= c.data[1] && y <= c.data[3];
          check_near(picture.image.rgb(i, j),
                     inside ? Vec3f(float(x % 4096 + y), float(x % 4096 - y), 7) : Vec3f(0.0f), 0);
        }
    }
}

TEST_CASE("kinds of data that are no picture are named in one line") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.exr");
  const auto refusal = [&] {
    const Result<Image> image = read(path);
    REQUIRE_FALSE(image.ok());
    CHECK(image.error().message.rfind(path + ": ", 0) == 0);
    CHECK(image.error().message.find('\n') == std::string::npos);
    return image.error().message;
  };
  make_deep_exr(path);
  CHECK(has(refusal(), "deep data"));
  CHECK(list_layers(path)->front().kind == LayerKind::not_flat);

  ExrPart part;
  part.channels = channels_of("", {"R", "G", "B"}, 1);
  part.channels[2].x_sampling = 2;
  make_exr(path, {part});
  CHECK(has(refusal(), "channel 'B' has one value for 2x1 pixels"));
  part.channels = channels_of("", {"Y", "RY", "BY"}, 1);
  part.channels[1].x_sampling = 4;
  make_exr(path, {part});
  CHECK(has(refusal(), "channel 'RY' has one value for 4x1 pixels"));
  part.channels = channels_of("", {"R", "G"}, 1);
  make_exr(path, {part});
  CHECK(has(refusal(), "no picture"));
  part.channels = channels_of("N.", {"Y", "RY"}, 1);
  make_exr(path, {part});
  CHECK(has(refusal(), "no picture"));
}
