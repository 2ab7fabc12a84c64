// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A cut through a tree of lights, refined where its error may be largest until the sum is allowed.
//
// Source: Walter, Fernandez, Arbree, Bala, Donikian, Greenberg 2005, "Lightcuts: A Scalable
// Approach to Illumination", sections 3 and 4. There a cut serves a pixel, a cluster is shaded by
// one of its lights and may err as much as it may contribute. Here a cut serves a batch of points,
// a cluster is left out or shaded as a patch in its centre, and that patch has an error bound of
// its own; both kinds of bound add up to one that holds for every point.

#include "openltc/render/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace openltc::render {

namespace {

// How much a light's direction counts beside its place when lights are grouped: opposite normals
// weigh four times the size of the group.
constexpr float k_direction_weight = 4.0f;

/// Place and direction of a light as six numbers.
std::array<float, 6> features(const LightExtent& e, float direction_scale) {
  const Vec3f p = (e.lower + e.upper) * 0.5f;
  const Vec3f n = (e.normal_lower + e.normal_upper) * (0.5f * direction_scale);
  return {p.x, p.y, p.z, n.x, n.y, n.z};
}

double power_of(const FarLight& far) {
  return double(length(far.moment[0]) + length(far.moment[1]) + length(far.moment[2]));
}

} // namespace

LightTree::LightTree(std::span<const TreeLight> lights) {
  order_.resize(lights.size());
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(2 * lights.size());
  if (!lights.empty()) build(lights, 0, std::int32_t(lights.size()));
  double sum = 0;
  cdf_.push_back(0);
  for (const std::int32_t i : order_) {
    sum += power_of(lights[std::size_t(i)].far);
    cdf_.push_back(float(sum));
  }
}

void LightTree::build(std::span<const TreeLight> lights, std::int32_t begin, std::int32_t end) {
  const std::size_t index = nodes_.size();
  const auto members = std::span(order_).subspan(std::size_t(begin), std::size_t(end - begin));
  Node node;
  node.begin = begin;
  node.end = end;
  std::vector<TreeLight> together;
  for (const std::int32_t i : members)
    together.push_back(lights[std::size_t(i)]);
  node.light = united(together);
  nodes_.push_back(node);
  if (members.size() == 1) return;

  // Split in halves along the feature that differs most.
  const LightExtent& extent = node.light.extent;
  const float scale = 0.5f * k_direction_weight * length(extent.upper - extent.lower);
  const auto features_of = [&](std::int32_t i) {
    return features(lights[std::size_t(i)].extent, scale);
  };
  std::array<float, 6> low = features_of(members.front()), high = low;
  for (const std::int32_t i : members) {
    const auto f = features_of(i);
    for (std::size_t k = 0; k < f.size(); ++k) {
      low[k] = std::min(low[k], f[k]);
      high[k] = std::max(high[k], f[k]);
    }
  }
  std::size_t widest = 0;
  for (std::size_t k = 1; k < low.size(); ++k)
    if (high[k] - low[k] > high[widest] - low[widest]) widest = k;
  const auto before = [&](std::int32_t a, std::int32_t b) {
    const float fa = features_of(a)[widest], fb = features_of(b)[widest];
    return fa != fb ? fa < fb : a < b;
  };
  const std::int32_t half = (end - begin) / 2;
  std::nth_element(members.begin(), members.begin() + half, members.end(), before);
  build(lights, begin, begin + half);
  nodes_[index].right = std::int32_t(nodes_.size());
  build(lights, begin + half, end);
}

double LightTree::spacing() const {
  if (nodes_.empty()) return 0;
  // As if they were spread over a square.
  const LightExtent& all = nodes_.front().light.extent;
  return double(length(all.upper - all.lower)) / std::sqrt(double(order_.size()));
}

std::size_t LightTree::choose(const BatchBounds& batch, double tolerance, std::size_t most_exact,
                              LightChoice& choice) const {
  using Entry = LightChoice::Entry;
  const PreparedBatch prepared(batch);
  std::vector<Entry>& cut = choice.cut;
  choice.leaves.clear();
  choice.exact.clear();
  choice.far.clear();
  cut.clear();
  double error = 0;  // of the bounded entries of the cut
  int unbounded = 0; // entries of the cut
  std::size_t bounded = 0;
  const auto before = [](const Entry& a, const Entry& b) {
    return a.error != b.error ? a.error < b.error : a.node < b.node;
  };
  const auto add = [&](std::int32_t node) {
    const TreeLight& light = nodes_[std::size_t(node)].light;
    const LightBound bound = bound_light(prepared, light);
    ++bounded;
    if (bound.all <= 0) return;
    const float least = std::min(bound.all, bound.far_error);
    if (least < k_unbounded)
      error += double(least);
    else
      ++unbounded;
    cut.push_back({least, node, bound});
    std::push_heap(cut.begin(), cut.end(), before);
  };
  const auto sum = [&] {
    double total = 0;
    for (const Entry& entry : cut)
      total += double(entry.error);
    return total;
  };

  if (!nodes_.empty()) add(0);
  while (!cut.empty()) {
    if (unbounded == 0 && error <= tolerance) {
      // Subtraction may have rounded; the sum decides.
      error = sum();
      if (error <= tolerance) break;
    }
    const Entry entry = cut.front();
    std::pop_heap(cut.begin(), cut.end(), before);
    cut.pop_back();
    if (entry.error < k_unbounded)
      error -= double(entry.error);
    else
      --unbounded;
    const Node& node = nodes_[std::size_t(entry.node)];
    if (node.right == 0) {
      choice.leaves.push_back(entry);
      continue;
    }
    add(entry.node + 1);
    add(node.right);
  }

  // Leave out what the rest of the tolerance allows, dimmest first.
  error = cut.empty() ? 0.0 : error;
  std::sort(cut.begin(), cut.end(), [](const Entry& a, const Entry& b) {
    return a.bound.all != b.bound.all ? a.bound.all < b.bound.all : a.node < b.node;
  });
  double bounds = 0;
  const auto add_group = [&](const Entry& entry, bool exact) {
    const Node& node = nodes_[std::size_t(entry.node)];
    const FarLight& far = node.light.far;
    FarGroup group;
    const float center[3] = {far.center.x, far.center.y, far.center.z};
    std::copy_n(center, 3, group.center);
    for (int c = 0; c < 3; ++c) {
      const float moment[3] = {far.moment[c].x, far.moment[c].y, far.moment[c].z};
      std::copy_n(moment, 3, group.moment[c]);
    }
    group.specular = entry.bound.far_specular;
    group.exact = exact;
    bounds += double(entry.bound.all);
    group.cdf = float(bounds);
    group.begin = node.begin;
    group.end = node.end;
    choice.far.push_back(group);
  };
  std::sort(choice.leaves.begin(), choice.leaves.end(), [](const Entry& a, const Entry& b) {
    return a.bound.all != b.bound.all ? a.bound.all > b.bound.all : a.node < b.node;
  });
  for (const Entry& entry : choice.leaves) {
    const Node& node = nodes_[std::size_t(entry.node)];
    if (choice.exact.size() >= most_exact && node.light.far.valid)
      add_group(entry, true);
    else
      choice.exact.push_back(order_[std::size_t(node.begin)]);
  }
  for (const Entry& entry : cut) {
    if (entry.bound.all <= entry.bound.far_error) continue;
    const double more = double(entry.bound.all) - double(entry.bound.far_error);
    if (error + more <= tolerance) {
      error += more;
      continue;
    }
    add_group(entry, false);
  }
  for (FarGroup& group : choice.far)
    group.cdf = float(double(group.cdf) / bounds);
  if (!choice.far.empty()) choice.far.back().cdf = 1;
  std::sort(choice.exact.begin(), choice.exact.end());
  choice.error_nits = error;
  return bounded;
}

} // namespace openltc::render
