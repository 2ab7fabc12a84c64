// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source: Lane, Riesenfeld 1981, "Bounds on a Polynomial", BIT 21: on a box, a polynomial lies
// between the smallest and the largest of its Bernstein coefficients, the four at the corners are
// its values there, and de Casteljau's halving makes the bounds converge quadratically.
//
// The determinant over the width, A D - w B C, w = alpha = x^2 or 1, is itself a polynomial of
// x = roughness and y = sqrt(1 - cos theta): Chebyshev's basis is written out in powers of x and y,
// multiplied, brought to Bernstein's form on [0.01, 1] x [0, 1] and halved where it is not yet
// decided. Boxes with the least bound come first.

#include "openltc/fit/measure/certificate.h"

#include "openltc/target/shade_f64.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace openltc::fit {

namespace {

// Coefficients c[i][j] of x^i y^j or of Bernstein's basis, (n + 1)^2 of them.
struct Bivariate {
  int n = 0;
  std::vector<double> c;

  explicit Bivariate(int degree)
      : n(degree), c(std::size_t(degree + 1) * std::size_t(degree + 1)) {}
  double& at(int i, int j) { return c[std::size_t(i) * std::size_t(n + 1) + std::size_t(j)]; }
  double at(int i, int j) const { return c[std::size_t(i) * std::size_t(n + 1) + std::size_t(j)]; }
};

// Powers of x of T_k(2x - 1), k = 0..degree.
std::vector<std::vector<double>> shifted_chebyshev(int degree) {
  std::vector<std::vector<double>> t = {{1}, {-1, 2}};
  for (int k = 2; k <= degree; ++k) {
    std::vector<double> next(std::size_t(k) + 1);
    for (std::size_t i = 0; i < t[std::size_t(k) - 1].size(); ++i) {
      next[i] -= 2 * t[std::size_t(k) - 1][i];
      next[i + 1] += 4 * t[std::size_t(k) - 1][i];
    }
    for (std::size_t i = 0; i < t[std::size_t(k) - 2].size(); ++i)
      next[i] -= t[std::size_t(k) - 2][i];
    t.push_back(next);
  }
  return t;
}

// Channels 0 to 3 are A B C D of the first lobe, 4 to 7 those of the second.
Bivariate powers_of_channel(const table::LobePolynomial& p, int channel) {
  const auto t = shifted_chebyshev(p.degree);
  Bivariate result(p.degree);
  int term = 0;
  for (int j = 0; j <= p.degree; ++j)
    for (int i = 0; i <= p.degree - j; ++i, ++term)
      for (int a = 0; a <= i; ++a)
        for (int b = 0; b <= j; ++b)
          result.at(a, b) +=
              double(channel < 4 ? p.term(term)[channel] : p.second_term(term)[channel - 4]) *
              t[std::size_t(i)][std::size_t(a)] * t[std::size_t(j)][std::size_t(b)];
  return result;
}

void add_product(Bivariate& sum, const Bivariate& a, const Bivariate& b, double factor,
                 int x_power) {
  for (int i = 0; i <= a.n; ++i)
    for (int j = 0; j <= a.n; ++j)
      for (int k = 0; k <= b.n; ++k)
        for (int l = 0; l <= b.n; ++l)
          if (const double v = factor * a.at(i, j) * b.at(k, l); v != 0)
            sum.at(i + k + x_power, j + l) += v;
}

double sum_of_sizes(const Bivariate& p) {
  double sum = 0;
  for (const double c : p.c)
    sum += std::abs(c);
  return sum;
}

double binomial(int n, int k) {
  double result = 1;
  for (int i = 1; i <= k; ++i)
    result *= double(n - k + i) / i;
  return result;
}

// b_ij = sum over k <= i, l <= j of c_kl C(i,k)/C(n,k) C(j,l)/C(n,l)
Bivariate to_bernstein(const Bivariate& power) {
  const int n = power.n;
  Bivariate result(n);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= i; ++k)
        for (int l = 0; l <= j; ++l)
          result.at(i, j) +=
              power.at(k, l) * binomial(i, k) / binomial(n, k) * binomial(j, l) / binomial(n, l);
  return result;
}

// The two parts of a Bernstein form cut at `where` along x or y.
std::pair<Bivariate, Bivariate> cut(const Bivariate& whole, bool along_x, double where) {
  const int n = whole.n;
  Bivariate low(n), high(n);
  std::vector<double> row(std::size_t(n) + 1);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i)
      row[std::size_t(i)] = along_x ? whole.at(i, j) : whole.at(j, i);
    for (int level = 0; level <= n; ++level) {
      (along_x ? low.at(level, j) : low.at(j, level)) = row[0];
      (along_x ? high.at(n - level, j) : high.at(j, n - level)) = row[std::size_t(n - level)];
      for (int i = 0; i < n - level; ++i)
        row[std::size_t(i)] = (1 - where) * row[std::size_t(i)] + where * row[std::size_t(i) + 1];
    }
  }
  return {std::move(low), std::move(high)};
}

struct Box {
  Bivariate form;
  double bound;
  bool cut_x_next;

  Box(Bivariate f, bool x)
      : form(std::move(f)), bound(*std::min_element(form.c.begin(), form.c.end())), cut_x_next(x) {}
  double corner() const {
    const int n = form.n;
    return std::min(std::min(form.at(0, 0), form.at(n, 0)), std::min(form.at(0, n), form.at(n, n)));
  }
  bool operator<(const Box& other) const { return bound > other.bound; } // least first
};

// The determinant in a part of a cell: Bernstein's coefficients, degree 4 along x, 2 along y.
struct CellForm {
  double c[5][3];

  double least() const {
    double least = c[0][0];
    for (const auto& column : c)
      for (const double value : column)
        least = std::min(least, value);
    return least;
  }
  double corner() const { return std::min(std::min(c[0][0], c[4][0]), std::min(c[0][2], c[4][2])); }
};

// Products of Bernstein forms: the coefficients times binomials multiply as those of powers do.
CellForm cell_form(const float* const corners[4], int columns_apart, const double width[3]) {
  // Of a bilinear function the values at the corners are its coefficients, degree 1 along both
  // axes.
  const auto corner = [&](int channel, int i, int j) {
    return double(corners[2 * j + (columns_apart ? i : 0)][channel]);
  };
  // Degree 2 along both axes of the products, with binomials.
  double ad[3][3] = {}, bc[3][3] = {};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l) {
          ad[i + k][j + l] += corner(0, i, j) * corner(3, k, l);
          bc[i + k][j + l] += corner(1, i, j) * corner(2, k, l);
        }
  constexpr double two[3] = {1, 2, 1}, four[5] = {1, 4, 6, 4, 1};
  CellForm form = {};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        form.c[i + k][j] += two[k] * (ad[i][j] - width[k] * bc[i][j]) / (four[i + k] * two[j]);
  return form;
}

std::pair<CellForm, CellForm> halves(const CellForm& whole, bool along_x) {
  CellForm low = whole, high = whole;
  if (along_x) {
    for (int j = 0; j < 3; ++j)
      for (int level = 1; level < 5; ++level)
        for (int i = 4; i >= level; --i)
          low.c[i][j] = 0.5 * (low.c[i - 1][j] + low.c[i][j]);
    for (int j = 0; j < 3; ++j)
      for (int level = 1; level < 5; ++level)
        for (int i = 0; i <= 4 - level; ++i)
          high.c[i][j] = 0.5 * (high.c[i][j] + high.c[i + 1][j]);
  } else {
    for (int i = 0; i < 5; ++i) {
      for (int level = 1; level < 3; ++level)
        for (int j = 2; j >= level; --j)
          low.c[i][j] = 0.5 * (low.c[i][j - 1] + low.c[i][j]);
      for (int level = 1; level < 3; ++level)
        for (int j = 0; j <= 2 - level; ++j)
          high.c[i][j] = 0.5 * (high.c[i][j] + high.c[i][j + 1]);
    }
  }
  return {low, high};
}

// A bound that is positive if one can be had by that many halvings.
double bound_of(const CellForm& form, int halvings) {
  const double least = form.least();
  if (least > 0 || halvings == 0 || !(form.corner() > 0)) return least;
  const auto [low, high] = halves(form, halvings % 2 == 0);
  return std::min(bound_of(low, halvings - 1), bound_of(high, halvings - 1));
}

// Of the lobe whose A is that channel.
Certificate certify_lobe(const table::LobePolynomial& p, int first, int max_boxes) {
  const bool wide = p.width == brdf::LobeWidth::one;
  Bivariate determinant(2 * p.degree + 2);
  const Bivariate a = powers_of_channel(p, first), b = powers_of_channel(p, first + 1);
  const Bivariate c = powers_of_channel(p, first + 2), d = powers_of_channel(p, first + 3);
  add_product(determinant, a, d, 1, 0);
  add_product(determinant, b, c, -1, wide ? 0 : 2);
  const double size_of_products =
      sum_of_sizes(a) * sum_of_sizes(d) + sum_of_sizes(b) * sum_of_sizes(c);

  const double least_roughness = f64::roughness_from_alpha(f64::k_min_alpha);
  std::priority_queue<Box> open;
  open.emplace(cut(to_bernstein(determinant), true, least_roughness).second, true);
  Certificate result;
  result.smallest_seen = open.top().corner();
  for (result.boxes = 1; result.boxes < max_boxes; result.boxes += 2) {
    const Box& worst = open.top();
    // A value that is not positive decides; so does a bound close to the smallest value.
    if (!(result.smallest_seen > 0) || worst.bound > 0.9 * result.smallest_seen) break;
    auto [low, high] = cut(worst.form, worst.cut_x_next, 0.5);
    const bool next = !worst.cut_x_next;
    open.pop();
    for (Bivariate* part : {&low, &high}) {
      Box box(std::move(*part), next);
      result.smallest_seen = std::min(result.smallest_seen, box.corner());
      open.push(std::move(box));
    }
  }
  // What rounding may have cost: every coefficient above is a sum of at most some hundred products,
  // each of them within the sum of the products' sizes, and every halving rounds some fifty times.
  result.lower_bound =
      open.top().bound - 2000 * std::numeric_limits<double>::epsilon() * size_of_products;
  return result;
}

} // namespace

TableCertificate certify_determinants(const table::LobeTable& t, int max_halvings) {
  TableCertificate result;
  result.lower_bound = std::numeric_limits<double>::infinity();
  const bool wide = t.width == brdf::LobeWidth::one;
  const int cells = std::max(t.columns - 1, 1);
  for (int lobe = 0; lobe < (t.two_lobes() ? 2 : 1); ++lobe)
    for (int row = 0; row + 1 < t.rows; ++row)
      for (int column = 0; column < cells; ++column) {
        const int next = t.columns > 1 ? column + 1 : column;
        const float* corners[4];
        double most[4] = {0, 0, 0, 0};
        for (int k = 0; k < 4; ++k) {
          const int x = k % 2 ? next : column, y = row + k / 2;
          corners[k] = lobe == 0 ? t.texel(x, y) : t.second_texel(x, y);
          for (int channel = 0; channel < 4; ++channel)
            most[channel] = std::max(most[channel], std::abs(double(corners[k][channel])));
        }
        // w = x^2 along the cell, a quadratic of these coefficients.
        const double x0 = t.columns > 1 ? double(column) / cells : 1;
        const double x1 = t.columns > 1 ? double(next) / cells : 1;
        const double squares[3] = {x0 * x0, x0 * x1, x1 * x1}, ones[3] = {1, 1, 1};
        const CellForm form = cell_form(corners, next - column, wide ? ones : squares);
        double bound = bound_of(form, max_halvings);
        if (column == 0 && t.columns > 1 && !wide) {
          // Below k_min_roughness alpha stays k_min_alpha.
          const double least[3] = {f64::k_min_alpha, f64::k_min_alpha, f64::k_min_alpha};
          bound = std::min(bound, bound_of(cell_form(corners, 1, least), max_halvings));
        }
        // The look-up interpolates A B C D in single precision.
        const double widest = wide ? 1 : std::max(x1 * x1, f64::k_min_alpha);
        bound -= 8 * double(std::numeric_limits<float>::epsilon()) *
                 (most[0] * most[3] + widest * most[1] * most[2]);
        if (bound < result.lower_bound) {
          result.lower_bound = bound;
          result.roughness = 0.5 * (x0 + x1);
        }
      }
  return result;
}

Certificate certify_determinant(const table::LobePolynomial& p, int max_boxes) {
  Certificate result = certify_lobe(p, 0, max_boxes);
  if (!p.two_lobes()) return result;
  const Certificate second = certify_lobe(p, 4, max_boxes);
  result.lower_bound = std::min(result.lower_bound, second.lower_bound);
  result.smallest_seen = std::min(result.smallest_seen, second.smallest_seen);
  result.boxes += second.boxes;
  return result;
}

} // namespace openltc::fit
