// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/figures/polygon_figure.h"

#include "openltc/draw/axes.h"
#include "openltc/plot/lobe_rows.h"
#include "openltc/plot/polygon_panel.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace openltc::plot {

namespace {

constexpr double k_width = 904, k_height = 580, k_radius = 160, k_middle = 236;
constexpr double k_left_center = 200, k_right_center = 704;

draw::Type marked(double size, draw::Anchor anchor, const char* color, bool bold = false) {
  return {size, anchor, color, bold, false, 0, true};
}

void draw_heads(draw::Figure& figure, const std::string& lobe_name) {
  draw_text(figure, {0, 9}, lobe_name, {12.5, draw::Anchor::start, "soft"});
  const draw::Type head = marked(13.5, draw::Anchor::middle, "ink", true);
  draw_text(figure, {k_left_center, 32}, "shading space: *D* over *P*", head);
  draw_text(figure, {k_right_center, 32}, "cosine space: *D*_{o} over *M*⁻¹*P*", head);
  const double x = 0.5 * (k_left_center + k_right_center);
  draw_line(figure, {x - 27, k_middle}, {x + 20, k_middle}, {"ink", 1.6});
  const std::array arrow_head = {Vec2d(x + 29, k_middle), Vec2d(x + 18, k_middle - 4.5),
                                 Vec2d(x + 18, k_middle + 4.5)};
  draw_path(figure, arrow_head, filled("ink"), true);
  draw_text(figure, {x, k_middle - 10}, "*M*⁻¹", marked(15, draw::Anchor::middle, "ink"));
}

struct Results {
  double x; // of the middle
  double peak;
  const char* density;
  const char* integral;
  const char* method;
};

Status draw_results(draw::Figure& figure, const PolygonSpace& space, const Results& r) {
  constexpr double k_bar = 200;
  const double y = k_middle + k_radius + 26;
  const draw::Axis densities{
      "",
      0,
      r.peak,
      false,
      {{0, "0"}, {0.5 * r.peak, number_text(0.5 * r.peak)}, {r.peak, number_text(r.peak)}}};
  if (Status status = draw_color_bar(figure, {r.x - 0.5 * k_bar, y}, {k_bar, 9},
                                     image::Colormap::viridis, densities);
      !status)
    return status;
  draw_text(figure, {r.x + 0.5 * k_bar + 14, y + 9}, r.density,
            marked(11, draw::Anchor::start, "soft"));
  draw_text(figure, {r.x, y + 56}, fmt::format("{} = {:.7f}", r.integral, space.integral),
            marked(17, draw::Anchor::middle, "ink"));
  const draw::Type note = marked(12, draw::Anchor::middle, "soft");
  draw_text(figure, {r.x, y + 77}, r.method, note);
  const double count = double(space.samples.size());
  const double deviation = std::sqrt(space.integral * (1 - space.integral) / count);
  draw_text(figure, {r.x, y + 96},
            fmt::format("{} of {} samples inside: {:.3f} ± {:.3f}", space.inside_count,
                        space.samples.size(), space.inside_count / count, deviation),
            note);
  return Success{};
}

void draw_key(draw::Figure& figure, double y) {
  const auto explain = [&](double x, const char* text) {
    draw_text(figure, {x + 31, y}, text, marked(11, draw::Anchor::start, "soft"));
  };
  const auto line = [&](double x, const draw::Pen& pen) {
    draw_line(figure, {x, y - 4}, {x + 24, y - 4}, pen);
  };
  line(12, {"ink", 1.3});
  explain(12, "surface's horizon");
  line(164, {"ink", 1.3, "8 3 1.5 3"});
  explain(164, "cosine's horizon");
  line(312, {"#000000", 3.8, "", 0.6});
  line(312, {"#ffffff", 2.3});
  explain(312, "*P*, clipped to both");
  draw::Pen cut_off{"ink", 1.2, "5 3"};
  cut_off.fill = k_hatch;
  draw_rectangle(figure, {482, y - 10}, {24, 12}, cut_off);
  explain(482, "what is cut off");
  draw_sample_sign(figure, {640, y - 4}, true);
  explain(620, "sample inside");
  draw_sample_sign(figure, {774, y - 4}, false);
  explain(754, "sample outside");
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

Result<draw::Figure> make_polygon_figure(const PolygonOptions& options) {
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

  draw::Figure figure;
  figure.title = "The integral over P under the lobe is that over M⁻¹P under the cosine";
  figure.caption = "Spheres of directions from outside. Samples of the lobe are carried "
                   "along by M⁻¹, "
                   "those behind the sphere are counted but not drawn.\n" +
                   options.command;
  figure.width = k_width;
  figure.height = k_height;
  define_hatch(figure);
  draw_heads(figure, options.lobe_name);
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
       {draw_polygon_panel(figure, view, {k_left_center, k_middle}, k_radius, shading),
        draw_polygon_panel(figure, view, {k_right_center, k_middle}, k_radius, cosine),
        draw_results(figure, spaces->shading, left), draw_results(figure, spaces->cosine, right)})
    if (!status) return status.error();
  draw_key(figure, k_middle + k_radius + 164);
  return figure;
}

} // namespace openltc::plot
