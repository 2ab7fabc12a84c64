// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/lobe_rows.h"

#include "openltc/fit/table_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace openltc::plot {

namespace {

constexpr std::string_view k_names = "abcd";

double& entry(LobeMatrix& m, char name) {
  switch (name) {
  case 'a':
    return m.a;
  case 'b':
    return m.b;
  case 'c':
    return m.c;
  default:
    return m.d;
  }
}

// The numbers between separators; none where one of them is no number.
std::vector<double> numbers_in(std::string_view text, char separator) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    double value = 0;
    const auto [read, error] = std::from_chars(text.data() + at, text.data() + end, value);
    if (error != std::errc() || read != text.data() + end) return {};
    numbers.push_back(value);
    at = end + 1;
  }
  return numbers;
}

double two_digits(double x) { return std::round(x * 100) / 100 + 0.0; }

// Values like 0.1 + 0.2 without their rounding.
double rounded(double x) { return std::round(x * 1e9) / 1e9 + 0.0; }

LobeRow diagonal_row(const char* title, const char* note, std::span<const Vec2d> scales) {
  LobeRow row{title, note, {}};
  for (const Vec2d s : scales)
    row.cells.push_back({{s.x, 0, s.y, 0},
                         s.x == s.y ? fmt::format("a = c = {:.4g}", s.x)
                                    : fmt::format("a = {:.4g}, c = {:.4g}", s.x, s.y),
                         ""});
  return row;
}

struct LobeTables {
  const brdf::Brdf& brdf;
  table::LobeTable fitted;
  bool is_builtin;

  Result<f64::Lobe> at(double theta_degrees, double roughness) const {
    const table::LobeTable& table = is_builtin ? table::builtin_ggx_table() : fitted;
    const double cos_theta = std::max(std::cos(theta_degrees * f64::k_pi / 180), 0.0);
    const f64::Lobe lobe = fit::lobes_of(table)(roughness, cos_theta).lobe;
    const std::string name = fmt::format("--brdf {} --theta {:.4g} --roughness {:.4g}", brdf.name,
                                         theta_degrees, roughness);
    const Result<LobeMatrix> matrix = matrix_of_lobe(lobe);
    if (!matrix) return Error{name + ": " + matrix.error().message};
    if (!check_matrix(*matrix, name))
      return Error{name + ": the lobe is too narrow for a picture; take a larger roughness"};
    return lobe;
  }
};

Result<LobeTables> lobe_tables(const brdf::Brdf& brdf) {
  if (brdf.name == table::builtin_ggx_table().metadata.brdf) return LobeTables{brdf, {}, true};
  Result<table::LobeTable> fitted = fit::fit_table(brdf, {});
  if (!fitted) return fitted.error();
  return LobeTables{brdf, std::move(*fitted), false};
}

} // namespace

LobeRow standard_row(StandardRow row) {
  switch (row) {
  case StandardRow::cosine:
    return {"cosine", "M is the identity", {{{}, "a = c = 1, b = d = 0", ""}}};
  case StandardRow::roughness: {
    constexpr double k_scales[] = {0.8, 0.5, 0.3, 0.15};
    std::vector<Vec2d> scales;
    for (const double s : k_scales)
      scales.push_back({s, s});
    return diagonal_row("roughness", "an isotropic scale, a = c; b = d = 0", scales);
  }
  case StandardRow::anisotropy: {
    const Vec2d scales[] = {{0.6, 0.4}, {0.6, 0.25}, {0.6, 0.15}, {0.6, 0.08}};
    return diagonal_row("anisotropy", "different scales along x and y, a and c; b = d = 0", scales);
  }
  case StandardRow::skew:
    break;
  }
  LobeRow skew{"skew", "M z leans by b; a = c = 0.5, d = 0", {}};
  for (const double b : {-0.3, -0.6, -1.0, -1.6})
    skew.cells.push_back({{0.5, b, 0.5, 0}, "b = " + number_text(b), ""});
  return skew;
}

std::string text_of(const LobeMatrix& m) { return fmt::format("{},{},{},{}", m.a, m.b, m.c, m.d); }

std::string number_text(double x) {
  std::string text = fmt::format("{:.4g}", std::abs(x));
  return x < 0 ? "−" + text : text;
}

std::string entries_text(const LobeMatrix& m) {
  return fmt::format("a = {}, b = {}, c = {}, d = {}", number_text(m.a), number_text(m.b),
                     number_text(m.c), number_text(m.d));
}

std::string view_text(const brdf::Brdf& brdf, double theta_degrees, double roughness) {
  const std::string theta = fmt::format("θ = {:.4g}°", theta_degrees);
  return brdf.has_parameter() ? fmt::format("{}, roughness {:.4g}", theta, roughness) : theta;
}

Result<LobeMatrix> parse_matrix(const std::string& text) {
  const std::vector<double> v = numbers_in(text, ',');
  if (v.size() != 4)
    return Error{fmt::format("--matrix {}: give four numbers, a,b,c,d of M = "
                             "[[a,0,b],[0,c,0],[d,0,1]], e.g. 0.5,-0.6,0.5,0",
                             text)};
  const LobeMatrix m{v[0], v[1], v[2], v[3]};
  if (Status status = check_matrix(m, "--matrix " + text); !status) return status.error();
  return m;
}

Result<LobeSweep> parse_sweep(const std::string& text) {
  LobeSweep sweep;
  const std::vector<double> v =
      text.size() > 2 ? numbers_in(std::string_view(text).substr(2), ':') : std::vector<double>{};
  const bool named =
      text.size() > 2 && text[1] == '=' && k_names.find(text[0]) != std::string_view::npos;
  if (!named || v.size() != 3 || !(std::abs(v[0]) <= 1e3) || !(std::abs(v[1]) <= 1e3) ||
      v[2] != std::floor(v[2]) || !(v[2] >= 2) || !(v[2] <= k_most_swept))
    return Error{fmt::format("--sweep {}: give NAME=FROM:TO:COUNT, NAME one of a b c d, COUNT 2 to "
                             "{}, e.g. c=0.6:0.1:4",
                             text, k_most_swept)};
  sweep.name = text[0];
  sweep.from = v[0];
  sweep.to = v[1];
  sweep.count = int(v[2]);
  return sweep;
}

Result<LobeRow> matrix_row(std::span<const LobeMatrix> matrices) {
  LobeRow row{"given matrices", "M = [[a,0,b],[0,c,0],[d,0,1]]", {}};
  for (const LobeMatrix& m : matrices) {
    if (Status status = check_matrix(m, "--matrix " + text_of(m)); !status) return status.error();
    row.cells.push_back({m, entries_text(m), ""});
  }
  return row;
}

Result<LobeRow> sweep_row(const LobeMatrix& base, const LobeSweep& sweep) {
  LobeRow row{
      fmt::format("{} from {} to {}", sweep.name, number_text(sweep.from), number_text(sweep.to)),
      "",
      {}};
  for (const char name : k_names) {
    LobeMatrix m = base;
    if (name != sweep.name)
      row.note +=
          fmt::format("{}{} = {}", row.note.empty() ? "" : ", ", name, number_text(entry(m, name)));
  }
  for (int i = 0; i < sweep.count; ++i) {
    LobeMatrix m = base;
    double& value = entry(m, sweep.name);
    value = rounded(sweep.from + (sweep.to - sweep.from) * i / (sweep.count - 1));
    const std::string caption = fmt::format("{} = {:.4g}", sweep.name, value);
    const std::string name = fmt::format("--sweep {}={:.6g}:{:.6g}:{} at {}", sweep.name,
                                         sweep.from, sweep.to, sweep.count, caption);
    if (Status status = check_matrix(m, name); !status) return status.error();
    row.cells.push_back({m, fmt::format("{} = {}", sweep.name, number_text(value)), ""});
  }
  return row;
}

Result<std::vector<LobeRow>> fitted_rows(const brdf::Brdf& brdf,
                                         std::span<const double> theta_degrees,
                                         std::span<const double> roughness) {
  const Result<LobeTables> tables = lobe_tables(brdf);
  if (!tables) return tables.error();
  std::vector<LobeRow> rows;
  for (const double r : roughness) {
    LobeRow row{brdf.name, "lobes as fitted; θ is the view's angle to the normal", {}};
    if (brdf.has_parameter()) row.title += fmt::format(", roughness {:.4g}", r);
    for (const double theta : theta_degrees) {
      const Result<f64::Lobe> lobe = tables->at(theta, r);
      if (!lobe) return lobe.error();
      const LobeMatrix m = *matrix_of_lobe(*lobe);
      row.cells.push_back(
          {m, fmt::format("θ = {:.4g}°", theta),
           entries_text({two_digits(m.a), two_digits(m.b), two_digits(m.c), two_digits(m.d)})});
    }
    rows.push_back(std::move(row));
    if (!brdf.has_parameter()) break;
  }
  return rows;
}

Result<f64::Lobe> fitted_lobe(const brdf::Brdf& brdf, double theta_degrees, double roughness) {
  const Result<LobeTables> tables = lobe_tables(brdf);
  if (!tables) return tables.error();
  return tables->at(theta_degrees, roughness);
}

} // namespace openltc::plot
