// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A picture in one call: every point of a floor under lights of all shapes, in SIMD lanes.
//
//   batch FILE.ppm
//
// Needs openltc/batch.h and the library openltc::batch.

#include "openltc/batch.h"

#include <array>
#include <cstdio>
#include <vector>

using namespace openltc;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: batch FILE.ppm\n");
    return 2;
  }
  BatchLights lights; // nits; the line's cd/m
  lights.add(Polygon::rectangle({-1.5f, 0.6f, 0}, {0.3f, 0, 0}, {0, 0, 0.5f}), Vec3f(60));
  lights.add(disk({-0.4f, 0.5f, 0}, {0, -1, 0}, 0.3f), {80, 60, 40});
  lights.add(Sphere{{0.5f, 0.3f, 0}, 0.15f}, {60, 60, 90});
  lights.add(Tube{{1.1f, 0.3f, -0.6f}, {1.3f, 0.3f, 0.6f}, 0.04f, TubeCaps::round}, Vec3f(120));
  lights.add(Line{{-1.9f, 0.1f, 0.8f}, {1.9f, 0.1f, 0.8f}}, {0.2f, 2, 0.4f});

  // One array for each number of a point; what all points share needs none.
  constexpr int columns = 320, rows = 180;
  const Vec3f eye(0, 2, 3.5f);
  std::array<std::vector<float>, 3> position, view;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vec3f p((float(column) + 0.5f) / 80 - 2, 0, (float(row) + 0.5f) / 80 - 1.125f);
      const Vec3f to_eye = eye - p;
      const float p3[3] = {p.x, p.y, p.z}, v3[3] = {to_eye.x, to_eye.y, to_eye.z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        position[axis].push_back(p3[axis]);
        view[axis].push_back(v3[axis]);
      }
    }
  const std::vector<float> zeros(columns * rows, 0.0f), ones(columns * rows, 1.0f);
  PointBatch points;
  points.count = columns * rows;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    points.position[axis] = position[axis].data();
    points.view[axis] = view[axis].data();
    points.normal[axis] = axis == 1 ? ones.data() : zeros.data();
  }
  points.material.base_color = {0.5f, 0.45f, 0.4f};
  points.material.roughness = 0.25f;

  std::array<std::vector<float>, 3> radiance{zeros, zeros, zeros};
  float* const out[3] = {radiance[0].data(), radiance[1].data(), radiance[2].data()};
  if (const char* error = shade_batch(points, lights, built_in_table(), out)) {
    std::fprintf(stderr, "batch: %s\n", error);
    return 1;
  }
  double sum = 0;
  for (const float nits : radiance[1])
    sum += double(nits);
  std::printf("%d points by %zu lights, kernel %s: %.3f nits on average\n", columns * rows,
              lights.size(), batch_kernel(), sum / (columns * rows));

  std::vector<unsigned char> pixels;
  for (std::size_t i = 0; i < points.count; ++i)
    for (const auto& channel : radiance)
      pixels.push_back(static_cast<unsigned char>(channel[i] < 15 ? 17 * channel[i] : 255));
  std::FILE* file = std::fopen(argv[1], "wb");
  bool written = file && std::fprintf(file, "P6\n%d %d\n255\n", columns, rows) > 0 &&
                 std::fwrite(pixels.data(), 1, pixels.size(), file) == pixels.size();
  if (file) written = std::fclose(file) == 0 && written;
  if (!written) std::fprintf(stderr, "batch: cannot write %s\n", argv[1]);
  return written ? 0 : 1;
}
