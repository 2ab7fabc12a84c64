// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Written for the benchmark from the formulas of Heitz, Dupuy, Hill, Neubelt 2016 and of Hill and
// Heitz 2016 (rational fit of theta / sin theta): look up M^-1 and the amplitudes, build the frame,
// clip the quad to the surface's horizon, sum its edges for the diffuse part; transform, clip to
// the cosine's horizon, sum again for the specular part.

#include "bench/usual_quad.h"

#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f32.h"

#include <algorithm>
#include <cmath>

namespace openltc::bench {

namespace {

struct Matrix {
  float m00, m02, m20, m22;
};

// Bilinear, four channels.
void sample(const std::vector<float>& texels, int size, float u, float v, float* out) {
  const float x = u * float(size - 1), y = v * float(size - 1);
  const int x0 = std::min(int(x), size - 2), y0 = std::min(int(y), size - 2);
  const float fx = x - float(x0), fy = y - float(y0);
  const float* t = texels.data() + 4 * (y0 * size + x0);
  for (int k = 0; k < 4; ++k) {
    const float a = t[k] + (t[k + 4] - t[k]) * fx;
    const float b = t[k + 4 * size] + (t[k + 4 * size + 4] - t[k + 4 * size]) * fx;
    out[k] = a + (b - a) * fy;
  }
}

// The part of a convex outline with z >= 0.
int clip_to_horizon(const Vec3f* points, int count, Vec3f* kept) {
  int n = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3f a = points[i], b = points[i + 1 < count ? i + 1 : 0];
    if (a.z >= 0) kept[n++] = a;
    if ((a.z >= 0) != (b.z >= 0)) {
      const float t = a.z / (a.z - b.z);
      kept[n] = a + (b - a) * t;
      kept[n++].z = 0;
    }
  }
  return n;
}

float edge(Vec3f a, Vec3f b) {
  const float x = dot(a, b), y = std::abs(x);
  const float fit =
      (0.8543985f + (0.4965155f + 0.0145206f * y) * y) / (3.4175940f + (4.1616724f + y) * y);
  const float theta_sin = x > 0 ? fit : 0.5f / std::sqrt(std::max(1 - x * x, 1e-7f)) - fit;
  return (a.x * b.y - a.y * b.x) * theta_sin;
}

// The integral of the cosine over an outline above the horizon. The fit is theta / sin / (2 pi).
float irradiance(const Vec3f* points, int count) {
  if (count < 3) return 0;
  Vec3f units[8];
  for (int i = 0; i < count; ++i)
    units[i] = normalize(points[i]);
  float sum = 0;
  for (int i = 0; i < count; ++i)
    sum += edge(units[i], units[i + 1 < count ? i + 1 : 0]);
  return std::abs(sum);
}

} // namespace

UsualTable usual_table() {
  UsualTable t;
  const LobeTableView from = table::builtin_ggx_table().view();
  for (int y = 0; y < t.size; ++y)
    for (int x = 0; x < t.size; ++x) {
      const float roughness = float(x) / float(t.size - 1), v = float(y) / float(t.size - 1);
      const f32::FittedLobe f =
          f32::fetch_lobe(from, f32::alpha_from_roughness(roughness), 1 - v * v);
      t.matrix.insert(t.matrix.end(), {f.lobe.m00, f.lobe.m02, f.lobe.m20, f.lobe.m22});
      t.amplitude.insert(t.amplitude.end(), {f.n1, f.n5, 0, 0});
    }
  return t;
}

void usual_quad(const testing::LightBatch& batch, const UsualTable& table, int first, int count,
                float (*out)[testing::k_batch]) {
  for (int i = first; i < first + count; ++i) {
    const auto get = [&](const float(&v)[3][testing::k_batch]) {
      return Vec3f(v[0][i], v[1][i], v[2][i]);
    };
    const Vec3f position = get(batch.position), n = get(batch.normal), wo = get(batch.wo);
    const float cos_theta = std::min(std::max(dot(n, wo), 0.0f), 1.0f);
    float m[4], amplitude[4];
    const float v = std::sqrt(1 - cos_theta);
    sample(table.matrix, table.size, batch.roughness[i], v, m);
    sample(table.amplitude, table.size, batch.roughness[i], v, amplitude);

    const Vec3f t1 = normalize(wo - n * dot(n, wo)), t2 = cross(n, t1);
    const float* p = batch.polygon.points;
    Vec3f quad[4];
    for (int k = 0; k < 4; ++k) {
      const Vec3f d = Vec3f(p[4 * k], p[4 * k + 1], p[4 * k + 2]) - position;
      quad[k] = Vec3f(dot(t1, d), dot(t2, d), dot(n, d));
    }
    // One-sided.
    const float* normal = batch.polygon.normal;
    const Vec3f to_light = Vec3f(p[0], p[1], p[2]) - position;
    if (dot(to_light, Vec3f(normal[0], normal[1], normal[2])) >= 0 && !batch.polygon.two_sided) {
      out[0][i] = out[1][i] = out[2][i] = 0;
      continue;
    }
    Vec3f above[6], transformed[6], lit[8];
    const int corners = clip_to_horizon(quad, 4, above);
    const float diffuse = irradiance(above, corners);
    for (int k = 0; k < corners; ++k) {
      const Vec3f c = above[k];
      transformed[k] = Vec3f(m[0] * c.x + m[1] * c.z, c.y, m[2] * c.x + m[3] * c.z);
    }
    const float specular = irradiance(lit, clip_to_horizon(transformed, corners, lit));
    const Vec3f albedo(batch.albedo[i]), f0(batch.f0[i]);
    const Vec3f reflectance = f0 * amplitude[0] + (Vec3f(1.0f) - f0) * amplitude[1];
    const float left = 1 - std::max(std::max(reflectance.x, reflectance.y), reflectance.z);
    const Vec3f light = albedo * (left * diffuse) + reflectance * specular;
    out[0][i] = light.x;
    out[1][i] = light.y;
    out[2][i] = light.z;
  }
}

} // namespace openltc::bench
