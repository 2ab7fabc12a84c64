// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What engines use for area lights, from the formulas of the papers, in double: the error that is
// left is the method's own. For comparison only.
//
// Sources:
//   Hill & Heitz 2016, "Real-Time Area Lighting: a Journey from Research to Production", SIGGRAPH
//     course, "clipless" approximation;
//   Heitz & Hill 2017, "Real-Time Line- and Disk-Light Shading with Linearly Transformed Cosines".

#pragma once

#include "tests/shade/lights/light_fixture.h"

namespace openltc::testing {

/// Polygons: the vector irradiance of the unclipped outline, as of a sphere in that direction with
/// that form factor, cut by the horizon; the share that is left in closed form.
double published_polygon(const LightCase& light, const CaseView& view, const f64::Lobe& lobe);

/// The same with (l^2 + z)/(l + 1), l the vector's length and z its height, in place of the sphere.
double published_polygon_fit(const LightCase& light, const CaseView& view, const f64::Lobe& lobe);

/// Disks, ellipses and spheres (as the disk in which they are seen): the cone of the transformed
/// ellipse brought to its axes, form factor L1 L2 / sqrt((1 + L1^2)(1 + L2^2)) along its axis, cut
/// by the horizon as a sphere.
double published_ellipse(const LightCase& light, const CaseView& view, const f64::Lobe& lobe);

/// Lines, per metre of diameter: the diffuse line in closed form, transformed, its width scaled by
/// the transformation's stretch across it.
double published_line(const LightCase& light, const CaseView& view, const f64::Lobe& lobe);

/// Tubes: the line times the diameter and, with ends, their disks as points, R^2 pi D; at
/// most 1.
double published_tube(const LightCase& light, const CaseView& view, const f64::Lobe& lobe);

/// The one of these that belongs to a shape.
double published_integral(const LightCase& light, const CaseView& view, const f64::Lobe& lobe);

} // namespace openltc::testing
