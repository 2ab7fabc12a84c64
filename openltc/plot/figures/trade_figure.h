// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Error over time of the ways to shade by an area light.

#pragma once

#include "openltc/draw/figure.h"
#include "openltc/render/form_trade.h"

#include <string>
#include <vector>

namespace openltc::plot {

struct TradeScene {
  std::string name;
  render::TradeErrors errors;
};

struct Trade {
  render::TradeValues nanoseconds{}; ///< of a quad, see render::time_of_quad
  std::string kernel;                ///< that was timed: "avx2"
  std::vector<TradeScene> scenes;    ///< at least one
  int samples = 0;                   ///< of the reference per pixel
  std::string command;               ///< stands in the caption
};

/// The mean over the scenes of the error of the light, for each form.
render::TradeValues mean_errors(const Trade& trade);

/// A thin line for each scene, a thick one for the mean, from form to form by their times.
draw::Figure make_trade_figure(const Trade& trade);

/// The numbers as a table in Markdown: a row of times, one for each scene, mean and worst.
std::string trade_table(const Trade& trade);

} // namespace openltc::plot
