// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The lane builds of the parity test. Plain arrays only: nothing inline may be shared between files
// that are compiled for different instruction sets.

#pragma once

#include "openltc/target/resources.h"

namespace openltc::testing {

constexpr int k_parity_inputs = 30;
constexpr int k_parity_max_outputs = 384;

/// What the dialect looks up.
struct ParityResources {
  LobeTableView table;
  LobePolynomialView polynomial;
  PolygonView polygon;
  ProfileView profile;
  EmissionTextureView emission;
};

/// Evaluates `count` inputs, a multiple of 16: in[k * count + i] is input k of element i, out
/// likewise. Returns the number of outputs.
using ParityRun = int (*)(const float* in, int count, const ParityResources& resources, float* out);

int parity_run_baseline(const float*, int, const ParityResources&, float*);
int parity_run_sse4(const float*, int, const ParityResources&, float*);
int parity_run_avx2(const float*, int, const ParityResources&, float*);
int parity_run_avx512(const float*, int, const ParityResources&, float*);
int parity_lanes_baseline();
int parity_lanes_sse4();
int parity_lanes_avx2();
int parity_lanes_avx512();

/// Gives a normal that is no direction to a function that asks for one, in one lane.
void parity_break_baseline();
void parity_break_sse4();
void parity_break_avx2();
void parity_break_avx512();

} // namespace openltc::testing
