// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   parity_cases write FOLDER                          the cases of every shape, and what C++ makes
//   of them parity_cases compare FOLDER SHAPE TARGET [FORMS]   how far FOLDER/TARGET_SHAPE.bin is
//   from double
//
// The first writes, for each shape: cases_SHAPE.bin, k_case_count * k_case_numbers floats;
// expected_SHAPE.bin, k_case_count * k_case_outputs doubles; uncertain_SHAPE.bin, as many floats
// (ExpectedLight); and TARGET_SHAPE.bin, k_case_count * k_case_result floats, for the targets
// scalar, sse4, avx2 ... that this CPU has, whose names it prints. Once for all: polygons.bin, four
// floats an element.
//
// The second prints a line of JSON: figures of lights at random on rough surfaces (roughness 0.2
// and more) and on smooth ones, and of adversarial ones. FORMS: only of those forms, the first of
// them.

#include "openltc/base/processor.h"
#include "tests/parity/case_set.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace openltc;
using namespace openltc::testing;

namespace {

struct Target {
  const char* name;
  EvaluateBlock evaluate;
};

std::vector<Target> targets() {
  std::vector<Target> list = {{"scalar", case_block_scalar}};
#ifdef OPENLTC_CASES_BASELINE
  list.push_back({"baseline", case_block_baseline});
#endif
#ifdef OPENLTC_CASES_SSE4
  if (has_sse4()) list.push_back({"sse4", case_block_sse4});
#endif
#ifdef OPENLTC_CASES_AVX2
  if (has_avx2()) list.push_back({"avx2", case_block_avx2});
#endif
#ifdef OPENLTC_CASES_AVX512
  if (has_avx512()) list.push_back({"avx512", case_block_avx512});
#endif
  return list;
}

[[noreturn]] void stop(const std::string& what) {
  std::fprintf(stderr, "parity_cases: %s\n", what.c_str());
  std::exit(2);
}

std::string path_of(const std::string& folder, const std::string& what, CaseShape shape) {
  return folder + "/" + what + "_" + name_of(shape) + ".bin";
}

template <class T> void write(const std::string& path, const std::vector<T>& values) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(values.data()),
             std::streamsize(values.size() * sizeof(T)));
  if (!file) stop("cannot write " + path);
}

template <class T> std::vector<T> read(const std::string& path, int each) {
  std::ifstream file(path, std::ios::binary);
  std::vector<T> values(std::size_t(k_case_count) * std::size_t(each));
  file.read(reinterpret_cast<char*>(values.data()), std::streamsize(values.size() * sizeof(T)));
  if (!file || file.peek() != std::ifstream::traits_type::eof())
    stop(path + " does not hold " + std::to_string(values.size()) + " numbers");
  return values;
}

CaseShape shape_of(const std::string& name) {
  for (int k = 0; k < k_case_shapes; ++k)
    if (name == name_of(CaseShape(k))) return CaseShape(k);
  stop("no shape " + name);
}

int write_cases(const std::string& folder) {
  for (int k = 0; k < k_case_shapes; ++k) {
    const CaseSet cases = make_cases(CaseShape(k));
    const ExpectedLight expected = expected_light(cases);
    write(path_of(folder, "cases", cases.shape), cases.numbers);
    write(path_of(folder, "expected", cases.shape), expected.light);
    write(path_of(folder, "uncertain", cases.shape), expected.uncertain);
    if (cases.shape == CaseShape::polygon) write(folder + "/polygons.bin", cases.elements);
    for (const Target& target : targets()) {
      std::vector<float> light(std::size_t(k_case_count) * k_case_result);
      for (int i = 0; i < k_case_count / k_case_block; ++i)
        target.evaluate(cases.block(i),
                        light.data() + std::size_t(i) * k_case_block * k_case_result);
      write(path_of(folder, target.name, cases.shape), light);
    }
  }
  for (const Target& target : targets())
    std::printf("%s\n", target.name);
  return 0;
}

// Differences, relative where the light exceeds 1.
struct Figures {
  std::vector<double> all;
  double sum = 0, largest = 0;
  int worst = -1;
  int beyond = 0;    // numbers that differ by more than inputs in single precision explain
  double excess = 0; // by how much at most
  int worst_excess = -1;
  int wrong = 0; // not a number, infinite or negative
};

void add(Figures& f, int index, double got, double expected, double uncertain) {
  const double size = std::max(std::abs(expected), 1.0);
  const double difference = std::abs(got - expected) / size;
  if (!std::isfinite(got) || got < 0) ++f.wrong;
  f.all.push_back(difference);
  f.sum += difference;
  if (!(difference <= f.largest)) { // a NaN counts as the largest
    f.largest = difference;
    f.worst = index;
  }
  // Six disturbances do not find the most.
  const double excess = difference - (10 * 0x1p-23 + 4 * uncertain / size);
  if (!(excess <= 0)) ++f.beyond;
  if (excess > f.excess) {
    f.excess = excess;
    f.worst_excess = index;
  }
}

int compare(const std::string& folder, CaseShape shape, const std::string& target, int forms) {
  const CaseSet cases = make_cases(shape);
  const std::vector<double> expected =
      read<double>(path_of(folder, "expected", shape), k_case_outputs);
  const std::vector<float> uncertain =
      read<float>(path_of(folder, "uncertain", shape), k_case_outputs);
  const std::vector<float> got = read<float>(path_of(folder, target, shape), k_case_result);
  const char* names[] = {"rough", "smooth", "adversarial"};
  Figures groups[3];
  for (int i = 0; i < k_case_count; ++i) {
    const float* numbers = cases.numbers.data() + std::size_t(i) * k_case_numbers;
    if (int(numbers[15]) >= forms) continue;
    const float roughness = numbers[3];
    const int group = i / k_case_block % 2 == 1 ? 2 : roughness >= 0.2f ? 0 : 1;
    for (int k = 0; k < k_case_outputs; ++k) {
      const std::size_t at = std::size_t(i) * k_case_outputs + std::size_t(k);
      add(groups[group], i, double(got[std::size_t(i) * k_case_result + std::size_t(k)]),
          expected[at], double(uncertain[at]));
    }
  }
  std::printf("{");
  for (int g = 0; g < 3; ++g) {
    Figures& f = groups[g];
    const auto rank = f.all.begin() + std::ptrdiff_t(0.99 * double(f.all.size() - 1));
    std::nth_element(f.all.begin(), rank, f.all.end());
    std::printf("%s\"%s\": {\"count\": %d, \"mean\": %.3g, \"p99\": %.3g, \"largest\": %.3g, "
                "\"worst\": %d, "
                "\"beyond\": %d, \"excess\": %.3g, \"worst_excess\": %d, \"wrong\": %d}",
                g > 0 ? ", " : "", names[g], int(f.all.size()), f.sum / double(f.all.size()), *rank,
                f.largest, f.worst, f.beyond, f.excess, f.worst_excess, f.wrong);
  }
  std::printf("}\n");
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::strcmp(argv[1], "write") == 0) return write_cases(argv[2]);
  if ((argc == 5 || argc == 6) && std::strcmp(argv[1], "compare") == 0)
    return compare(argv[2], shape_of(argv[3]), argv[4],
                   argc == 6 ? std::atoi(argv[5]) : k_case_forms);
  std::fprintf(stderr, "usage: parity_cases write FOLDER | compare FOLDER SHAPE TARGET [FORMS]\n");
  return 2;
}
