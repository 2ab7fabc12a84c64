// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// FLIP, after the papers named in flip.h; section numbers are those of the first one.
//
//   picture -> YCxCz -> blur by the eye's contrast sensitivity -> CIELAB, Hunt effect -> HyAB
//          \-> luminance -> edges and points ------------------------------------------> exponent

#include "openltc/image/compare/flip.h"

#include "openltc/image/compare/convolve.h"
#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace openltc::image {

namespace {

// Three planes, because filtering works on one channel at a time.
using Planes = std::array<Plane, 3>;

// --- Colour spaces -----------------------------------------------------------------------------

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix inverse(const Matrix& m) {
  Matrix r{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      r[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
  const double det = m[0][0] * r[0][0] + m[0][1] * r[1][0] + m[0][2] * r[2][0];
  for (auto& row : r)
    for (double& v : row)
      v /= det;
  return r;
}

// From the chromaticities of Rec.709's primaries and of D65 to five digits, (0.31271, 0.32902), as
// the paper's numbers have it: columns are the primaries, scaled so that their sum is white.
constexpr Matrix xyz_from_rgb_matrix() {
  constexpr double x[3] = {0.64, 0.30, 0.15}, y[3] = {0.33, 0.60, 0.06};
  constexpr double white_x = 0.31271, white_y = 0.32902;
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) {
    m[0][i] = x[i] / y[i];
    m[1][i] = 1.0;
    m[2][i] = (1.0 - x[i] - y[i]) / y[i];
  }
  const Matrix inv = inverse(m);
  const double white[3] = {white_x / white_y, 1.0, (1.0 - white_x - white_y) / white_y};
  for (std::size_t i = 0; i < 3; ++i) {
    const double scale = inv[i][0] * white[0] + inv[i][1] * white[1] + inv[i][2] * white[2];
    for (auto& row : m)
      row[i] *= scale;
  }
  return m;
}

// XYZ divided by that of white, so that white is (1, 1, 1): YCxCz and CIELAB need nothing else.
struct ColorSpaces {
  float white_xyz_from_rgb[3][3];
  float rgb_from_white_xyz[3][3];
};

constexpr ColorSpaces make_color_spaces() {
  const Matrix m = xyz_from_rgb_matrix();
  Matrix relative = m;
  for (std::size_t i = 0; i < 3; ++i) {
    const double white = m[i][0] + m[i][1] + m[i][2];
    for (double& v : relative[i])
      v /= white;
  }
  const Matrix back = inverse(relative);
  ColorSpaces spaces{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      spaces.white_xyz_from_rgb[i][j] = float(relative[i][j]);
      spaces.rgb_from_white_xyz[i][j] = float(back[i][j]);
    }
  return spaces;
}

constexpr ColorSpaces k_spaces = make_color_spaces();

Vec3f multiply(const float (&m)[3][3], Vec3f v) {
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
          m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

// YCxCz is linear in XYZ, so that a blur in it is a blur of light (section 4.1).
Vec3f ycxcz_from_rgb(Vec3f rgb) {
  const Vec3f xyz = multiply(k_spaces.white_xyz_from_rgb, rgb);
  return {116.0f * xyz.y - 16.0f, 500.0f * (xyz.x - xyz.y), 200.0f * (xyz.y - xyz.z)};
}

Vec3f rgb_from_ycxcz(Vec3f ycxcz) {
  const float y = (ycxcz.x + 16.0f) / 116.0f;
  return multiply(k_spaces.rgb_from_white_xyz, {y + ycxcz.y / 500.0f, y, y - ycxcz.z / 200.0f});
}

// CIELAB (CIE 15:2004), then the Hunt effect: dark colours look less colourful (section 4.1, eq.
// 5).
Vec3f hunt_lab_from_rgb(Vec3f rgb) {
  constexpr float delta = 6.0f / 29.0f;
  const auto f = [](float t) {
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
  };
  const Vec3f xyz = multiply(k_spaces.white_xyz_from_rgb, rgb);
  const float fx = f(xyz.x), fy = f(xyz.y), fz = f(xyz.z);
  const float l = 116.0f * fy - 16.0f;
  return {l, 0.01f * l * 500.0f * (fx - fy), 0.01f * l * 200.0f * (fy - fz)};
}

// HyAB (Abasi, Amani Tehran, Fairchild 2019): city block for lightness, Euclid for chroma.
float hyab(Vec3f a, Vec3f b) { return std::fabs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

// --- Colour pipeline, section 4.1 ----------------------------------------------------------------

// Contrast sensitivity of the eye in space: sum of a_i sqrt(pi / b_i) exp(-pi^2 x^2 / b_i), x in
// degrees (eq. 2 and table 1).
struct Gaussian {
  double a, b;
};
constexpr Gaussian k_achromatic[] = {{1.0, 0.0047}};
constexpr Gaussian k_red_green[] = {{1.0, 0.0053}};
constexpr Gaussian k_blue_yellow[] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double k_widest_b = 0.04;

// A sum of two-dimensional Gaussians is not separable, but each of them is: blur by each and add.
// The weights of the square window sum to 1 in all.
Plane blur_by_sensitivity(const Plane& in, std::span<const Gaussian> gaussians,
                          double pixels_per_degree) {
  constexpr double pi = std::numbers::pi;
  // Three standard deviations of the widest Gaussian, the same window for all channels.
  const int radius =
      int(std::ceil(3.0 * std::sqrt(k_widest_b / (2.0 * pi * pi)) * pixels_per_degree));
  std::vector<std::vector<double>> kernels;
  std::vector<double> weights;
  double total = 0.0;
  for (const Gaussian& g : gaussians) {
    std::vector<double> kernel;
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i) {
      const double x = i / pixels_per_degree;
      kernel.push_back(std::exp(-pi * pi * x * x / g.b));
      sum += kernel.back();
    }
    kernels.push_back(kernel);
    weights.push_back(g.a * std::sqrt(pi / g.b));
    total += weights.back() * sum * sum;
  }
  Plane out(in.width, in.height);
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const Kernel plain(kernels[i]);
    const Plane rows = convolve_rows(in, plain);
    add_convolved_columns(rows, plain.scaled(weights[i] / total), out);
  }
  return out;
}

// Display-referred linear RGB in [0, 1] after the eye's blur, as perceived colours.
Planes perceived_colors(const Planes& ycxcz, double pixels_per_degree) {
  Planes out = {blur_by_sensitivity(ycxcz[0], k_achromatic, pixels_per_degree),
                blur_by_sensitivity(ycxcz[1], k_red_green, pixels_per_degree),
                blur_by_sensitivity(ycxcz[2], k_blue_yellow, pixels_per_degree)};
  for (std::size_t i = 0; i < out[0].data.size(); ++i) {
    const Vec3f rgb = rgb_from_ycxcz({out[0].data[i], out[1].data[i], out[2].data[i]});
    const Vec3f lab =
        hunt_lab_from_rgb({std::clamp(rgb.x, 0.0f, 1.0f), std::clamp(rgb.y, 0.0f, 1.0f),
                           std::clamp(rgb.z, 0.0f, 1.0f)});
    out[0].data[i] = lab.x;
    out[1].data[i] = lab.y;
    out[2].data[i] = lab.z;
  }
  return out;
}

constexpr float k_color_exponent = 0.7f; // q_c: compresses large differences

// Redistribution (eq. 8): differences up to p_c of the largest possible one fill p_t of the range.
float redistribute(float difference, float largest) {
  constexpr float p_c = 0.4f, p_t = 0.95f;
  const float knee = p_c * largest;
  if (difference < knee) return difference * (p_t / knee);
  return p_t + (difference - knee) / (largest - knee) * (1.0f - p_t);
}

// --- Feature pipeline, section 4.2 ---------------------------------------------------------------

struct Features {
  Plane edges, points; // magnitudes
};

Features find_features(const Plane& y, double pixels_per_degree) {
  constexpr double feature_width_degrees = 0.082; // w, of the eye's edge detection
  const double sigma = 0.5 * feature_width_degrees * pixels_per_degree;
  const int radius = int(std::ceil(3.0 * sigma));
  std::vector<double> gauss, first, second;
  for (int i = -radius; i <= radius; ++i) {
    const double g = std::exp(-i * i / (2.0 * sigma * sigma));
    gauss.push_back(g);
    first.push_back(-i * g);
    second.push_back((i * i / (sigma * sigma) - 1.0) * g);
  }
  // Positive weights sum to 1, negative ones to -1; the blur across sums to 1.
  const auto normalized = [](std::vector<double> weights) {
    double positive = 0.0, negative = 0.0;
    for (double w : weights)
      (w > 0.0 ? positive : negative) += std::fabs(w);
    for (double& w : weights)
      w /= w > 0.0 ? positive : negative;
    return Kernel(weights);
  };
  const Kernel blur = normalized(gauss), edge = normalized(first), point = normalized(second);

  const auto magnitude = [](Plane a, const Plane& b) {
    for (std::size_t i = 0; i < a.data.size(); ++i)
      a.data[i] = std::sqrt(a.data[i] * a.data[i] + b.data[i] * b.data[i]);
    return a;
  };
  const Plane blurred_rows = convolve_rows(y, blur);
  return {magnitude(convolve_columns(convolve_rows(y, edge), blur),
                    convolve_columns(blurred_rows, edge)),
          magnitude(convolve_columns(convolve_rows(y, point), blur),
                    convolve_columns(blurred_rows, point))};
}

// --- Both together
// ---------------------------------------------------------------------------------

// FLIP of linear RGB in [0, 1].
Plane flip_linear(const Planes& a, const Planes& b, double pixels_per_degree) {
  const auto to_ycxcz = [](Planes p) {
    for (std::size_t i = 0; i < p[0].data.size(); ++i) {
      const Vec3f c = ycxcz_from_rgb({p[0].data[i], p[1].data[i], p[2].data[i]});
      p[0].data[i] = c.x;
      p[1].data[i] = c.y;
      p[2].data[i] = c.z;
    }
    return p;
  };
  const auto to_luminance = [](Plane p) {
    for (float& v : p.data)
      v = (v + 16.0f) / 116.0f;
    return p;
  };
  const Planes ycxcz_a = to_ycxcz(a), ycxcz_b = to_ycxcz(b);
  const Planes color_a = perceived_colors(ycxcz_a, pixels_per_degree);
  const Planes color_b = perceived_colors(ycxcz_b, pixels_per_degree);
  const Features features_a = find_features(to_luminance(ycxcz_a[0]), pixels_per_degree);
  const Features features_b = find_features(to_luminance(ycxcz_b[0]), pixels_per_degree);

  // The largest difference of two displayable colours, between green and blue.
  const float largest =
      std::pow(hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1})), k_color_exponent);
  Plane out(a[0].width, a[0].height);
  for (std::size_t i = 0; i < out.data.size(); ++i) {
    const Vec3f lab_a{color_a[0].data[i], color_a[1].data[i], color_a[2].data[i]};
    const Vec3f lab_b{color_b[0].data[i], color_b[1].data[i], color_b[2].data[i]};
    const float color = redistribute(std::pow(hyab(lab_a, lab_b), k_color_exponent), largest);
    const float feature =
        std::max(std::fabs(features_a.edges.data[i] - features_b.edges.data[i]),
                 std::fabs(features_a.points.data[i] - features_b.points.data[i]));
    // Exponent q_f = 1/2; both feature strengths together reach sqrt(2) at most.
    const float feature_difference = std::sqrt(feature * float(1.0 / std::numbers::sqrt2));
    out.data[i] = std::clamp(std::pow(color, 1.0f - feature_difference), 0.0f, 1.0f);
  }
  return out;
}

// The pixels that are finite in both pictures, through `f`; black elsewhere.
template <class F> Planes linear_planes(const Image& picture, const Image& other, F&& f) {
  const Plane black(picture.width, picture.height);
  Planes out = {black, black, black};
  const auto finite = [](Vec3f v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  std::size_t i = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x, ++i) {
      const Vec3f rgb = picture.rgb(x, y);
      if (!finite(rgb) || !finite(other.rgb(x, y))) continue;
      const Vec3f v = f(rgb);
      out[0].data[i] = v.x;
      out[1].data[i] = v.y;
      out[2].data[i] = v.z;
    }
  return out;
}

Image to_image(Plane plane) {
  Image image;
  image.width = plane.width;
  image.height = plane.height;
  image.channels = 1;
  image.data = std::move(plane.data);
  return image;
}

} // namespace

Image flip_ldr(const Image& a, const Image& b, const FlipOptions& options) {
  assert(a.width == b.width && a.height == b.height && !a.empty());
  const auto linear = [](Vec3f v) {
    return Vec3f(linear_from_srgb(std::clamp(v.x, 0.0f, 1.0f)),
                 linear_from_srgb(std::clamp(v.y, 0.0f, 1.0f)),
                 linear_from_srgb(std::clamp(v.z, 0.0f, 1.0f)));
  };
  return to_image(flip_linear(linear_planes(a, b, linear), linear_planes(b, a, linear),
                              double(options.pixels_per_degree)));
}

HdrFlip flip_hdr(const Image& test, const Image& reference, const FlipOptions& options) {
  assert(test.width == reference.width && test.height == reference.height && !test.empty());
  HdrFlip result;

  // From the exposure that brings the brightest pixel to the shoulder of the tone curve to the one
  // that does so for the median (second paper, section 4).
  std::vector<float> luminances;
  luminances.reserve(reference.pixel_count());
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x) {
      const Vec3f c = reference.rgb(x, y);
      const float luminance = 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
      luminances.push_back(luminance > 0.0f && std::isfinite(luminance) ? luminance : 0.0f);
    }
  // The upper of the two middle values, and no less than the epsilon of single precision, as in the
  // authors' program: a picture that is mostly black takes about two dozen exposures.
  const auto middle = luminances.begin() + std::ptrdiff_t(luminances.size() / 2);
  std::nth_element(luminances.begin(), middle, luminances.end());
  constexpr float least = std::numeric_limits<float>::epsilon();
  const float median = std::max(*middle, least);
  const float largest = std::max(*std::max_element(middle, luminances.end()), least);

  constexpr float shoulder = 0.85f;
  const float shoulder_input = inverse_aces(shoulder);
  result.start_exposure = std::log2(shoulder_input / largest);
  result.stop_exposure = std::log2(shoulder_input / median);
  result.exposure_count = std::max(2, int(std::ceil(result.stop_exposure - result.start_exposure)));

  const float step =
      (result.stop_exposure - result.start_exposure) / float(result.exposure_count - 1);
  Plane worst(test.width, test.height);
  for (int i = 0; i < result.exposure_count; ++i) {
    const float scale = std::exp2(result.start_exposure + float(i) * step);
    const auto displayed = [&](Vec3f v) {
      return Vec3f(aces(std::max(v.x, 0.0f) * scale), aces(std::max(v.y, 0.0f) * scale),
                   aces(std::max(v.z, 0.0f) * scale));
    };
    const Plane map =
        flip_linear(linear_planes(test, reference, displayed),
                    linear_planes(reference, test, displayed), double(options.pixels_per_degree));
    for (std::size_t k = 0; k < map.data.size(); ++k)
      worst.data[k] = std::max(worst.data[k], map.data[k]);
  }
  result.map = to_image(std::move(worst));
  return result;
}

double mean_value(const Image& image) {
  double sum = 0.0;
  for (float v : image.data)
    sum += double(v);
  return image.data.empty() ? 0.0 : sum / double(image.data.size());
}

} // namespace openltc::image
