// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Level of the lights. A white Lambertian card of luminance L receives the illuminance E = pi L.
//
// A rectangle with half sides a, b that faces a point straight at distance d gives the irradiance
// E = L * 2 [ a/sqrt(d2+a2) atan(b/sqrt(d2+a2)) + b/sqrt(d2+b2) atan(a/sqrt(d2+b2)) ]
// (four times the corner configuration factor, e.g. J. R. Howell, Catalog of Radiation Heat
// Transfer Configuration Factors, C-3; the factor pi is in it). Solved for L.

#include "openltc/scene/view/studio.h"

#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/line.h"
#include "openltc/light/polygon.h"
#include "openltc/light/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace openltc::scene {

namespace {

struct SoftBox {
  const char* name;
  double azimuth_rad;   // from the camera's side, to the right
  double elevation_rad; // above the horizon
  double distance;      // from the centre, in radii of the scene
  double half_width;    // radii
  double half_height;   // radii
  double share;         // of the key's illuminance
};

constexpr double k_degree = std::numbers::pi / 180;

constexpr SoftBox k_soft_boxes[3] = {
    {"studio key", -45 * k_degree, 40 * k_degree, 2.6, 1.1, 1.1, 1.0},
    {"studio fill", 60 * k_degree, 15 * k_degree, 3.0, 1.4, 1.4, 0.3},
    {"studio rim", 160 * k_degree, 50 * k_degree, 2.6, 1.2, 0.5, 0.8},
};

// Of a light's radiance: what a polished or brushed metal shows of it. White paper shows less,
// unless the light fills a fifth of what it sees, weighted by the cosine.
constexpr float k_image_of_light = 0.2f;

double irradiance_per_radiance(double a, double b, double d) {
  const double da = std::sqrt(d * d + a * a), db = std::sqrt(d * d + b * b);
  return 2 * (a / da * std::atan(b / da) + b / db * std::atan(a / db));
}

double luminance(Vec3f rgb) {
  return 0.2126 * double(rgb.x) + 0.7152 * double(rgb.y) + 0.0722 * double(rgb.z);
}

// Illuminance that a light gives at `p`, facing it, when its area is taken for a point.

// `offset` leads from the light to the point; nearer than the light's own size it is no point.
double illuminance_of_flat(const light::Emitter& light, Vec3d normal, Vec3d offset, double area) {
  const double distance2 = std::max(dot(offset, offset), area);
  const double cosine = dot(offset, normal) / std::sqrt(distance2);
  const double facing = light.two_sided ? std::abs(cosine) : std::max(cosine, 0.0);
  return luminance(light.radiance) * area * std::pow(facing, double(light.cosine_power) + 1) /
         distance2;
}

double illuminance_at(const light::PolygonLight& light, Vec3d p) {
  if (light.vertices.empty()) return 0;
  return illuminance_of_flat(light, to_double(light.normal), p - to_double(light.vertices[0]),
                             light::area(light));
}

double illuminance_at(const light::EllipseLight& light, Vec3d p) {
  return illuminance_of_flat(light,
                             normalize(cross(to_double(light.half_u), to_double(light.half_v))),
                             p - to_double(light.center), light::area(light));
}

double illuminance_at(const light::SphereLight& light, Vec3d p) {
  const Vec3d offset = p - to_double(light.center);
  const double radius2 = double(light.radius) * double(light.radius);
  return luminance(light.radiance) * std::numbers::pi * radius2 /
         std::max(dot(offset, offset), radius2);
}

// A tube seen across, without its ends.
double illuminance_of_line(Vec3d from, Vec3d to, double candela_per_metre, Vec3d p) {
  const double l = length(to - from);
  const Vec3d offset = p - (from + to) * 0.5;
  const double distance2 = std::max(dot(offset, offset), l * l / 4);
  const double along = dot(offset, (to - from) / l);
  return candela_per_metre * l * std::sqrt(std::max(1 - along * along / distance2, 0.0)) /
         distance2;
}

double illuminance_at(const light::TubeLight& light, Vec3d p) {
  return illuminance_of_line(to_double(light.from), to_double(light.to),
                             luminance(light.radiance) * 2 * double(light.radius), p);
}

double illuminance_at(const light::LineLight& light, Vec3d p) {
  return illuminance_of_line(to_double(light.from), to_double(light.to),
                             luminance(light.intensity_per_metre), p);
}

double illuminance_at(const light::PunctualLight& light, Vec3d p) {
  const Vec3d offset = p - to_double(light.position);
  const bool far = light.type == light::PunctualType::directional;
  return luminance(light.intensity) / (far ? 1.0 : std::max(dot(offset, offset), 1e-6));
}

} // namespace

light::Lights studio_lights(const Bounds& bounds, const Camera& camera, double white_nits) {
  const Vec3d lower(double(bounds.lower.x), double(bounds.lower.y), double(bounds.lower.z));
  const Vec3d upper(double(bounds.upper.x), double(bounds.upper.y), double(bounds.upper.z));
  const Vec3d center = (lower + upper) * 0.5;
  double radius = 0.5 * length(upper - lower);
  if (!(radius > 0)) radius = 0.5;

  // Around the vertical, starting from the side where the camera stands.
  Vec3d front(-double(camera.forward.x), 0, -double(camera.forward.z));
  if (!(length(front) > 1e-3)) front = Vec3d(-double(camera.up.x), 0, -double(camera.up.z));
  front = length(front) > 1e-3 ? normalize(front) : Vec3d(0, 0, 1);
  const Vec3d up(0, 1, 0);
  const Vec3d side = cross(up, front);

  const double key_illuminance = std::numbers::pi * white_nits;
  light::Lights lights;
  for (const SoftBox& box : k_soft_boxes) {
    const Vec3d towards = (front * std::cos(box.azimuth_rad) + side * std::sin(box.azimuth_rad)) *
                              std::cos(box.elevation_rad) +
                          up * std::sin(box.elevation_rad);
    const double luminance_nits =
        box.share * key_illuminance /
        irradiance_per_radiance(box.half_width, box.half_height, box.distance);
    // Facing the centre: right x up = -towards.
    const Vec3d right = normalize(cross(towards, up));
    const Vec3d box_up = cross(right, towards);
    light::PolygonLight light = light::rectangle(
        to_float(center + towards * (box.distance * radius)),
        to_float(right * (box.half_width * radius)), to_float(box_up * (box.half_height * radius)),
        Vec3f(float(luminance_nits)));
    light.name = box.name;
    lights.polygons.push_back(std::move(light));
  }
  return lights;
}

light::Lights ceiling_light(Vec3d center, double half_x, double half_z, double distance,
                            double white_nits) {
  const double nits =
      std::numbers::pi * white_nits / irradiance_per_radiance(half_x, half_z, distance);
  light::Lights lights;
  // right x up = (1, 0, 0) x (0, 0, 1) = (0, -1, 0): downwards
  lights.polygons.push_back(light::rectangle(to_float(center), to_float(Vec3d(half_x, 0, 0)),
                                             to_float(Vec3d(0, 0, half_z)), Vec3f(float(nits))));
  lights.polygons.back().name = "studio ceiling";
  return lights;
}

double white_level_nits(const light::Lights& lights, const Bounds& bounds) {
  const Vec3d center = (to_double(bounds.lower) + to_double(bounds.upper)) * 0.5;
  double brightest = 0;
  lights.for_each_area_light(
      [&](const auto& light) { brightest = std::max(brightest, illuminance_at(light, center)); });
  for (const light::PunctualLight& light : lights.punctual)
    brightest = std::max(brightest, illuminance_at(light, center));
  return brightest / std::numbers::pi;
}

float least_nits_of_lights(const light::Lights& lights) {
  float least = std::numeric_limits<float>::max();
  double all = 0;
  const auto each = [&](const auto& visit) {
    lights.for_each_area_light([&](const auto& light) {
      using Light = std::decay_t<decltype(light)>;
      if constexpr (!std::is_same_v<Light, light::LineLight>) {
        const float brightest = std::max({light.radiance.x, light.radiance.y, light.radiance.z});
        visit(brightest, luminance(light.radiance) * light::area(light));
      }
    });
  };
  each([&](float, double flux) { all += flux; });
  each([&](float brightest, double flux) {
    if (flux > 0 && flux >= 0.01 * all) least = std::min(least, k_image_of_light * brightest);
  });
  return least;
}

} // namespace openltc::scene
