// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Scenes and nodes: glTF 2.0 specification, section 3.5. A skinned mesh stands where its joints
// are, whatever its node says: section 3.7.3.3.

#include "openltc/scene/gltf/node.h"

#include "openltc/light/light_list.h"
#include "openltc/scene/gltf/camera.h"
#include "openltc/scene/gltf/file/accessor.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"
#include "openltc/scene/gltf/file/tinygltf.h"
#include "openltc/scene/gltf/instances.h"
#include "openltc/scene/gltf/light/extras_light.h"
#include "openltc/scene/gltf/light/lamp.h"
#include "openltc/scene/gltf/light/light.h"
#include "openltc/scene/gltf/material.h"
#include "openltc/scene/gltf/primitive.h"
#include "openltc/scene/gltf/skin.h"
#include "openltc/scene/mesh_transform.h"
#include "openltc/scene/scene_origin.h"
#include "openltc/scene/transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <utility>

namespace openltc::scene::gltf {

namespace {

// Instances are copies, so that a small file can ask for any number of triangles.
constexpr std::size_t k_max_triangles = std::size_t(1) << 28;

bool is_in_range(Vec3d p) { // false for NaN
  return std::abs(p.x) <= light::k_max_metres && std::abs(p.y) <= light::k_max_metres &&
         std::abs(p.z) <= light::k_max_metres;
}

// Twice through the nodes: where the meshes are decides where the origin of single-precision
// coordinates is, and only then is anything placed.
class Placer {
public:
  Placer(Document& document, std::span<const NodePose> pose, Imported& imported)
      : document_(document), model_(*document.model), pose_(pose), imported_(imported),
        scene_(imported.scene) {}

  void place() {
    if (!model_.scenes.empty())
      scene_.describes_lights =
          names_lights(model_.scenes[std::size_t(std::max(model_.defaultScene, 0))].extensions);
    Hierarchy hierarchy = read_hierarchy(document_, pose_);
    imported_.to_world = std::move(hierarchy.to_world);
    for (const int node : hierarchy.placed)
      collect(node);
    scene_.origin = (has_meshes_ ? of_meshes_ : of_others_).origin();
    auto next = placements_.begin();
    for (const int node : hierarchy.placed) {
      const std::size_t first_mesh = scene_.meshes.size();
      for (; next != placements_.end() && next->node == node; ++next)
        place_mesh(*next);
      place_others(node, first_mesh);
    }
    if (scene_.meshes.empty() && !first_without_area_.empty())
      fail(first_without_area_,
           "none of the scene's triangles has an area, so that there is nothing "
           "to see; check positions, indices and node scales");
  }

private:
  // A mesh in its own space, for one or more places.
  struct Local {
    Mesh mesh;
    std::size_t uses = 0;
  };
  struct MeshPlacement {
    int node;
    std::size_t local; // into locals_
    Transform to_world;
  };
  using Key = std::tuple<std::size_t, std::size_t, std::vector<double>>; // mesh, primitive, weights

  std::string label(int node) const {
    return node_label(std::size_t(node), model_.nodes[std::size_t(node)].name);
  }

  Transform to_scene(Transform to_world) const {
    to_world.column[3] = to_world.column[3] - scene_.origin;
    return to_world;
  }

  // --- first pass ------------------------------------------------------------------------------

  void collect(int index) {
    const tinygltf::Node& node = model_.nodes[std::size_t(index)];
    const Transform& to_world = imported_.to_world[std::size_t(index)];
    if (node.mesh >= 0) collect_mesh(index, to_world);
    const bool has_other =
        node.camera >= 0 || !node.extensions.empty() || document_.extras[std::size_t(index)].light;
    if (has_other && is_in_range(to_world.column[3]))
      of_others_.add(to_world.column[3], to_world.column[3], 1);
  }

  void collect_mesh(int index, const Transform& to_world) {
    const std::size_t node = std::size_t(index);
    const std::size_t mesh = std::size_t(model_.nodes[node].mesh);
    Deformation deformation;
    deformation.weights = weights_of(node);
    const int skin = document_.node_skins[node];
    std::vector<Transform> joints;
    Vec3d reference{0, 0, 0};
    if (skin >= 0) joints = joints_of(std::size_t(skin), index);
    if (!joints.empty()) {
      // Near the vertices, which are in single precision until the origin is known.
      reference = joints[0].point(first_position_of(mesh));
      for (Transform& joint : joints)
        joint.column[3] = joint.column[3] - reference;
      deformation.joints = joints;
    }
    const std::vector<Transform> instances = read_instances(document_, node);
    if (instances.size() != 1 && !joints.empty())
      document_.warnings.add(label(index) + ": a mesh with a skin has no instances; one is shown");
    for (std::size_t p = 0; p < model_.meshes[mesh].primitives.size(); ++p) {
      bool is_skinned = false;
      const std::size_t local = local_mesh(mesh, p, deformation, is_skinned);
      if (locals_[local].mesh.triangles.empty()) {
        if (!locals_[local].mesh.positions.empty()) note_without_area(mesh, p);
        continue;
      }
      if (is_skinned) {
        add_placement({index, local, translation(reference)});
        continue;
      }
      for (const Transform& instance : instances)
        add_placement({index, local, compose(to_world, instance)});
    }
  }

  // Of the morph targets: the animation's, else the node's own, else the mesh's.
  std::vector<double> weights_of(std::size_t node) const {
    if (!pose_.empty() && pose_[node].weights) return *pose_[node].weights;
    const tinygltf::Node& from = model_.nodes[node];
    const std::vector<double>& weights =
        from.weights.empty() ? model_.meshes[std::size_t(from.mesh)].weights : from.weights;
    return weights;
  }

  std::vector<Transform> joints_of(std::size_t skin, int node) {
    try {
      return joint_transforms(document_, skin, imported_.to_world);
    } catch (const Failure& failure) {
      document_.warnings.add(
          fmt::format("{}; the mesh of {} is not bent", failure.message, label(node)));
      return {};
    }
  }

  // Any vertex of the mesh; the origin where there is none.
  Vec3d first_position_of(std::size_t mesh) const {
    for (const auto& primitive : model_.meshes[mesh].primitives) {
      const auto position = primitive.attributes.find("POSITION");
      const bool is_plain = position != primitive.attributes.end() &&
                            primitive.extensions.count("KHR_draco_mesh_compression") == 0 &&
                            model_.accessors[std::size_t(position->second)].count > 0;
      if (!is_plain) continue;
      const Floats first = read_floats(document_, position->second, 0, 1);
      if (first.components == 3 && std::isfinite(first.values[0]) &&
          std::isfinite(first.values[1]) && std::isfinite(first.values[2]))
        return {double(first.values[0]), double(first.values[1]), double(first.values[2])};
    }
    return {0, 0, 0};
  }

  // Read once for all nodes that show it alike.
  std::size_t local_mesh(std::size_t mesh, std::size_t primitive, const Deformation& deformation,
                         bool& is_skinned) {
    Key key(mesh, primitive, deformation.weights);
    const bool is_shared = deformation.joints.empty();
    if (is_shared)
      if (const auto found = known_.find(key); found != known_.end()) return found->second;
    int material = model_.meshes[mesh].primitives[primitive].material;
    if (material < 0) material = default_material();
    Primitive read =
        read_primitive(document_, mesh, primitive,
                       vertex_needs(scene_.materials[std::size_t(material)]), deformation);
    is_skinned = read.is_skinned;
    read.mesh.material = material;
    locals_.push_back({std::move(read.mesh)});
    if (is_shared) known_.emplace(std::move(key), locals_.size() - 1);
    return locals_.size() - 1;
  }

  void add_placement(MeshPlacement placement) {
    Local& local = locals_[placement.local];
    triangle_count_ += local.mesh.triangles.size();
    if (triangle_count_ > k_max_triangles)
      fail(fmt::format("nodes[{}]", placement.node),
           fmt::format("the scene has more than {} million triangles; reduce it",
                       k_max_triangles >> 20));
    const auto [lower, upper] = box_of(local.mesh.positions, placement.to_world);
    if (!is_in_range(lower) || !is_in_range(upper))
      fail(label(placement.node),
           fmt::format("its transform takes the mesh outside the usable range of coordinates, {:g} "
                       "m to each side; move or scale it",
                       light::k_max_metres));
    take_memory(*document_.scene_memory, mesh_memory(local.mesh),
                fmt::format("nodes[{}].mesh", placement.node));
    ++local.uses;
    has_meshes_ = true;
    of_meshes_.add(lower, upper, double(local.mesh.triangles.size()));
    placements_.push_back(std::move(placement));
  }

  // --- second pass -----------------------------------------------------------------------------

  void place_mesh(const MeshPlacement& placement) {
    Local& local = locals_[placement.local];
    const tinygltf::Node& node = model_.nodes[std::size_t(placement.node)];
    Mesh mesh;
    if (--local.uses == 0)
      mesh = std::move(local.mesh);
    else
      mesh = local.mesh;
    if (!node.name.empty()) mesh.name = node.name;
    mesh.node = placement.node;
    mesh.emits_light = document_.extras[std::size_t(placement.node)].emits_light;
    apply_transform(mesh, to_scene(placement.to_world));
    if (mesh.triangles.empty()) {
      document_.warnings.add_for_mesh(mesh.name,
                                      "its node's scale leaves it no area; it is left out");
      note_without_area(std::size_t(node.mesh), 0);
      return;
    }
    scene_.meshes.push_back(std::move(mesh));
  }

  void check_place(int node, const char* what) const {
    const Vec3d at = imported_.to_world[std::size_t(node)].column[3];
    if (is_in_range(at)) return;
    fail(label(node), fmt::format("its {} is at ({:g}, {:g}, {:g}), outside the usable range of "
                                  "coordinates, {:g} m to each side; move it",
                                  what, at.x, at.y, at.z, light::k_max_metres));
  }

  void place_others(int index, std::size_t first_mesh) {
    const tinygltf::Node& node = model_.nodes[std::size_t(index)];
    const NodeExtras& extras = document_.extras[std::size_t(index)];
    scene_.describes_lights = scene_.describes_lights || extras.describes_light ||
                              names_lights(node.extensions) ||
                              document_.lost_lights.contains(index);
    const Transform to_scene = this->to_scene(imported_.to_world[std::size_t(index)]);
    if (node.camera >= 0) {
      check_place(index, "camera");
      scene_.cameras.push_back(read_camera(document_, node.camera, to_scene, node.name));
    }
    const auto punctual = node.extensions.find("KHR_lights_punctual");
    if (punctual != node.extensions.end()) {
      const int light = punctual->second.Get("light").GetNumberAsInt();
      // A sun has no place.
      if (model_.lights[std::size_t(light)].type != "directional") check_place(index, "light");
      scene_.lights.punctual.push_back(read_punctual_light(document_, light, to_scene, node.name));
    }
    const auto area = node.extensions.find("EXT_lights_area");
    if (area != node.extensions.end()) {
      check_place(index, "light");
      read_area_light(document_, area->second.Get("light").GetNumberAsInt(), to_scene, node.name,
                      extras.surface_deviation, scene_.lights);
    }
    if (const IesNode* ies = document_.ies_lights.of_node(index)) {
      check_place(index, "light");
      read_ies_light(document_, *ies, to_scene, node.name, scene_.lights);
    }
    if (extras.light) place_extras_light(index, *extras.light, to_scene, first_mesh);
  }

  // KHR_lights_punctual, EXT_lights_image_based and so on, also one that is not known here.
  static bool names_lights(const tinygltf::ExtensionMap& extensions) {
    return std::any_of(extensions.begin(), extensions.end(), [](const auto& extension) {
      return extension.first.find("_lights_") != std::string::npos;
    });
  }

  // The light that the node's extras describe. The node's mesh, if there is one, shows it: its own
  // emission makes no lights, and shadow rays stop before it.
  void place_extras_light(int index, const nlohmann::json& properties, const Transform& to_scene,
                          std::size_t first_mesh) {
    const std::string& name = model_.nodes[std::size_t(index)].name;
    const std::string label = node_label(std::size_t(index), name);
    NodeLight found;
    found.node = index;
    std::swap(found.light.textures, scene_.lights.textures); // their indices go on
    try {
      check_place(index, "light");
      read_extras_light(properties, label, name.empty() ? label : name, to_scene, document_,
                        found.light);
    } catch (const Failure& failure) {
      document_.warnings.add(failure.message + "; the light is left out");
    }
    std::swap(found.light.textures, scene_.lights.textures);
    if (found.light.empty()) return;
    if (first_mesh < scene_.meshes.size()) {
      attach_mesh(label, std::span(scene_.meshes).subspan(first_mesh), scene_.materials,
                  found.light, document_.warnings);
    }
    light::append_lights(found.light, scene_.lights);
    imported_.extras_lights.push_back(std::move(found));
  }

  void note_without_area(std::size_t mesh_index, std::size_t primitive) {
    if (first_without_area_.empty())
      first_without_area_ = fmt::format("meshes[{}].primitives[{}]", mesh_index, primitive);
  }

  int default_material() {
    if (default_material_ < 0) {
      default_material_ = int(scene_.materials.size());
      scene_.materials.push_back({});
      scene_.materials.back().name = "default";
    }
    return default_material_;
  }

  Document& document_;
  const tinygltf::Model& model_;
  std::span<const NodePose> pose_;
  Imported& imported_;
  Scene& scene_;
  std::vector<Local> locals_;
  std::map<Key, std::size_t> known_; // those of locals_ that no skin bends
  std::vector<MeshPlacement> placements_;
  OriginFinder of_meshes_, of_others_;
  bool has_meshes_ = false;
  std::size_t triangle_count_ = 0;
  int default_material_ = -1;
  std::string first_without_area_;
};

} // namespace

std::uint64_t mesh_memory(const Mesh& mesh) {
  constexpr std::uint64_t k_triangle_of_tree = 128, k_geometry = 1024;
  return sizeof(Mesh) + k_geometry +
         mesh.triangles.size() * (sizeof(mesh.triangles[0]) + k_triangle_of_tree) +
         mesh.positions.size() * sizeof(Vec3f) + mesh.normals.size() * sizeof(Vec3f) +
         mesh.tangents.size() * sizeof(Vec4f) + mesh.tex_coord_0.size() * sizeof(Vec2f) +
         mesh.tex_coord_1.size() * sizeof(Vec2f) + mesh.colors.size() * sizeof(Vec4f);
}

void read_nodes(Document& document, std::span<const NodePose> pose, Imported& imported) {
  Placer(document, pose, imported).place();
}

} // namespace openltc::scene::gltf
