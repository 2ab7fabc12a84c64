// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// References of the hard scenes, kept in a folder and refined until their noise is small enough.

#pragma once

#include "openltc/base/result.h"
#include "openltc/image/image.h"
#include "openltc/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <utility>

namespace openltc::bench {

/// An unshadowed picture by the reference integrator, through the middle of each pixel: the mean of
/// two pictures of half its samples each, with seeds of their own. What they differ by says how
/// much noise there is, eight times less in such scenes than the integrator's own standard error,
/// which knows nothing of the stratification.
struct HardReference {
  image::Image radiance;    ///< nits, RGB
  image::Image half;        ///< the first of the two
  std::int64_t samples = 0; ///< per pixel, of both
  double seconds = 0;       ///< that this run spent on it; 0 if the folder had it
};

/// One scene's reference of one size. The file's name has the scene's name, the size and a hash of
/// the scene's bytes, so that a changed scene has a new reference; a changed integrator does not,
/// therefore `fresh` ignores what is there.
class HardReferenceStore {
public:
  HardReferenceStore(std::filesystem::path folder, bool fresh)
      : folder_(std::move(folder)), fresh_(fresh) {}

  /// What the folder has; without a file a reference of `samples` samples that is rendered.
  Result<HardReference> load(const scene::Scene& scene, const std::filesystem::path& scene_file,
                             int width, int height, std::int64_t samples);

  /// A reference of `samples` samples, even, rendered and kept.
  Result<HardReference> render(const scene::Scene& scene, const std::filesystem::path& scene_file,
                               int width, int height, std::int64_t samples);

private:
  std::filesystem::path folder_;
  bool fresh_;
};

} // namespace openltc::bench
