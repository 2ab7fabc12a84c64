// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Values between the keys of an animation: glTF 2.0 specification, appendix C, "Animation Sampler
// Interpolation Modes".

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace openltc::scene {

enum class Interpolation { step, linear, cubic_spline };

/// Where a time lies among keys: between key `first` and the next one, or at `first` alone.
struct KeySpan {
  std::size_t first = 0;
  bool at_key = true;  ///< the value of `first`, nothing is interpolated
  double fraction = 0; ///< of the way to the next key, 0 .. 1
  double seconds = 0;  ///< from `first` to the next key
};

/// `times` ascend, at least one. Before the first key and behind the last the nearest one counts.
KeySpan find_span(std::span<const double> times, double seconds, Interpolation interpolation);

/// The value at `at`, as many numbers as a key has. `from` and `to` are the keys at both ends, each
/// `size` numbers, or three times as many for a cubic spline: in-tangents, values, out-tangents.
/// `to` is not read when at.at_key. A rotation is a quaternion x y z w, `size` = 4: it takes the
/// shorter way on the sphere and comes back with unit length, unless it has none.
std::vector<double> value_at(const KeySpan& at, std::span<const double> from,
                             std::span<const double> to, std::size_t size,
                             Interpolation interpolation, bool is_rotation);

} // namespace openltc::scene
