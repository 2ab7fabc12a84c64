// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/measure/limit.h"

#include "openltc/fit/lobe_start.h"

#include <utility>

namespace openltc::fit {

LobeFunction best_single_lobes(const brdf::Brdf& brdf, LobeFunction start,
                               const Objective& objective) {
  LobeFitOptions options;
  options.objective = objective;
  return [&brdf, start = std::move(start), options](double roughness, double cos_theta) {
    f64::FittedLobe lobe = start(roughness, cos_theta);
    const Result<Quadrature> rule = make_quadrature(brdf, roughness, cos_theta, {20, 32});
    if (!rule) return lobe;
    Vec4d from = f64::mirror_from_lobe(lobe.lobe, rule->width, cos_theta);
    const LobeFit fit = fit_from_neighbour(*rule, from, options);
    lobe.lobe = f64::lobe_from_mirror(fit.mirror, rule->width, cos_theta);
    lobe.n1 = rule->n1;
    lobe.n5 = rule->n5;
    return lobe;
  };
}

} // namespace openltc::fit
