// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// docs/examples/batch.cpp and many_lights.cpp do what their comments say.

#include "tests/examples/run_example.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

using namespace openltc;

TEST_CASE("batch_writes_a_picture_of_a_floor_under_lights_of_all_shapes") {
  const image::test::TemporaryFolder folder;
  const std::string path = folder.file("floor.ppm");
  const testing::Run run = testing::run_example(OPENLTC_EXAMPLE_BATCH, path);
  CAPTURE(run.out);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("57600 points by 5 lights") != std::string::npos);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string head = "P6\n320 180\n255\n";
  REQUIRE(bytes.size() == head.size() + 3 * 320 * 180);
  const auto pixel = [&](int x, int y, int channel) {
    return int(
        static_cast<unsigned char>(bytes[head.size() + std::size_t(3 * (y * 320 + x) + channel)]));
  };
  // Under the rectangle it is bright, beside the line green, behind the ball bluer than under the
  // disk.
  CHECK(pixel(40, 90, 1) > 4 * pixel(40, 5, 1));
  CHECK(pixel(160, 154, 1) > pixel(160, 154, 0));
  CHECK(pixel(200, 90, 2) > pixel(200, 90, 0));
  CHECK(pixel(128, 90, 0) > pixel(128, 90, 2));
  CHECK(testing::run_example(OPENLTC_EXAMPLE_BATCH, folder.file("no/such/folder.ppm")).exit_code ==
        1);
}

TEST_CASE("many_lights_errs_no_more_than_it_says_and_saves_most_of_the_work") {
  const image::test::TemporaryFolder folder;
  const testing::Run run =
      testing::run_example(OPENLTC_EXAMPLE_MANY_LIGHTS, folder.file("hall.png"));
  CAPTURE(run.out);
  REQUIRE(run.exit_code == 0);
  int lamps = 0;
  double lights = 0, groups = 0, error = 0, allowed = 0, brightest = 0;
  REQUIRE(std::sscanf(
              run.out.c_str(),
              "of %d lamps a point is shaded by %lf and %lf groups; largest error %lf nits, of %lf "
              "allowed, where the brightest is %lf",
              &lamps, &lights, &groups, &error, &allowed, &brightest) == 6);
  CHECK(lamps == 500);
  CHECK(lights < 0.4 * 500);
  CHECK(lights + groups < 500);
  CHECK(error <= allowed + 1e-5);
  CHECK(allowed <= 0.003 * brightest);
}
