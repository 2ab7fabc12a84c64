// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   bench_light_errors [COUNT] [--worst]   the error table of docs/lights.md
//
// COUNT random lights of each shape, 100000 if not given: the difference of single precision from
// the exact integral of the same lobe, and that of the published formulas. --worst prints the
// inputs of the largest differences below the table.

#include "tests/shade/lights/light_errors.h"

#include "tests/shade/lights/light_reference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

using namespace openltc;
using testing::ErrorFigures;
using testing::LightCase;
using testing::LightShape;
using testing::ShapeErrors;

namespace {

void print_worst(const char* what, const ShapeErrors& e, const ErrorFigures& f) {
  const LightCase light = testing::error_case(e.shape, f.worst);
  const testing::CaseView view = testing::view_of(light);
  const testing::CaseAnswer answer = testing::evaluate(light);
  const f64::LightIntegral precise = testing::evaluate_precise(light, view);
  const f64::Lobe lobe = std::strcmp(what, "diffuse") == 0 ? f64::cosine_lobe() : view.lobe;
  const Vec3d exact = testing::contour_integral(light, view, lobe);
  std::printf("%s %s %s, case %llu: off by %.3g; exact %.9g; float %.9g, %.9g, double %.9g, %.9g\n",
              testing::shape_name(e.shape), e.surfaces.c_str(), what,
              static_cast<unsigned long long>(f.worst), f.largest, exact.z, double(answer.diffuse),
              double(answer.specular), precise.diffuse, precise.specular);
  const auto put = [](const char* name, Vec3f v) {
    std::printf("  %s %.9g %.9g %.9g", name, double(v.x), double(v.y), double(v.z));
  };
  put("position", light.position);
  put("normal", light.normal);
  put("wo", light.wo);
  std::printf("  roughness %.9g radius %.9g two_sided %d\n", double(light.roughness),
              double(light.radius), int(light.two_sided));
  put("a", light.a);
  put("b", light.b);
  put("c", light.c);
  std::printf("\n");
}

} // namespace

int main(int argc, char** argv) {
  long long count = 100000;
  bool worst = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--worst") == 0)
      worst = true;
    else
      count = std::atoll(argv[i]);
  }
  if (count < 1) {
    std::fprintf(stderr, "usage: bench_light_errors [COUNT] [--worst]\n");
    return 2;
  }
  std::printf("%lld lights of each shape; rough: roughness 0.2 to 1, smooth: 0 to 0.2.\n"
              "Absolute differences of integrals, 0 to 1: mean / 99 of 100 below / largest.\n\n",
              count);
  std::printf("| shape | surface | diffuse | specular | published, specular | published, below the "
              "surface too | published fit |\n|---|---|---|---|---|---|---|\n");
  std::vector<ShapeErrors> all;
  for (int k = 0; k < testing::k_light_shapes; ++k) {
    for (const ShapeErrors& e : testing::measure_light_errors(testing::shape_of_index(k), count)) {
      std::printf("| %s | %s |", testing::shape_name(e.shape), e.surfaces.c_str());
      const auto put = [](const ErrorFigures& f) {
        std::printf(" %.1e / %.1e / %.1e |", f.mean, f.p99, f.largest);
      };
      put(e.diffuse);
      put(e.specular);
      put(e.published);
      put(e.published_leaking);
      if (testing::is_polygon(e.shape))
        put(e.published_fit);
      else
        std::printf(" |");
      std::printf("\n");
      std::fflush(stdout);
      all.push_back(e);
    }
  }
  std::printf("\n");
  for (const LightShape shape : {LightShape::rectangle, LightShape::polygon}) {
    long long noticeable = 0;
    float below = 0;
    for (const ShapeErrors& e : all)
      if (e.shape == shape) {
        noticeable += e.specular.noticeable;
        below = std::max(below, e.specular.noticeable_below);
      }
    std::printf(
        "Of %lld specular integrals of a %s, %lld are off by more than 1e-5, at a roughness "
        "of %.3f and less.\n",
        count, testing::shape_name(shape), noticeable, std::ceil(double(below) * 1e3) / 1e3);
  }
  if (worst)
    for (const ShapeErrors& e : all) {
      print_worst("diffuse", e, e.diffuse);
      print_worst("specular", e, e.specular);
    }
}
