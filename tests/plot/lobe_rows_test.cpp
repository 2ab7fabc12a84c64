// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/measure/error.h"
#include "openltc/plot/lobe_rows.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::plot;

namespace {

bool names(const Error& error, const std::string& option, const std::string& part) {
  INFO(error.message);
  const bool good = error.message.rfind(option, 0) == 0 &&
                    error.message.find(part) != std::string::npos &&
                    error.message.find('\n') == std::string::npos;
  CHECK(good);
  return good;
}

} // namespace

TEST_CASE("every lobe of the standard rows integrates to 1") {
  for (const StandardRow name :
       {StandardRow::cosine, StandardRow::roughness, StandardRow::anisotropy, StandardRow::skew}) {
    const LobeRow row = standard_row(name);
    CHECK(!row.cells.empty());
    for (const LobeCell& cell : row.cells) {
      REQUIRE(check_matrix(cell.matrix, cell.caption).ok());
      CHECK(std::abs(lobe_facts(lobe_of_matrix(cell.matrix)).integral - 1) < 1e-8);
    }
  }
}

TEST_CASE("a sweep goes from one value to the other in equal steps") {
  const auto sweep = parse_sweep("c=0.6:0.1:6");
  REQUIRE(sweep.ok());
  const auto row = sweep_row({1, -0.2, 9, 0.1}, *sweep);
  REQUIRE(row.ok());
  REQUIRE(row->cells.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const LobeMatrix& m = row->cells[i].matrix;
    CHECK(m.c == doctest::Approx(0.6 - 0.1 * double(i)));
    CHECK(m.a == 1);
    CHECK(m.b == -0.2);
    CHECK(m.d == 0.1);
  }
  CHECK(row->cells[5].caption == "c = 0.1");
  CHECK(parse_sweep("d=-1:1:2")->from == -1);
}

TEST_CASE("a matrix is read as it is written") {
  const auto m = parse_matrix("0.5,-1e-1,.25,0");
  REQUIRE(m.ok());
  CHECK(text_of(*m) == "0.5,-0.1,0.25,0");
  CHECK(parse_matrix(text_of(*m))->b == -0.1);
}

TEST_CASE("what is no matrix or sweep is refused by its option") {
  for (const char* text :
       {"", "1", "1,0,1", "1,0,1,0,0", "1,0,1,x", "1;0;1;0", "1,0,1,0,", "1,,1,0"})
    names(parse_matrix(text).error(), "--matrix", "four numbers");
  names(parse_matrix("nan,0,1,0").error(), "--matrix nan,0,1,0", "numbers between");
  names(parse_matrix("1,1,1,1").error(), "--matrix 1,1,1,1", "c > 0 and a > b d");
  names(parse_matrix("1,0,-1,0").error(), "--matrix 1,0,-1,0", "det M");
  for (const char* text : {"", "c", "c=", "c=1", "c=1:2", "c=1:2:1", "c=1:2:99", "c=1:2:2.5",
                           "e=1:2:3", "c:1:2:3", "c=1:inf:3", "c=1:nan:3", "c=1:2:3:4"})
    names(parse_sweep(text).error(), "--sweep", "NAME=FROM:TO:COUNT");
  names(sweep_row({}, *parse_sweep("c=1:-1:5")).error(), "--sweep c=1:-1:5 at c = 0", "det M");
}

TEST_CASE("fitted lobes are those that shading looks up") {
  const brdf::Brdf& ggx = *brdf::find_brdf("ggx");
  const auto rows = fitted_rows(ggx, std::vector<double>{0, 60}, std::vector<double>{0.3, 0.7});
  REQUIRE(rows.ok());
  REQUIRE(rows->size() == 2);
  REQUIRE(rows->back().cells.size() == 2);
  const f64::Lobe wanted =
      fit::lobes_of(table::builtin_ggx_table())(0.7, std::cos(60 * f64::k_pi / 180)).lobe;
  const f64::Lobe lobe = lobe_of_matrix(rows->back().cells[1].matrix);
  for (const Vec3d w : {Vec3d(-0.8, 0, 0.6), Vec3d(0, 0.6, 0.8), Vec3d(0.36, -0.48, 0.8)})
    CHECK(f64::eval_lobe(lobe, w) == doctest::Approx(f64::eval_lobe(wanted, w)));
  const auto narrow = fitted_lobe(ggx, 0, 0.001);
  REQUIRE(!narrow.ok());
  CHECK(narrow.error().message.find("too narrow") != std::string::npos);
}
