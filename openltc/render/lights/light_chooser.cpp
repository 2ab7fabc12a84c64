// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The bound of light_tree is of light without shadow: certain, and blind. A lamp behind a wall has
// the same bound as one in front of it. What an error may be, and which light deserves a shadow of
// its own, is therefore asked of a few points of each range, by their own shadow rays: they shade
// with the choice at hand and tell how much they show, and what share of each light arrives. That
// decides costs and noise; it leaves no light out that the bound did not.

#include "openltc/render/lights/light_chooser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace openltc::render {

namespace {

// Costs in terms of shading one point by one light without shadow: bounding a node of the light
// tree for a range of points, shading by a far group, shading with shadow rays.
constexpr double k_choosing_cost = 40, k_far_cost = 0.2, k_traced_cost = 20;
constexpr double k_wide = 1; // points so far apart, or so turned, are split at once
// Lights of a range of points that have shadow rays of their own; dimmer ones share a ratio.
constexpr std::size_t k_most_traced = 16;
constexpr std::size_t k_most_probed = 4 * k_most_traced; // that may become one of those
constexpr std::size_t k_smallest_range = 32;             // points that are not split any more
constexpr std::size_t k_probe_points = 16;
// Of the points of a probe so many may be darker than the level that errors are measured against.
constexpr std::size_t k_darker_points = 3;
// What shows less than k_darkest, or more than k_brightest, of the view's level counts as that
// bright. With the default light error what is allowed in the dark is 3e-4 of that level, a fifth
// of the smallest step of 8 bits of sRGB when the level is shown as 18 % grey. The other bound
// keeps dark points among very bright ones.
constexpr double k_darkest = 0.1;
constexpr double k_brightest = 16;
// A choice that allows at most so much more than its range turns out to deserve is kept.
constexpr double k_near_enough = 1.25;

float largest(const Vec3f& v) { return std::max({v.x, v.y, v.z}); }

} // namespace

Lighting lighting_of(const LightChoice& choice) {
  Lighting lighting;
  lighting.lights = choice.exact;
  const FarGroup* groups = choice.far.data();
  lighting.far[0] = {groups, int(choice.far_open), 0, k_far_light_samples, nullptr};
  lighting.far[1] = {groups + choice.far_open, int(choice.far.size() - choice.far_open), 0,
                     k_hidden_light_samples, nullptr};
  return lighting;
}

LightChooser::LightChooser(const Kernel& kernel, const KernelContext& context,
                           const LightTree& tree, LightErrorScale scale)
    : kernel_(kernel), context_(context), tree_(tree), scale_(scale),
      light_spacing_(tree.spacing()), probe_(k_probe_points), probe_levels_(k_probe_points) {}

void LightChooser::light(PointBuffer& points, PointBuffer::Range range, const Shade& shade) {
  light(points, range, k_brightest * scale_.view_nits, false, shade);
}

void LightChooser::light(PointBuffer& points, PointBuffer::Range range, double level, bool measured,
                         const Shade& shade) {
  take_probe(points, range);
  const double emission = darker_emission();
  if (!measured) level = std::max(level, emission);
  const double tolerance = scale_.light_error * level;
  const bool traced = context_.trace != nullptr;
  const std::size_t most_exact = traced ? k_most_traced : LightTree::k_all_exact;
  const BatchBounds bounds = points.measure(kernel_, context_, range);
  const Width width = widest_field(bounds);
  bool split = range.size() >= 4 * k_smallest_range && width.relative > k_wide;
  if (!split) {
    // A range that has been measured goes on with the choice that was measured.
    if (measured)
      tree_.refine(bounds, tolerance, choice_);
    else
      tree_.choose(bounds, tolerance, choice_);
    if (range.size() >= 2 * k_smallest_range) {
      const double own = double(std::min(choice_.single_count, most_exact));
      const double exact = double(choice_.single_count) - own;
      const double groups = double(choice_.entries.size() - choice_.single_count);
      const double shading = double(range.size()) *
                             (own * (traced ? k_traced_cost : 1.0) + exact + k_far_cost * groups);
      split = shading * std::min(width.relative, 1.0) > k_choosing_cost * double(choice_.bounded);
    }
  }
  if (split) {
    const std::size_t middle = points.split(range, width.field);
    light(points, {range.begin, middle}, level, false, shade);
    light(points, {middle, range.end}, level, false, shade);
    return;
  }
  // What the range shows, and of which lights.
  tree_.arrange(traced ? k_most_probed : most_exact, choice_);
  const double shown = std::clamp(measure_level(), k_darkest * scale_.view_nits,
                                  k_brightest * scale_.view_nits + emission);
  if (level > k_near_enough * shown) {
    light(points, range, shown, true, shade);
    return;
  }
  tree_.arrange(most_exact, choice_);
  shade(range, choice_);
}

void LightChooser::take_probe(const PointBuffer& points, PointBuffer::Range range) {
  probe_.clear();
  points.thin(range, k_probe_points, probe_);
}

double LightChooser::darker_emission() {
  for (std::size_t p = 0; p < probe_.size(); ++p)
    probe_levels_[p] = probe_.emission(p);
  return darker_level();
}

double LightChooser::darker_level() {
  const std::size_t count = probe_.size();
  const std::size_t darker = std::min(k_darker_points * count / k_probe_points, count - 1);
  const auto begin = probe_levels_.begin();
  std::nth_element(begin, begin + std::ptrdiff_t(darker), begin + std::ptrdiff_t(count));
  return double(probe_levels_[darker]);
}

double LightChooser::measure_level() {
  const bool traced = context_.trace != nullptr;
  const std::size_t count = probe_.size();
  KernelContext context = context_;
  context.light_samples = 1;
  context.brdf_samples = 0;

  const std::size_t singles = choice_.exact.size(), slots = singles + 2;
  probe_slots_.resize(singles);
  for (std::size_t i = 0; i < singles; ++i)
    probe_slots_[i] = std::int32_t(i);
  probe_sums_.assign(traced ? slots * k_ratio_sum_count * count : 0, 0.0f);
  probe_radiance_.assign(count, Vec3f(0.0f));
  far_reach_.assign(2 * choice_.far.size(), 0.0f);
  Lighting lighting = lighting_of(choice_);
  lighting.slots = probe_slots_;
  for (int i = 0; i < 2; ++i)
    lighting.far[i].slot = std::int32_t(singles) + i;
  lighting.far[0].reach = far_reach_.data();
  lighting.far[1].reach = far_reach_.data() + 2 * choice_.far_open;
  probe_.shade(kernel_, context, probe_.all(), lighting, probe_radiance_,
               {probe_sums_, int(count)});

  if (traced) {
    for (std::size_t slot = 0; slot < slots; ++slot) {
      double reached = 0, all = 0;
      const bool far = slot >= singles;
      const float* radiance = far ? nullptr : context_.area_lights[choice_.exact[slot]].radiance;
      for (std::size_t p = 0; p < count; ++p) {
        const float* sums = probe_sums_.data() + slot * k_ratio_sum_count * count + p;
        float light[3];
        for (std::size_t c = 0; c < 3; ++c) {
          const float closed = sums[(k_closed_r + c) * count],
                      unshadowed = sums[(k_unshadowed_r + c) * count],
                      shadowed = sums[(k_shadowed_r + c) * count];
          const float ratio = unshadowed > 0 ? shadowed / unshadowed : 0;
          light[c] = closed * ratio * (radiance ? radiance[c] : 1.0f);
          reached += double(closed * ratio);
          all += double(closed);
        }
        probe_radiance_[p] += Vec3f(light[0], light[1], light[2]);
      }
      if (!far)
        choice_.entries[choice_.exact_entry[slot]].reach = all > 0 ? float(reached / all) : 0;
    }
    // A group of which no sample was drawn may reach the points.
    for (std::size_t g = 0; g < choice_.far.size(); ++g)
      choice_.entries[choice_.far_entry[g]].reach =
          far_reach_[2 * g] > 0 ? far_reach_[2 * g + 1] / far_reach_[2 * g] : 1;
  }
  for (std::size_t p = 0; p < count; ++p)
    probe_levels_[p] = largest(probe_radiance_[p]) + probe_.emission(p);
  return darker_level();
}

LightChooser::Width LightChooser::widest_field(const BatchBounds& bounds) const {
  static constexpr std::pair<int, PointField> fields[] = {
      {k_bound_position, k_position_x},     {k_bound_position + 1, k_position_y},
      {k_bound_position + 2, k_position_z}, {k_bound_normal, k_normal_x},
      {k_bound_normal + 1, k_normal_y},     {k_bound_normal + 2, k_normal_z}};
  Width widest;
  for (const auto& [bound, field] : fields) {
    const double extent = double(bounds.upper[bound]) - double(bounds.lower[bound]);
    const double relative = field < k_normal_x ? extent / light_spacing_ : extent;
    if (relative > widest.relative) widest = {field, relative};
  }
  return widest;
}

} // namespace openltc::render
