// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Surface points under lights, as a shader reads them.

#pragma once

#include "openltc/target/resources.h"

namespace openltc::testing {

/// The shapes of shader files. Disks are ellipses too, tubes open, flat and round.
enum class CaseShape { quad, polygon, disk, sphere, tube, line };
constexpr int k_case_shapes = 6;

/// "quad": as `openltc shaders --shapes` has it.
const char* name_of(CaseShape shape);

/// Numbers of a case, seven vectors of four:
///   0  position, roughness          1  normal, albedo        2  direction to the eye, f0
///   3  normal of the triangle, form  4  a, radius           5  b, extra    6  c, 0
/// a, b, c as in LightBatch, or centre and half sides of a quad; extra: whether quads and disks are
/// two-sided, the caps of a tube, the first element of a polygon. Form 0 is by the lobe alone; in
/// form 1 its specular part is corrected in its mean direction (correct_at_mean); in form 2 a
/// normal map has turned the normal, and the triangle hides what is behind it
/// (set_geometric_normal).
constexpr int k_case_numbers = 28;
constexpr int k_case_forms = 3;

/// What is computed of a case: its diffuse and its specular light. A result is a vector of four.
constexpr int k_case_outputs = 2;
constexpr int k_case_result = 4;

/// Cases of a block share their form, quad or polygon, and caps.
constexpr int k_case_block = 16;

/// Of each shape. Blocks 0, 2, 4 ... are lights at random, 1, 3, 5 ... adversarial ones.
constexpr int k_case_count = 10240;

/// A block of cases in plain arrays: nothing inline may be shared between files that are compiled
/// for different instruction sets.
struct CaseBlock {
  CaseShape shape;
  const float* numbers; ///< k_case_block * k_case_numbers
  PolygonView polygon;
  LobePolynomialView polynomial;
};

/// What shader files make of a block, in single precision: k_case_block * k_case_result numbers.
using EvaluateBlock = void (*)(const CaseBlock& block, float* out);

void case_block_scalar(const CaseBlock&, float*);
void case_block_baseline(const CaseBlock&, float*);
void case_block_sse4(const CaseBlock&, float*);
void case_block_avx2(const CaseBlock&, float*);
void case_block_avx512(const CaseBlock&, float*);

/// A quad's case in double, from its numbers alone.
void shade_exact_quad(const double* numbers, double* out);

} // namespace openltc::testing
