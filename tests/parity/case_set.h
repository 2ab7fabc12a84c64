// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The cases that all targets run, and what they ought to give.

#pragma once

#include "openltc/api/polygon_packing.h"
#include "tests/parity/shader_case.h"
#include "tests/shade/lights/light_fixture.h"

#include <memory>
#include <vector>

namespace openltc::testing {

/// The cases of a shape.
struct CaseSet {
  CaseShape shape = CaseShape::quad;
  std::vector<float> numbers;        ///< k_case_count * k_case_numbers
  std::vector<PolygonView> polygons; ///< one a block; empty but of flat shapes
  std::vector<float> elements;       ///< of polygons, as shader files read them
  std::vector<std::shared_ptr<const TestPolygon>> outlines; ///< which the views of polygons show
  std::vector<std::unique_ptr<const PackedPolygon>> quads;  ///< and those of quads

  CaseBlock block(int index) const;
};

/// Of the lights of fuzz_lights: those of its seeds from 0 on, a block each.
CaseSet make_cases(CaseShape shape);

/// In double, without and with disturbed inputs.
struct ExpectedLight {
  std::vector<double> light; ///< k_case_count * k_case_outputs
  /// What inputs that are off by a few units in the last place make of it: no formula in single
  /// precision can be expected to be better.
  std::vector<float> uncertain;
};
ExpectedLight expected_light(const CaseSet& cases);

} // namespace openltc::testing
