// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Polar coordinates (t, phi) about the lobe's axis q = M z / |M z|. Where is the ring that lies at
// the angle b from z in cosine space? On the meridian u(phi), w = q cos t + u sin t goes to
//   o = M^-1 w = k z cos t + v sin t,  M^-1 q = k z,  v = M^-1 u,
// so tan b = sin t |v_xy| / (k cos t + v_z sin t), and
//   tan t = k tan b / (|v_xy| - v_z tan b).
// Rings of both kinds are sorted along each meridian; the n-th smallest of continuous functions is
// continuous, so neighbouring meridians fit together.

#include "openltc/plot/direction_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace openltc::plot {

namespace {

struct Axis {
  Vec3d q, e; // the axis and, in the plane of symmetry, what is perpendicular to it
  double k;   // M^-1 q = k z

  explicit Axis(const f64::Lobe& lobe)
      : q(normalize(f64::from_cosine(lobe, {0, 0, 1}))), e(q.z, 0, -q.x),
        k(f64::to_cosine(lobe, q).z) {}

  Vec3d meridian(double phi) const { return e * std::cos(phi) + Vec3d(0, std::sin(phi), 0); }
};

// Azimuths, ascending from 0 to 2 pi: even about the axis, and even about z in cosine space.
std::vector<double> spread_spokes(const f64::Lobe& lobe, const Axis& axis, int count) {
  const Vec3d across = f64::to_cosine(lobe, axis.e);
  std::vector<double> spokes = {2 * f64::k_pi};
  for (int i = 0; i < count / 2; ++i) {
    const double even = 2 * f64::k_pi * i / (count / 2);
    // Half a step off, so that no spoke is there twice.
    const double shifted = even + f64::k_pi / (count / 2);
    const double warped = std::atan2(std::abs(across.x) * std::sin(shifted), std::cos(shifted));
    spokes.push_back(even);
    spokes.push_back(warped < 0 ? warped + 2 * f64::k_pi : warped);
  }
  std::sort(spokes.begin(), spokes.end());
  return spokes;
}

// Angles from the axis along a meridian, ascending from 0 to the cosine's horizon (to pi if
// `whole`).
std::vector<double> spread_rings(const f64::Lobe& lobe, const Axis& axis, Vec3d meridian, int count,
                                 bool whole) {
  const Vec3d v = f64::to_cosine(lobe, meridian);
  const double across = std::hypot(v.x, v.y);
  const double horizon = std::atan2(axis.k, -v.z);
  const double end = whole ? f64::k_pi : horizon;
  const int half = count / 2;
  std::vector<double> rings = {0, end};
  for (int i = 1; i < half; ++i) {
    rings.push_back(end * i / half);
    const double b = 0.5 * f64::k_pi * i / half;
    rings.push_back(std::atan2(axis.k * std::sin(b), across * std::cos(b) - v.z * std::sin(b)));
  }
  if (whole) rings.push_back(horizon); // where the density has a kink
  std::sort(rings.begin(), rings.end());
  return rings;
}

void add_normals(scene::Mesh& mesh) {
  std::vector<Vec3d> sums(mesh.positions.size());
  const auto at = [&](std::uint32_t i) { return to_double(mesh.positions[i]); };
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d normal = cross(at(b) - at(a), at(c) - at(a));
    for (const std::uint32_t i : {a, b, c})
      sums[i] += normal;
  }
  for (const Vec3d& sum : sums) {
    const double l = length(sum);
    mesh.normals.push_back(l > 0 ? to_float(sum / l) : Vec3f(0, 0, 1));
  }
}

// A closed surface around the axis: radius(w) w for every direction.
template <class Radius>
scene::Mesh wrap(const f64::Lobe& lobe, const DirectionColor& color, DirectionMeshSize size,
                 bool whole, const Radius& radius) {
  const Axis axis(lobe);
  const std::vector<double> spokes = spread_spokes(lobe, axis, size.spokes);
  scene::Mesh mesh;
  const auto add = [&](Vec3d w) {
    mesh.positions.push_back(to_float(w * radius(w)));
    const Vec3f c = color(w);
    mesh.colors.push_back({c.x, c.y, c.z, 1.0f});
    return std::uint32_t(mesh.positions.size() - 1);
  };
  // One corner for the pole, one for the opposite end, spokes between; the last spoke is the first.
  const std::uint32_t pole = add(axis.q);
  std::vector<std::vector<std::uint32_t>> columns;
  std::uint32_t end = 0;
  for (std::size_t s = 0; s + 1 < spokes.size(); ++s) {
    const Vec3d u = axis.meridian(spokes[s]);
    const std::vector<double> rings = spread_rings(lobe, axis, u, size.rings, whole);
    if (s == 0)
      end = add(whole ? -axis.q : axis.q * std::cos(rings.back()) + u * std::sin(rings.back()));
    std::vector<std::uint32_t> column = {pole};
    for (std::size_t r = 1; r + 1 < rings.size(); ++r)
      column.push_back(add(axis.q * std::cos(rings[r]) + u * std::sin(rings[r])));
    column.push_back(end);
    columns.push_back(std::move(column));
  }
  for (std::size_t s = 0; s < columns.size(); ++s) {
    const auto& here = columns[s];
    const auto& next = columns[(s + 1) % columns.size()];
    for (std::size_t r = 0; r + 1 < here.size(); ++r) {
      if (r + 2 < here.size()) mesh.triangles.push_back({here[r], here[r + 1], next[r + 1]});
      if (r > 0) mesh.triangles.push_back({here[r], next[r + 1], next[r]});
    }
  }
  add_normals(mesh);
  return mesh;
}

} // namespace

scene::Mesh sphere_mesh(const f64::Lobe& lobe, const DirectionColor& color,
                        DirectionMeshSize size) {
  scene::Mesh mesh = wrap(lobe, color, size, true, [](Vec3d) { return 1.0; });
  mesh.normals = mesh.positions;
  return mesh;
}

scene::Mesh lobe_mesh(const f64::Lobe& lobe, double scale, const DirectionColor& color,
                      DirectionMeshSize size) {
  return wrap(lobe, color, size, false, [&](Vec3d w) { return f64::eval_lobe(lobe, w) / scale; });
}

} // namespace openltc::plot
