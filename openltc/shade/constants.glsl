// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Constants. CONSTANT is a compile-time scalar in every target.

/// pi
CONSTANT k_pi = 3.14159265358979323846;
/// 1 / pi
CONSTANT k_inv_pi = 0.31830988618379067154;
/// 1 / (2 pi)
CONSTANT k_half_inv_pi = 0.15915494309189533577;

/// Smallest microfacet width that shading uses: roughness 0.01. A perfect mirror has no finite
/// density; at this width the lobe is 0.01 degrees wide, below what a pixel resolves, and single
/// precision still carries it.
CONSTANT k_min_alpha = 1.0e-4;
/// The roughness of k_min_alpha.
CONSTANT k_min_roughness = 0.01;

/// What rounding may make of a distance of 0 from a plane, relative to that from the plane's origin:
/// four units in the last place of single precision.
CONSTANT k_plane_rounding = 2.5e-7;

/// Rounding of a position on a triangle in world space, relative to its distance from the origin: some
/// ten units in the last place of single precision.
CONSTANT k_position_rounding = 6.0e-7;

/// Length of the difference of two unit normals up to which they are the same: some ten units in the
/// last place of single precision.
CONSTANT k_normal_rounding = 1.0e-6;

/// Least share of a lobe above the horizon that its amplitude is divided by. Fitted lobes have 0.7
/// and more there; a lobe of a damaged table must not magnify rounding.
CONSTANT k_min_share = 0.01;

/// Most that a light's specular part is multiplied by (blended_ratio), so that it fades where a light
/// leaves the lobe, beyond whose own horizon there is nothing to multiply. Where the BRDF is so many times
/// the lobe, there is next to nothing of either.
CONSTANT k_max_ratio = 64.0;

/// Added under a division or a square root whose argument may vanish; far below any length in use.
CONSTANT k_tiny = 1.0e-30;

/// Added to the square of a length under an inverse root: the product of two inverse lengths, at most
/// 1e11 each, and an inverse sine, at most 1e15, stays finite.
CONSTANT k_least_length2 = 1.0e-22;
