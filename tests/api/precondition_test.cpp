// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What the dialect asks of its arguments is an assertion in debug builds, and costs nothing in
// others.

#include "openltc/openltc.h"
#include "tests/base/last_words.h"

#include <doctest/doctest.h>

#include <string>

using namespace openltc;
using openltc::test::last_words_of;

namespace {

#ifdef NDEBUG
constexpr bool k_asserts = false;
#else
constexpr bool k_asserts = true;
#endif

const Vec3f k_up(0, 0, 1);

// The program ends and names the condition where there are assertions, and goes on elsewhere.
template <class Work> void check_asks(const char* condition, const Work& work) {
  CAPTURE(condition);
  const std::string words = last_words_of(work);
  CAPTURE(words);
  CHECK((words.find(condition) != std::string::npos) == k_asserts);
}

} // namespace

TEST_CASE("directions_of_the_dialect_are_unit_in_debug_builds") {
  CHECK(last_words_of([] { f32::shading_frame(k_up, k_up); }) == "");
  check_asks("is_unit(n)", [] { f32::shading_frame(k_up * 1.001f, k_up); });
  check_asks("is_unit(wi)", [] { f32::eval_ggx_terms(k_up, Vec3f(0, 0, 2), 0.5f); });
  const f32::SeenSphere seen = f32::sphere_seen({k_up, 0.5f}, Vec3f(0.0f));
  CHECK(last_words_of([&] { f32::intersect_sphere({k_up, 0.5f}, seen, k_up); }) == "");
  check_asks("is_unit(direction)", [&] {
    f32::intersect_sphere({k_up, 0.5f}, seen, Vec3f(0, 0, 2));
  });
}

TEST_CASE("widths_radii_and_tables_of_the_dialect_are_there_in_debug_builds") {
  CHECK(last_words_of([] { f32::pdf_ggx(k_up, k_up, 0.1f); }) == "");
  check_asks("alpha > Real(0.0)", [] { f32::pdf_ggx(k_up, k_up, 0.0f); });
  check_asks("sphere.radius >= Real(0.0)", [] { f32::sphere_seen({k_up, -1.0f}, Vec3f(0.0f)); });
  check_asks("in_unit_square(u)", [] { f32::sample_lambert({-0.1f, 0.5f}); });
  // Of nothing: no column, so that release builds read nothing either.
  CHECK(last_words_of([] { f32::fetch_lobe(built_in_table().table, 0.5f, 0.5f); }) == "");
  if (k_asserts)
    check_asks("table.texels != nullptr", [] { f32::fetch_lobe(LobeTableView{}, 0.5f, 0.5f); });
}

TEST_CASE("the_api_itself_never_breaks_what_the_dialect_asks") {
  // Whatever it is given: see robustness_test.cpp, too.
  for (const Vec3f normal : {Vec3f(0, 0, 0), Vec3f(0, 0, 1e30f), Vec3f(1, 2, 3)})
    CHECK(last_words_of([&] {
            const Surface s =
                make_surface(Vec3f(0.0f), normal, Vec3f(1, 1, 20), Material{}, built_in_table());
            sample_light(s, Sphere{Vec3f(0, 0, 2), -1}, {2, -3});
            intersect_light(s, Sphere{Vec3f(0, 0, 2), 1}, Vec3f(0, 0, 7));
          }) == "");
}
