// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// docs/examples/shade_quad.cpp does what its comments say.

#include "tests/examples/run_example.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

using namespace openltc;

TEST_CASE("shade_quad_prints_the_light_of_the_floor_and_writes_a_picture") {
  const image::test::TemporaryFolder folder;
  const std::string path = folder.file("floor.pgm");
  const testing::Run run = testing::run_example(OPENLTC_EXAMPLE_SHADE_QUAD, path);
  CAPTURE(run.out);
  REQUIRE(run.exit_code == 0);
  double nits = 0;
  REQUIRE(std::sscanf(run.out.c_str(), "in the middle: %lf nits", &nits) == 1);
  // The factor from a floor's element to a square metre, a metre above it, is 0.2394 (Howell,
  // "A Catalog of Radiation Heat Transfer Configuration Factors"): so much of 100 nits times the
  // albedo is the most that the diffuse part gives, and a dielectric seen at 69 degrees leaves it
  // more than four fifths.
  CHECK(nits > 0.8 * 0.2 * 23.94);
  CHECK(nits < 0.2 * 23.94 + 1); // the specular part, which the mirror ray leads past the lamp

  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string head = "P5\n160 90\n255\n";
  REQUIRE(bytes.size() == head.size() + 160 * 90);
  CHECK(bytes.compare(0, head.size(), head) == 0);
  // Bright below the lamp, dark at the corners.
  const auto pixel = [&](int x, int y) {
    return int(static_cast<unsigned char>(bytes[head.size() + std::size_t(y * 160 + x)]));
  };
  CHECK(pixel(80, 45) == doctest::Approx(25.5 * nits).epsilon(0.02));
  CHECK(pixel(0, 0) < pixel(80, 45) / 3);

  CHECK(testing::run_example(OPENLTC_EXAMPLE_SHADE_QUAD, folder.file("no/such/folder.pgm"))
            .exit_code == 1);
}
