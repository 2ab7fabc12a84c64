// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A picture of a scene: camera rays, surfaces, all lights in closed form or by the reference.

#pragma once

#include "openltc/base/progress.h"
#include "openltc/base/result.h"
#include "openltc/image/image.h"
#include "openltc/render/kernel_types.h"
#include "openltc/scene/scene.h"
#include "openltc/table/lobe_polynomial.h"
#include "openltc/table/lobe_table.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace openltc::render {

enum class PixelFilter {
  blackman_harris, ///< radius 1.5 pixels
  none,            ///< every camera ray through the middle of its pixel, to compare light alone
};

/// Pixels of a side of the tiles that a picture is made of.
inline constexpr int k_tile_side = 16;

/// Pixels from (x0, y0) to before (x1, y1), (0, 0) at the upper left. Each number is a multiple of
/// k_tile_side, or x1 the picture's width, y1 its height.
struct PixelWindow {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct RenderOptions {
  int width = 1280; ///< pixels
  int height = 720;
  Integrator integrator = Integrator::ltc;
  int samples = 8; ///< camera samples per pixel; the reference takes one light sample with each
  /// LTC: samples of the shadow ratio per pixel and area light, spread over its camera samples:
  /// half of them where neighbours agree, three times as many elsewhere (see shadow_ratio.h); 0 =
  /// no shadows at all. Reference: only whether it is 0.
  int shadow_samples = 16;
  /// Reference: whether polygon lights are sampled as the fitted lobe and the cosine have them, or
  /// by their solid angle, which is noisier. The mean is the same.
  bool lobe_samples = true;
  PixelFilter filter = PixelFilter::blackman_harris; ///< with more than one sample per pixel
  /// LTC, scenes of many area lights: how far the light of a surface point, in any channel, may be
  /// from that of all lights shaded one by one, as a fraction of what points like it reflect,
  /// shadows included, and never more than that of the view's level (see light_chooser.h,
  /// light_level.h). So much may be left out or taken from lights in groups. 0 = every light shades
  /// every point.
  float light_error = 0.003f;
  PunctualForm punctual_form = PunctualForm::exact;
  /// Of area lights, LTC; none: adaptive for lobes that were fitted to GGX and fewer area lights
  /// than k_many_lights, else the lobe alone.
  std::optional<SpecularForm> specular_form;
  /// Renders these pixels alone: the same values that they have in the whole picture of width x
  /// height, and a Picture of that size. None: all of them.
  std::optional<PixelWindow> window;
  Vec3f background{0, 0, 0}; ///< nits, where a ray meets nothing
  std::uint32_t seed = 0;
  int threads = 0;             ///< 0 = all cores; the picture does not depend on it
  std::string kernel = "auto"; ///< "auto" or a name of kernel_by_name
  Progress progress;           ///< of render(): told of each tile that is done; may stop it
};

/// Where shading has its lobes from: a table or a polynomial. A view; what it was made of must
/// outlive it.
struct LobeSource {
  LobeSource(const table::LobeTable& from) : table(from.view()), brdf(from.metadata.brdf) {}
  LobeSource(const table::LobePolynomial& from)
      : polynomial(from.view()), brdf(from.metadata.brdf) {}

  LobeTableView table;
  LobePolynomialView polynomial; ///< without coefficients when there is a table
  std::string brdf;              ///< that they were fitted to; empty where nobody says
};

/// From so many area lights on, groups of them are shaded together, which only one lobe by itself
/// lets them be as a whole: with a ratio or a second lobe 500 lights take twice as long.
inline constexpr std::size_t k_many_lights = 64;

/// The built-in lobes of the least error that take at most twice the time of the fastest (`openltc
/// plot trade`): two at every node; from k_many_lights area lights on, and where there are none,
/// one.
LobeSource builtin_lobes_for(const light::Lights& lights);

struct Picture {
  image::Image radiance; ///< scene-linear, in the scene's units (nits)
  /// Reference of several samples: standard error of each pixel's mean, per channel, from the
  /// variance of its camera samples; these are stratified, so it is an upper estimate. Else empty:
  /// the LTC integrator's shadow ratio is no mean.
  image::Image standard_error;
  /// LTC: the largest error in nits that the choice of lights made anywhere, at most; 0 where every
  /// light shaded every point. Where shadow ratios are 1 or 0 no pixel is further from such a
  /// picture, but for rounding; elsewhere there is the noise of shadows that are sampled together.
  double light_error_nits = 0;
  /// What shaded a surface point, on average: area lights one by one, and groups of far ones.
  double lights_per_point = 0, far_groups_per_point = 0;
  double build_seconds = 0; ///< acceleration structure, textures, light tree
  double render_seconds = 0;
  std::string kernel; ///< that shaded
  std::vector<std::string> warnings;
};

/// Renders `scene` from `camera`, with exactly the lights of scene.lights.
/// Fails with one line when an option is out of range, memory is short or options.progress asks it
/// to stop.
Result<Picture> render(const scene::Scene& scene, const scene::Camera& camera,
                       const LobeSource& lobes, const RenderOptions& options);

} // namespace openltc::render
