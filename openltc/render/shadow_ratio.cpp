// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/render/shadow_ratio.h"

#include "openltc/base/sampling.h"
#include "openltc/render/lights/light_chooser.h"

#include <algorithm>

namespace openltc::render {

namespace {

// Whose sums a slot holds, when no single light's: groups that reach the points, and those that do
// not.
constexpr std::int32_t k_far_lights = -1, k_hidden_lights = -2;

constexpr int k_neighbours = 2;        // pixels on each side that a ratio is compared with
constexpr int k_fewest_neighbours = 4; // a light that fewer pixels have is not known well
// In place of a ratio. Without: no first ray found any of the light. Apart: the pixel has none of
// it.
constexpr float k_without = -1.0f, k_apart = -2.0f;
constexpr float k_equal = 1.0e-3f;  // ratios that differ by less are rounding or glass
constexpr float k_unseen = 1.0e-2f; // of a pixel's light; the noise is a small part of that
constexpr std::uint32_t k_further = 0x6d6f7265u; // tells the numbers of further rays from the first

int divide_up(int a, int b) { return (a + b - 1) / b; }

float sum3(const float* sums, int field, std::size_t stride) {
  const float* p = sums + std::size_t(field) * stride;
  return p[0] + p[stride] + p[2 * stride];
}

} // namespace

ShadowPlan plan_shadows(int shadow_samples, int camera_samples) {
  const auto samples = [](int rays, int points) {
    return ShadowPlan::Samples{divide_up(rays, points),
                               std::min(divide_up(rays, 2 * points), k_max_brdf_samples)};
  };
  return {camera_samples, samples(divide_up(shadow_samples, 4), divide_up(camera_samples, 2)),
          samples(2 * shadow_samples, camera_samples)};
}

ShadowRatio::ShadowRatio(const Kernel& kernel, const KernelContext& context, const ShadowPlan& plan,
                         int columns)
    : kernel_(kernel), first_context_(context), more_context_(context), plan_(plan),
      columns_(columns), pixels_(columns * columns),
      slot_of_light_(std::size_t(context.area_light_count), -1), weight_(std::size_t(pixels_)),
      first_weight_(std::size_t(pixels_)), ratio_(std::size_t(pixels_)),
      level_(std::size_t(pixels_)), chosen_(k_most_points) {
  first_context_.light_samples = plan.first.of_light;
  first_context_.brdf_samples = plan.first.of_brdf;
  more_context_.light_samples = plan.more.of_light;
  more_context_.brdf_samples = plan.more.of_brdf;
}

void ShadowRatio::begin(int first, int count) {
  first_sample_ = first;
  first_count_ = divide_up(count, 2);
}

// Sums for the lights that this tile meets for the first time.
void ShadowRatio::give_slots(ShadedRange& shaded) {
  const LightChoice& choice = shaded.choice;
  const auto slot_for = [&](std::int32_t light, std::int32_t& slot) {
    if (slot < 0) {
      slot = std::int32_t(light_of_slot_.size());
      light_of_slot_.push_back(light);
    }
    return slot;
  };
  for (const std::int32_t light : choice.exact)
    shaded.slots.push_back(slot_for(light, slot_of_light_[std::size_t(light)]));
  if (choice.far_open > 0) slot_for(k_far_lights, far_slots_[0]);
  if (choice.far_open < choice.far.size()) slot_for(k_hidden_lights, far_slots_[1]);
  for (Sums* sums : {&total_, &first_, &more_})
    sums->resize(light_of_slot_.size() * k_ratio_sum_count * std::size_t(pixels_), 0.0f);
}

Lighting ShadowRatio::lighting(const ShadedRange& shaded) const {
  Lighting lighting = lighting_of(shaded.choice);
  lighting.slots = shaded.slots;
  for (int i = 0; i < 2; ++i)
    lighting.far[i].slot = far_slots_[i];
  return lighting;
}

void ShadowRatio::shade(PointBuffer& points, PointBuffer::Range range, const LightChoice& choice,
                        std::vector<Vec3f>& samples) {
  if (round_ended_) start_round();
  ranges_.push_back({range, choice, {}});
  give_slots(ranges_.back());
  points.shade(kernel_, first_context_, range, lighting(ranges_.back()), samples,
               {total_, pixels_, ShadingPart::closed});
  shade_first_rays(points, ranges_.back(), samples);
}

void ShadowRatio::shade_first_rays(const PointBuffer& points, const ShadedRange& shaded,
                                   std::vector<Vec3f>& samples) {
  // The first rays of a pixel are a sequence of their own, half as long as that of all its camera
  // samples, so that theirs too are spread over the squares of pixels.
  const int bits = bits_below(std::uint32_t(plan_.camera_samples));
  const int first_bits = bits_below(std::uint32_t(divide_up(plan_.camera_samples, 2)));
  chosen_.clear();
  for (std::size_t i = shaded.range.begin; i < shaded.range.end; ++i) {
    PointTarget target = points.target(i);
    weight_[target.pixel] += target.weight;
    const std::uint32_t sample = target.sample / std::uint32_t(pixels_); // of the round
    if (sample >= std::uint32_t(first_count_)) continue;
    target.sample_index =
        ((target.sample_index >> bits) << first_bits) + std::uint32_t(first_sample_ / 2) + sample;
    first_weight_[target.pixel] += target.weight;
    points.copy(i, target, chosen_);
  }
  if (!chosen_.empty())
    chosen_.shade(kernel_, first_context_, chosen_.all(), lighting(shaded), samples,
                  {first_, pixels_, ShadingPart::rays, total_.data()});
}

float ShadowRatio::radiance(std::size_t slot, int channel) const {
  const std::int32_t light = light_of_slot_[slot];
  return light < 0 ? 1.0f : first_context_.area_lights[light].radiance[channel];
}

void ShadowRatio::read_ratios(std::size_t slot) {
  const std::size_t n = std::size_t(pixels_);
  const float *closed = sums_of(total_, slot), *rays = sums_of(first_, slot);
  for (std::size_t p = 0; p < n; ++p) {
    const float found = sum3(rays + p, k_unshadowed_r, n);
    ratio_[p] = !(sum3(closed + p, k_closed_r, n) > 0) ? k_apart
                : found > 0                            ? sum3(rays + p, k_shadowed_r, n) / found
                                                       : k_without;
  }
}

float ShadowRatio::light_of(std::size_t slot, std::size_t pixel) const {
  const float* closed = sums_of(total_, slot) + pixel;
  float light = 0;
  for (int c = 0; c < 3; ++c)
    light += closed[c * pixels_] * radiance(slot, c);
  return light;
}

// How much the ratios differ around a pixel; 1 where too little is known.
float ShadowRatio::ratio_spread(int x, int y) const {
  if (ratio_[std::size_t(y * columns_ + x)] == k_without) return 1;
  float low = 1, high = 0;
  int known = 0;
  const int last = columns_ - 1;
  for (int v = std::max(y - k_neighbours, 0); v <= std::min(y + k_neighbours, last); ++v)
    for (int u = std::max(x - k_neighbours, 0); u <= std::min(x + k_neighbours, last); ++u) {
      const float ratio = ratio_[std::size_t(v * columns_ + u)];
      if (ratio < 0) continue;
      low = std::min(low, ratio);
      high = std::max(high, ratio);
      ++known;
    }
  return known < k_fewest_neighbours ? 1.0f : high - low;
}

void ShadowRatio::find_disagreement(const std::vector<Vec3f>& samples) {
  const std::size_t n = std::size_t(pixels_), slots = light_of_slot_.size();
  wants_more_.assign(slots * n, 0);
  slot_wants_more_.assign(slots, 0);
  std::fill(level_.begin(), level_.end(), 0.0f);
  for (std::size_t i = 0; i < samples.size(); ++i)
    level_[i % n] += samples[i].x + samples[i].y + samples[i].z;
  for (std::size_t slot = 0; slot < slots; ++slot) {
    read_ratios(slot);
    for (std::size_t p = 0; p < n; ++p)
      if (ratio_[p] > 0) level_[p] += light_of(slot, p) * ratio_[p];
  }
  for (std::size_t slot = 0; slot < slots; ++slot) {
    read_ratios(slot);
    for (int y = 0; y < columns_; ++y)
      for (int x = 0; x < columns_; ++x) {
        const std::size_t p = std::size_t(y * columns_ + x);
        const float light = ratio_[p] == k_apart ? 0.0f : light_of(slot, p);
        if (!(light > k_unseen * level_[p])) continue;
        const float spread = ratio_spread(x, y);
        if (spread > k_equal && light * spread > k_unseen * level_[p])
          wants_more_[slot * n + p] = slot_wants_more_[slot] = 1;
      }
  }
}

void ShadowRatio::shade_more_rays(const PointBuffer& points, std::vector<Vec3f>& samples) {
  for (const ShadedRange& shaded : ranges_) {
    const auto shade_slot = [&](std::int32_t slot, const Lighting& part) {
      if (!slot_wants_more_[std::size_t(slot)]) return;
      const std::uint8_t* wanted = wants_more_.data() + std::size_t(slot) * std::size_t(pixels_);
      chosen_.clear();
      for (std::size_t i = shaded.range.begin; i < shaded.range.end; ++i) {
        PointTarget target = points.target(i);
        if (!wanted[target.pixel]) continue;
        target.pixel_seed = hash_combine(target.pixel_seed, k_further);
        points.copy(i, target, chosen_);
      }
      if (!chosen_.empty())
        chosen_.shade(kernel_, more_context_, chosen_.all(), part, samples,
                      {more_, pixels_, ShadingPart::rays, total_.data()});
    };
    const Lighting all = lighting(shaded);
    for (std::size_t k = 0; k < all.lights.size(); ++k) {
      Lighting one;
      one.lights = all.lights.subspan(k, 1);
      one.slots = all.slots.subspan(k, 1);
      shade_slot(shaded.slots[k], one);
    }
    for (int i = 0; i < 2; ++i) {
      if (all.far[i].count == 0) continue;
      Lighting far;
      far.far[i] = all.far[i];
      far.far[i].samples = all.far[i].samples / 2;
      shade_slot(far_slots_[i], far);
    }
  }
}

// The sums of a round join those before it. First and further rays are weighted by their number,
// each brought to all camera samples of the round.
void ShadowRatio::add_up() {
  const std::size_t n = std::size_t(pixels_);
  const auto rays = [](const ShadowPlan::Samples& s) { return float(s.of_light + s.of_brdf); };
  const float first_rays = rays(plan_.first) * (plan_.camera_samples > 1 ? 0.5f : 1.0f);
  const float first_share = first_rays / (first_rays + rays(plan_.more));
  for (std::size_t slot = 0; slot < light_of_slot_.size(); ++slot) {
    const std::size_t begin = slot * k_ratio_sum_count * n;
    float* total = total_.data() + begin;
    const float *first = first_.data() + begin, *more = more_.data() + begin;
    for (std::size_t p = 0; p < n; ++p) {
      float a = first_weight_[p] > 0 ? weight_[p] / first_weight_[p] : 0.0f, b = 0;
      if (wants_more_[slot * n + p]) {
        b = a > 0 ? 1 - first_share : 1.0f;
        a *= first_share;
      }
      for (std::size_t i = k_unshadowed_r * n + p; i < k_ratio_sum_count * n; i += n)
        total[i] += a * first[i] + b * more[i];
    }
  }
}

void ShadowRatio::start_round() {
  for (Sums* sums : {&first_, &more_})
    std::fill(sums->begin(), sums->end(), 0.0f);
  for (auto* weights : {&weight_, &first_weight_})
    std::fill(weights->begin(), weights->end(), 0.0f);
  ranges_.clear();
  round_ended_ = false;
}

void ShadowRatio::finish(const PointBuffer& points, std::vector<Vec3f>& samples) {
  find_disagreement(samples);
  shade_more_rays(points, samples);
  add_up();
  round_ended_ = true;
}

// The closed form times the ratio of shadowed to unshadowed light. Where the samples found none of
// a channel, that of all channels; where they found none at all, no ray was open.
Vec3d ShadowRatio::light(std::size_t pixel) const {
  const std::size_t n = std::size_t(pixels_);
  Vec3d total(0.0);
  for (std::size_t slot = 0; slot < light_of_slot_.size(); ++slot) {
    const float* sums = sums_of(total_, slot) + pixel;
    const double found = double(sum3(sums, k_unshadowed_r, n));
    const double ratio_of_all = found > 0 ? double(sum3(sums, k_shadowed_r, n)) / found : 0.0;
    const auto channel = [&](std::size_t c) {
      const double closed = double(sums[(k_closed_r + c) * n]),
                   unshadowed = double(sums[(k_unshadowed_r + c) * n]),
                   shadowed = double(sums[(k_shadowed_r + c) * n]);
      const double ratio = unshadowed > 0 ? shadowed / unshadowed : ratio_of_all;
      return closed * ratio * double(radiance(slot, int(c)));
    };
    total += Vec3d(channel(0), channel(1), channel(2));
  }
  return total;
}

} // namespace openltc::render
