// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/figures/trade_figure.h"

#include "openltc/draw/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace openltc::plot {

namespace {

using render::k_trade_forms;
using render::TradeValues;

constexpr std::size_t k_forms = k_trade_forms.size();
constexpr double k_width = 620, k_height = 380, k_left = 64, k_head = 118, k_foot = 44;
constexpr double k_least_error = 1e-5; // of the light; what is less lies on the lower edge

double time_of(const Trade& trade, std::size_t form) {
  return trade.nanoseconds[form] / trade.nanoseconds[0];
}

std::vector<std::size_t> forms_by_time(const Trade& trade) {
  std::vector<std::size_t> order(k_forms);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return trade.nanoseconds[a] < trade.nanoseconds[b];
  });
  return order;
}

std::vector<Vec2d> places_of(const Trade& trade, const draw::Panel& panel,
                             const TradeValues& errors) {
  std::vector<Vec2d> places;
  for (const std::size_t form : forms_by_time(trade))
    places.push_back(
        place_in(panel, time_of(trade, form), std::max(100 * errors[form], panel.y.from)));
  return places;
}

draw::Panel panel_of(const Trade& trade) {
  double slowest = 1, largest = k_least_error, smallest = 1;
  for (std::size_t form = 0; form < k_forms; ++form)
    slowest = std::max(slowest, time_of(trade, form));
  for (const TradeScene& scene : trade.scenes)
    for (const double error : scene.errors.of_light) {
      largest = std::max(largest, error);
      smallest = std::min(smallest, std::max(error, k_least_error));
    }
  draw::Panel panel;
  panel.corner = Vec2d(k_left, k_head);
  panel.size = Vec2d(k_width, k_height);
  panel.x = {"time of a quad, one lobe = 1", 0.8, 1.15 * slowest, true, {}};
  for (double tick = 1; tick <= panel.x.to; tick *= 2)
    panel.x.ticks.push_back({tick, fmt::format("{:g}", tick)});
  panel.y = {"error, % of the light",
             100 * k_least_error,
             std::pow(10.0, std::ceil(std::log10(100 * largest))),
             true,
             {}};
  return panel;
}

/// The names of the forms above their columns, far enough from each other to be read.
void draw_names(draw::Figure& figure, const Trade& trade, const draw::Panel& panel) {
  double last = -1e9;
  for (const std::size_t form : forms_by_time(trade)) {
    const double x = place_in(panel, time_of(trade, form), panel.y.from).x;
    const double at = std::max(x, last + 16);
    last = at;
    draw_line(figure, Vec2d(x, k_head + k_height), Vec2d(x, k_head), {.color = "rule"});
    draw_line(figure, Vec2d(x, k_head), Vec2d(at, k_head - 10), {.color = "soft"});
    draw_text(figure, Vec2d(at + 4, k_head - 14), k_trade_forms[form].name,
              {11.5, draw::Anchor::start, "ink", false, false, -90});
  }
}

std::string percent(double share) {
  return fmt::format("{:.{}f} %", 100 * share, share < 0.001 ? 3 : 2);
}

} // namespace

TradeValues mean_errors(const Trade& trade) {
  TradeValues mean{};
  for (const TradeScene& scene : trade.scenes)
    for (std::size_t form = 0; form < k_forms; ++form)
      mean[form] += scene.errors.of_light[form] / double(trade.scenes.size());
  return mean;
}

draw::Figure make_trade_figure(const Trade& trade) {
  draw::Figure figure;
  figure.title = "Forms of the closed form: error over time";
  figure.width = k_left + k_width + 12;
  figure.height = k_head + k_height + k_foot;
  const draw::Panel panel = panel_of(trade);
  draw_axes(figure, panel);
  draw_names(figure, trade, panel);
  for (const TradeScene& scene : trade.scenes) {
    const std::vector<Vec2d> places = places_of(trade, panel, scene.errors.of_light);
    draw_path(figure, places, {.color = "series0", .width = 1, .opacity = 0.45});
    draw_dots(figure, places, {.color = "series0", .width = 4, .opacity = 0.7});
  }
  const std::vector<Vec2d> mean = places_of(trade, panel, mean_errors(trade));
  draw_path(figure, mean, {.color = "series1", .width = 2.5});
  draw_dots(figure, mean, {.color = "series1", .width = 8});
  figure.caption = fmt::format(
      "Blue: a scene each, {} in all; orange: their mean. Error: the sum of |picture − reference| "
      "over the reference's, no shadows, {} samples per pixel. Time: one more quad at a point, "
      "kernel {}, one core; one lobe takes {:.1f} ns.",
      trade.scenes.size(), trade.samples, trade.kernel, trade.nanoseconds[0]);
  if (!trade.command.empty()) figure.caption += "\n" + trade.command;
  return figure;
}

std::string trade_table(const Trade& trade) {
  std::string table = "| |";
  for (const render::TradeForm& form : k_trade_forms)
    table += fmt::format(" {} |", form.name);
  table += " noise |\n|---|";
  for (std::size_t i = 0; i <= k_forms; ++i)
    table += "---|";
  table += "\n| time of a quad |";
  for (std::size_t form = 0; form < k_forms; ++form)
    table += fmt::format(" {:.2f} ({:.1f} ns) |", time_of(trade, form), trade.nanoseconds[form]);
  table += " |\n";
  TradeValues worst{};
  for (const TradeScene& scene : trade.scenes) {
    table += fmt::format("| {} |", scene.name);
    for (std::size_t form = 0; form < k_forms; ++form) {
      table += fmt::format(" {} |", percent(scene.errors.of_light[form]));
      worst[form] = std::max(worst[form], scene.errors.of_light[form]);
    }
    table += fmt::format(" {} |\n", percent(scene.errors.noise));
  }
  for (const auto& [what, values] : {std::pair{"mean", mean_errors(trade)}, {"worst", worst}}) {
    table += fmt::format("| {} |", what);
    for (const double value : values)
      table += fmt::format(" {} |", percent(value));
    table += " |\n";
  }
  return table;
}

} // namespace openltc::plot
