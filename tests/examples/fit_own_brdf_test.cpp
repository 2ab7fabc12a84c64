// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// docs/examples/fit_own_brdf.cpp does what its comments say.

#include "openltc/table/packed_file.h"
#include "openltc/table/table_file.h"
#include "tests/examples/run_example.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <string>

using namespace openltc;

TEST_CASE("fit_own_brdf_prints_a_small_error_and_writes_files_that_read") {
  const image::test::TemporaryFolder folder;
  const testing::Run run = testing::run_example(OPENLTC_EXAMPLE_FIT_OWN_BRDF, folder.file(""));
  CAPTURE(run.out);
  REQUIRE(run.exit_code == 0);
  double mean = -1, p95 = -1, largest = -1;
  REQUIRE(std::sscanf(run.out.c_str(), "mean TV %lf, 95 %% below %lf, largest %lf", &mean, &p95,
                      &largest) == 3);
  CHECK(mean > 0);
  CHECK(mean < 0.13); // a Gaussian lobe, as Beckmann's: nearer than this comes no single lobe
  CHECK(p95 >= mean);
  CHECK(largest >= p95);
  CHECK(largest <= 1);
  CHECK(folder.file_count() == 4); // ward.json, ward_1.dds, ward_2.dds, ward.dds.json

  const Result<table::LobeTable> table = table::read_table(folder.file("ward.json"));
  REQUIRE(table);
  CHECK(table->columns == 32);
  CHECK(table->rows == 32);
  CHECK(table->metadata.brdf == "ward");
  CHECK(table->metadata.horizon == "clipped");
  CHECK(table->metadata.mean_tv == doctest::Approx(mean).epsilon(0.01));
  // A mirror reflects everything; Ward's model loses what leaves below the horizon.
  CHECK(table->texel(0, 0)[4] == doctest::Approx(1.0f).epsilon(0.01));
  CHECK(table->texel(31, 0)[4] < 1);

  const Result<table::PackedTable> packed = table::read_packed(folder.file("ward.dds"));
  REQUIRE(packed);
  CHECK(packed->layout == table::Layout::ltc_code);
  CHECK(packed->precision == table::Precision::float16);
  CHECK(packed->metadata.brdf == "ward");
}

TEST_CASE("fit_own_brdf_says_in_one_line_what_it_cannot_write") {
  const image::test::TemporaryFolder folder;
  const testing::Run run =
      testing::run_example(OPENLTC_EXAMPLE_FIT_OWN_BRDF, folder.file("missing"));
  CHECK(run.exit_code == 1);
  CHECK(run.out.find("ward.json") != std::string::npos);
  CHECK(folder.file_count() == 0);
}
