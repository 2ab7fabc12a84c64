// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// How bright a light is may be said by its luminance along the normal L, by its flux or by its
// intensity. With p the cosine power of its emission and A its area
//   flux      = 2 pi / (p + 2) A L, twice that from two sides (light/curved.h),
//   intensity = A L along the normal of a flat one.
// Of a convex one the facets add cos^p times their projected area to a view across; over a sphere
//   r^2 L int cos^(p+1) dw = 2 pi / (p + 2) r^2 L,
// over the side of a tube of length l
//   r l L int_-pi/2^pi/2 cos^(p+1) t dt = sqrt(pi) Gamma(p/2 + 1) / Gamma(p/2 + 3/2) r l L;
// flat ends are seen edge-on, round ones add a sphere.

#include "openltc/scene/gltf/light/extras_light.h"

#include "openltc/base/quote.h"
#include "openltc/image/file.h"
#include "openltc/light/curved.h"
#include "openltc/light/ellipse.h"
#include "openltc/light/emitter.h"
#include "openltc/light/line.h"
#include "openltc/light/photometry/ies.h"
#include "openltc/light/polygon.h"
#include "openltc/light/punctual.h"
#include "openltc/light/shapes.h"
#include "openltc/light/units/units.h"
#include "openltc/scene/emissive/simple_outline.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/uri.h"
#include "openltc/scene/gltf/light/properties.h"
#include "openltc/scene/gltf/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace openltc::scene::gltf {

namespace {

enum class Quantity { luminance_nits, flux_lumens, intensity_candela, illuminance_lux };
constexpr const char* k_quantities[] = {"luminance_nits", "flux_lumens", "intensity_candela",
                                        "illuminance_lux"};

struct Strength {
  Quantity quantity = Quantity::luminance_nits;
  Vec3d value{0, 0, 0}; ///< times colour and exposure
};

class ExtrasLight {
public:
  ExtrasLight(const nlohmann::json& properties, const std::string& field,
              const std::string& node_name, const Placement& placement, Document& document,
              light::Lights& lights)
      : p_(properties, field), name_(node_name), placement_(placement), document_(document),
        lights_(lights) {}

  void read() {
    const std::string type = p_.text("type", "");
    if (type == "rect") return read_rectangle();
    if (type == "disk" || type == "ellipse") return read_ellipse(type == "disk");
    if (type == "polygon") return read_polygon();
    if (type == "sphere") return read_sphere();
    if (type == "tube") return read_tube();
    if (type == "line") return read_line();
    if (type == "point") return read_punctual(light::PunctualType::point);
    if (type == "spot") return read_punctual(light::PunctualType::spot);
    if (type == "directional") return read_punctual(light::PunctualType::directional);
    p_.refuse("type",
              fmt::format("\"{}\" is not one of: rect disk ellipse polygon sphere tube line "
                          "point spot directional",
                          quote(type)));
  }

private:
  // Positions and axes in the world. The emitting side of planar shapes is -Z, so that their own
  // right-hand frame has x turned over.
  Vec3f point(double x, double y) const { return to_float(placement_.point({x, y, 0})); }
  Vec3f right(double metres) const {
    return to_float(-placement_.right * (metres * placement_.scale));
  }
  Vec3f up(double metres) const { return to_float(placement_.up * (metres * placement_.scale)); }
  float scaled(double metres) const { return float(metres * placement_.scale); }

  void read_rectangle() {
    const double width = p_.positive("width"), height = p_.positive("height");
    light::PolygonLight light =
        light::rectangle(point(0, 0), right(width / 2), up(height / 2), Vec3f(0));
    light.normal = to_float(-placement_.back);
    add_planar(std::move(light), "a rect", lights_.polygons, width / 2, height / 2);
  }

  void read_ellipse(bool is_disk) {
    const double x = p_.positive(is_disk ? "radius" : "radius_x");
    const double y = is_disk ? x : p_.positive("radius_y");
    add_planar(light::ellipse(point(0, 0), right(x), up(y), Vec3f(0)),
               is_disk ? "a disk" : "an ellipse", lights_.ellipses, x, y);
  }

  void read_polygon() {
    std::vector<std::vector<Vec2d>> rings = {p_.outline("points")};
    std::vector<std::string> names = {"points"};
    for (auto& hole : p_.outlines("holes")) {
      names.push_back(fmt::format("holes[{}]", rings.size() - 1));
      rings.push_back(std::move(hole));
    }
    const auto check = [&](std::size_t ring, const Status& status) {
      if (!status.ok()) p_.refuse(names[ring], status.error().message);
    };
    light::PolygonLight light;
    light.normal = to_float(-placement_.back);
    for (std::size_t i = 0; i < rings.size(); ++i) {
      std::vector<Vec2d>& ring = rings[i];
      const bool repeats_first =
          ring.size() > 1 && ring.front().x == ring.back().x && ring.front().y == ring.back().y;
      if (repeats_first) ring.pop_back();
      check(i, check_simple(ring));
      if (i > 0) check(i, check_inside(ring, rings[0]));
      for (std::size_t k = 1; k < i; ++k)
        check(i, check_apart(ring, rings[k]));
      // Seen from -Z, the outline runs counter-clockwise and the holes clockwise.
      if ((signed_area(ring) < 0) != (i == 0)) std::reverse(ring.begin(), ring.end());
      for (const Vec2d corner : ring)
        light.vertices.push_back(point(corner.x, corner.y));
      light.ring_end.push_back(std::uint32_t(light.vertices.size()));
    }
    read_flat_emission(light, "a polygon");
    add(std::move(light), lights_.polygons, "points");
  }

  void read_sphere() {
    light::SphereLight light;
    light.center = point(0, 0);
    light.radius = scaled(p_.positive("radius"));
    read_emission(light, "a sphere");
    add(std::move(light), lights_.spheres, "radius");
  }

  void read_tube() {
    light::TubeLight light;
    const double length = p_.positive("length");
    light.from = point(-length / 2, 0);
    light.to = point(length / 2, 0);
    light.radius = scaled(p_.positive("radius"));
    const std::string caps = p_.choice("caps", {"round", "flat", "none"});
    light.caps = caps == "round"  ? light::TubeCaps::round
                 : caps == "flat" ? light::TubeCaps::flat
                                  : light::TubeCaps::none;
    read_emission(light, "a tube");
    add(std::move(light), lights_.tubes, "radius");
  }

  void read_line() {
    light::LineLight light;
    const double length = p_.positive("length");
    light.from = point(-length / 2, 0);
    light.to = point(length / 2, 0);
    const Strength strength =
        read_strength("a line", {Quantity::flux_lumens, Quantity::intensity_candela});
    p_.check_all_known("a line");
    const bool is_flux = strength.quantity == Quantity::flux_lumens;
    light.intensity_per_metre = limited(
        strength.value / (is_flux ? light::flux_per_intensity(light) : length * placement_.scale));
    add(std::move(light), lights_.lines, "length");
  }

  void read_punctual(light::PunctualType type) {
    light::PunctualLight light;
    light.type = type;
    light.position = point(0, 0);
    const bool is_spot = type == light::PunctualType::spot;
    const bool is_far = type == light::PunctualType::directional;
    const std::string what = is_far ? "a directional light" : is_spot ? "a spot" : "a point";
    if (type != light::PunctualType::point) light.direction = to_float(-placement_.back);
    const bool has_profile = !is_far && read_profile(light);
    if (is_spot) {
      const double inner = p_.not_negative("inner_cone_degrees", 0);
      // A profile has its own limits.
      const double outer = p_.not_negative("outer_cone_degrees", has_profile ? 90 : 45);
      if (!(outer > 0) || outer > 90)
        p_.refuse("outer_cone_degrees", fmt::format("{} is not between 0 and 90", outer));
      if (inner > outer)
        p_.refuse("inner_cone_degrees",
                  fmt::format("{} is wider than the outer cone of {}", inner, outer));
      const bool is_open = has_profile && !p_.has("outer_cone_degrees");
      if (is_open) light.type = light::PunctualType::point;
      light.cos_inner = float(std::cos(inner * std::numbers::pi / 180));
      light.cos_outer = float(std::cos(outer * std::numbers::pi / 180));
    }
    if (!is_far)
      light.range = float(std::min(p_.not_negative("range", 0), 1e2 * light::k_max_metres));
    const bool is_given = p_.has("intensity_candela") || p_.has("flux_lumens");
    if (has_profile && !is_given) {
      light.intensity = limited(read_color() * light.profile->max_candela);
    } else {
      const Strength strength =
          is_far ? read_strength(what, {Quantity::illuminance_lux})
                 : read_strength(what, {Quantity::intensity_candela, Quantity::flux_lumens});
      const bool is_flux = strength.quantity == Quantity::flux_lumens;
      const double per_candela = is_flux ? light::flux_per_intensity(light) : 1.0;
      if (!(per_candela > 0)) p_.refuse("flux_lumens", "the profile and the cone leave no light");
      light.intensity = limited(strength.value / per_candela);
    }
    p_.check_all_known(what);
    add(std::move(light), lights_.punctual, "type");
  }

  // A photometric file, whose aim (nadir) points along -Z and whose horizontal angle 0 along +X.
  // Without an intensity or flux of its own, the light has the file's.
  bool read_profile(light::PunctualLight& light) {
    const std::string uri = p_.text("ies", "");
    if (uri.empty()) return false;
    const std::string field = p_.field() + ".ies";
    light.profile = document_.profiles.read(resolve_uri(uri, document_.base_dir, field), field,
                                            document_.warnings);
    light.direction = to_float(-placement_.back);
    light.right = to_float(placement_.right);
    return true;
  }

  // --- emission ------------------------------------------------------------------------------

  Strength read_strength(const std::string& what, const std::vector<Quantity>& allowed) {
    std::string listed;
    for (const Quantity q : allowed)
      listed += (listed.empty() ? "" : " or ") + std::string(k_quantities[std::size_t(q)]);
    std::optional<Strength> strength;
    double value = 0;
    for (const Quantity q : {Quantity::luminance_nits, Quantity::flux_lumens,
                             Quantity::intensity_candela, Quantity::illuminance_lux}) {
      const char* const name = k_quantities[std::size_t(q)];
      if (std::find(allowed.begin(), allowed.end(), q) == allowed.end()) {
        if (p_.has(name)) p_.refuse(name, fmt::format("is not for {}; give {}", what, listed));
        continue;
      }
      const auto given = p_.number(name);
      if (!given) continue;
      if (strength)
        p_.refuse(name, fmt::format("how bright it is, is said twice, by {} too; give one",
                                    k_quantities[std::size_t(strength->quantity)]));
      if (*given < 0) p_.refuse(name, fmt::format("{} must not be negative", *given));
      strength = Strength{q, Vec3d(0, 0, 0)};
      value = *given;
    }
    if (!strength)
      p_.refuse(k_quantities[std::size_t(allowed[0])],
                fmt::format("is missing: say how bright it is, by {}", listed));
    strength->value = read_color() * value;
    return *strength;
  }

  // Colour times exposure.
  Vec3d read_color() {
    const double exposure = p_.number("exposure", 0);
    if (!(std::abs(exposure) <= 100))
      p_.refuse("exposure", fmt::format("{} is not within 100 stops of 0", exposure));
    return p_.color("color") * std::exp2(exposure);
  }

  static Vec3f limited(Vec3d v) {
    return Vec3f(float(std::min(v.x, 1e30)), float(std::min(v.y, 1e30)),
                 float(std::min(v.z, 1e30)));
  }

  template <class Light> void read_emission(Light& light, const std::string& what) {
    light.cosine_power = float(p_.not_negative("cosine_power", 0));
    const Strength strength = read_strength(
        what, {Quantity::luminance_nits, Quantity::flux_lumens, Quantity::intensity_candela});
    const double per_nit =
        strength.quantity == Quantity::flux_lumens         ? light::flux_per_radiance(light)
        : strength.quantity == Quantity::intensity_candela ? light::intensity_per_radiance(light)
                                                           : 1.0;
    if (!(per_nit > 0))
      p_.refuse("type", "the light has no area; check its size and its node's scale");
    light.radiance = limited(strength.value / per_nit);
    p_.check_all_known(what);
  }

  template <class Light> void read_flat_emission(Light& light, const std::string& what) {
    light.two_sided = p_.flag("two_sided");
    read_emission(light, what);
  }

  // A planar light that may carry a picture, which fills the rectangle of these half sides and is
  // upright for who looks at its emitting side.
  template <class Light>
  void add_planar(Light light, const char* what, std::vector<Light>& list, double half_width,
                  double half_height) {
    const std::string texture = p_.text("texture", "");
    read_flat_emission(light, what);
    if (!texture.empty()) {
      light.texture = load_texture(texture);
      light.texture_corner = point(half_width, half_height);
      light.texture_u = right(2 * half_width);
      light.texture_v = up(-2 * half_height);
    }
    add(std::move(light), list, "scale");
  }

  int load_texture(const std::string& uri) {
    const std::string field = p_.field() + ".texture";
    const std::string path = resolve_uri(uri, document_.base_dir, field);
    const std::string key = canonical_path(path); // of all spellings
    const auto known = document_.light_textures.find(key);
    if (known != document_.light_textures.end()) return known->second;
    const auto lost = document_.lost_light_textures.find(key);
    if (lost != document_.lost_light_textures.end()) fail(field, lost->second);
    Result<image::Texels> image = image::read_texels(path);
    Status status =
        image ? document_.scene_memory->take(image->byte_count(), path) : Status(image.error());
    if (!status) {
      const std::string reason = quote(status.error().message, 300);
      document_.lost_light_textures[key] = reason;
      fail(field, reason);
    }
    const int index = int(lights_.textures.size());
    lights_.textures.push_back(std::move(*image));
    document_.light_textures[key] = index;
    return index;
  }

  template <class Light> void add(Light light, std::vector<Light>& list, const char* property) {
    light.name = name_;
    if (const Status status = light::validate(light); !status.ok())
      p_.refuse(property, fmt::format("it gives no usable light ({}); check its size and its "
                                      "node's scale",
                                      status.error().message));
    list.push_back(std::move(light));
  }

  Properties p_;
  std::string name_;
  const Placement& placement_;
  Document& document_;
  light::Lights& lights_;
};

} // namespace

void read_extras_light(const nlohmann::json& properties, const std::string& node,
                       const std::string& node_name, const Transform& to_world, Document& document,
                       light::Lights& lights) {
  const std::string field = node + ".extras.openltc_light";
  const Placement placement = placement_of(to_world, field, document);
  ExtrasLight(properties, field, node_name.empty() ? node : node_name, placement, document, lights)
      .read();
}

} // namespace openltc::scene::gltf
