// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/measure/error.h"

#include "openltc/base/parallel.h"
#include "openltc/fit/lobe_fit.h"
#include "openltc/table/divided.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace openltc::fit {

namespace {

constexpr std::array k_fields = {
    LobeErrorField{"tv", &LobeError::tv},     LobeErrorField{"bound", &LobeError::bound},
    LobeErrorField{"l1", &LobeError::l1},     LobeErrorField{"l2", &LobeError::l2},
    LobeErrorField{"l3", &LobeError::l3},     LobeErrorField{"peak", &LobeError::peak},
    LobeErrorField{"leak", &LobeError::leak}, LobeErrorField{"n1", &LobeError::n1},
    LobeErrorField{"n5", &LobeError::n5}};

} // namespace

bool is_finite(const MeasuredLobe& f) {
  const f64::Lobe& s = f.second.lobe;
  return std::isfinite(f.lobe.m00) && std::isfinite(f.lobe.m02) && std::isfinite(f.lobe.m20) &&
         std::isfinite(f.lobe.m22) && std::isfinite(f.lobe.det) && std::isfinite(f.n1) &&
         std::isfinite(f.n5) && std::isfinite(f.second.weight) && std::isfinite(s.m00) &&
         std::isfinite(s.m02) && std::isfinite(s.m20) && std::isfinite(s.m22) &&
         std::isfinite(s.det);
}

std::span<const LobeErrorField> lobe_error_fields() { return k_fields; }

double horizon_scale(const f64::Lobe& lobe, Horizon horizon) {
  if (horizon == Horizon::leaking) return 1;
  return 1 / std::max(f64::share_above_horizon(lobe), f64::k_min_share);
}

namespace {

// lobe_density without derivatives, to the same bits.
double lobe_value(Vec4d abcd, double alpha, double x, double y, double z) {
  const double ox = abcd.x * x + alpha * abcd.y * z;
  const double oz = alpha * (abcd.z * x + abcd.w * z);
  if (!(oz > 0)) return 0;
  const double det = alpha * (abcd.x * abcd.w - alpha * abcd.y * abcd.z);
  const double inv_length2 = 1 / (ox * ox + y * y + oz * oz);
  return oz * det * (inv_length2 * inv_length2 * f64::k_inv_pi);
}

// Total variation as the energy that D lacks, the integral of max(rho/E - D, 0): as much as it has
// in excess elsewhere, since both integrate to 1, and bounded by rho/E, whose quadrature this is.
// (A clipped lobe of which less than k_min_share lies above the horizon integrates to less than 1
// even so; what it lacks is then more than its excess, and counts.)
// At grazing angles D may be narrow where rho/E is not, and |rho/E - D| would miss some of it.
LobeError measure_density(const Quadrature& q, const MeasuredLobe& fitted, Horizon horizon) {
  const f64::Lobe &lobe = fitted.lobe, &beside = fitted.second.lobe;
  const double w = fitted.second.weight;
  const bool two = fitted.two();
  const Vec4d mirror = f64::mirror_from_lobe(lobe, q.width, q.cos_theta);
  const Vec4d mirror_beside = f64::mirror_from_lobe(beside, q.width, q.cos_theta);
  const double scale = (1 - w) * horizon_scale(lobe, horizon);
  const double scale_beside = two ? w * horizon_scale(beside, horizon) : 0;
  LobeError e;
  if (!(lobe.det > 0) || (two && !(beside.det > 0 && w > 0 && w <= 1))) {
    e.tv = e.l2 = e.l3 = e.peak = 1;
    e.l1 = 2;
    return e;
  }
  double missing = 0, l2 = 0, l3 = 0, norm2 = 0, norm3 = 0, peak = 0, peak_of_brdf = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double x = q.x_mirror[i], y = q.y[i], z = q.z_mirror[i];
    double d = scale * lobe_value(mirror, q.width, x, y, z);
    if (two) d += scale_beside * lobe_value(mirror_beside, q.width, x, y, z);
    const double r = std::abs(d - q.density[i]);
    const double solid_angle = q.weight[i];
    missing += solid_angle * std::max(q.density[i] - d, 0.0);
    l2 += solid_angle * r * r;
    l3 += solid_angle * r * r * r;
    norm2 += solid_angle * q.density[i] * q.density[i];
    norm3 += solid_angle * q.density[i] * q.density[i] * q.density[i];
    peak = std::max(peak, d);
    peak_of_brdf = std::max(peak_of_brdf, q.density[i]);
  }
  const double leak = lobe_leak(mirror, q.width, q.cos_theta);
  const double leak_beside = two ? lobe_leak(mirror_beside, q.width, q.cos_theta) : 0;
  e.leak = two ? (1 - w) * leak + w * leak_beside : leak;
  e.tv = missing;
  // Over the hemisphere the scaled lobe integrates to 1 less this.
  const double kept = scale * (1 - leak) + scale_beside * (1 - leak_beside);
  const double lost = std::max(1 - kept, 0.0);
  e.l1 = std::max(2 * missing - lost, 0.0);
  e.l2 = std::sqrt(l2 / norm2);
  e.l3 = std::cbrt(l3 / norm3);
  e.peak = std::abs(peak / peak_of_brdf - 1);
  return e;
}

} // namespace

LobeError measure_lobe(const Quadrature& q, const f64::Lobe& lobe, Horizon horizon) {
  return measure_density(q, f64::FittedLobe{lobe, 1, 0}, horizon);
}

// The light is n1 D where E (rho/E) is right. For directions P with the integrals d of D and p of
// rho/E over them, n1 d - E p = E (d - p) + (n1 - E) d, of which |d - p| <= TV and 0 <= d <= 1.
// A light of radiance 0..1 is a mixture of such sets.
LobeError measure_lobe(const Quadrature& q, const MeasuredLobe& fitted, Horizon horizon) {
  LobeError e = measure_density(q, fitted, horizon);
  e.n1 = std::abs(fitted.n1 - q.n1);
  e.n5 = std::abs(fitted.n5 - q.n5);
  e.bound = q.n1 * e.tv + e.n1;
  return e;
}

double mean_second_difference(const table::LobeTable& table) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < table.rows; ++y) {
    for (int x = 0; x < table.columns; ++x) {
      for (int k = 0; k < 4; ++k) {
        const double here = double(table.texel(x, y)[k]);
        if (x > 0 && x + 1 < table.columns) {
          sum += std::abs(double(table.texel(x - 1, y)[k]) - 2 * here +
                          double(table.texel(x + 1, y)[k]));
          ++count;
        }
        if (y > 0 && y + 1 < table.rows) {
          sum += std::abs(double(table.texel(x, y - 1)[k]) - 2 * here +
                          double(table.texel(x, y + 1)[k]));
          ++count;
        }
      }
    }
  }
  return count > 0 ? sum / count : 0;
}

double mean_second_difference(const LobeFunction& lobes, int points) {
  const auto n = std::size_t(std::max(points, 3));
  std::vector<std::array<double, 4>> entries(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const double x = double(i) / double(n - 1), y = double(j) / double(n - 1);
      const f64::Lobe lobe = lobes(x, 1 - y * y).lobe;
      entries[j * n + i] = {lobe.m00, lobe.m02, lobe.m20, lobe.m22};
    }
  }
  double sum = 0;
  std::size_t count = 0;
  const auto add = [&](std::size_t before, std::size_t at, std::size_t after) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double d = std::abs(entries[before][k] - 2 * entries[at][k] + entries[after][k]);
      if (!std::isfinite(d)) continue; // measure_maps reports such a lobe
      sum += d;
      ++count;
    }
  };
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t at = j * n + i;
      if (i > 0 && i + 1 < n) add(at - 1, at, at + 1);
      if (j > 0 && j + 1 < n) add(at - n, at, at + n);
    }
  }
  return count > 0 ? sum / double(count) : 0;
}

LobeFunction lobes_of(const table::LobeTable& table) {
  return [&table](double roughness, double cos_theta) {
    return MeasuredLobe(table::fetch_native(table, roughness, cos_theta),
                        table::fetch_native_second(table, roughness, cos_theta));
  };
}

LobeFunction lobes_of(const table::PackedTable& packed) {
  return [&packed](double roughness, double cos_theta) {
    return MeasuredLobe(table::fetch_packed(packed, roughness, cos_theta),
                        table::fetch_packed_second(packed, roughness, cos_theta));
  };
}

MeasuredLobe fetch_measured(const table::PackedTable& packed, double roughness, double cos_theta) {
  return {table::fetch_albedo(packed, roughness, cos_theta),
          table::fetch_packed_second(packed, roughness, cos_theta)};
}

Horizon horizon_of(const table::PackedTable& packed) {
  const std::string& said = packed.metadata.horizon;
  if (said == name_of(Horizon::clipped) || said == table::k_divided) return Horizon::clipped;
  if (said == name_of(Horizon::leaking)) return Horizon::leaking;
  return table::is_native(packed.layout) ? Horizon::clipped : Horizon::leaking;
}

double theta_at(double t, double theta_to_degrees, table::AngleAxis axis) {
  if (axis == table::AngleAxis::theta) return t * theta_to_degrees;
  const double span = 1 - std::cos(theta_to_degrees * f64::k_pi / 180);
  return std::acos(1 - t * t * span) * 180 / f64::k_pi;
}

MeasureAxes midpoint_axes(const MeasureOptions& options) {
  MeasureAxes axes;
  const int n = options.points;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) / n;
    axes.roughness.push_back(options.roughness_from +
                             (options.roughness_to - options.roughness_from) * t);
    axes.theta_degrees.push_back(theta_at(t, options.theta_to_degrees, options.angle_axis));
  }
  return axes;
}

MeasureAxes node_axes(const table::LobeTable& table, const MeasureOptions& region) {
  MeasureAxes axes;
  for (int i = 0; i < table.columns; ++i) {
    // A table of one column holds for every roughness.
    const double roughness =
        table.columns > 1 ? double(i) / (table.columns - 1) : region.roughness_to;
    if (roughness >= region.roughness_from && roughness <= region.roughness_to)
      axes.roughness.push_back(roughness);
  }
  for (int j = 0; j < table.rows; ++j) {
    const double y = table.rows > 1 ? double(j) / (table.rows - 1) : 0;
    const double theta = table.angle_axis == table::AngleAxis::theta
                             ? 90 * y
                             : std::acos(1 - y * y) * 180 / f64::k_pi;
    if (theta <= region.theta_to_degrees) axes.theta_degrees.push_back(theta);
  }
  return axes;
}

Result<std::vector<ErrorMap>> measure_maps(const brdf::Brdf& brdf,
                                           std::span<const MeasuredLobes> candidates,
                                           const MeasureAxes& axes, QuadratureSize quadrature) {
  const std::size_t columns = axes.roughness.size(), count = columns * axes.theta_degrees.size();
  if (count == 0)
    return Error{"no point to measure lobes at: choose a region that holds at least one"};
  std::vector<ErrorMap> maps(candidates.size());
  for (ErrorMap& map : maps) {
    map.axes = axes;
    map.cells.resize(count);
    map.albedo.resize(count);
  }
  std::vector<HalfVectors> half_vectors;
  for (const double roughness : axes.roughness)
    half_vectors.push_back(find_half_vectors(brdf, roughness));
  std::vector<std::string> failures(count);
  parallel_for(std::int64_t(count), 0, [&](std::int64_t index) {
    const std::size_t k = std::size_t(index);
    const double roughness = axes.roughness[k % columns];
    const double theta_degrees = axes.theta_degrees[k / columns];
    const double cos_theta = std::cos(theta_degrees * f64::k_pi / 180);
    const Result<Quadrature> rule =
        make_quadrature(brdf, roughness, cos_theta, half_vectors[k % columns], quadrature);
    if (!rule) {
      failures[k] = rule.error().message;
      return;
    }
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const MeasuredLobe fitted = candidates[c].lobes(roughness, cos_theta);
      if (!is_finite(fitted)) {
        failures[k] = fmt::format("{}: the lobe at roughness {:.6g}, theta {:.6g} degrees is not "
                                  "finite; the table is broken or read in a wrong layout",
                                  candidates[c].label, roughness, theta_degrees);
        return;
      }
      maps[c].cells[k] = measure_lobe(*rule, fitted, candidates[c].horizon);
      maps[c].albedo[k] = rule->n1;
    }
  });
  for (const std::string& failure : failures)
    if (!failure.empty()) return Error{failure};
  return maps;
}

TableError summarise(const ErrorMap& map) {
  TableError result;
  if (map.cells.empty()) return result;
  result.roughness_from = map.axes.roughness.front();
  result.roughness_to = map.axes.roughness.back();
  result.theta_to_degrees = map.axes.theta_degrees.back();
  result.points = int(map.columns());
  for (const LobeErrorField& field : k_fields) {
    std::vector<double> values;
    double sum = 0; // in a fixed order
    for (const LobeError& e : map.cells) {
      values.push_back(e.*field.member);
      sum += e.*field.member;
    }
    std::sort(values.begin(), values.end());
    const auto quantile = [&](double share) {
      return values[std::size_t(share * double(values.size() - 1))];
    };
    result.mean.*field.member = sum / double(values.size());
    result.median.*field.member = quantile(0.5);
    result.p95.*field.member = quantile(0.95);
    result.max.*field.member = values.back();
  }
  return result;
}

Result<TableError> measure_lobes(const brdf::Brdf& brdf, const LobeFunction& lobes,
                                 const MeasureOptions& options) {
  const MeasuredLobes one{brdf.name, lobes, options.horizon};
  const Result<std::vector<ErrorMap>> maps =
      measure_maps(brdf, {&one, 1}, midpoint_axes(options), options.quadrature);
  if (!maps) return maps.error();
  TableError result = summarise(maps->front());
  result.roughness_from = options.roughness_from;
  result.roughness_to = options.roughness_to;
  result.theta_to_degrees = options.theta_to_degrees;
  return result;
}

} // namespace openltc::fit
