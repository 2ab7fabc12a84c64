// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "bench/hard_reference.h"

#include "openltc/image/file.h"
#include "openltc/render/renderer.h"
#include "openltc/table/lobe_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace openltc::bench {

namespace {

// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::uint64_t hash = 14695981039346656037u;
  for (std::istreambuf_iterator<char> at(stream), end; at != end; ++at)
    hash = (hash ^ static_cast<unsigned char>(*at)) * 1099511628211u;
  return hash;
}

std::filesystem::path file_of(const std::filesystem::path& folder,
                              const std::filesystem::path& scene_file, int width, int height) {
  return folder / fmt::format("{}_{}x{}_{:016x}.exr", scene_file.stem().string(), width, height,
                              hash_of(scene_file));
}

// The number of samples is a layer of its own, so that picture and number cannot part.
Status save(const HardReference& reference, const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  image::Image samples(reference.radiance.width, reference.radiance.height, 1);
  std::fill(samples.data.begin(), samples.data.end(), float(reference.samples));
  const image::LayerView layers[] = {
      {"", &reference.radiance}, {"half", &reference.half}, {"samples", &samples}};
  return image::write_exr_views(file.string(), layers);
}

Result<HardReference> read(const std::filesystem::path& file) {
  HardReference reference;
  Result<image::Image> radiance = image::read_layer(file.string(), "");
  Result<image::Image> samples = image::read_layer(file.string(), "samples");
  Result<image::Image> half = image::read_layer(file.string(), "half");
  if (!radiance) return radiance.error();
  if (!samples) return samples.error();
  if (!half) return half.error();
  reference.radiance = std::move(*radiance);
  reference.half = std::move(*half);
  reference.samples = std::int64_t(samples->data.at(0));
  return reference;
}

Result<render::Picture> rendered(const scene::Scene& scene, int width, int height,
                                 std::int64_t samples, std::uint32_t seed) {
  render::RenderOptions options;
  options.width = width;
  options.height = height;
  options.integrator = render::Integrator::reference;
  options.filter = render::PixelFilter::none;
  options.shadow_samples = 0;
  options.samples = int(samples);
  options.seed = seed;
  return render::render(scene, scene.cameras.at(0), table::builtin_ggx_table(), options);
}

} // namespace

Result<HardReference> HardReferenceStore::load(const scene::Scene& scene,
                                               const std::filesystem::path& scene_file, int width,
                                               int height, std::int64_t samples) {
  const std::filesystem::path file = file_of(folder_, scene_file, width, height);
  if (!fresh_ && std::filesystem::exists(file)) return read(file);
  return render(scene, scene_file, width, height, samples);
}

Result<HardReference> HardReferenceStore::render(const scene::Scene& scene,
                                                 const std::filesystem::path& scene_file, int width,
                                                 int height, std::int64_t samples) {
  Result<render::Picture> first = rendered(scene, width, height, samples / 2, 98);
  if (!first) return first.error();
  Result<render::Picture> second = rendered(scene, width, height, samples / 2, 99);
  if (!second) return second.error();
  HardReference reference;
  reference.half = std::move(first->radiance);
  reference.radiance = std::move(second->radiance);
  for (std::size_t i = 0; i < reference.radiance.data.size(); ++i)
    reference.radiance.data[i] = 0.5f * (reference.radiance.data[i] + reference.half.data[i]);
  reference.samples = samples;
  reference.seconds = first->render_seconds + second->render_seconds;
  if (Status status = save(reference, file_of(folder_, scene_file, width, height)); !status)
    return status.error();
  return reference;
}

} // namespace openltc::bench
