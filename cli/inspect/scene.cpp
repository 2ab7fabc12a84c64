// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights in the units in which lamps are sold and measured: luminance in nits, intensity in
// candela, flux in lumens. A light's colour is weighed by Rec.709 luminance.

#include "cli/inspect/inspect.h"
#include "openltc/base/quote.h"
#include "openltc/image/tonemap.h"
#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/emission_stack.h"
#include "openltc/light/line.h"
#include "openltc/light/photometry/ies.h"
#include "openltc/light/polygon.h"
#include "openltc/light/units/units.h"
#include "openltc/scene/gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace openltc::cli {

namespace {

using Json = nlohmann::ordered_json;

// A curved emitter can be thousands of lights; more than these are only in the JSON.
constexpr std::size_t k_max_listed = 24;

double degrees(double angle_rad) { return angle_rad * 180 / std::numbers::pi; }

Json numbers(Vec3f v) { return Json::array({v.x, v.y, v.z}); }
Json numbers(Vec3d v) { return Json::array({v.x, v.y, v.z}); }

/// Coordinates of a scene as the file has them (Scene::origin).
struct Place {
  Vec3d origin;
  Json operator()(Vec3f p) const {
    const bool is_moved = origin.x != 0 || origin.y != 0 || origin.z != 0;
    return is_moved ? numbers(origin + to_double(p)) : numbers(p);
  }
};

void describe_geometry(const scene::Scene& scene, Description& out) {
  std::size_t triangles = 0, vertices = 0;
  for (const scene::Mesh& mesh : scene.meshes) {
    triangles += mesh.triangles.size();
    vertices += mesh.positions.size();
  }
  const Vec3f size = scene.bounds.upper - scene.bounds.lower;
  const Vec3d low = scene.origin + to_double(scene.bounds.lower);
  const Vec3d high = scene.origin + to_double(scene.bounds.upper);
  const auto point = [&](Vec3d p) {
    // As many digits as tell places of the scene apart.
    const bool is_far = length(scene.origin) > 0;
    return is_far ? fmt::format("({:.3f}, {:.3f}, {:.3f})", p.x, p.y, p.z)
                  : fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z);
  };
  out.text += fmt::format(
      "scene, {} meshes, {} triangles, {} vertices, {} materials, {} textures\n",
      scene.meshes.size(), triangles, vertices, scene.materials.size(), scene.textures.size());
  out.text += fmt::format("bounds     {:.4g} x {:.4g} x {:.4g} m, from {} to {}\n", size.x, size.y,
                          size.z, point(low), point(high));
  const Place place{scene.origin};
  out.json["meshes"] = scene.meshes.size();
  out.json["triangles"] = triangles;
  out.json["vertices"] = vertices;
  out.json["materials"] = Json::array();
  for (const scene::Material& material : scene.materials)
    out.json["materials"].push_back(material.name);
  out.json["textures"] = Json::array();
  for (const scene::Texture& texture : scene.textures)
    out.json["textures"].push_back(
        {{"width", texture.image.width}, {"height", texture.image.height}});
  out.json["bounds_m"] = {{"lower", place(scene.bounds.lower)},
                          {"upper", place(scene.bounds.upper)}};
}

void describe_cameras(const scene::Scene& scene, Description& out) {
  out.json["cameras"] = Json::array();
  if (scene.cameras.empty()) out.text += "camera     none; the scene will be framed\n";
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    const scene::Camera& camera = scene.cameras[i];
    const bool is_perspective = camera.projection == scene::Projection::perspective;
    Json json = {{"number", i}, {"name", camera.name}};
    json["type"] = is_perspective ? "perspective" : "orthographic";
    json["position_m"] = Place{scene.origin}(camera.position);
    if (is_perspective)
      json["fov_y_degrees"] = degrees(double(camera.fov_y_rad));
    else
      json["height_m"] = camera.height;
    if (camera.aspect > 0) json["aspect"] = camera.aspect;
    out.json["cameras"].push_back(json);
    out.text +=
        fmt::format("camera     {} \"{}\": {}\n", i, quote(camera.name),
                    is_perspective ? fmt::format("perspective, {:.1f} degrees high",
                                                 degrees(double(camera.fov_y_rad)))
                                   : fmt::format("orthographic, {:.4g} m high", camera.height));
  }
}

/// Width and height of the outlines along their longest edge and across it, in metres.
Vec2d extent_of(const light::PolygonLight& light) {
  Vec3f along(0.0f);
  for (std::size_t r = 0; r < light.ring_end.size(); ++r) {
    const auto ring = light::ring_vertices(light, r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3f edge = ring[(i + 1) % ring.size()] - ring[i];
      if (dot(edge, edge) > dot(along, along) * 1.0001f) along = edge;
    }
  }
  if (!(dot(along, along) > 0)) return {0, 0};
  along = normalize(along);
  const Vec3f across = cross(light.normal, along);
  Vec2d low{0, 0}, high{0, 0};
  for (const Vec3f vertex : light.vertices) {
    const Vec3f offset = vertex - light.vertices[0];
    const Vec2d p{double(dot(offset, along)), double(dot(offset, across))};
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return high - low;
}

double length_between(Vec3f a, Vec3f b) { return double(length(b - a)); }

// What is said of a light's shape: its type, its sizes for programs, and both for people.
struct ShapeDescription {
  std::string type;
  Json json;
  std::string text;
};

ShapeDescription describe_shape(const light::PolygonLight& light, const Place&) {
  const Vec2d size = extent_of(light);
  std::size_t holes = 0;
  for (std::size_t r = 0; r < light.ring_end.size(); ++r)
    holes += light::signed_ring_area(light::ring_vertices(light, r), light.normal) < 0;
  return {"polygon",
          {{"corners", light.vertices.size()},
           {"holes", holes},
           {"size_m", Json::array({size.x, size.y})}},
          fmt::format("polygon of {} corners{}, {:.4g} x {:.4g} m", light.vertices.size(),
                      holes == 0 ? "" : fmt::format(" and {} hole{}", holes, holes > 1 ? "s" : ""),
                      size.x, size.y)};
}

ShapeDescription describe_shape(const light::EllipseLight& light, const Place& place) {
  const double x = double(length(light.half_u)), y = double(length(light.half_v));
  const bool is_disk = std::abs(x - y) <= 1e-5 * std::max(x, y);
  Json json = {{"center_m", place(light.center)},
               {"size_m", Json::array({2 * x, 2 * y})},
               {"radii_m", Json::array({x, y})}};
  if (is_disk) return {"disk", json, fmt::format("disk, {:.4g} m across", 2 * x)};
  return {"ellipse", json, fmt::format("ellipse, {:.4g} x {:.4g} m", 2 * x, 2 * y)};
}

ShapeDescription describe_shape(const light::SphereLight& light, const Place& place) {
  return {"sphere",
          {{"center_m", place(light.center)}, {"radius_m", light.radius}},
          fmt::format("sphere, {:.4g} m across", 2 * light.radius)};
}

ShapeDescription describe_shape(const light::TubeLight& light, const Place& place) {
  const char* const caps = light.caps == light::TubeCaps::none   ? "none"
                           : light.caps == light::TubeCaps::flat ? "flat"
                                                                 : "round";
  const double metres = length_between(light.from, light.to);
  return {"tube",
          {{"from_m", place(light.from)},
           {"to_m", place(light.to)},
           {"length_m", metres},
           {"radius_m", light.radius},
           {"caps", caps}},
          fmt::format("tube, {:.4g} m long, {:.4g} m across, {} ends", metres, 2 * light.radius,
                      light.caps == light::TubeCaps::none ? "open" : caps)};
}

Vec3f picture_mean(const light::Emitter&, const light::Lights&) { return Vec3f(1.0f); }
Vec3f picture_mean(const light::PolygonLight& light, const light::Lights& lights) {
  return light::mean_of_texture(light, lights.textures);
}
Vec3f picture_mean(const light::EllipseLight& light, const light::Lights& lights) {
  return light::mean_of_texture(light, lights.textures);
}

template <class Light>
void describe_light(const Light& light, const light::Lights& lights, const Place& place,
                    Description& out, bool is_listed) {
  const ShapeDescription shape = describe_shape(light, place);
  const double area = light::area(light);
  const double lumens =
      double(image::luminance(light::flux_lumens(light) * picture_mean(light, lights)));
  const float nits = image::luminance(light.radiance);
  Json json = {{"name", light.name}, {"type", shape.type}};
  json.update(shape.json);
  json["two_sided"] = light.two_sided;
  json["area_m2"] = area;
  json["radiance_nits"] = numbers(light.radiance);
  json["luminance_nits"] = nits;
  json["flux_lumens"] = lumens;
  std::string more = light.two_sided ? ", two-sided" : "";
  if (light.cosine_power > 0) {
    json["cosine_power"] = light.cosine_power;
    more += fmt::format(", narrowed by cos^{:.4g}", light.cosine_power);
  }
  if (light.texture >= 0) {
    json["texture"] = light.texture;
    more += ", textured (nits where it is white)";
  }
  out.json["lights"].push_back(json);
  if (is_listed)
    out.text += fmt::format("light      \"{}\": {}, {:.4g} m2, {:.4g} nits, {:.4g} lm{}\n",
                            quote(light.name), shape.text, area, nits, lumens, more);
}

void describe_light(const light::LineLight& light, const light::Lights&, const Place& place,
                    Description& out, bool is_listed) {
  const double metres = length_between(light.from, light.to);
  const float strength = image::luminance(light.intensity_per_metre);
  const double lumens = double(image::luminance(light::flux_lumens(light)));
  out.json["lights"].push_back({{"name", light.name},
                                {"type", "line"},
                                {"from_m", place(light.from)},
                                {"to_m", place(light.to)},
                                {"length_m", metres},
                                {"intensity_candela_per_metre", strength},
                                {"flux_lumens", lumens}});
  if (is_listed)
    out.text += fmt::format("light      \"{}\": line, {:.4g} m long, {:.4g} cd/m, {:.4g} lm\n",
                            quote(light.name), metres, strength, lumens);
}

void describe_punctual(const light::PunctualLight& light, const Place& place, Description& out,
                       bool is_listed) {
  const double strength = double(image::luminance(light.intensity));
  const char* const type = light.type == light::PunctualType::point  ? "point"
                           : light.type == light::PunctualType::spot ? "spot"
                                                                     : "directional";
  Json json = {{"name", light.name}, {"type", type}};
  std::string text;
  if (light.type == light::PunctualType::directional) {
    json["illuminance_lux"] = strength;
    text = fmt::format("{:.4g} lux", strength);
  } else {
    json["position_m"] = place(light.position);
    json["intensity_candela"] = strength;
    text = fmt::format("{:.4g} cd", strength);
  }
  if (light.type != light::PunctualType::directional) {
    const double lumens = light::flux_per_intensity(light) * strength;
    json["flux_lumens"] = lumens;
    text += fmt::format(", {:.4g} lm", lumens);
  }
  if (light.profile) {
    json["profile"] = light.profile->name;
    text += fmt::format(", profile \"{}\"", quote(light.profile->name));
  }
  if (light.type == light::PunctualType::spot) {
    const double inner = degrees(std::acos(std::clamp(double(light.cos_inner), -1.0, 1.0)));
    const double outer = degrees(std::acos(std::clamp(double(light.cos_outer), -1.0, 1.0)));
    json["inner_cone_degrees"] = inner;
    json["outer_cone_degrees"] = outer;
    text += fmt::format(", cone {:.1f} to {:.1f} degrees from its axis", inner, outer);
  }
  if (light.range > 0) {
    json["range_m"] = light.range;
    text += fmt::format(", range {:.4g} m", light.range);
  }
  out.json["lights"].push_back(json);
  if (is_listed)
    out.text += fmt::format("light      \"{}\": {}, {}\n", quote(light.name), type, text);
}

void describe_lights(const scene::Scene& scene, const Place& place, Description& out) {
  const light::Lights& lights = scene.lights;
  out.json["lights"] = Json::array();
  std::size_t listed = 0;
  lights.for_each_area_light([&](const auto& light) {
    describe_light(light, lights, place, out, listed++ < k_max_listed);
  });
  for (const light::PunctualLight& light : lights.punctual)
    describe_punctual(light, place, out, listed++ < k_max_listed);
  out.json["describes_lights"] = scene.describes_lights;
  if (listed == 0)
    out.text += scene.describes_lights
                    ? "light      none that can be used, though the file describes some\n"
                    : "light      none; a studio rig will light it\n";
  if (listed > k_max_listed)
    out.text +=
        fmt::format("light      and {} more; --json lists them all\n", listed - k_max_listed);
}

void describe_animations(const scene::Scene& scene, Description& out) {
  out.json["animations"] = Json::array();
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    const scene::Animation& animation = scene.animations[i];
    out.json["animations"].push_back({{"number", i},
                                      {"name", animation.name},
                                      {"duration_seconds", animation.duration_seconds}});
    if (i < k_max_listed)
      out.text += fmt::format("animation  {} \"{}\": {:.4g} s\n", i, animation.name,
                              animation.duration_seconds);
  }
  if (scene.animations.size() > k_max_listed)
    out.text += fmt::format("animation  and {} more; --json lists them all\n",
                            scene.animations.size() - k_max_listed);
}

} // namespace

Result<Description> inspect_scene(const std::string& path, const scene::EmissiveOptions& emissive,
                                  const scene::ReadOptions& reading) {
  const Result<scene::Scene> scene = scene::load_gltf(path, emissive, reading);
  if (!scene) return scene.error();
  Description out;
  out.json = {{"file", path}, {"kind", "scene"}};
  describe_geometry(*scene, out);
  describe_cameras(*scene, out);
  describe_lights(*scene, Place{scene->origin}, out);
  describe_animations(*scene, out);
  out.json["warnings"] = scene->warnings;
  for (const std::string& warning : scene->warnings)
    out.text += fmt::format("warning    {}\n", warning);
  return out;
}

} // namespace openltc::cli
