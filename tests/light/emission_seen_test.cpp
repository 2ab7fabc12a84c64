// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The picture as lobes see it, against converged quadrature of picture times lobe over the light.
//
// The table of the documentation is made by
//   test_light -tc="a picture through lobes*" -s

#include "openltc/light/emission_stack.h"
#include "openltc/light/packed_polygon.h"
#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f32.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>

using namespace openltc;

namespace {

class Random {
public:
  double uniform(double low, double high) { return low + (high - low) * (generator_() * 0x1p-32); }
  Vec3d box() { return Vec3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)); }

private:
  std::mt19937 generator_{11};
};

constexpr int k_side = 128;
constexpr int k_pictures = 4;

// A checkerboard, a gradient, windows with dark frames, and noise with a few bright spots.
image::Image test_picture(int kind) {
  image::Image image(k_side, k_side, 3);
  std::mt19937 generator(5);
  for (int y = 0; y < k_side; ++y)
    for (int x = 0; x < k_side; ++x) {
      const double u = (x + 0.5) / k_side, v = (y + 0.5) / k_side;
      Vec3d value;
      if (kind == 0)
        value = ((x / 16 + y / 16) & 1) ? Vec3d(1, 0.8, 0.6) : Vec3d(0.05);
      else if (kind == 1)
        value = Vec3d(u, v, 1 - u);
      else if (kind == 2) {
        const double a = std::fmod(3 * u, 1), b = std::fmod(2 * v, 1);
        const bool pane = a > 0.12 && a < 0.88 && b > 0.1 && b < 0.9;
        value = pane ? Vec3d(1 - 0.5 * v, 1 - 0.3 * v, 1) : Vec3d(0.02);
      } else {
        const auto spot = [&] { return std::pow(generator() * 0x1p-32, 3); };
        value = (x % 2 == 0 && y % 2 == 0) ? Vec3d(spot(), spot(), spot()) : Vec3d(0);
        if (x % 2 || y % 2) {
          const Vec3f even = image.rgb(x & ~1, y & ~1);
          value = Vec3d(even.x, even.y, even.z);
        }
      }
      float* p = image.pixel(x, y);
      p[0] = float(value.x);
      p[1] = float(value.y);
      p[2] = float(value.z);
    }
  return image;
}

struct Setting {
  light::PolygonLight light;
  Vec3d middle, u, v, normal; // of the rectangle
  double width, height;
  f64::Frame frame; // of a surface at the origin, world space = shading space
  Vec3d wo;
};

// A rectangle somewhere about the mirror direction of a random view, facing the origin.
Setting random_setting(Random& random) {
  Setting s;
  s.width = random.uniform(0.3, 2);
  s.height = random.uniform(0.3, 2);
  const double cosine = random.uniform(0.1, 1);
  s.wo = Vec3d(std::sqrt(1 - cosine * cosine), 0, cosine);
  s.frame = f64::shading_frame(Vec3d(0, 0, 1), s.wo);
  s.middle = normalize(Vec3d(-s.wo.x, 0, s.wo.z) + random.box() * 0.7) * random.uniform(0.4, 4);
  s.normal = normalize(random.box());
  if (dot(s.normal, s.middle) > 0) s.normal = -s.normal;
  s.u = normalize(cross(s.normal, random.box()));
  s.v = cross(s.u, s.normal); // downwards for who faces it
  const Vec3d corner = s.middle - s.u * (s.width / 2) - s.v * (s.height / 2);
  const Vec3d along = s.u * s.width, down = s.v * s.height;
  s.light.vertices = {to_float(corner), to_float(corner + down), to_float(corner + down + along),
                      to_float(corner + along)};
  s.light.ring_end = {4};
  s.light.normal = to_float(s.normal);
  s.light.radiance = {1, 1, 1};
  s.light.texture = 0;
  s.light.texture_corner = to_float(corner);
  s.light.texture_u = to_float(along);
  s.light.texture_v = to_float(down);
  return s;
}

Vec3d bilinear(const image::Image& image, double u, double v) {
  const double x = std::clamp(u * image.width - 0.5, 0.0, image.width - 1.0);
  const double y = std::clamp(v * image.height - 0.5, 0.0, image.height - 1.0);
  const int x0 = int(x), y0 = int(y);
  const int x1 = std::min(x0 + 1, image.width - 1), y1 = std::min(y0 + 1, image.height - 1);
  const auto at = [&](int i, int j) {
    const Vec3f c = image.rgb(i, j);
    return Vec3d(c.x, c.y, c.z);
  };
  const double fx = x - x0, fy = y - y0;
  return (at(x0, y0) * (1 - fx) + at(x1, y0) * fx) * (1 - fy) +
         (at(x0, y1) * (1 - fx) + at(x1, y1) * fx) * fy;
}

struct Truth {
  double integral = 0; // of the lobe over the light
  Vec3d mean{0, 0, 0}; // of the picture, weighted by the lobe
};

// Points of the rectangle crowded, by a tangent, where the lobe's middle direction meets it.
Truth quadrature(const Setting& s, const f64::Lobe& lobe, double width_rad,
                 const image::Image& picture, int n) {
  const Vec3d peak = f64::sample_lobe(lobe, f64::Vec2(0, 0));
  const double t = dot(s.middle, s.normal) / dot(peak, s.normal);
  const Vec3d hit = t > 0 && t < 100 ? peak * t : s.middle;
  const double width = width_rad * length(hit);
  struct Place {
    double at, measure;
  };
  const auto place = [&](double half, double around, int i) {
    const double low = std::atan((-half - around) / width);
    const double high = std::atan((half - around) / width);
    const double angle = low + (high - low) * (i + 0.5) / n;
    const double c = std::cos(angle);
    return Place{around + width * std::tan(angle), width * (high - low) / (c * c * n)};
  };
  const double around_u = std::clamp(dot(hit - s.middle, s.u), -s.width / 2, s.width / 2);
  const double around_v = std::clamp(dot(hit - s.middle, s.v), -s.height / 2, s.height / 2);
  Truth truth;
  for (int i = 0; i < n; ++i) {
    const Place x = place(s.width / 2, around_u, i);
    for (int j = 0; j < n; ++j) {
      const Place y = place(s.height / 2, around_v, j);
      const Vec3d p = s.middle + s.u * x.at + s.v * y.at;
      if (p.z <= 0) continue;
      const double distance2 = dot(p, p);
      const Vec3d wi = p / std::sqrt(distance2);
      const double weight =
          f64::eval_lobe(lobe, wi) * -dot(wi, s.normal) / distance2 * x.measure * y.measure;
      truth.integral += weight;
      truth.mean += bilinear(picture, x.at / s.width + 0.5, y.at / s.height + 0.5) * weight;
    }
  }
  truth.mean = truth.mean / truth.integral;
  return truth;
}

// The rule of Heitz et al. 2016: one look, at the point of the plane nearest to the origin in
// cosine space, a Gaussian of standard deviation distance / sqrt(2 area) of the light's side.
Vec3d one_look(const EmissionTextureView& e, const f64::Frame& frame, const f64::Lobe& lobe) {
  const f64::Vec2 extent = f64::emission_extent(e);
  const auto carried = [&](Vec3d v) { return f64::to_cosine(lobe, f64::to_shading(frame, v)); };
  const Vec3d corner = carried(f64::emission_corner(e));
  const Vec3d a = carried(f64::emission_axis_u(e)), b = carried(f64::emission_axis_v(e));
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), det = aa * bb - ab * ab;
  const double x = (ab * dot(corner, b) - bb * dot(corner, a)) / det;
  const double y = (ab * dot(corner, a) - aa * dot(corner, b)) / det;
  const double distance = length(corner + a * x + b * y);
  const double sigma = distance / std::sqrt(2 * std::sqrt(det) * extent.x * extent.y);
  const f64::Vec2 count = f64::emission_texel_count(e);
  // A look at a level is a Gaussian of sqrt(1/4 + 1/6) of its texels, interpolation included.
  const double level = std::log2(std::max(sigma * std::sqrt(count.x * count.y) / 0.645, 1e-9));
  const f64::Vec4 look = f64::emission_texel(e, f64::Vec2(x / extent.x, y / extent.y), level);
  return Vec3d(look.x, look.y, look.z) / look.w;
}

double sum(Vec3d v) { return v.x + v.y + v.z; }
double difference(Vec3d a, Vec3d b) {
  return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

Vec3d seen(const EmissionTextureView& e, const Setting& s, const f64::Lobe& lobe,
           const light::PackedPolygon& packed) {
  const Vec3d mean =
      f64::integrate_polygon(packed.view, Vec3d(0, 0, 0), s.frame, lobe).specular_direction;
  return f64::emission_seen(e, Vec3d(0, 0, 0), s.frame, lobe, mean);
}

} // namespace

TEST_CASE("a picture through lobes of every roughness: mean relative error, one look beside it") {
  // Lobes that see less than a thousandth of the light are left out: nothing is seen by them.
  constexpr int k_count = 96;
  Random random;
  struct Row {
    double roughness; // negative: Lambert
    double bound;     // of the error over the picture's mean
  };
  for (const Row row : {Row{-1, 0.04}, Row{0.05, 0.07}, Row{0.1, 0.1}, Row{0.2, 0.08},
                        Row{0.3, 0.06}, Row{0.5, 0.04}, Row{0.7, 0.04}, Row{1, 0.04}}) {
    double error = 0, share = 0, plain_error = 0, plain_share = 0;
    for (int i = 0; i < k_count;) {
      const Setting s = random_setting(random);
      const double alpha = row.roughness < 0 ? 1 : row.roughness * row.roughness;
      const f64::Lobe lobe =
          row.roughness < 0
              ? f64::cosine_lobe()
              : f64::fetch_lobe(table::builtin_ggx_table().view(), alpha, s.wo.z).lobe;
      const light::PackedPolygon packed = light::pack_polygon(s.light);
      if (f64::integrate_polygon(packed.view, Vec3d(0, 0, 0), s.frame, lobe).specular < 1e-3)
        continue;
      const image::Image picture = test_picture(i % k_pictures);
      const Truth truth =
          quadrature(s, lobe, std::max(alpha, 0.001), picture, row.roughness > 0.15 ? 200 : 300);
      auto stack = light::build_emission_stack(picture, s.light);
      REQUIRE(stack.ok());
      const Vec3d estimate = seen(stack->view, s, lobe, packed);
      const Vec3d plain = one_look(stack->view, s.frame, lobe);
      const double mean = double(stack->mean.x + stack->mean.y + stack->mean.z);
      error += difference(estimate, truth.mean) / sum(truth.mean) / k_count;
      plain_error += difference(plain, truth.mean) / sum(truth.mean) / k_count;
      share += difference(estimate, truth.mean) / mean / k_count;
      plain_share += difference(plain, truth.mean) / mean / k_count;
      ++i;
    }
    const std::string name = row.roughness < 0
                                 ? "diffuse       "
                                 : "roughness " + std::to_string(row.roughness).substr(0, 4);
    MESSAGE(name, ": error ", error, ", of the picture's mean ", share, "; one look ", plain_error,
            ", ", plain_share);
    // In places where the picture is dark, little of its mean is much of the value.
    CHECK(share < row.bound);
    CHECK(share < 0.6 * plain_share);
    CHECK(error < 0.75 * plain_error);
  }
}

TEST_CASE("a uniform picture is seen as it is by every lobe, at every distance") {
  image::Image picture(8, 8, 3);
  for (float& value : picture.data)
    value = 0.75f;
  Random random;
  const LobeTableView table = table::builtin_ggx_table().view();
  for (int i = 0; i < 2000; ++i) {
    const Setting s = random_setting(random);
    auto stack = light::build_emission_stack(picture, s.light, {32});
    REQUIRE(stack.ok());
    const double roughness = std::pow(random.uniform(0, 1), 3);
    const Vec3f wo = to_float(s.wo);
    const f32::Frame frame = f32::shading_frame(Vec3f(0, 0, 1), wo);
    const f32::Lobe lobe =
        f32::fetch_lobe(table, f32::alpha_from_roughness(float(roughness)), wo.z).lobe;
    // Any mean direction: it only places the cells. Any position: in the light's plane, too.
    const Vec3f position = i % 5 == 0 ? s.light.vertices[0] : to_float(random.box() * 3.0);
    const Vec3f seen =
        f32::emission_seen(stack->view, position, frame, lobe, to_float(normalize(random.box())));
    CHECK(seen.x == doctest::Approx(0.75).epsilon(1e-4));
    CHECK(seen.z == doctest::Approx(0.75).epsilon(1e-4));
  }
}

TEST_CASE("what a lobe sees lies within the picture's range") {
  Random random;
  const image::Image picture = test_picture(3);
  const LobeTableView table = table::builtin_ggx_table().view();
  for (int i = 0; i < 200; ++i) {
    const Setting s = random_setting(random);
    auto stack = light::build_emission_stack(picture, s.light);
    REQUIRE(stack.ok());
    const f64::Lobe lobe =
        f64::fetch_lobe(table, f64::alpha_from_roughness(random.uniform(0, 1)), s.wo.z).lobe;
    const Vec3d value =
        f64::emission_seen(stack->view, random.box(), s.frame, lobe, normalize(random.box()));
    for (const double v : {value.x, value.y, value.z})
      CHECK((v >= 0 && v <= 1 + 1e-6));
  }
}

TEST_CASE("half of a picture beyond the surface's horizon is not seen") {
  // A wall light, half below a floor, white above and black below.
  image::Image picture(64, 64, 3);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 3; ++c)
        picture.pixel(x, y)[c] = 1;
  light::PolygonLight wall;
  wall.vertices = {{1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {1, 1, -1}};
  wall.ring_end = {4};
  wall.normal = {-1, 0, 0};
  wall.radiance = {1, 1, 1};
  light::place_texture(wall, 0, {0, -1, 0});
  auto stack = light::build_emission_stack(picture, wall);
  REQUIRE(stack.ok());
  const light::PackedPolygon packed = light::pack_polygon(wall);
  const f64::Frame frame = f64::shading_frame(Vec3d(0, 0, 1), Vec3d(0, 0, 1));
  for (const double roughness : {0.2, 0.5, 1.0}) {
    const f64::Lobe lobe = f64::fetch_lobe(table::builtin_ggx_table().view(),
                                           f64::alpha_from_roughness(roughness), 0.5)
                               .lobe;
    const Vec3d mean =
        f64::integrate_polygon(packed.view, Vec3d(0, 0, 0), frame, lobe).specular_direction;
    const Vec3d value = f64::emission_seen(stack->view, Vec3d(0, 0, 0), frame, lobe, mean);
    CAPTURE(roughness);
    CHECK(value.x > 0.9);
  }
}
