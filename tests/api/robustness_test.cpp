// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// NaN, infinity, zero and the ends of single precision, in any place: nothing but finite numbers
// that are not negative comes out.

#include "openltc/openltc.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace openltc;

namespace {

/// All that a caller can hand over, with sound values.
struct Input {
  Vec3f position{0.1f, 0.2f, 0.3f}, normal{0, 1, 0.2f}, view{0.3f, 1, 0.5f}, geometric{0.1f, 1, 0};
  Material material;
  Vec3f center{0.2f, 1.2f, -0.4f}, half_u{0.5f, 0, 0}, half_v{0, 0, 0.4f}, end{1, 1.5f, 0.3f};
  float radius = 0.2f, range = 5, inner = 0.2f, outer = 0.6f;
  Vec3f radiance{1, 2, 3}, direction{0.1f, 1, -0.2f};
  Vec2f u{0.3f, 0.7f};
  float position_error = 1e-4f;
};
constexpr int k_numbers = int(sizeof(Input) / sizeof(float));
static_assert(sizeof(Input) == sizeof(std::array<float, k_numbers>));

bool is_sound(float x) { return x >= 0 && x <= std::numeric_limits<float>::max(); }
bool is_sound(Vec3f v) { return is_sound(v.x) && is_sound(v.y) && is_sound(v.z); }
bool is_finite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_sound(const LightSample& s) {
  return is_sound(s.pdf) && is_sound(s.distance) && is_sound(s.cos_light) &&
         is_finite(s.position) && is_finite(s.direction) && (!s.valid || s.pdf > 0);
}

template <class AreaLight>
bool is_sound_with(const Surface& s, const AreaLight& light, const Input& in) {
  const ShadedParts parts = shade_parts(s, light);
  return is_sound(parts.diffuse) && is_sound(parts.specular) &&
         is_sound(shade(s, light, in.radiance)) && is_sound(sample_light(s, light, in.u));
}

template <class AreaLight>
bool is_solid_sound(const Surface& s, const AreaLight& light, const Input& in) {
  return is_sound_with(s, light, in) && is_sound(intersect_light(s, light, in.direction)) &&
         is_sound(pdf_light(s, light, in.direction));
}

bool is_all_sound(const Input& in) {
  for (const Lobes& lobes : {built_in_table(), built_in_polynomial(), built_in_two_lobe_table(),
                             built_in_two_lobe_polynomial()}) {
    Surface surfaces[] = {
        make_surface(in.position, in.normal, in.view, in.material, lobes),
        make_surface(in.position, in.normal, in.view, in.material, lobes, in.geometric)};
    set_position_error(surfaces[1], in.position_error);
    for (const Surface& s : surfaces) {
      const DirectionSample d = sample_surface(s, in.u);
      if (!is_sound(eval_surface(s, in.direction)) || !is_sound(pdf_surface(s, in.direction)) ||
          !is_sound(d.value) || !is_sound(d.pdf) || !is_finite(d.direction))
        return false;
      if (!is_solid_sound(s, Polygon::rectangle(in.center, in.half_u, in.half_v, true), in) ||
          !is_solid_sound(s, Polygon::from_vertices({in.center, in.half_u, in.end, in.half_v}),
                          in) ||
          !is_solid_sound(s, Ellipse{in.center, in.half_u, in.half_v, true}, in) ||
          !is_solid_sound(s, disk(in.center, in.half_v, in.radius), in) ||
          !is_solid_sound(s, Sphere{in.center, in.radius}, in) ||
          !is_sound_with(s, Line{in.center, in.end}, in))
        return false;
      for (const TubeCaps caps : {TubeCaps::none, TubeCaps::flat, TubeCaps::round})
        if (!is_solid_sound(s, Tube{in.center, in.end, in.radius, caps}, in)) return false;
      if (!is_sound(shade(s, PointLight{in.center, in.radiance, in.range})) ||
          !is_sound(shade(
              s, SpotLight{in.center, in.direction, in.radiance, in.range, in.inner, in.outer})) ||
          !is_sound(shade(s, DirectionalLight{in.direction, in.radiance})))
        return false;
    }
  }
  return true;
}

float& number(Input& in, int i) { return reinterpret_cast<float*>(&in)[i]; }

const std::vector<float>& bad_numbers() {
  using Limits = std::numeric_limits<float>;
  static const std::vector<float> numbers = {Limits::quiet_NaN(),
                                             Limits::infinity(),
                                             -Limits::infinity(),
                                             0.0f,
                                             -0.0f,
                                             1.0f,
                                             -1.0f,
                                             Limits::max(),
                                             -Limits::max(),
                                             1e20f,
                                             -1e20f,
                                             3e8f,
                                             1e-20f,
                                             Limits::min(),
                                             Limits::denorm_min(),
                                             1e-6f,
                                             0.9999f,
                                             1e5f};
  return numbers;
}

} // namespace

TEST_CASE("sound_input_is_sound") {
  const Input in;
  CHECK(is_all_sound(in));
  CHECK(shade(make_surface(in.position, in.normal, in.view, in.material, built_in_table()),
              Sphere{in.center, in.radius}, in.radiance)
            .x > 0);
}

TEST_CASE("no_single_number_makes_nan_or_infinity_of_anything") {
  for (int i = 0; i < k_numbers; ++i)
    for (const float bad : bad_numbers()) {
      Input in;
      number(in, i) = bad;
      CAPTURE(i);
      CAPTURE(bad);
      CHECK(is_all_sound(in));
    }
}

TEST_CASE("no_two_numbers_do_either") {
  // A walk through pairs of places and values, the same every time.
  unsigned state = 1;
  const auto next = [&](std::size_t count) {
    state = state * 1664525u + 1013904223u;
    return std::size_t(state >> 8) % count;
  };
  for (int k = 0; k < 6000; ++k) {
    Input in;
    const std::size_t places = 2 + next(4);
    for (std::size_t p = 0; p < places; ++p)
      number(in, int(next(std::size_t(k_numbers)))) = bad_numbers()[next(bad_numbers().size())];
    CAPTURE(k);
    CHECK(is_all_sound(in));
  }
}

TEST_CASE("tables_of_nonsense_give_no_nonsense") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float value : {nan, 0.0f, -1.0f, 1e30f, std::numeric_limits<float>::infinity()}) {
    const std::vector<float> texels(4 * 4 * 8, value);
    for (const int form : {0, 1, 2, 3}) {
      Lobes lobes;
      if (form == 0) lobes.polynomial = {texels.data(), 4, nullptr};
      if (form == 1) lobes.table = {texels.data(), 4, 4, nullptr};
      if (form == 2) lobes.table = {texels.data(), 4, 4, texels.data()};
      if (form == 3) lobes.polynomial = {texels.data(), 4, texels.data()};
      const Input in;
      const Surface s = make_surface(in.position, in.normal, in.view, in.material, lobes);
      CAPTURE(value);
      CHECK(is_solid_sound(s, Polygon::rectangle(in.center, in.half_u, in.half_v, true), in));
      CHECK(is_solid_sound(s, Sphere{in.center, in.radius}, in));
      CHECK(is_solid_sound(s, Tube{in.center, in.end, in.radius}, in));
      CHECK(is_sound_with(s, Line{in.center, in.end}, in));
      CHECK(is_sound(sample_surface(s, in.u).pdf));
      CHECK(is_sound(shade(s, PointLight{in.center})));
    }
  }
}
