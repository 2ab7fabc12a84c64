// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One variant of lobe_sums; OPENLTC_VARIANT names it and the build sets the instruction set.
//
// With o = (m0 x + m1 z, y, m2 x + m3 z), q = 1/|o|^2 and d = det s / pi (lobe_fit.cpp):
//   D = o.z d q^2,
//   dD/dm0 = D g0 - 4 D o.x q x      dD/dm2 = D g2 + (d q^2 - 4 D o.z q) x
//   dD/dm1 = D g1 - 4 D o.x q z      dD/dm3 = D g3 + (d q^2 - 4 D o.z q) z
// with g the slopes of log(det s). All zero where o.z <= 0.

#include "openltc/fit/lobe_sums.h"

#include <cstring>

namespace openltc::fit {

namespace {

constexpr int k_width = 8;
typedef double Block __attribute__((vector_size(k_width * sizeof(double))));

inline void load(Block& to, const double* from) { std::memcpy(&to, from, sizeof(Block)); }

inline double sum(const Block& b) {
  return ((b[0] + b[4]) + (b[2] + b[6])) + ((b[1] + b[5]) + (b[3] + b[7]));
}

} // namespace

void OPENLTC_VARIANT(const LobeSumsInput& in, LobeSumsOutput& out) {
  const Block zero = {};
  Block value = zero, g[4] = {zero, zero, zero, zero};
  Block h[10] = {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
  for (std::size_t i = 0; i < in.count; i += k_width) {
    Block x, y, z, w, p;
    load(x, in.x + i);
    load(y, in.y + i);
    load(z, in.z + i);
    load(w, in.weight + i);
    load(p, in.density + i);

    const Block ox = in.m[0] * x + in.m[1] * z;
    const Block oz = in.m[2] * x + in.m[3] * z;
    const Block q = 1.0 / (ox * ox + y * y + oz * oz);
    const Block inside = oz > zero ? in.det * q * q : zero;
    const Block d = oz * inside;

    const Block r = d - p;
    const Block a = r < zero ? -r : r;
    const Block e = in.rounding * p + in.floor;
    const Block inverse = 1.0 / (a + e);
    const Block square = r * r;
    value += w * square * (in.tv * inverse + in.l2 + in.l3 * a);
    const Block omega =
        w * (in.tv * (a + 2.0 * e) * inverse * inverse + 2.0 * in.l2 + 3.0 * in.l3 * a);

    const Block four_dq = 4.0 * d * q;
    const Block by_x = -four_dq * ox, by_z = inside - four_dq * oz;
    const Block d0 = d * in.log_slope[0] + by_x * x, d1 = d * in.log_slope[1] + by_x * z;
    const Block d2 = d * in.log_slope[2] + by_z * x, d3 = d * in.log_slope[3] + by_z * z;
    const Block w0 = omega * d0, w1 = omega * d1, w2 = omega * d2, w3 = omega * d3;
    g[0] += w0 * r;
    g[1] += w1 * r;
    g[2] += w2 * r;
    g[3] += w3 * r;
    h[0] += w0 * d0;
    h[1] += w0 * d1;
    h[2] += w0 * d2;
    h[3] += w0 * d3;
    h[4] += w1 * d1;
    h[5] += w1 * d2;
    h[6] += w1 * d3;
    h[7] += w2 * d2;
    h[8] += w2 * d3;
    h[9] += w3 * d3;
  }
  out.value = sum(value);
  for (int k = 0; k < 4; ++k)
    out.gradient[k] = sum(g[k]);
  for (int k = 0; k < 10; ++k)
    out.hessian[k] = sum(h[k]);
}

} // namespace openltc::fit
