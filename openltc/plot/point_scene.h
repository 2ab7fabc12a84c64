// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// One point light over a floor, seen from the opposite side: the scene of source section 0.1.3, and
// what its highlight is, computed in double precision and rendered.
//
// World space: the floor is y = 0, the camera and the light stand in the plane x = 0, the plane of
// incidence, at the same distance and angle from the normal of the origin, so that there the light
// comes from the mirror direction. The camera is on the side of +z.

#pragma once

#include "openltc/base/result.h"
#include "openltc/fit/measure/error.h"
#include "openltc/image/image.h"
#include "openltc/render/renderer.h"
#include "openltc/scene/scene.h"

#include <vector>

namespace openltc::plot {

/// The floor, the light and where the camera is. Everything is grey.
struct PointSetup {
  double theta_degrees =
      60;                ///< of view and light at the mirror point, from the normal, 0..90, not 90
  double distance_m = 2; ///< of camera and light from the mirror point, > 0
  double intensity_cd = 1000; ///< of the light
  double metallic = 1;        ///< 0..1
  double base_color = 0.8;    ///< 0..1: albedo of the dielectric part, F0 of the metallic one
  double f0 = 0.04;           ///< 0..1: F0 of the dielectric part; F90 is 1
};

/// What the camera sees. Odd sizes: the middle pixel's ray meets the mirror point.
struct PointView {
  int width = 241, height = 181;
  double tan_half_height = 0.3; ///< tangent of half the vertical field of view

  int middle_column() const { return width / 2; }
  int middle_row() const { return height / 2; }
};

/// The view that holds the highlight of a roughness, from which the horizon stays out.
PointView frame_highlight(const PointSetup& setup, double roughness);

/// Where the ray through the middle of a pixel meets the floor: (x, z), metres.
Vec2d floor_at(const PointSetup& setup, const PointView& view, int column, int row);

/// The luminance of a point of the floor as the camera sees it, cd/m2, without shadow.
struct PointLuminance {
  double exact = 0; ///< by the BRDF itself: diffuse + D V F cos
  double ltc = 0;   ///< by the lobe's density, eval_surface_ltc of shade/surface.glsl

  double relative_difference() const { return exact > 0 ? ltc / exact - 1 : 0; }
};
PointLuminance shade_floor(const PointSetup& setup, double roughness,
                           const fit::LobeFunction& lobes, Vec2d floor);

/// A line of pixels through the highlight.
enum class Scan {
  along, ///< the middle column: in the plane of incidence, towards the light
  across ///< the middle row
};

/// One pixel of a scan.
struct ScanPoint {
  int column = 0, row = 0;
  double position_m = 0; ///< on the floor from the mirror point; towards the light, or to the right
  PointLuminance luminance;
};

/// All pixels of a line whose rays meet the floor, by ascending position.
std::vector<ScanPoint> scan_highlight(const PointSetup& setup, const PointView& view, Scan scan,
                                      double roughness, const fit::LobeFunction& lobes);

/// The floor and the light, for the renderer, and the camera.
scene::Scene make_point_scene(const PointSetup& setup, const PointView& view, double roughness);
scene::Camera make_point_camera(const PointSetup& setup, const PointView& view);

/// The same pixels by the renderer, cd/m2, one channel: rays through the middles of pixels.
struct PointPictures {
  image::Image exact; ///< render::PunctualForm::exact
  image::Image ltc;   ///< render::PunctualForm::ltc
};
Result<PointPictures> render_point(const PointSetup& setup, const PointView& view, double roughness,
                                   const render::LobeSource& lobes);

} // namespace openltc::plot
