// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/polygon_figure.h"

#include "openltc/plot/key_signs.h"
#include "openltc/plot/lobe_rows.h"
#include "openltc/plot/polygon_panel.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace openltc::plot {

namespace {

constexpr double k_width = 940, k_height = 660, k_radius = 165, k_middle = 284;
constexpr double k_left_center = 226, k_right_center = 714;

void draw_heads(Sketch& sketch, const std::string& lobe_name) {
  draw_text(sketch, 24, 30,
            "The integral over *P* under the lobe is that over *M*⁻¹*P* under the cosine",
            {17, Ink::ink, Anchor::start, true});
  draw_text(sketch, 24, 50, lobe_name, {12.5, Ink::soft});
  const TextStyle head{13.5, Ink::ink, Anchor::middle, true};
  draw_text(sketch, k_left_center, 80, "shading space: *D* over *P*", head);
  draw_text(sketch, k_right_center, 80, "cosine space: *D*_{o} over *M*⁻¹*P*", head);
  const double x = 0.5 * (k_left_center + k_right_center);
  draw_path(sketch, std::array{Vec2d(x - 27, k_middle), Vec2d(x + 20, k_middle)}, {Ink::ink, 1.6});
  draw_shape(sketch,
             std::array{Vec2d(x + 29, k_middle), Vec2d(x + 18, k_middle - 4.5),
                        Vec2d(x + 18, k_middle + 4.5)},
             {Ink::ink});
  draw_text(sketch, x, k_middle - 10, "*M*⁻¹", {15, Ink::ink, Anchor::middle});
}

struct Results {
  double x; // of the middle
  double peak;
  const char* density;
  const char* integral;
  const char* method;
};

Status draw_results(Sketch& sketch, const PolygonSpace& space, const Results& r) {
  constexpr double k_bar = 200;
  const double y = k_middle + k_radius + 26;
  Status bar = draw_density_bar(
      sketch, {r.x - 0.5 * k_bar, y}, k_bar,
      {{0, "0"}, {0.5, number_text(0.5 * r.peak)}, {1, number_text(r.peak)}}, r.density);
  if (!bar) return bar;
  draw_text(sketch, r.x, y + 56, fmt::format("{} = {:.7f}", r.integral, space.integral),
            {17, Ink::ink, Anchor::middle});
  const TextStyle note{12, Ink::soft, Anchor::middle};
  draw_text(sketch, r.x, y + 77, r.method, note);
  const double count = double(space.samples.size());
  const double deviation = std::sqrt(space.integral * (1 - space.integral) / count);
  draw_text(sketch, r.x, y + 96,
            fmt::format("{} of {} samples inside: {:.3f} ± {:.3f}", space.inside_count,
                        space.samples.size(), space.inside_count / count, deviation),
            note);
  return Success{};
}

void draw_key(Sketch& sketch, double y) {
  draw_line_sign(sketch, {30, y}, {Ink::ink, 1.3}, "surface's horizon");
  draw_line_sign(sketch, {182, y}, {Ink::ink, 1.3, "8 3 1.5 3"}, "cosine's horizon");
  draw_line_sign(sketch, {330, y}, {Ink::black, 3.8, "", 0.6}, "*P*, clipped to both");
  draw_path(sketch, std::array{Vec2d(330, y - 4), Vec2d(354, y - 4)}, {Ink::white, 2.3});
  const std::array swatch = {Vec2d(500, y - 10), Vec2d(524, y - 10), Vec2d(524, y + 2),
                             Vec2d(500, y + 2)};
  draw_shape(sketch, swatch, {Ink::soft, 1, true});
  draw_path(sketch, swatch, {Ink::ink, 1.2, "5 3", 0.9}, true);
  draw_sign_text(sketch, {500, y}, "what is cut off");
  draw_sample_sign(sketch, {658, y - 4}, true);
  draw_sign_text(sketch, {638, y}, "sample inside");
  draw_sample_sign(sketch, {792, y - 4}, false);
  draw_sign_text(sketch, {772, y}, "sample outside");
}

} // namespace

std::vector<Vec3d> default_polygon() {
  return {{-2.1, -0.05, -0.45}, {0.6, -1.45, -0.45}, {0.6, -1.45, 1.2}, {-2.1, -0.05, 1.2}};
}

Result<std::vector<Vec3d>> parse_points(const std::string& text) {
  std::vector<Vec3d> corners;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    double v[3] = {0, 0, 0};
    const char* at = word.data();
    const char* const end = word.data() + word.size();
    bool good = true;
    for (int i = 0; i < 3 && good; ++i) {
      const auto [read, error] = std::from_chars(at, end, v[i]);
      good = error == std::errc() && (i < 2 ? read != end && *read == ',' : read == end);
      at = good && i < 2 ? read + 1 : read;
    }
    if (!good)
      return Error{fmt::format(
          "--points: '{}' is not a corner x,y,z; give \"x,y,z x,y,z x,y,z ...\"", word)};
    corners.push_back({v[0], v[1], v[2]});
  }
  return corners;
}

Result<Sketch> make_polygon_figure(const PolygonOptions& options) {
  if (options.sampling.samples < 1 || options.sampling.samples > k_most_samples)
    return Error{
        fmt::format("--samples {}: must be 1 to {}", options.sampling.samples, k_most_samples)};
  const Result<PolygonEquivalence> spaces =
      compare_spaces(options.lobe, options.corners, "--points", options.sampling);
  if (!spaces) return spaces.error();
  const double difference = std::abs(spaces->shading.integral - spaces->cosine.integral);
  if (!(difference <= 1e-6))
    return Error{
        fmt::format("the integrals differ by {:.1e}; is the polygon degenerate?", difference)};
  if (spaces->shading.inside != spaces->cosine.inside)
    return Error{"a sample lies on the polygon's edge; take another --seed"};
  const LobeFacts facts = lobe_facts(options.lobe);

  Sketch sketch{k_width, k_height, ""};
  draw_heads(sketch, options.lobe_name);
  const Vec3d up(0, 0, 1);
  PolygonPanel shading{
      spaces->shading, options.lobe, facts.peak, up, spaces->horizon_normal_shading, {}};
  if (options.theta_degrees) {
    const double theta = *options.theta_degrees * f64::k_pi / 180;
    shading.wo = Vec3d(std::sin(theta), 0, std::cos(theta));
  }
  const PolygonPanel cosine{
      spaces->cosine, f64::cosine_lobe(), f64::k_inv_pi, spaces->horizon_normal_cosine, up, {}};
  const View view = polygon_view(*spaces, facts.mean_direction);
  const Results left{k_left_center, facts.peak, "*D*, sr⁻¹", "∫_{*P*} *D* dω",
                     "by quadrature of *D*"};
  const Results right{k_right_center, f64::k_inv_pi, "*D*_{o}, sr⁻¹", "∫_{*M*⁻¹*P*} *D*_{o} dω",
                      "by Lambert's edge sum, in closed form"};
  for (const Status& status :
       {draw_polygon_panel(sketch, view, {k_left_center, k_middle}, k_radius, shading),
        draw_polygon_panel(sketch, view, {k_right_center, k_middle}, k_radius, cosine),
        draw_results(sketch, spaces->shading, left), draw_results(sketch, spaces->cosine, right)})
    if (!status) return status.error();
  draw_key(sketch, k_middle + k_radius + 164);
  draw_text(sketch, 24, k_height - 16, options.command,
            {11, Ink::soft, Anchor::start, false, true});
  return sketch;
}

} // namespace openltc::plot
