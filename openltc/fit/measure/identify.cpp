// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/measure/identify.h"

#include "openltc/base/parallel.h"
#include "openltc/brdf/brdf.h"
#include "openltc/fit/measure/error.h"
#include "openltc/fit/quadrature.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace openltc::fit {

namespace {

using table::Layout;
using Texel = std::array<double, 4>;

// How four numbers, or five, are taken for a matrix.
struct Packing {
  const char* words;
  Layout layout;   // the channels' order
  bool transposed; // the two elements off the diagonal exchanged
  bool inverted;   // M instead of M^-1
  bool five;       // ltc_code before October 2017: M22 in the second texture, nothing normalised
  bool is_layout_self; // the layout itself
};
constexpr Packing k_packings[] = {
    {"mirror-frame A B C D", Layout::native, false, false, false, true},
    {"M^-1 as ltc_code (M00 M20 M02 M22)", Layout::ltc_code, false, false, false, true},
    {"M^-1 as ltc_code, transposed", Layout::ltc_code, true, false, false, false},
    {"M (not M^-1) in the order of ltc_code", Layout::ltc_code, false, true, false, false},
    {"M (not M^-1) in the order of ltc_code, transposed", Layout::ltc_code, true, true, false,
     false},
    {"M^-1 as Unity (M00 M20 M11 M02)", Layout::unity, false, false, false, true},
    {"M^-1 as Unity, transposed", Layout::unity, true, false, false, false},
    {"M as Godot (a b c d | e)", Layout::godot, false, false, false, true},
    {"M^-1 as O3DE and the first ltc_code (M22 M20 M11 M02)", Layout::o3de, false, false, false,
     true},
    {"M^-1 as O3DE, transposed", Layout::o3de, true, false, false, false},
    {"M^-1 in five numbers, ltc_code before October 2017", Layout::ltc_code, false, false, true,
     false},
};

enum class Angle { root, theta, cosine };
constexpr const char* k_angle_words[] = {"sqrt(1 - cos theta)", "theta", "cos theta"};

struct Reading {
  const Packing* packing;
  Angle angle;
  bool by_alpha; // x = alpha instead of roughness
  bool swapped;  // roughness along the rows
};

std::string words_of(const Reading& r) {
  return fmt::format("{}; {} by {}{}", r.packing->words, r.by_alpha ? "alpha" : "roughness",
                     k_angle_words[std::size_t(r.angle)], r.swapped ? ", axes swapped" : "");
}

std::optional<Layout> layout_of(const Reading& r, std::span<const table::Texture> textures) {
  const table::AngleAxis axis = table::angle_axis_of(r.packing->layout);
  const Angle angle = axis == table::AngleAxis::theta ? Angle::theta : Angle::root;
  if (!r.packing->is_layout_self || r.angle != angle || r.by_alpha || r.swapped) return {};
  const std::size_t needed = table::facts_of(r.packing->layout).channels.size();
  if (!table::check_textures("", r.packing->layout,
                             textures.first(std::min(needed, textures.size()))))
    return {};
  return r.packing->layout;
}

// The textures' lobe for a roughness and view angle, read this way.
f64::FittedLobe read_lobe(const Reading& r, std::span<const table::Texture> textures,
                          double roughness, double cos_theta, double width) {
  const double alpha = f64::alpha_from_roughness(roughness);
  double x = r.by_alpha ? alpha : roughness;
  double y = r.angle == Angle::root    ? std::sqrt(1 - cos_theta)
             : r.angle == Angle::theta ? std::acos(cos_theta) / (0.5 * f64::k_pi)
                                       : cos_theta;
  if (r.swapped) std::swap(x, y);
  const auto sample = [&](const table::Texture& texture) {
    return table::sample_texture(texture, f64::table_coordinate(x, texture.width),
                                 f64::table_coordinate(y, texture.height));
  };
  Texel first = sample(textures[0]), second = {};
  if (textures.size() > 1) second = sample(textures[1]);
  if (r.packing->five)
    first = {first[0] / first[2], first[1] / first[2], first[3] / first[2], second[0] / first[2]};
  if (r.packing->transposed) {
    if (r.packing->layout == Layout::ltc_code)
      std::swap(first[1], first[2]);
    else
      std::swap(first[1], first[3]);
  }
  f64::FittedLobe fitted = table::lobe_of_texel(r.packing->layout, first, second, width, cos_theta);
  if (r.packing->inverted) { // with the middle element 1 before and after
    const f64::Lobe m = fitted.lobe;
    fitted.lobe = f64::make_lobe(m.m22 / m.det, -m.m02 / m.det, -m.m20 / m.det, m.m00 / m.det);
  }
  if (r.packing->five) {
    fitted.n1 = second[1];
    fitted.n5 = 0;
  }
  return fitted;
}

bool is_lobe(const f64::Lobe& lobe) {
  return lobe.det > 0 && std::isfinite(lobe.det) &&
         std::isfinite(lobe.m00 + lobe.m02 + lobe.m20 + lobe.m22);
}

Result<std::vector<Quadrature>> rules_of(const brdf::Brdf& brdf, int points) {
  const MeasureOptions region;
  std::vector<Quadrature> rules;
  for (int k = 0; k < points * points; ++k) {
    const double roughness = region.roughness_from + (region.roughness_to - region.roughness_from) *
                                                         (k % points + 0.5) / points;
    const double theta = region.theta_to_degrees * (k / points + 0.5) / points * f64::k_pi / 180;
    Result<Quadrature> rule = make_quadrature(brdf, roughness, std::cos(theta), {24, 20});
    if (!rule) return rule.error();
    rules.push_back(std::move(*rule));
  }
  return rules;
}

Identification compare(const Reading& r, std::span<const table::Texture> textures,
                       const brdf::Brdf& brdf, std::span<const Quadrature> rules) {
  Identification id;
  id.reading = words_of(r);
  id.layout = layout_of(r, textures);
  id.brdf = brdf.name;
  id.has_amplitudes = textures.size() > 1 && r.packing->layout != Layout::unity;
  id.mean_tv = 0;
  for (const Quadrature& rule : rules) {
    const f64::FittedLobe fitted =
        read_lobe(r, textures, rule.roughness, rule.cos_theta, rule.width);
    id.mean_tv += is_lobe(fitted.lobe) ? measure_lobe(rule, fitted.lobe).tv : 1;
    id.mean_n1 += std::abs(fitted.n1 - rule.n1);
    id.mean_n5 += std::abs(fitted.n5 - rule.n5);
  }
  for (double* sum : {&id.mean_tv, &id.mean_n1, &id.mean_n5})
    *sum = std::isfinite(*sum) ? *sum / double(rules.size()) : 1;
  return id;
}

} // namespace

Result<std::vector<Identification>> identify(std::span<const table::Texture> textures, int points) {
  if (textures.empty() || textures[0].channels != 4 || textures[0].height < 2)
    return Error{"only a texture of four channels and several rows can hold lobes"};
  std::vector<Reading> readings;
  for (const Packing& packing : k_packings) {
    if ((packing.five || packing.layout == Layout::godot) && textures.size() < 2) continue;
    for (const Angle angle : {Angle::root, Angle::theta, Angle::cosine})
      for (const bool by_alpha : {false, true})
        for (const bool swapped : {false, true})
          readings.push_back({&packing, angle, by_alpha, swapped});
  }

  std::vector<Identification> found;
  for (const brdf::Brdf& brdf : brdf::all_brdfs()) {
    const Result<std::vector<Quadrature>> rules = rules_of(brdf, points);
    if (!rules) continue; // a BRDF that cannot be integrated is no candidate
    std::vector<Identification> of_brdf(readings.size());
    parallel_for(std::int64_t(readings.size()), 0, [&](std::int64_t index) {
      const std::size_t i = std::size_t(index);
      of_brdf[i] = compare(readings[i], textures, brdf, *rules);
    });
    found.insert(found.end(), of_brdf.begin(), of_brdf.end());
  }
  // BRDFs that differ in amplitude only, such as one with and without multiple scattering, have the
  // same lobes: then the amplitudes decide.
  const auto key = [](const Identification& id) {
    return std::tuple(std::lround(id.mean_tv * 1e5), id.layout ? 0 : 1,
                      id.has_amplitudes ? id.mean_n1 : 0.0);
  };
  std::stable_sort(
      found.begin(), found.end(),
      [&](const Identification& a, const Identification& b) { return key(a) < key(b); });
  return found;
}

} // namespace openltc::fit
