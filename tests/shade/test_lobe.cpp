// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The linearly transformed cosine: a density, its matrices, and the change of variables.

#include "openltc/target/shade_f64.h"
#include "tests/shade/random.h"
#include "tests/shade/sphere_quadrature.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace openltc;
using testing::Random;
using testing::SphereMap;

namespace {

f64::Lobe random_lobe(Random& random) {
  for (;;) {
    const f64::Lobe lobe = f64::make_lobe(random.uniform(0.2, 3), random.uniform(-1.5, 1.5),
                                          random.uniform(-1.5, 1.5), random.uniform(0.2, 3));
    if (lobe.det > 0.2) return lobe;
  }
}

} // namespace

TEST_CASE("the lobe of any matrix integrates to 1 over the sphere") {
  Random random(41);
  for (int i = 0; i < 40; ++i) {
    const f64::Lobe lobe = random_lobe(random);
    const Vec3d axis = normalize(f64::from_cosine(lobe, Vec3d(0, 0, 1)));
    const double mass =
        SphereMap(axis, 0.7).integrate([&](Vec3d w) { return f64::eval_lobe(lobe, w); }, 400);
    CHECK(mass == doctest::Approx(1).epsilon(2e-4));
  }
}

TEST_CASE("change of variables: moments over the lobe are moments over the cosine") {
  Random random(42);
  for (int i = 0; i < 20; ++i) {
    const f64::Lobe lobe = random_lobe(random);
    const Vec3d axis = normalize(f64::from_cosine(lobe, Vec3d(0, 0, 1)));
    const auto f = [](Vec3d w) { return 1 + w.x - 2 * w.y * w.y + w.x * w.z * w.z; };
    const double direct = SphereMap(axis, 0.7).integrate(
        [&](Vec3d w) { return f(w) * f64::eval_lobe(lobe, w); }, 400);
    const double through_cosine = SphereMap(Vec3d(0, 0, 1), 0.7)
                                      .integrate(
                                          [&](Vec3d o) {
                                            const Vec3d w = normalize(f64::from_cosine(lobe, o));
                                            return f(w) * f64::eval_lambert(o);
                                          },
                                          400);
    CHECK(direct == doctest::Approx(through_cosine).epsilon(5e-4));
  }
}

TEST_CASE("to_cosine and from_cosine are inverses up to the determinant") {
  Random random(43);
  for (int i = 0; i < 2000; ++i) {
    const f64::Lobe lobe = random_lobe(random);
    const Vec3d v = random.sphere();
    const Vec3d back = f64::from_cosine(lobe, f64::to_cosine(lobe, v)) / lobe.det;
    CHECK(length(back - v) < 1e-12);
  }
}

TEST_CASE("mirror packing: there and back") {
  Random random(44);
  for (int i = 0; i < 2000; ++i) {
    const Vec4d abcd(random.uniform(0, 1), random.uniform(-1.2, 0), random.uniform(0, 2),
                     random.uniform(0, 2));
    const double alpha = random.log_uniform(1e-4, 1), cos_theta = random.uniform();
    const f64::Lobe lobe = f64::lobe_from_mirror(abcd, alpha, cos_theta);
    const Vec4d back = f64::mirror_from_lobe(lobe, alpha, cos_theta);
    CHECK(back.x == doctest::Approx(abcd.x).epsilon(1e-10));
    CHECK(back.y == doctest::Approx(abcd.y).epsilon(1e-10));
    CHECK(back.z == doctest::Approx(abcd.z).epsilon(1e-10));
    CHECK(back.w == doctest::Approx(abcd.w).epsilon(1e-10));
    CHECK(lobe.det ==
          doctest::Approx(lobe.m00 * lobe.m22 - lobe.m02 * lobe.m20).epsilon(1e-9).scale(1e-3));
  }
}

TEST_CASE("the cosine lobe is Lambert's") {
  Random random(45);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d w = random.sphere();
    CHECK(f64::eval_lobe(f64::cosine_lobe(), w) ==
          doctest::Approx(f64::eval_lambert(w)).epsilon(1e-12));
  }
}

TEST_CASE("shading frames are orthonormal and right-handed, also along the normal") {
  Random random(46);
  for (int i = 0; i < 5000; ++i) {
    const Vec3d n = random.sphere();
    Vec3d wo = random.sphere();
    if (i % 4 == 1) wo = n;
    if (i % 4 == 2) wo = normalize(n + random.sphere() * random.log_uniform(1e-9, 1e-3));
    const f64::Frame f = f64::shading_frame(n, wo);
    CHECK(dot(f.t1, f.t1) == doctest::Approx(1).epsilon(1e-9));
    CHECK(std::abs(dot(f.t1, n)) < 1e-9);
    CHECK(length(cross(f.t1, f.t2) - n) < 1e-9);
    const Vec3d local = f64::to_shading(f, wo);
    CHECK(std::abs(local.y) < 1.1e-4);
    CHECK(length(f64::to_world(f, local) - wo) < 1e-9);
    if (length(wo - n * dot(wo, n)) > 1e-4) CHECK(local.x >= 0);
  }
}
