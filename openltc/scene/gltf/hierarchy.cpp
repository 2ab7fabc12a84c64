// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/hierarchy.h"

#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/tinygltf.h"

#include <fmt/format.h>

namespace openltc::scene::gltf {

namespace {

constexpr std::size_t k_max_depth = 4096;

Transform matrix_of(const tinygltf::Node& node, const std::string& field, Document& document) {
  Transform t;
  const auto& m = node.matrix; // column-major
  for (std::size_t c = 0; c < 4; ++c)
    t.column[c] = Vec3d(m[4 * c], m[4 * c + 1], m[4 * c + 2]);
  const bool is_affine = m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
  if (!is_affine)
    document.warnings.add(
        fmt::format("{}.matrix: its last row is not (0, 0, 0, 1); it is ignored", field));
  return t;
}

Transform local_transform(const tinygltf::Node& node, const NodePose& pose,
                          const std::string& field, Document& document) {
  if (node.matrix.size() == 16) return matrix_of(node, field, document);
  Vec3d translation(0, 0, 0), scale(1, 1, 1);
  std::array<double, 4> rotation{0, 0, 0, 1};
  if (node.translation.size() == 3)
    translation = Vec3d(node.translation[0], node.translation[1], node.translation[2]);
  if (node.scale.size() == 3) scale = Vec3d(node.scale[0], node.scale[1], node.scale[2]);
  if (node.rotation.size() == 4)
    rotation = {node.rotation[0], node.rotation[1], node.rotation[2], node.rotation[3]};
  bool has_rotation = true;
  const Transform t =
      transform_of(pose.translation.value_or(translation), pose.rotation.value_or(rotation),
                   pose.scale.value_or(scale), has_rotation);
  if (!has_rotation)
    document.warnings.add(
        fmt::format("{}.rotation: it has no length; the node is not rotated", field));
  return t;
}

// Every node has at most one parent, and following parents ends. Returns the parents, -1 = none.
std::vector<int> checked_parents(const tinygltf::Model& model) {
  std::vector<int> parent(model.nodes.size(), -1);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    for (const int child : model.nodes[i].children) {
      int& known = parent[std::size_t(child)];
      if (known >= 0)
        fail(fmt::format("nodes[{}].children", i),
             fmt::format("nodes[{}] already is a child of nodes[{}]; a node has one parent, export "
                         "the file again",
                         child, known));
      known = int(i);
    }
  }
  std::vector<std::size_t> seen_from(model.nodes.size(), 0);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    int node = int(i);
    while (node >= 0 && seen_from[std::size_t(node)] == 0) {
      seen_from[std::size_t(node)] = i + 1;
      node = parent[std::size_t(node)];
    }
    if (node >= 0 && seen_from[std::size_t(node)] == i + 1)
      fail(fmt::format("nodes[{}].children", node),
           "the node is its own descendant; break the cycle and export again");
  }
  return parent;
}

std::vector<int> without_parent(const std::vector<int>& parent) {
  std::vector<int> roots;
  for (std::size_t i = 0; i < parent.size(); ++i)
    if (parent[i] < 0) roots.push_back(int(i));
  return roots;
}

class Walker {
public:
  Walker(Document& document, std::span<const NodePose> pose)
      : document_(document), nodes_(document.model->nodes), pose_(pose),
        visited_(nodes_.size(), false) {
    hierarchy_.to_world.resize(nodes_.size());
  }

  Hierarchy walk() {
    const tinygltf::Model& model = *document_.model;
    const std::vector<int> parent = checked_parents(model);
    const std::vector<int> trees = without_parent(parent);
    std::vector<int> roots = trees;
    if (model.defaultScene >= 0)
      roots = model.scenes[std::size_t(model.defaultScene)].nodes;
    else if (!model.scenes.empty())
      roots = model.scenes[0].nodes;
    walk_from(roots, true);
    walk_from(trees, false); // the others may be joints
    return std::move(hierarchy_);
  }

private:
  struct Pending {
    int node;
    std::size_t depth;
    Transform parent;
  };

  void walk_from(const std::vector<int>& roots, bool is_placed) {
    std::vector<Pending> stack;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
      stack.push_back({*root, 0, {}});
    while (!stack.empty()) {
      const Pending next = stack.back();
      stack.pop_back();
      const std::size_t index = std::size_t(next.node);
      const std::string field = fmt::format("nodes[{}]", next.node);
      if (visited_[index]) {
        if (is_placed) fail(field, "it is reached twice; a node may stand in one place only");
        continue;
      }
      visited_[index] = true;
      if (next.depth > k_max_depth)
        fail(field, fmt::format("nodes are nested deeper than {} levels; flatten the hierarchy",
                                k_max_depth));
      static const NodePose k_at_rest;
      const NodePose& pose = pose_.empty() ? k_at_rest : pose_[index];
      const Transform to_world =
          compose(next.parent, local_transform(nodes_[index], pose, field, document_));
      hierarchy_.to_world[index] = to_world;
      if (is_placed) hierarchy_.placed.push_back(next.node);
      const auto& children = nodes_[index].children;
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        stack.push_back({*child, next.depth + 1, to_world});
    }
  }

  Document& document_;
  const std::vector<tinygltf::Node>& nodes_;
  std::span<const NodePose> pose_;
  std::vector<bool> visited_;
  Hierarchy hierarchy_;
};

} // namespace

Hierarchy read_hierarchy(Document& document, std::span<const NodePose> pose) {
  return Walker(document, pose).walk();
}

} // namespace openltc::scene::gltf
