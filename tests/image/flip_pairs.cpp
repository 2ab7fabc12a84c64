// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/image/flip_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

namespace openltc::image::test {

namespace {

constexpr int k_width = 96, k_height = 64;

struct Place {
  int x, y, c;
  double u() const { return (x + 0.5) / k_width; }
  double v() const { return (y + 0.5) / k_height; }
};

double random(std::uint32_t seed, Place p) {
  const auto n = std::uint32_t((p.y * k_width + p.x) * 3 + p.c);
  std::uint32_t h = n * 2654435761u + seed * 974711u;
  h = (h ^ (h >> 16)) * 0x7feb352du;
  h = (h ^ (h >> 15)) * 0x846ca68bu;
  h ^= h >> 16;
  return double(h >> 8) * 0x1p-24;
}

double gradient(Place p) {
  return p.c == 0 ? p.u() : p.c == 1 ? p.v() : 1.0 - 0.5 * p.u() - 0.5 * p.v();
}

double checker(int shift, Place p) {
  return ((p.x + shift) / 12 + p.y / 12) % 2 == 0 ? 0.8 : 0.25 - 0.05 * p.c;
}

double glow(Place p) {
  const int dx = p.x - 60, dy = p.y - 20;
  const double light = dx * dx + dy * dy < 64 ? 200.0 - 50.0 * p.c : 0.0;
  return std::pow(10.0, 4.0 * p.u() - 3.0) * (0.5 + 0.25 * p.c * p.v()) + light;
}

double dark(Place p) { return p.x < 30 ? 2.0 * p.v() + 0.1 * p.c : 0.0; }

Image make(const std::function<double(Place)>& value) {
  Image image(k_width, k_height, 3);
  for (int y = 0; y < k_height; ++y)
    for (int x = 0; x < k_width; ++x)
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = float(value({x, y, c}));
  return image;
}

} // namespace

FlipPair make_flip_pair(const std::string& name) {
  if (name == "noise")
    return {make([](Place p) {
              return std::clamp(gradient(p) + 0.2 * (random(1, p) - 0.5), 0.0, 1.0);
            }),
            make(gradient)};
  if (name == "shifted edges")
    return {make([](Place p) { return checker(1, p); }),
            make([](Place p) { return checker(0, p); })};
  if (name == "swapped colours")
    return {make([](Place p) { return gradient({p.x, p.y, (p.c + 2) % 3}); }), make(gradient)};
  if (name == "black and white")
    return {make([](Place) { return 0.0; }), make([](Place) { return 1.0; })};
  if (name == "far noise" || name == "near noise")
    return {make([](Place p) { return random(2, p); }), make([](Place p) { return random(3, p); })};
  if (name == "hdr noise")
    return {make([](Place p) { return glow(p) * (0.8 + 0.4 * random(4, p)); }), make(glow)};
  if (name == "hdr brighter") return {make([](Place p) { return 1.1 * glow(p); }), make(glow)};
  if (name == "hdr black") return {make([](Place p) { return dark(p) * 1.2; }), make(dark)};
  if (name == "hdr half black")
    return {make([](Place p) { return dark(p) * 1.2 + 0.01; }),
            make([](Place p) { return dark(p) + 0.001; })};
  return {};
}

} // namespace openltc::image::test
