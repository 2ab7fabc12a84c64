// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// docs/examples/shade_quad.c makes the picture of shade_quad.cpp.

#include "tests/examples/run_example.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

using namespace openltc;

namespace {

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

double middle_nits(const testing::Run& run) {
  double nits = -1;
  REQUIRE(std::sscanf(run.out.c_str(), "in the middle: %lf nits", &nits) == 1);
  return nits;
}

} // namespace

TEST_CASE("shade_quad_in_c_prints_and_writes_what_the_program_in_cpp_does") {
  const image::test::TemporaryFolder folder;
  const std::string c_path = folder.file("c.pgm"), cpp_path = folder.file("cpp.pgm");
  const testing::Run c = testing::run_example(OPENLTC_EXAMPLE_SHADE_QUAD_C, c_path);
  const testing::Run cpp = testing::run_example(OPENLTC_EXAMPLE_SHADE_QUAD, cpp_path);
  CAPTURE(c.out);
  REQUIRE(c.exit_code == 0);
  REQUIRE(cpp.exit_code == 0);
  CHECK(middle_nits(c) == doctest::Approx(middle_nits(cpp)).epsilon(1e-3));
  const std::string c_bytes = bytes_of(c_path), cpp_bytes = bytes_of(cpp_path);
  REQUIRE(c_bytes.size() == cpp_bytes.size());
  REQUIRE(c_bytes.size() > 160 * 90);
  // The two are compiled with different options; their last bits may lie on both sides of a level.
  int apart = 0;
  for (std::size_t i = 0; i < c_bytes.size(); ++i)
    apart = std::max(apart, std::abs(int(static_cast<unsigned char>(c_bytes[i])) -
                                     int(static_cast<unsigned char>(cpp_bytes[i]))));
  CHECK(apart <= 1);

  CHECK(testing::run_example(OPENLTC_EXAMPLE_SHADE_QUAD_C, folder.file("no/such/folder.pgm"))
            .exit_code == 1);
}
