// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/view/view_samples.h"

#include "openltc/base/sampling.h"
#include "openltc/image/tonemap.h"
#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"
#include "openltc/scene/view/backdrop.h"

#include <algorithm>
#include <cmath>

namespace openltc::render {

namespace {

constexpr std::size_t k_samples = 1024;
constexpr std::size_t k_most_lights = 32; // the strongest
// What no light reaches is still worth a tenth: its outline is seen.
constexpr double k_worth_in_the_dark = 0.1;
constexpr double k_worth_of_outside = 0.7;
constexpr double k_off_surface = 1e-4; // of the scene's diagonal

/// A light taken for a point that shines as its shape does from afar.
struct LightPoint {
  Vec3d position;
  Vec3d axis{0, 0, 0}; ///< of a flat light, a spot or the sun
  double strength = 0; ///< candela; lux of the sun
  double radius = 0;   ///< within which its own shape may block
  bool is_flat = false, is_two_sided = false, is_sun = false;
  double cos_outer = -1;
};

bool is_bright(Vec3f radiance) { return std::max({radiance.x, radiance.y, radiance.z}) > 1; }

struct LightPoints {
  std::vector<LightPoint> points;

  void add(const light::PolygonLight& light) {
    if (light.vertices.empty() || !is_bright(light.radiance)) return;
    LightPoint point;
    for (const Vec3f v : light.vertices)
      point.position += to_double(v) / double(light.vertices.size());
    flat(light, point, to_double(light.normal), light::area(light));
  }
  void add(const light::EllipseLight& light) {
    LightPoint point;
    point.position = to_double(light.center);
    if (is_bright(light.radiance))
      flat(light, point, normalize(cross(to_double(light.half_u), to_double(light.half_v))),
           light::area(light));
  }
  void add(const light::SphereLight& light) {
    if (!is_bright(light.radiance)) return;
    const double r = double(light.radius);
    round(to_double(light.center), nits(light.radiance) * 3.1416 * r * r, 1.1 * r);
  }
  void add(const light::TubeLight& light) {
    const double r = double(light.radius), l = double(length(light.to - light.from));
    if (is_bright(light.radiance))
      round((to_double(light.from) + to_double(light.to)) * 0.5, nits(light.radiance) * 2 * r * l,
            1.1 * r);
  }
  void add(const light::LineLight& light) {
    round((to_double(light.from) + to_double(light.to)) * 0.5,
          nits(light.intensity_per_metre) * double(length(light.to - light.from)), 0);
  }
  void add(const light::PunctualLight& light) {
    LightPoint point;
    point.position = to_double(light.position);
    point.axis = to_double(light.direction);
    point.strength = nits(light.intensity);
    point.is_sun = light.type == light::PunctualType::directional;
    if (light.type == light::PunctualType::spot) point.cos_outer = double(light.cos_outer);
    points.push_back(point);
  }

private:
  static double nits(Vec3f rgb) { return double(image::luminance(rgb)); }
  void flat(const light::Emitter& light, LightPoint point, Vec3d normal, double area) {
    point.axis = normal;
    point.strength = nits(light.radiance) * area;
    point.is_flat = true;
    point.is_two_sided = light.two_sided;
    point.radius = double(light.surface_deviation);
    points.push_back(point);
  }
  void round(Vec3d position, double candela, double radius) {
    LightPoint point;
    point.position = position;
    point.strength = candela;
    point.radius = radius;
    points.push_back(point);
  }
};

std::vector<LightPoint> light_points(const light::Lights& lights) {
  LightPoints collected;
  lights.for_each_area_light([&](const auto& light) { collected.add(light); });
  for (const light::PunctualLight& light : lights.punctual)
    collected.add(light);
  auto& points = collected.points;
  std::erase_if(points, [](const LightPoint& p) { return !(p.strength > 0); });
  std::stable_sort(points.begin(), points.end(), [](const LightPoint& a, const LightPoint& b) {
    return a.is_sun != b.is_sun ? a.is_sun : a.strength > b.strength;
  });
  if (points.size() > k_most_lights) points.resize(k_most_lights);
  return std::move(points);
}

/// Illuminance on a surface that faces the light, without shadow; `towards` leads there, unit.
double illuminance(const LightPoint& light, Vec3d towards, double distance) {
  if (light.is_sun) return light.strength;
  double along = -dot(light.axis, towards);
  if (light.is_two_sided) along = std::abs(along);
  if (light.is_flat && along <= 0) return 0;
  if (along < light.cos_outer) return 0;
  return light.strength * (light.is_flat ? along : 1.0) / (distance * distance);
}

void weigh_by_light(std::vector<ViewSample>& samples, const scene::Scene& scene,
                    const SightLines& sight) {
  const std::vector<LightPoint> lights = light_points(scene.lights);
  if (lights.empty()) return;
  const double diagonal = scene::diagonal(scene.bounds);
  std::vector<std::array<double, 2>> received(samples.size(), {0, 0});
  std::vector<SightLine> lines(samples.size());
  for (const LightPoint& light : lights) {
    std::vector<double> unshadowed(samples.size(), 0);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const ViewSample& s = samples[i];
      const Vec3d offset =
          light.is_sun ? -light.axis * (2 * diagonal) : light.position - s.position;
      const double distance = std::max(length(offset), 1e-6 * diagonal);
      const Vec3d towards = offset / distance;
      const double cosine = dot(s.normal, towards);
      unshadowed[i] = illuminance(light, towards, distance) * std::abs(cosine);
      const Vec3d from = s.position + s.normal * std::copysign(k_off_surface * diagonal, cosine);
      lines[i] = {from, from + towards * std::max(distance - light.radius, 0.0)};
    }
    sight.trace(lines, SightLines::Blocks::all);
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (lines[i].is_free) {
        const bool is_front = dot(samples[i].normal, lines[i].to - lines[i].from) > 0;
        received[i][is_front ? 0 : 1] += unshadowed[i];
      }
  }
  double sum = 0;
  std::size_t lit = 0;
  for (const auto& sides : received)
    for (const double e : sides)
      if (e > 0) {
        sum += std::log(e);
        ++lit;
      }
  if (lit == 0) return;
  const double typical = std::exp(sum / double(lit));
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t side = 0; side < 2; ++side) {
      const double e = received[i][side];
      samples[i].worth[side] =
          k_worth_in_the_dark + (1 - k_worth_in_the_dark) * std::min(2 * e / (e + typical), 1.0);
    }
}

// Of a wall with two sides the inner one is what there is to see: another surface faces it.
void weigh_by_enclosure(std::vector<ViewSample>& samples, const scene::Scene& scene,
                        const SightLines& sight) {
  const double diagonal = scene::diagonal(scene.bounds);
  for (ViewSample& sample : samples) {
    if (!sample.two_sided) continue;
    for (std::size_t side = 0; side < 2; ++side) {
      const Vec3d outwards = side == 0 ? sample.normal : -sample.normal;
      const Vec3d from = sample.position + outwards * (k_off_surface * diagonal);
      if (sight.free_distance(from, outwards, diagonal) >= diagonal)
        sample.worth[side] *= k_worth_of_outside;
    }
  }
}

} // namespace

std::vector<ViewSample> sample_subject(const scene::Scene& scene, const scene::Subject& subject,
                                       const SightLines& sight) {
  struct Entry {
    std::uint32_t mesh, triangle;
    double area_before; // of all triangles up to and with this one
  };
  std::vector<Entry> entries;
  double area = 0;
  for (const scene::SubjectPart& part : subject.parts)
    for (const std::uint32_t triangle : part.triangles) {
      area += length(scene::area_vector(scene.meshes[part.mesh], triangle));
      entries.push_back({part.mesh, triangle, area});
    }
  std::vector<ViewSample> samples;
  if (entries.empty() || !(area > 0)) return samples;
  for (std::size_t i = 0; i < k_samples; ++i) {
    const double place = (double(i / 2) + 0.5) / (k_samples / 2);
    std::size_t at = std::min(std::size_t(place * double(entries.size())), entries.size() - 1);
    if (i % 2 == 0)
      at =
          std::size_t(std::lower_bound(entries.begin(), entries.end() - 1, place * area,
                                       [](const Entry& e, double a) { return e.area_before < a; }) -
                      entries.begin());
    const scene::Mesh& mesh = scene.meshes[entries[at].mesh];
    const Vec3d vector = scene::area_vector(mesh, entries[at].triangle);
    if (!(length(vector) > 0)) continue;
    const Sample2 random = owen_sobol(std::uint32_t(i), 0x51a7c3u);
    const double root = std::sqrt(double(random.u)), v = double(random.v);
    const auto& corner = mesh.triangles[entries[at].triangle];
    ViewSample sample;
    sample.position = to_double(mesh.positions[corner[0]]) * (1 - root) +
                      to_double(mesh.positions[corner[1]]) * (root * (1 - v)) +
                      to_double(mesh.positions[corner[2]]) * (root * v);
    sample.normal = normalize(vector);
    sample.two_sided = scene.materials[std::size_t(mesh.material)].double_sided;
    samples.push_back(sample);
  }
  weigh_by_light(samples, scene, sight);
  weigh_by_enclosure(samples, scene, sight);
  return samples;
}

} // namespace openltc::render
