// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/keyframes.h"

#include <algorithm>
#include <cmath>

namespace openltc::scene {

namespace {

double product_of(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

void bring_to_unit_length(std::vector<double>& q) {
  const double l = std::sqrt(product_of(q, q));
  if (!(l > 0) || !std::isfinite(l)) return;
  for (double& c : q)
    c /= l;
}

// C.4; where the rotations are almost the same, the line between them is as good as the arc.
std::vector<double> slerp(std::vector<double> a, std::vector<double> b, double t) {
  bring_to_unit_length(a);
  bring_to_unit_length(b);
  const double cosine = product_of(a, b);
  const double sign = cosine < 0 ? -1 : 1;
  const double angle = std::acos(std::min(std::abs(cosine), 1.0));
  const bool is_flat = !(std::sin(angle) > 1e-6);
  const double weight_a = is_flat ? 1 - t : std::sin(angle * (1 - t)) / std::sin(angle);
  const double weight_b = sign * (is_flat ? t : std::sin(angle * t) / std::sin(angle));
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] = a[i] * weight_a + b[i] * weight_b;
  bring_to_unit_length(a);
  return a;
}

} // namespace

KeySpan find_span(std::span<const double> times, double seconds, Interpolation interpolation) {
  KeySpan span;
  if (!(seconds > times.front())) return span;
  const auto after = std::upper_bound(times.begin(), times.end(), seconds);
  span.first = std::size_t(after - times.begin()) - 1;
  if (after == times.end() || interpolation == Interpolation::step || times[span.first] == seconds)
    return span;
  span.at_key = false;
  span.seconds = *after - times[span.first];
  span.fraction = (seconds - times[span.first]) / span.seconds;
  return span;
}

std::vector<double> value_at(const KeySpan& at, std::span<const double> from,
                             std::span<const double> to, std::size_t size,
                             Interpolation interpolation, bool is_rotation) {
  const bool is_cubic = interpolation == Interpolation::cubic_spline;
  const auto value = from.subspan(is_cubic ? size : 0, size);
  std::vector<double> result(value.begin(), value.end());
  if (at.at_key) {
    if (is_rotation) bring_to_unit_length(result);
    return result;
  }
  const double t = at.fraction;
  if (is_cubic) {
    const auto out_tangent = from.subspan(2 * size, size);
    const auto in_tangent = to.first(size), end = to.subspan(size, size);
    const double t2 = t * t, t3 = t2 * t;
    for (std::size_t i = 0; i < size; ++i)
      result[i] = (2 * t3 - 3 * t2 + 1) * value[i] +
                  at.seconds * (t3 - 2 * t2 + t) * out_tangent[i] + (-2 * t3 + 3 * t2) * end[i] +
                  at.seconds * (t3 - t2) * in_tangent[i];
    if (is_rotation) bring_to_unit_length(result);
    return result;
  }
  if (is_rotation) return slerp(std::move(result), std::vector<double>(to.begin(), to.end()), t);
  for (std::size_t i = 0; i < size; ++i)
    result[i] += (to[i] - result[i]) * t;
  return result;
}

} // namespace openltc::scene
