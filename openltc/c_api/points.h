// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The caller's arrays of points.

#pragma once

#include "openltc/api/surface.h"
#include "openltc/openltc_c.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace openltc::c_api {

/// Refuses points of which an array is null, or whose stride is shorter than what it leads over.
/// Writes nothing of them but through the error.
openltc_status check_points(const openltc_points* points);

/// The vector of point i.
Vec3f read_vector(const openltc_vectors& vectors, std::size_t i);

/// The material and the position error of point i; the latter's array is there.
Material read_material(const openltc_materials& materials, std::size_t i);
float read_number(const openltc_numbers& numbers, std::size_t i);

/// Point i, ready to be shaded: not `usable` where its data are no point.
Surface read_surface(const Lobes& lobes, const openltc_points& points, std::size_t i);

/// Points that are worked on together: long enough to be handed out, short enough for a cache.
inline constexpr std::size_t k_points_per_part = 512;

/// Calls work(begin, end) for parts of k_points_per_part that make up [0, count), on at most
/// `threads` threads; 0 = all, 1 = the calling one.
openltc_status for_ranges(std::size_t count, std::int32_t threads,
                          const std::function<void(std::size_t, std::size_t)>& work);

} // namespace openltc::c_api
