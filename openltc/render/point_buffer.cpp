// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/point_buffer.h"

#include <algorithm>
#include <numeric>

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
  emission_.assign(padded, 0.0f);
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
  emission_[i] = std::max({p.emission.x, p.emission.y, p.emission.z});
  set_target(i, target);
}

// Arrays of the points of a range. The last register of all is filled with copies of the last
// point, so that every lane holds valid numbers.
ShadingBatch PointBuffer::batch(Range range) {
  for (std::size_t i = count_; i % k_batch_padding != 0; ++i) {
    for (auto& field : fields_)
      field[i] = field[count_ - 1];
    weight_[i] = 0;
    pixel_[i] = pixel_[count_ - 1];
    seed_[i] = seed_[count_ - 1];
    index_[i] = index_[count_ - 1];
  }
  ShadingBatch batch;
  batch.count = int(range.size());
  for (std::size_t f = 0; f < fields_.size(); ++f)
    batch.in[f] = fields_[f].data() + range.begin;
  for (std::size_t c = 0; c < 3; ++c)
    batch.out[c] = out_[c].data() + range.begin;
  batch.weight = weight_.data() + range.begin;
  batch.pixel = pixel_.data() + range.begin;
  batch.seed = seed_.data() + range.begin;
  batch.index = index_.data() + range.begin;
  return batch;
}

BatchBounds PointBuffer::measure(const Kernel& kernel, const KernelContext& context, Range range) {
  BatchBounds bounds;
  kernel.measure(context, batch(range), &bounds);
  return bounds;
}

std::size_t PointBuffer::split(Range range, PointField field) {
  const std::size_t half =
      std::max(range.size() / 2 / k_batch_padding, std::size_t(1)) * k_batch_padding;
  const std::vector<float>& key = fields_[std::size_t(field)];
  order_.resize(range.size());
  std::iota(order_.begin(), order_.end(), std::uint32_t(range.begin));
  std::nth_element(
      order_.begin(), order_.begin() + std::ptrdiff_t(half), order_.end(),
      [&](std::uint32_t a, std::uint32_t b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
  const auto reorder = [&](auto& values, auto& moved) {
    moved.resize(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i)
      moved[i] = values[order_[i]];
    std::copy(moved.begin(), moved.end(), values.begin() + std::ptrdiff_t(range.begin));
  };
  for (auto& values : fields_)
    reorder(values, moved_float_);
  reorder(weight_, moved_float_);
  reorder(emission_, moved_float_);
  for (auto* values : {&seed_, &index_, &pixel_, &sample_})
    reorder(*values, moved_uint_);
  return range.begin + half;
}

void PointBuffer::thin(Range range, std::size_t count, PointBuffer& to) const {
  count = std::min({count, range.size(), to.capacity_ - to.count_});
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t from = range.begin + (2 * k + 1) * range.size() / (2 * count);
    const auto i = std::uint32_t(to.count_);
    copy(from, {i, i, seed_[from], index_[from], 1.0f}, to);
  }
}

void PointBuffer::copy(std::size_t from, const PointTarget& target, PointBuffer& to) const {
  const std::size_t i = to.count_++;
  for (std::size_t f = 0; f < fields_.size(); ++f)
    to.fields_[f][i] = fields_[f][from];
  to.emission_[i] = emission_[from];
  to.set_target(i, target);
}

void PointBuffer::set_target(std::size_t i, const PointTarget& target) {
  seed_[i] = target.pixel_seed;
  index_[i] = target.sample_index;
  pixel_[i] = target.pixel;
  sample_[i] = target.sample;
  weight_[i] = target.weight;
}

void PointBuffer::shade(const Kernel& kernel, const KernelContext& context, Range range,
                        const ShadingBatch& batch, std::vector<Vec3f>& samples) {
  kernel.shade(context, batch);
  for (std::size_t i = range.begin; i < range.end; ++i)
    samples[sample_[i]] += Vec3f(out_[0][i], out_[1][i], out_[2][i]) * weight_[i];
}

void PointBuffer::shade(const Kernel& kernel, const KernelContext& context, Range range,
                        const Lighting& lighting, std::vector<Vec3f>& samples, RatioSums sums) {
  static constexpr std::int32_t none = 0; // an empty list is not the null that means all
  ShadingBatch chosen = batch(range);
  chosen.ratio_sums = sums.values.data();
  chosen.pixel_count = sums.pixel_count;
  chosen.part = sums.part;
  chosen.closed_sums = sums.closed;
  chosen.lights = lighting.lights.empty() ? &none : lighting.lights.data();
  chosen.slots = lighting.slots.data();
  chosen.light_count = int(lighting.lights.size());
  for (int i = 0; i < 2; ++i)
    chosen.far[i] = lighting.far[i];
  shade(kernel, context, range, chosen, samples);
}

void PointBuffer::shade(const Kernel& kernel, const KernelContext& context,
                        std::vector<Vec3f>& samples, std::vector<float>& ratio_sums,
                        int pixel_count) {
  if (count_ == 0) return;
  ShadingBatch every = batch(all());
  every.ratio_sums = ratio_sums.data();
  every.pixel_count = pixel_count;
  shade(kernel, context, all(), every, samples);
  clear();
}

} // namespace openltc::render
