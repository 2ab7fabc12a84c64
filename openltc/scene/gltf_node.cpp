// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Scenes and nodes: glTF 2.0 specification, section 3.5.

#include "openltc/scene/gltf_node.h"

#include "openltc/scene/gltf_document.h"
#include "openltc/scene/gltf_extras_light.h"
#include "openltc/scene/gltf_failure.h"
#include "openltc/scene/gltf_light.h"
#include "openltc/scene/gltf_material.h"
#include "openltc/scene/gltf_memory.h"
#include "openltc/scene/gltf_primitive.h"
#include "openltc/scene/light_surface.h"
#include "openltc/scene/normals.h"
#include "openltc/scene/transform.h"

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

namespace openltc::scene::gltf {

namespace {

// Instances are copies, so that a small file can ask for any number of triangles.
constexpr std::size_t k_max_triangles = std::size_t(1) << 28;
constexpr std::size_t k_max_depth = 4096;

Transform local_transform(const tinygltf::Node& node, const std::string& field,
                          Document& document) {
  Transform t;
  if (node.matrix.size() == 16) {
    const auto& m = node.matrix; // column-major
    for (std::size_t c = 0; c < 4; ++c)
      t.column[c] = Vec3d(m[4 * c], m[4 * c + 1], m[4 * c + 2]);
    const bool is_affine = m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
    if (!is_affine)
      document.warnings.add(
          fmt::format("{}.matrix: its last row is not (0, 0, 0, 1); it is ignored", field));
    return t;
  }
  if (node.rotation.size() == 4) {
    const double l =
        std::sqrt(node.rotation[0] * node.rotation[0] + node.rotation[1] * node.rotation[1] +
                  node.rotation[2] * node.rotation[2] + node.rotation[3] * node.rotation[3]);
    if (l > 0 && std::isfinite(l)) {
      const double x = node.rotation[0] / l, y = node.rotation[1] / l, z = node.rotation[2] / l,
                   w = node.rotation[3] / l;
      t.column[0] = Vec3d(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y));
      t.column[1] = Vec3d(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x));
      t.column[2] = Vec3d(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));
    } else {
      document.warnings.add(
          fmt::format("{}.rotation: it has no length; the node is not rotated", field));
    }
  }
  if (node.scale.size() == 3)
    for (std::size_t c = 0; c < 3; ++c)
      t.column[c] = t.column[c] * node.scale[c];
  if (node.translation.size() == 3)
    t.column[3] = Vec3d(node.translation[0], node.translation[1], node.translation[2]);
  return t;
}

// Moves `mesh` into the world; a mirroring transform turns the triangles' winding over.
void apply_transform(Mesh& mesh, const Transform& to_world, const std::string& field) {
  const bool mirrors = to_world.determinant() < 0;
  for (Vec3f& p : mesh.positions) {
    p = to_float(to_world.point(to_double(p)));
    // Beyond this, areas overflow single precision.
    const bool is_usable = std::abs(p.x) < 1e18f && std::abs(p.y) < 1e18f && std::abs(p.z) < 1e18f;
    if (!is_usable)
      fail(field, "its transform takes the mesh outside the usable range of coordinates (1e18 "
                  "metres); export the file again");
  }
  for (Vec3f& n : mesh.normals) {
    const Vec3d world = to_world.normal(to_double(n)) * (mirrors ? -1.0 : 1.0);
    const double l = length(world);
    n = l > 0 && std::isfinite(l) ? to_float(world / l) : Vec3f(0, 0, 0); // repaired below
  }
  if (mirrors)
    for (auto& triangle : mesh.triangles)
      std::swap(triangle[1], triangle[2]);
  drop_degenerate_triangles(mesh);
  repair_normals(mesh);
  for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
    Vec4f& t = mesh.tangents[i];
    const Vec3d n = to_double(mesh.normals[i]);
    Vec3d world = to_world.direction(Vec3d(double(t.x), double(t.y), double(t.z)));
    world = world - n * dot(n, world);
    double l = length(world);
    if (!(l > 0) || !std::isfinite(l)) {
      world = cross(n, std::abs(n.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0));
      l = length(world);
    }
    t = Vec4f(float(world.x / l), float(world.y / l), float(world.z / l), mirrors ? -t.w : t.w);
  }
}

class Walker {
public:
  Walker(Document& document, Imported& imported)
      : document_(document), model_(*document.model), imported_(imported), scene_(imported.scene),
        visited_(model_.nodes.size(), false), uses_(model_.meshes.size(), 0) {
    imported_.to_world.resize(model_.nodes.size());
    for (const auto& node : model_.nodes)
      if (node.mesh >= 0) ++uses_[std::size_t(node.mesh)];
  }

  void walk() {
    check_hierarchy();
    if (!model_.scenes.empty())
      scene_.describes_lights =
          names_lights(model_.scenes[std::size_t(std::max(model_.defaultScene, 0))].extensions);
    struct Pending {
      int node;
      std::size_t depth;
      Transform parent;
    };
    std::vector<Pending> stack;
    const std::vector<int> roots = root_nodes();
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
      stack.push_back({*root, 0, {}});
    while (!stack.empty()) {
      const Pending next = stack.back();
      stack.pop_back();
      const tinygltf::Node& node = model_.nodes[std::size_t(next.node)];
      const std::string field = fmt::format("nodes[{}]", next.node);
      if (visited_[std::size_t(next.node)])
        fail(field, "it is reached twice; a node may stand in one place only");
      visited_[std::size_t(next.node)] = true;
      if (next.depth > k_max_depth)
        fail(field, fmt::format("nodes are nested deeper than {} levels; flatten the hierarchy",
                                k_max_depth));
      const Transform to_world = compose(next.parent, local_transform(node, field, document_));
      imported_.to_world[std::size_t(next.node)] = to_world;
      place(next.node, field, to_world);
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        stack.push_back({*child, next.depth + 1, to_world});
    }
    if (scene_.meshes.empty() && !first_without_area_.empty())
      fail(first_without_area_,
           "none of the scene's triangles has an area, so that there is nothing "
           "to see; check positions, indices and node scales");
  }

private:
  // Every node has at most one parent, and following parents ends.
  void check_hierarchy() const {
    std::vector<int> parent(model_.nodes.size(), -1);
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      for (const int child : model_.nodes[i].children) {
        int& known = parent[std::size_t(child)];
        if (known >= 0)
          fail(fmt::format("nodes[{}].children", i),
               fmt::format(
                   "nodes[{}] already is a child of nodes[{}]; a node has one parent, export "
                   "the file again",
                   child, known));
        known = int(i);
      }
    }
    std::vector<std::size_t> seen_from(model_.nodes.size(), 0);
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      int node = int(i);
      while (node >= 0 && seen_from[std::size_t(node)] == 0) {
        seen_from[std::size_t(node)] = i + 1;
        node = parent[std::size_t(node)];
      }
      if (node >= 0 && seen_from[std::size_t(node)] == i + 1)
        fail(fmt::format("nodes[{}].children", node),
             "the node is its own descendant; break the cycle and export again");
    }
  }

  std::vector<int> root_nodes() const {
    if (model_.defaultScene >= 0) return model_.scenes[std::size_t(model_.defaultScene)].nodes;
    if (!model_.scenes.empty()) return model_.scenes[0].nodes;
    std::vector<bool> is_child(model_.nodes.size(), false);
    for (const auto& node : model_.nodes)
      for (const int child : node.children)
        is_child[std::size_t(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < model_.nodes.size(); ++i)
      if (!is_child[i]) roots.push_back(int(i));
    return roots;
  }

  void place(int index, const std::string& field, const Transform& to_world) {
    const tinygltf::Node& node = model_.nodes[std::size_t(index)];
    const NodeExtras& extras = document_.extras[std::size_t(index)];
    const std::size_t first_mesh = scene_.meshes.size();
    scene_.describes_lights = scene_.describes_lights || extras.describes_light ||
                              names_lights(node.extensions) ||
                              document_.lost_lights.contains(index);
    if (node.mesh >= 0) place_mesh(node, field, to_world);
    for (std::size_t i = first_mesh; i < scene_.meshes.size(); ++i) {
      scene_.meshes[i].node = index;
      scene_.meshes[i].emits_light = extras.emits_light;
    }
    if (node.camera >= 0)
      scene_.cameras.push_back(read_camera(document_, node.camera, to_world, node.name));
    const auto punctual = node.extensions.find("KHR_lights_punctual");
    if (punctual != node.extensions.end())
      scene_.lights.punctual.push_back(read_punctual_light(
          document_, punctual->second.Get("light").GetNumberAsInt(), to_world, node.name));
    const auto area = node.extensions.find("EXT_lights_area");
    if (area != node.extensions.end())
      read_area_light(document_, area->second.Get("light").GetNumberAsInt(), to_world, node.name,
                      extras.surface_deviation, scene_.lights);
    if (const IesNode* ies = document_.ies_lights.of_node(index))
      read_ies_light(document_, *ies, to_world, node.name, scene_.lights);
    if (extras.light) place_extras_light(index, *extras.light, to_world, first_mesh);
  }

  // KHR_lights_punctual, EXT_lights_image_based and so on, also one that is not known here.
  static bool names_lights(const tinygltf::ExtensionMap& extensions) {
    return std::any_of(extensions.begin(), extensions.end(), [](const auto& extension) {
      return extension.first.find("_lights_") != std::string::npos;
    });
  }

  // The light that the node's extras describe. The node's mesh, if there is one, shows it: its own
  // emission makes no lights, and shadow rays stop before it.
  void place_extras_light(int index, const nlohmann::json& properties, const Transform& to_world,
                          std::size_t first_mesh) {
    const std::string& name = model_.nodes[std::size_t(index)].name;
    const std::string label = node_label(std::size_t(index), name);
    NodeLight found;
    found.node = index;
    std::swap(found.light.textures, scene_.lights.textures); // their indices go on
    try {
      read_extras_light(properties, label, name.empty() ? label : name, to_world, document_,
                        found.light);
    } catch (const Failure& failure) {
      document_.warnings.add(failure.message + "; the light is left out");
    }
    std::swap(found.light.textures, scene_.lights.textures);
    if (found.light.empty()) return;
    if (first_mesh < scene_.meshes.size()) {
      attach_mesh(label, found.light, std::span(scene_.meshes).subspan(first_mesh));
    }
    append_lights(found.light, scene_.lights);
    imported_.extras_lights.push_back(std::move(found));
  }

  void attach_mesh(const std::string& label, light::Lights& light, std::span<Mesh> meshes) {
    // Where some of the mesh's surfaces glow, those are the lamp, and the others its housing.
    const auto glows = [&](const Mesh& mesh) {
      const Vec3f e = scene_.materials[std::size_t(mesh.material)].emission;
      return e.x > 0 || e.y > 0 || e.z > 0;
    };
    const bool any_glows = std::any_of(meshes.begin(), meshes.end(), glows);
    for (Mesh& mesh : meshes)
      mesh.emits_light = false;
    if (!light.punctual.empty()) {
      if (light.punctual[0].type != light::PunctualType::directional)
        document_.warnings.add(label + ": the light has no extent, so that the node's mesh shadows "
                                       "it; give it the type of the mesh's shape");
      return;
    }
    light.for_each_area_light([&](const auto& area_light) {
      double deviation = 0;
      for (const Mesh& mesh : meshes) {
        if (any_glows && !glows(mesh)) continue;
        for (const Vec3f p : mesh.positions)
          deviation = std::max(deviation, distance_outside(area_light, p));
      }
      if (deviation > reach_of(area_light)) {
        document_.warnings.add(
            fmt::format("{}: its mesh reaches {:.3g} m beyond the light, so that it is not taken "
                        "for the light's surface and may shadow it",
                        label, deviation));
        deviation = 0;
      }
      set_surface_deviation(light, float(deviation));
    });
  }

  static void set_surface_deviation(light::Lights& lights, float deviation) {
    const auto set = [&](auto& list) {
      for (auto& light : list)
        light.surface_deviation = deviation;
    };
    set(lights.polygons);
    set(lights.ellipses);
    set(lights.spheres);
    set(lights.tubes);
    set(lights.lines);
  }

  void place_mesh(const tinygltf::Node& node, const std::string& field, const Transform& to_world) {
    const std::size_t mesh_index = std::size_t(node.mesh);
    const auto& primitives = model_.meshes[mesh_index].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      Mesh mesh = local_mesh(mesh_index, p);
      if (mesh.triangles.empty()) {
        if (!mesh.positions.empty()) note_without_area(mesh_index, p);
        continue;
      }
      triangle_count_ += mesh.triangles.size();
      if (triangle_count_ > k_max_triangles)
        fail(field, fmt::format("the scene has more than {} million triangles; reduce it",
                                k_max_triangles >> 20));
      if (!node.name.empty()) mesh.name = node.name;
      apply_transform(mesh, to_world, field);
      if (mesh.triangles.empty()) {
        document_.warnings.add_for_mesh(mesh.name,
                                        "its node's scale leaves it no area; it is left out");
        note_without_area(mesh_index, p);
        continue;
      }
      scene_.meshes.push_back(std::move(mesh));
    }
  }

  void note_without_area(std::size_t mesh_index, std::size_t primitive) {
    if (first_without_area_.empty())
      first_without_area_ = fmt::format("meshes[{}].primitives[{}]", mesh_index, primitive);
  }

  static std::string primitive_field(const std::pair<std::size_t, std::size_t>& key) {
    return fmt::format("meshes[{}].primitives[{}]", key.first, key.second);
  }

  // Read once, copied for every instance; kept only when there are several.
  Mesh local_mesh(std::size_t mesh_index, std::size_t primitive) {
    const auto key = std::make_pair(mesh_index, primitive);
    const auto found = local_meshes_.find(key);
    if (found != local_meshes_.end()) {
      take_memory(*document_.scene_memory, mesh_memory(found->second), primitive_field(key));
      return found->second;
    }
    int material = model_.meshes[mesh_index].primitives[primitive].material;
    if (material < 0) material = default_material();
    Mesh mesh = read_primitive(document_, mesh_index, primitive,
                               vertex_needs(scene_.materials[std::size_t(material)]));
    mesh.material = material;
    take_memory(*document_.scene_memory, mesh_memory(mesh), primitive_field(key));
    if (uses_[mesh_index] < 2) return mesh;
    return local_meshes_.emplace(key, std::move(mesh)).first->second;
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
  Imported& imported_;
  Scene& scene_;
  std::vector<bool> visited_;
  std::vector<std::size_t> uses_; // of each mesh by nodes
  std::map<std::pair<std::size_t, std::size_t>, Mesh> local_meshes_;
  std::size_t triangle_count_ = 0;
  int default_material_ = -1;
  std::string first_without_area_;
};

} // namespace

std::uint64_t mesh_memory(const Mesh& mesh) {
  constexpr std::uint64_t k_triangle_of_tree = 128;
  return mesh.triangles.size() * (sizeof(mesh.triangles[0]) + k_triangle_of_tree) +
         mesh.positions.size() * sizeof(Vec3f) + mesh.normals.size() * sizeof(Vec3f) +
         mesh.tangents.size() * sizeof(Vec4f) + mesh.tex_coord_0.size() * sizeof(Vec2f) +
         mesh.tex_coord_1.size() * sizeof(Vec2f) + mesh.colors.size() * sizeof(Vec4f);
}

void read_nodes(Document& document, Imported& imported) { Walker(document, imported).walk(); }

} // namespace openltc::scene::gltf
