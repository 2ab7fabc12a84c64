// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One source, three number types: every public function in lanes, float and double.
//
// Lanes and float run the same operations in the same order; what may differ is a fused
// multiply-add, which the compiler makes of Highway's Mul and Add only where asked, and Highway's
// own sine and cosine. So they agree to a few units in the last place, magnified by how sensitive
// the function is to its inputs.

#include "openltc/base/processor.h"
#include "openltc/light/emission_stack.h"
#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/lobe_table.h"
#include "openltc/target/shade_f32.h"
#include "openltc/target/shade_f64.h"
#include "tests/base/last_words.h"
#include "tests/shade/parity/parity.h"
#include "tests/shade/parity/parity_inputs.h"
#include "tests/shade/polygon_fixture.h"
#include "tests/shade/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace openltc::f32 {
#include "tests/shade/parity/parity_body.inc"
}
namespace openltc::f64 {
#include "tests/shade/parity/parity_body.inc"
}

using namespace openltc;
using testing::Random;

namespace {

using testing::Batch;
using testing::k_count;
using testing::make_batch;

// Tables of all sizes in turn: the built-in, and parts of it down to one column and one row. Each
// with a second lobe, that of another node, of any weight.
LobeTableView table_of_round(int round) {
  const table::LobeTable& from = table::builtin_ggx_table();
  const int sizes[][2] = {{from.columns, from.rows}, {1, 1}, {1, 7}, {2, 1}, {3, 2}};
  static std::vector<float> texels, second;
  const int columns = sizes[round % 5][0], rows = sizes[round % 5][1];
  texels.clear();
  second.clear();
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      // Nodes spread over the whole table, without its first column, a mirror.
      const float* texel = from.texel(from.columns - 1 - x * (from.columns - 1) / columns,
                                      y * (from.rows - 1) / rows);
      texels.insert(texels.end(), texel, texel + table::LobeTable::k_channels);
      texels[texels.size() - 2] = float((7 * x + 3 * y) % 11) / 10;
      const float* other = from.texel(from.columns - 1 - x % 8, from.rows / 2 + y % 16);
      second.insert(second.end(), other, other + table::LobeTable::k_second_channels);
    }
  return {texels.data(), columns, rows, second.data()};
}

// Profiles of several sizes in turn: smooth, of one column, of one row, of a single value.
ProfileView profile_of_round(int round) {
  const int sizes[][2] = {{25, 19}, {1, 91}, {9, 1}, {1, 1}, {2, 2}};
  static std::vector<float> values;
  const int columns = sizes[round % 5][0], rows = sizes[round % 5][1];
  values.clear();
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      values.push_back(
          float(0.5 + 0.3 * std::cos(6.283185 * i / columns) + 0.2 * std::sin(3.0 * j / rows)));
  return {values.data(), columns, rows};
}

// A disk whose picture is noise of 48 x 40 pixels.
const EmissionTextureView& emission() {
  static const light::EmissionStack stack = [] {
    Random random(67);
    image::Image picture(48, 40, 3);
    for (float& value : picture.data)
      value = float(random.uniform());
    light::EllipseLight disk;
    disk.center = {0.4f, -0.3f, 1.2f};
    disk.half_u = {0.8f, 0.3f, 0};
    disk.half_v = {-0.3f, 0.8f, 0};
    disk.radiance = {1, 1, 1};
    light::place_texture(disk, 0, {1, 0, 0});
    return std::move(*light::build_emission_stack(picture, disk));
  }();
  return stack.view;
}

testing::ParityResources resources_of_round(int round, const testing::TestPolygon& polygon) {
  return {table_of_round(round), table::builtin_ggx_polynomial().view(), polygon.view(),
          profile_of_round(round), emission()};
}

// Runs the scalar form of one number type over a batch.
template <class R, class Evaluate>
int run_scalar(const std::vector<R>& in, const testing::ParityResources& resources,
               Evaluate evaluate, std::vector<R>& out, const char** names) {
  out.resize(std::size_t(testing::k_parity_max_outputs) * k_count);
  int outputs = 0;
  for (int i = 0; i < k_count; ++i) {
    R inputs[testing::k_parity_inputs], results[testing::k_parity_max_outputs];
    for (int k = 0; k < testing::k_parity_inputs; ++k)
      inputs[k] = in[std::size_t(k * k_count + i)];
    outputs = evaluate(inputs, resources, results, names);
    for (int k = 0; k < outputs; ++k)
      out[std::size_t(k * k_count + i)] = results[k];
  }
  return outputs;
}

// Choices, a hit or the part that is sampled, may fall differently within rounding of their border.
bool is_choice(const std::string& name) {
  return name.find(".hit") != std::string::npos || name.find(".choice") != std::string::npos ||
         name == "apex_side";
}

// What each output of each element may differ by: what inputs that are off by a few units in the
// last place of single precision make of it in double. A formula cannot be expected to be better:
// its first operations have rounded as much. Where a ray grazes a plane or touches a rim, a lobe is
// narrow or a view close to the normal that is much, and it is much for those elements alone.
constexpr double k_input_error = 8 * 0x1p-24;
constexpr int k_disturbances = 6;

// The inputs with each one off by k_input_error, up or down: of itself, or of 1 for coordinates,
// which are differences of others as soon as they are used.
std::vector<double> disturbed(const std::vector<double>& in, Random& random) {
  std::vector<double> out = in;
  for (int k = 0; k < testing::k_parity_inputs; ++k) {
    const bool coordinate = (k >= 1 && k <= 15) || (k >= 25 && k <= 27);
    for (int i = 0; i < k_count; ++i) {
      double& x = out[std::size_t(k * k_count + i)];
      const double size = coordinate ? std::max(std::abs(x), 1.0) : std::abs(x);
      x += (random.uniform() < 0.5 ? -1 : 1) * k_input_error * size;
    }
  }
  return out;
}

// One round of inputs: the same for every number type, with the answers of single and double.
struct Round {
  int index = 0;
  Batch batch;
  std::unique_ptr<testing::TestPolygon> polygon;
  std::vector<float> single;
  std::vector<double> exact;
  std::vector<float> uncertain; // what disturbed inputs make of `exact`
  int outputs = 0;
  const char* names[testing::k_parity_max_outputs] = {};

  testing::ParityResources resources() const { return resources_of_round(index, *polygon); }
};

// Five rounds of inputs, tables, profiles and polygons.
const std::deque<Round>& rounds() {
  static const std::deque<Round> all = [] {
    std::deque<Round> made;
    Random random(61), disturbance(71);
    for (int k = 0; k < 5; ++k) {
      Round& round = made.emplace_back();
      round.index = k;
      round.batch = make_batch(random);
      const testing::Plane p = testing::random_plane(random, Vec3d(0, 0, 0));
      round.polygon =
          std::make_unique<testing::TestPolygon>(testing::shape(k), p.origin, p.u, p.v, k % 2 == 1);
      const testing::ParityResources resources = round.resources();
      const std::vector<double> in(round.batch.in.begin(), round.batch.in.end());
      round.outputs =
          run_scalar(round.batch.in, resources, f32::parity_evaluate, round.single, round.names);
      run_scalar(in, resources, f64::parity_evaluate, round.exact, round.names);
      round.uncertain.assign(round.exact.size(), 0);
      std::vector<double> moved;
      for (int n = 0; n < k_disturbances; ++n) {
        run_scalar(disturbed(in, disturbance), resources, f64::parity_evaluate, moved, round.names);
        for (std::size_t i = 0; i < moved.size(); ++i)
          round.uncertain[i] =
              std::max(round.uncertain[i], float(std::abs(moved[i] - round.exact[i])));
      }
    }
    return made;
  }();
  return all;
}

// What is allowed beyond. Six disturbances may miss what a seventh would show: of any function ten
// of its values, of 20,480 for each number that it returns, may differ by more, by 1e-4 at most.
// The others are called with inputs that parity_body.inc makes so that something is exact, for
// disturbed inputs too; what rounding does behind that is not seen by disturbing.
struct Beyond {
  int count = 10;
  double largest = 1e-4;
};
const std::map<std::string, Beyond>& exceptions() {
  static const std::map<std::string, Beyond> all = {
      // It undoes lobe_from_mirror and gives back what went in; on the way a narrow lobe magnifies
      // rounding by 1/alpha, up to 400 here: 400 x 2^-24 for each of four operations.
      {"mirror_from_lobe", {k_count, 1600 * 0x1p-24}},
      // The ray goes to the centre, 1.7 away however it is disturbed; where it grazes the plane,
      // rounding is divided by the cosine, 1e-4 for the smallest of 20,480.
      {"intersect_ellipse_by_area", {200, 17 * 0x1p-24 / 1e-4}},
      {"intersect_ellipse", {200, 17 * 0x1p-24 / 1e-4}},
      // To the middle of a tube likewise, whose side is met at an angle.
      {"intersect_tube_by_area", {100, 1e-5}},
      {"intersect_tube", {100, 1e-5}},
      // Where a direction lies on the outline, the place goes by the square root of rounding, or,
      // on
      // an end seen edge on, by rounding over the cosine at which it is seen.
      {"sample_tube", {1000, 5e-2}},
      // One edge by itself may pass right by the pole of its plane, where its angle turns at once;
      // the sum of an outline does not.
      {"clipped_edge_term", {100, 1e-3}},
      // Where edges or arcs pass a peak of GGX that is narrow and seen at a grazing angle.
      {"shade_polygon.exact", {40, 1e-3}},
      {"shade_polygon.exact, tilted", {40, 2e-4}},
      {"shade_polygon.adaptive", {40, 2e-4}},
      {"shade_polygon.adaptive, tilted", {40, 2e-4}},
      {"shade_sphere.exact", {100, 2e-4}},
      {"shade_tube.exact", {30, 2e-4}},
      // The axes of cells turn quickly where the lobe is nearly round on the light.
      {"emission_seen.diffuse", {50, 2e-4}},
      {"emission_seen.specular", {50, 2e-4}}};
  return all;
}

// The differences of two answers. Allowed are rounding of the result, relative where it exceeds 1:
// ten units in the last place; and four times what disturbed inputs make of it.
struct Comparison {
  struct Function {
    int beyond = 0;     // values that differ by more than is allowed
    double largest = 0; // of their differences
  };
  std::map<std::string, Function> functions = {};
  int flipped = 0;
  bool finite = true;

  template <class A, class B>
  void add(const Round& round, const std::vector<A>& a, const std::vector<B>& b) {
    for (int k = 0; k < round.outputs; ++k) {
      for (int i = 0; i < k_count; ++i) {
        const auto at = std::size_t(k * k_count + i);
        const double x = double(a[at]), y = double(b[at]), size = std::max(std::abs(y), 1.0);
        const double difference = std::abs(x - y);
        if (!std::isfinite(x)) finite = false;
        if (is_choice(round.names[k])) {
          flipped += difference > 1e-3;
          continue;
        }
        Function& function = functions[round.names[k]];
        const double allowed = 10 * 0x1p-23 * size + 4 * double(round.uncertain[at]);
        function.beyond += !(difference <= allowed);
        if (!(difference <= allowed))
          function.largest = std::max(function.largest, difference / size);
      }
    }
  }

  void check() const {
    for (const auto& entry : functions) {
      const std::string& name = entry.first;
      const Function& function = entry.second;
      const auto found = exceptions().find(name);
      const Beyond beyond = found != exceptions().end() ? found->second : Beyond{};
      CAPTURE(name);
      CHECK(function.beyond <= beyond.count);
      if (function.beyond > 0) {
        MESSAGE(name, ": ", function.beyond, " beyond, largest ", function.largest);
        CHECK(function.largest <= beyond.largest);
      }
    }
    CHECK(finite);
  }
};

void check_lanes(testing::ParityRun run, int lanes) {
  Comparison result;
  for (const Round& round : rounds()) {
    std::vector<float> vector(round.single.size());
    CHECK(run(round.batch.in.data(), k_count, round.resources(), vector.data()) == round.outputs);
    result.add(round, vector, round.single);
  }
  MESSAGE(lanes, " lanes; choices that fell differently: ", result.flipped);
  result.check();
  CHECK(result.flipped <= 5);
}

} // namespace

TEST_CASE("float follows double in every function") {
  Comparison result;
  for (const Round& round : rounds())
    result.add(round, round.single, round.exact);
  MESSAGE("choices that fell differently: ", result.flipped);
  result.check();
  CHECK(result.flipped <= 20);
}

#ifdef OPENLTC_PARITY_BASELINE
TEST_CASE("lanes of the baseline instruction set agree with float") {
  check_lanes(testing::parity_run_baseline, testing::parity_lanes_baseline());
}
#endif

#ifdef OPENLTC_PARITY_SSE4
TEST_CASE("lanes of SSE4 agree with float") {
  if (!has_sse4()) {
    MESSAGE("skipped: this CPU has no SSE4");
    return;
  }
  CHECK(testing::parity_lanes_sse4() == 4);
  check_lanes(testing::parity_run_sse4, testing::parity_lanes_sse4());
}
#endif

#ifdef OPENLTC_PARITY_AVX2
TEST_CASE("lanes of AVX2 agree with float") {
  if (!has_avx2()) {
    MESSAGE("skipped: this CPU has no AVX2");
    return;
  }
  CHECK(testing::parity_lanes_avx2() == 8);
  check_lanes(testing::parity_run_avx2, testing::parity_lanes_avx2());
}
#endif

#ifdef OPENLTC_PARITY_AVX512
TEST_CASE("lanes of AVX-512 agree with float") {
  if (!has_avx512()) {
    MESSAGE("skipped: this CPU has no AVX-512");
    return;
  }
  CHECK(testing::parity_lanes_avx512() == 16);
  check_lanes(testing::parity_run_avx512, testing::parity_lanes_avx512());
}
#endif

TEST_CASE("what the dialect asks of its arguments is an assertion of every lane in debug builds") {
  std::vector<void (*)()> broken;
#ifdef OPENLTC_PARITY_BASELINE
  broken.push_back(testing::parity_break_baseline);
#endif
#ifdef OPENLTC_PARITY_SSE4
  if (has_sse4()) broken.push_back(testing::parity_break_sse4);
#endif
#ifdef OPENLTC_PARITY_AVX2
  if (has_avx2()) broken.push_back(testing::parity_break_avx2);
#endif
#ifdef OPENLTC_PARITY_AVX512
  if (has_avx512()) broken.push_back(testing::parity_break_avx512);
#endif
  for (void (*const break_precondition)() : broken) {
    const std::string words = test::last_words_of(break_precondition);
#ifdef NDEBUG
    CHECK(words == "");
#else
    CHECK(words.find("is_unit(n)") != std::string::npos);
#endif
  }
}
