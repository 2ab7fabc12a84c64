// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The tables in tables/: what openltc fit --engine makes, and better by a third than the published
// one through the look-up of each engine, which is written down here once more.

#include "openltc/brdf/choose.h"
#include "openltc/fit/fit_job.h"
#include "openltc/table/engine.h"
#include "openltc/table/table_file.h"
#include "tests/fit/published_table.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <map>

using namespace openltc;

namespace {

brdf::Brdf ggx() { return *brdf::choose_brdf("ggx"); }

// One fit for all engines that read the same.
const table::PackedTable& table_for(const table::Engine& engine) {
  static std::map<std::pair<int, int>, fit::FittedLobes> fits;
  fit::FitRequest request;
  request.layout = engine.layout;
  request.precision = engine.precision;
  request.size = engine.size;
  const std::pair<int, int> key{int(engine.layout), int(engine.precision)};
  if (!fits.count(key)) {
    Result<fit::FittedLobes> fitted = fit::fit_lobes(ggx(), request);
    REQUIRE(fitted);
    fits.emplace(key, std::move(*fitted));
  }
  return std::get<table::PackedTable>(fits.at(key).stored);
}

table::Bytes read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

double mean_tv(const fit::LobeFunction& lobes) {
  fit::MeasureOptions options;
  options.points = 20;
  return fit::measure_lobes(ggx(), lobes, options)->mean.tv;
}

} // namespace

TEST_CASE("tables for engines are what the command makes") {
  REQUIRE(table::all_engines().size() == 9);
  for (const table::Engine& engine : table::all_engines()) {
    CAPTURE(engine.name);
    CHECK(table::find_engine(engine.name) == &engine);
    const auto files = table::engine_files(table_for(engine), engine);
    REQUIRE(files);
    for (const std::pair<std::string, table::Bytes>& file : *files) {
      const std::string& name = file.first;
      const table::Bytes& bytes = file.second;
      CAPTURE(name);
      CHECK(bytes.size() < 300 * 1024);
      CHECK(read_file(std::string(OPENLTC_SOURCE_DIR) + "/tables/" + engine.name + "/" + name) ==
            bytes);
    }
  }
  CHECK(table::find_engine("unreal") == nullptr);
}

TEST_CASE("tables for engines that read ltc_code err by a third less than the published one") {
  const auto published = testing::published_lobes();
  if (!published) {
    MESSAGE("skipped: no published table in ../shared/tables");
    return;
  }
  // ltc.js and AreaLights_LTC_piece_ps.any: the coordinate of the columns is alpha, at least .001.
  const fit::LobeFunction at_alpha = [&](double roughness, double cos_theta) {
    return (*published)(std::max(roughness * roughness, 0.001), cos_theta);
  };
  const double before = mean_tv(*published), slipped = mean_tv(at_alpha);
  CHECK(slipped > 3 * before);
  for (const char* name : {"threejs", "babylon", "bevy", "eevee"})
    CHECK(mean_tv(fit::lobes_of(table_for(*table::find_engine(name)))) < before * 2 / 3);
  for (const char* name : {"playcanvas", "ogre-next"}) {
    const table::PackedTable& packed = table_for(*table::find_engine(name));
    // Read without the library's look-up: bilinear between nodes of alpha and sqrt(1 - cos theta).
    const fit::LobeFunction read = [&](double roughness, double cos_theta) {
      const int n = packed.columns();
      const double u = std::max(roughness * roughness, 0.001) * (n - 1);
      const double v = std::sqrt(1 - cos_theta) * (n - 1);
      const int i = std::min(int(u), n - 2), j = std::min(int(v), n - 2);
      const auto at = [&](std::size_t texture, int channel) {
        const auto texel = [&](int x, int y) {
          return double(packed.textures[texture].values[std::size_t((y * n + x) * 4 + channel)]);
        };
        const double x = u - i, y = v - j;
        return (1 - y) * ((1 - x) * texel(i, j) + x * texel(i + 1, j)) +
               y * ((1 - x) * texel(i, j + 1) + x * texel(i + 1, j + 1));
      };
      f64::FittedLobe fitted;
      fitted.lobe = f64::make_lobe(at(0, 0), at(0, 2), at(0, 1), at(0, 3));
      fitted.n1 = at(1, 0);
      fitted.n5 = at(1, 1);
      return fitted;
    };
    const double after = mean_tv(read);
    CHECK(after < before * 2 / 3);
    CHECK(mean_tv(fit::lobes_of(packed)) == doctest::Approx(after).epsilon(1e-4));
  }
}

TEST_CASE("a table for alpha comes back as the table that it was made from") {
  // Between the nodes of two axes: as near as the native interpolation, not to the bit.
  const table::LobeTable& native = table::builtin_ggx_table();
  const auto packed = table::pack(native, table::Layout::ltc_code_alpha, table::Precision::float32);
  REQUIRE(packed);
  const auto back = table::unpack(*packed);
  REQUIRE(back);
  for (int row = 0; row + 1 < native.rows; row += 5)
    for (int column = 8; column < native.columns; column += 5)
      for (int channel = 0; channel < 6; ++channel)
        CHECK(back->texel(column, row)[channel] ==
              doctest::Approx(native.texel(column, row)[channel]).epsilon(0.02));
}
