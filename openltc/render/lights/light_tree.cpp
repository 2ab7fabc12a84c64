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

#include "openltc/render/lights/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace openltc::render {

namespace {

// How much a light's direction counts beside its place when lights are grouped: opposite normals
// weigh four times the size of the group.
constexpr float k_direction_weight = 4.0f;
// A light has a shadow of its own, for it alone, if it is at least this share of all: the noise of
// shared shadows grows with what is in them.
constexpr double k_least_exact = 1.0 / 128;
// Refining goes on until so much of the tolerance is taken; the rest is for cheaper forms.
constexpr double k_refined_share = 0.8;
// Of a tolerance that refining has left over so much goes to leaving lights out.
constexpr double k_left_out_share = 0.5;

/// Place and direction of a light as six numbers.
std::array<float, 6> features(const LightExtent& e, float direction_scale) {
  const Vec3f p = (e.lower + e.upper) * 0.5f;
  const Vec3f n = (e.normal_lower + e.normal_upper) * (0.5f * direction_scale);
  return {p.x, p.y, p.z, n.x, n.y, n.z};
}

/// What a light counts when one is drawn. A group's is the sum of its lights'.
float sampling_power(const LightExtent& extent) {
  return std::min(extent.intensity.x + extent.intensity.y + extent.intensity.z, k_unbounded);
}

/// The lights of a branch, for drawing one.
LightNode sampling_node(std::span<const TreeLight> lights) {
  LightNode node{};
  LightExtent box = lights.front().extent;
  Vec3f axis(0.0f);
  double power = 0;
  bool any_direction = false;
  for (const TreeLight& light : lights) {
    const LightExtent& e = light.extent;
    box.lower = {std::min(box.lower.x, e.lower.x), std::min(box.lower.y, e.lower.y),
                 std::min(box.lower.z, e.lower.z)};
    box.upper = {std::max(box.upper.x, e.upper.x), std::max(box.upper.y, e.upper.y),
                 std::max(box.upper.z, e.upper.z)};
    any_direction = any_direction || length(e.normal_upper - e.normal_lower) > 0;
    axis += e.normal_lower;
    power += double(sampling_power(e));
  }
  float cos_spread = -1;
  if (!any_direction && length(axis) > 1.0e-3f * float(lights.size())) {
    axis = normalize(axis);
    cos_spread = 1;
    for (const TreeLight& light : lights)
      cos_spread = std::min(cos_spread, dot(axis, light.extent.normal_lower));
    cos_spread = std::max(cos_spread - 1.0e-5f, -1.0f);
  }
  const float lower[3] = {box.lower.x, box.lower.y, box.lower.z};
  const float upper[3] = {box.upper.x, box.upper.y, box.upper.z};
  const float towards[3] = {axis.x, axis.y, axis.z};
  std::copy_n(lower, 3, node.lower);
  std::copy_n(upper, 3, node.upper);
  std::copy_n(towards, 3, node.axis);
  node.cos_spread = cos_spread;
  node.sin_spread = std::sqrt(std::max(1 - cos_spread * cos_spread, 0.0f));
  node.power = float(std::min(power, double(k_unbounded)));
  return node;
}

} // namespace

LightTree::LightTree(std::span<const TreeLight> lights) {
  order_.resize(lights.size());
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(2 * lights.size());
  far_.reserve(2 * lights.size());
  sampling_nodes_.reserve(2 * lights.size());
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
  const TreeLight light = united(together);
  node.extent = light.extent;
  node.far_error = light.far_error;
  nodes_.push_back(node);
  far_.push_back(light.far);
  sampling_nodes_.push_back(sampling_node(together));
  if (members.size() == 1) {
    sampling_nodes_.back().light = members.front();
    return;
  }

  // Split in halves along the feature that differs most.
  const LightExtent& extent = node.extent;
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
  nodes_[index].right = sampling_nodes_[index].right = std::int32_t(nodes_.size());
  build(lights, begin + half, end);
}

double LightTree::spacing() const {
  if (nodes_.empty()) return 0;
  // As if they were spread over a square.
  const LightExtent& all = nodes_.front().extent;
  return double(length(all.upper - all.lower)) / std::sqrt(double(order_.size()));
}

void LightTree::choose(const BatchBounds& batch, double tolerance, LightChoice& choice) const {
  choice.singles.clear();
  choice.cut.clear();
  choice.cut_error = 0;
  choice.cut_unbounded = 0;
  choice.bounded = 0;
  if (!nodes_.empty()) add_to_cut(PreparedBatch(batch), 0, choice);
  refine(batch, tolerance, choice);
}

void LightTree::add_to_cut(const PreparedBatch& batch, std::int32_t node,
                           LightChoice& choice) const {
  const LightBound bound =
      bound_light(batch, nodes_[std::size_t(node)].extent, nodes_[std::size_t(node)].far_error);
  ++choice.bounded;
  if (bound.all <= 0) return;
  const float least = std::min(bound.all, bound.far_error);
  if (least < k_unbounded)
    choice.cut_error += double(least);
  else
    ++choice.cut_unbounded;
  choice.cut.push({least, node, bound});
}

void LightTree::refine(const BatchBounds& batch, double tolerance, LightChoice& choice) const {
  using Entry = LightChoice::Entry;
  const PreparedBatch prepared(batch);
  ErrorQueue<Entry>& cut = choice.cut;
  while (!cut.empty()) {
    if (choice.cut_unbounded == 0 && choice.cut_error <= k_refined_share * tolerance) {
      // Subtraction may have rounded; the sum decides.
      choice.cut_error = 0;
      cut.for_each([&](const Entry& entry) { choice.cut_error += double(entry.error); });
      if (choice.cut_error <= k_refined_share * tolerance) break;
    }
    const Entry entry = cut.pop();
    if (entry.error < k_unbounded)
      choice.cut_error -= double(entry.error);
    else
      --choice.cut_unbounded;
    const Node& node = nodes_[std::size_t(entry.node)];
    if (node.right == 0) {
      choice.singles.push_back(entry);
      continue;
    }
    add_to_cut(prepared, entry.node + 1, choice);
    add_to_cut(prepared, node.right, choice);
  }

  // Leave out what needs no more of the tolerance than a far form, and then what most of the rest
  // of it allows, dimmest first.
  std::vector<Entry>& entries = choice.entries;
  entries = choice.singles;
  choice.single_count = entries.size();
  double error = cut.empty() ? 0.0 : choice.cut_error;
  const auto more = [](const Entry& entry) {
    return double(entry.bound.all) - double(entry.bound.far_error);
  };
  const double kept = error + k_left_out_share * (tolerance - error);
  std::vector<Entry>& dim = choice.dim;
  dim.clear();
  cut.for_each([&](const Entry& entry) {
    if (more(entry) <= 0) return;
    (error + more(entry) <= kept ? dim : entries).push_back(entry);
  });
  std::sort(dim.begin(), dim.end(), [](const Entry& a, const Entry& b) {
    return a.bound.all != b.bound.all ? a.bound.all < b.bound.all : a.node < b.node;
  });
  for (const Entry& entry : dim) {
    if (error + more(entry) <= kept)
      error += more(entry);
    else
      entries.push_back(entry);
  }
  // What is left makes far forms plain, each by an equal part of it.
  const auto far = std::span(entries).subspan(choice.single_count);
  const double part = (tolerance - error) / double(std::max(far.size(), std::size_t(1)));
  for (Entry& entry : far) {
    const double dearer = double(entry.bound.plain_error) - double(entry.bound.far_error);
    entry.plain = dearer <= part;
    if (entry.plain) error += std::max(dearer, 0.0);
  }
  choice.error_nits = error;
}

FarGroup LightTree::group_of(const LightChoice::Entry& entry, bool exact) const {
  const Node& node = nodes_[std::size_t(entry.node)];
  const FarLight& far = far_[std::size_t(entry.node)];
  FarGroup group{};
  const float center[3] = {far.center.x, far.center.y, far.center.z};
  std::copy_n(center, 3, group.center);
  for (int c = 0; c < 3; ++c) {
    const float moment[3] = {far.moment[c].x, far.moment[c].y, far.moment[c].z};
    std::copy_n(moment, 3, group.moment[c]);
    const float first[3] = {far.first[c].x, far.first[c].y, far.first[c].z};
    std::copy_n(first, 3, group.first[c]);
  }
  const float channel[3] = {far.channel.x, far.channel.y, far.channel.z};
  std::copy_n(channel, 3, group.channel);
  std::copy_n(far.covariance, 6, group.covariance);
  group.specular = entry.bound.far_specular;
  group.plain = entry.plain;
  group.exact = exact;
  group.begin = node.begin;
  group.end = node.end;
  return group;
}

void LightTree::arrange(std::size_t most_exact, LightChoice& choice) const {
  // Of what a light may add, as much as reaches the points; a little for what may have been missed.
  const auto expected = [&](std::size_t i) {
    const LightChoice::Entry& e = choice.entries[i];
    return double(e.bound.likely) * (0.05 + 0.95 * double(e.reach));
  };
  std::vector<std::uint32_t>& own = choice.exact_entry;
  std::vector<std::uint32_t>& shared = choice.far_entry;
  own.clear();
  shared.clear();
  const auto node_of = [&](std::uint32_t i) -> const Node& {
    return nodes_[std::size_t(choice.entries[i].node)];
  };
  double all = 0;
  for (std::size_t i = 0; i < choice.entries.size(); ++i)
    all += expected(i);
  for (std::uint32_t i = 0; i < choice.entries.size(); ++i) {
    const bool single = i < choice.single_count;
    // A shadow of its own is for what counts; without shadows, what has no far form that will do.
    const bool shadowed =
        most_exact != k_all_exact && node_of(i).right == 0 && expected(i) >= k_least_exact * all;
    const bool alone =
        most_exact == k_all_exact ? single : shadowed || (single && !node_of(i).far_error.valid);
    (alone ? own : shared).push_back(i);
  }
  if (own.size() > most_exact)
    std::nth_element(own.begin(), own.begin() + std::ptrdiff_t(most_exact), own.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double ea = expected(a), eb = expected(b);
                       return ea != eb ? ea > eb : choice.entries[a].node < choice.entries[b].node;
                     });
  std::size_t kept = std::min(own.size(), most_exact);
  for (std::size_t i = kept; i < own.size(); ++i) {
    if (node_of(own[i]).far_error.valid)
      shared.push_back(own[i]);
    else
      own[kept++] = own[i];
  }
  own.resize(kept);
  const auto light_of = [&](std::uint32_t entry) {
    return order_[std::size_t(node_of(entry).begin)];
  };
  std::sort(own.begin(), own.end(),
            [&](std::uint32_t a, std::uint32_t b) { return light_of(a) < light_of(b); });
  choice.exact.clear();
  for (const std::uint32_t entry : own)
    choice.exact.push_back(light_of(entry));

  const auto hidden = std::stable_partition(
      shared.begin(), shared.end(), [&](std::uint32_t i) { return choice.entries[i].reach > 0; });
  choice.far.clear();
  choice.far_open = std::size_t(hidden - shared.begin());
  for (const std::uint32_t entry : shared)
    choice.far.push_back(group_of(choice.entries[entry], entry < choice.single_count));
  // Shares of the samples, by what is expected.
  const auto share = [&](std::size_t begin, std::size_t end) {
    double total = 0;
    for (std::size_t i = begin; i < end; ++i)
      total += expected(shared[i]);
    double running = 0;
    for (std::size_t i = begin; i < end; ++i) {
      running += expected(shared[i]);
      choice.far[i].cdf = float(running / total);
    }
    if (begin < end) choice.far[end - 1].cdf = 1;
  };
  share(0, choice.far_open);
  share(choice.far_open, shared.size());
}

} // namespace openltc::render
