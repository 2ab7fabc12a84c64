// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/point_buffer.h"

namespace openltc::render {

PointBuffer::PointBuffer(std::size_t capacity) : capacity_(capacity) {
  const std::size_t padded = capacity + k_batch_padding;
  for (auto& field : fields_)
    field.assign(padded, 0.0f);
  for (auto& channel : out_)
    channel.assign(padded, 0.0f);
  seed_.assign(padded, 0);
  index_.assign(padded, 0);
  pixel_.assign(padded, 0);
  sample_.assign(padded, 0);
  weight_.assign(padded, 0.0f);
}

void PointBuffer::add(const SurfacePoint& p, const PointTarget& target) {
  const std::size_t i = count_++;
  const auto put3 = [&](PointField field, Vec3f v) {
    fields_[std::size_t(field)][i] = v.x;
    fields_[std::size_t(field) + 1][i] = v.y;
    fields_[std::size_t(field) + 2][i] = v.z;
  };
  put3(k_position_x, p.position);
  put3(k_normal_x, p.normal);
  put3(k_geometric_x, p.geometric);
  put3(k_view_x, p.view);
  put3(k_albedo_r, p.albedo);
  put3(k_f0_r, p.f0);
  fields_[k_f90][i] = p.f90;
  fields_[k_roughness][i] = p.roughness;
  fields_[k_offset][i] = p.offset;
  seed_[i] = target.pixel_seed;
  index_[i] = target.sample_index;
  pixel_[i] = target.pixel;
  sample_[i] = target.sample;
  weight_[i] = target.weight;
}

// Arrays of the points, the last register filled with copies of the last point, so that every lane
// holds valid numbers.
ShadingBatch PointBuffer::batch() {
  for (std::size_t i = count_; i % k_batch_padding != 0; ++i) {
    for (auto& field : fields_)
      field[i] = field[count_ - 1];
    weight_[i] = 0;
    pixel_[i] = pixel_[count_ - 1];
    seed_[i] = seed_[count_ - 1];
    index_[i] = index_[count_ - 1];
  }
  ShadingBatch batch;
  batch.count = int(count_);
  for (std::size_t f = 0; f < fields_.size(); ++f)
    batch.in[f] = fields_[f].data();
  for (std::size_t c = 0; c < 3; ++c)
    batch.out[c] = out_[c].data();
  batch.weight = weight_.data();
  batch.pixel = pixel_.data();
  batch.seed = seed_.data();
  batch.index = index_.data();
  return batch;
}

BatchBounds PointBuffer::measure(const Kernel& kernel, const KernelContext& context) {
  BatchBounds bounds;
  kernel.measure(context, batch(), &bounds);
  return bounds;
}

void PointBuffer::shade(const Kernel& kernel, const KernelContext& context, ShadingBatch batch,
                        std::vector<Vec3f>& samples, std::vector<float>& ratio_sums,
                        int pixel_count) {
  batch.ratio_sums = ratio_sums.data();
  batch.pixel_count = pixel_count;
  kernel.shade(context, batch);
  for (std::size_t i = 0; i < count_; ++i)
    samples[sample_[i]] += Vec3f(out_[0][i], out_[1][i], out_[2][i]) * weight_[i];
  count_ = 0;
}

void PointBuffer::shade(const Kernel& kernel, const KernelContext& context,
                        const Lighting& lighting, std::vector<Vec3f>& samples,
                        std::vector<float>& ratio_sums, int pixel_count) {
  if (count_ == 0) return;
  static constexpr std::int32_t none = 0; // an empty list is not the null that means all
  ShadingBatch chosen = batch();
  chosen.lights = lighting.lights.empty() ? &none : lighting.lights.data();
  chosen.slots = lighting.slots.data();
  chosen.light_count = int(lighting.lights.size());
  chosen.far = lighting.far.data();
  chosen.far_count = int(lighting.far.size());
  chosen.far_slot = lighting.far_slot;
  shade(kernel, context, chosen, samples, ratio_sums, pixel_count);
}

void PointBuffer::shade(const Kernel& kernel, const KernelContext& context,
                        std::vector<Vec3f>& samples, std::vector<float>& ratio_sums,
                        int pixel_count) {
  if (count_ == 0) return;
  shade(kernel, context, batch(), samples, ratio_sums, pixel_count);
}

} // namespace openltc::render
