// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Twelve lines light a floor by a rectangle.
//
//   shade_quad [FILE.pgm]   prints what reaches the middle of the floor, and writes a picture of it
//
// Needs openltc/openltc.h alone: c++ -std=c++17 -O2 -I ROOT docs/examples/shade_quad.cpp, ROOT
// being the folder in which openltc/ lies.

#include "openltc/openltc.h"

#include <cstdio>
#include <vector>

using namespace openltc;

// Radiance, in nits, of a floor in the plane y = 0 at `point`, seen from `eye`.
static Vec3f light_of_floor(Vec3f point, Vec3f eye) {
  // A square metre, a metre above the floor, facing down. A real engine makes lights once.
  static const Polygon lamp = Polygon::rectangle({0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f});
  const Vec3f lamp_nits(100.0f), up(0, 1, 0);

  Material varnish; // glTF 2.0: a dielectric of index 1.5 over brown
  varnish.base_color = {0.4f, 0.2f, 0.1f};
  varnish.roughness = 0.3f;

  const Surface surface = make_surface(point, up, eye - point, varnish, built_in_table());
  return shade(surface, lamp, lamp_nits);
}

int main(int argc, char** argv) {
  const Vec3f eye(0, 1.5f, 4);
  std::printf("in the middle: %.3f nits\n", double(light_of_floor({0, 0, 0}, eye).y));
  if (argc < 2) return 0;

  std::vector<unsigned char> pixels;
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 160; ++x) {
      const Vec3f point((float(x) - 79.5f) / 40, 0, (float(y) - 44.5f) / 20);
      const float nits = light_of_floor(point, eye).y;
      pixels.push_back(static_cast<unsigned char>(nits < 10 ? 25.5f * nits : 255));
    }
  std::FILE* file = std::fopen(argv[1], "wb");
  bool written = file && std::fprintf(file, "P5\n160 90\n255\n") > 0 &&
                 std::fwrite(pixels.data(), 1, pixels.size(), file) == pixels.size();
  if (file) written = std::fclose(file) == 0 && written;
  if (!written) std::fprintf(stderr, "shade_quad: cannot write %s\n", argv[1]);
  return written ? 0 : 1;
}
