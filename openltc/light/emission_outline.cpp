// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/emission_outline.h"

#include "openltc/light/polygon.h"

#include <cmath>
#include <cstddef>
#include <span>

namespace openltc::light {

namespace {

// Lines along which a texel's cover is measured.
constexpr int k_lines_per_row = 4;

template <class Outline>
std::vector<float> cover_by_lines(const Outline& outline, const PlaneBox& box, int columns,
                                  int rows) {
  std::vector<float> cover(std::size_t(columns) * std::size_t(rows), 0.0f);
  const double width = box.upper.x - box.lower.x, height = box.upper.y - box.lower.y;
  std::vector<double> spans;
  for (int y = 0; y < rows; ++y) {
    float* row = cover.data() + std::size_t(y) * std::size_t(columns);
    for (int line = 0; line < k_lines_per_row; ++line) {
      const double at = (y + (line + 0.5) / k_lines_per_row) / rows;
      outline.spans_at(box.lower.y + at * height, spans);
      for (std::size_t i = 0; i + 1 < spans.size(); i += 2) {
        const double from = std::clamp((spans[i] - box.lower.x) / width, 0.0, 1.0) * columns;
        const double to = std::clamp((spans[i + 1] - box.lower.x) / width, 0.0, 1.0) * columns;
        for (int x = int(from); x < std::min(int(std::ceil(to)), columns); ++x)
          row[x] += float(std::min(to, x + 1.0) - std::max(from, double(x))) / k_lines_per_row;
      }
    }
  }
  return cover;
}

} // namespace

void PolygonOutline::spans_at(double y, std::vector<double>& spans) const {
  spans.clear();
  for (const Edge& e : edges)
    if ((e.a.y > y) != (e.b.y > y))
      spans.push_back(e.a.x + (y - e.a.y) * (e.b.x - e.a.x) / (e.b.y - e.a.y));
  std::sort(spans.begin(), spans.end());
}

void EllipseOutline::spans_at(double y, std::vector<double>& spans) const {
  spans.clear();
  // With h = sqrt(axis_0.y^2 + axis_1.y^2), heights reach h; the chord's middle and half length
  // follow from the unit circle turned so that its y axis is (axis_0.y, axis_1.y) / h.
  const double h2 = axis_0.y * axis_0.y + axis_1.y * axis_1.y;
  const double sine = (y - center.y) / std::sqrt(h2);
  if (!(std::abs(sine) < 1)) return;
  const double determinant = std::abs(axis_0.x * axis_1.y - axis_0.y * axis_1.x);
  const double middle =
      center.x + sine * (axis_0.x * axis_0.y + axis_1.x * axis_1.y) / std::sqrt(h2);
  const double half = std::sqrt(1 - sine * sine) * determinant / std::sqrt(h2);
  spans.push_back(middle - half);
  spans.push_back(middle + half);
}

bool make_frame(const Emitter& light, Vec3d origin, Vec3d normal, PlaneFrame& frame) {
  const Vec3d along = to_double(light.texture_u);
  const Vec3d in_plane = along - normal * dot(along, normal);
  const double size = length(in_plane);
  if (!(size > 1e-6 * length(along)) || !std::isfinite(size)) return false;
  frame.origin = origin;
  frame.u = in_plane / size;
  // v grows downwards in a texture that is upright: on the side that its own v axis points to.
  const Vec3d across = cross(normal, frame.u);
  frame.v = dot(across, to_double(light.texture_v)) < 0 ? -across : across;
  return true;
}

PolygonOutline outline_of(const PolygonLight& light, const PlaneFrame& frame, PlaneBox& box) {
  PolygonOutline outline;
  for (std::size_t ring = 0; ring < light.ring_end.size(); ++ring) {
    const std::span<const Vec3f> points = ring_vertices(light, ring);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2d a = frame.in_plane(to_double(points[i]));
      box.add(a);
      outline.edges.push_back({a, frame.in_plane(to_double(points[(i + 1) % points.size()]))});
    }
  }
  return outline;
}

EllipseOutline outline_of(const EllipseLight& light, const PlaneFrame& frame, PlaneBox& box) {
  const auto direction = [&](Vec3f v) {
    return Vec2d(dot(to_double(v), frame.u), dot(to_double(v), frame.v));
  };
  const EllipseOutline outline{frame.in_plane(to_double(light.center)), direction(light.half_u),
                               direction(light.half_v)};
  const Vec2d reach(std::hypot(outline.axis_0.x, outline.axis_1.x),
                    std::hypot(outline.axis_0.y, outline.axis_1.y));
  box.add(outline.center - reach);
  box.add(outline.center + reach);
  return outline;
}

std::vector<float> coverage(const PolygonOutline& outline, const PlaneBox& box, int columns,
                            int rows) {
  return cover_by_lines(outline, box, columns, rows);
}

std::vector<float> coverage(const EllipseOutline& outline, const PlaneBox& box, int columns,
                            int rows) {
  return cover_by_lines(outline, box, columns, rows);
}

} // namespace openltc::light
