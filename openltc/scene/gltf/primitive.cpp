// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Primitives: glTF 2.0 specification, section 3.7.2.

#include "openltc/scene/gltf/primitive.h"

#include "openltc/scene/deform.h"
#include "openltc/scene/gltf/file/accessor.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/draco_primitive.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"
#include "openltc/scene/gltf/file/tinygltf.h"
#include "openltc/scene/gltf/morph.h"
#include "openltc/scene/normals.h"
#include "openltc/scene/tangents.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace openltc::scene::gltf {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// The corners in drawing order become triangles; every second one of a strip is turned over.
Triangles assemble(const std::vector<std::uint32_t>& corners, int mode) {
  Triangles triangles;
  const std::size_t n = corners.size();
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (std::size_t i = 0; i + 2 < n; i += 3)
      triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
    for (std::size_t i = 0; i + 2 < n; ++i)
      triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
  } else {
    for (std::size_t i = 1; i + 1 < n; ++i)
      triangles.push_back({corners[i], corners[i + 1], corners[0]});
  }
  return triangles;
}

class Reader {
public:
  Reader(Document& document, std::size_t mesh, std::size_t primitive)
      : document_(document), primitive_(document.model->meshes[mesh].primitives[primitive]),
        field_(fmt::format("meshes[{}].primitives[{}]", mesh, primitive)),
        name_(document.model->meshes[mesh].name) {
    if (name_.empty()) name_ = fmt::format("meshes[{}]", mesh);
  }

  Primitive read(const VertexNeeds& needs, const Deformation& deformation) {
    Primitive result;
    Mesh& mesh = result.mesh;
    mesh.name = name_;
    const int mode = primitive_.mode;
    if (mode < TINYGLTF_MODE_TRIANGLES) {
      warn("points and lines are not drawn");
      return result;
    }
    if (std::optional<DracoMesh> decoded = decode_draco_part(document_, primitive_, field_)) {
      draco_ = std::move(*decoded);
      is_draco_ = true;
    }
    if (!has("POSITION")) {
      warn("without positions it is left out");
      return result;
    }
    MemoryShare reading; // whoever keeps the mesh counts it anew
    take_memory(reading, bytes_to_read(needs, mode), field_);
    read_positions(mesh);
    read_triangles(mesh, mode);
    read_optional(mesh);
    add_targets(document_, primitive_.targets, field_, deformation.weights, mesh);
    keep_usable(mesh);
    if (!deformation.joints.empty()) result.is_skinned = apply_skin(mesh, deformation.joints);
    check_positions(mesh);
    const std::size_t dropped = drop_degenerate_triangles(mesh);
    // Strips repeat corners on purpose.
    if (dropped != 0 && mode == TINYGLTF_MODE_TRIANGLES)
      warn("triangles without area are left out");
    if (mesh.triangles.empty()) return result;

    if (mesh.normals.empty()) {
      make_flat_normals(mesh);
    } else if (repair_normals(mesh) != 0) {
      warn("some normals are unusable and were computed from the triangles");
    }
    provide_tex_coords(mesh, needs);
    provide_tangents(mesh, needs);
    return result;
  }

private:
  void warn(const std::string& what) { document_.warnings.add_for_mesh(name_, what); }

  bool has(const std::string& name) const {
    return draco_.attributes.count(name) != 0 || primitive_.attributes.count(name) != 0;
  }

  // The arrays of the mesh. Without normals each triangle gets corners of its own.
  std::uint64_t bytes_to_read(const VertexNeeds& needs, int mode) const {
    const auto count_of = [&](const std::string& name) -> std::size_t {
      const auto decoded = draco_.attributes.find(name);
      if (decoded != draco_.attributes.end()) return decoded->second.count;
      const auto attribute = primitive_.attributes.find(name);
      return attribute == primitive_.attributes.end()
                 ? 0
                 : accessor_count(document_, attribute->second);
    };
    std::uint64_t vertex = 2 * sizeof(Vec3f);
    if (has("TANGENT") || needs.tangent_tex_coord >= 0) vertex += sizeof(Vec4f);
    if (has("TEXCOORD_0") || needs.tex_coord[0]) vertex += sizeof(Vec2f);
    if (has("TEXCOORD_1") || needs.tex_coord[1]) vertex += sizeof(Vec2f);
    if (has("COLOR_0")) vertex += sizeof(Vec4f);
    std::uint64_t vertices = count_of("POSITION");
    std::uint64_t corners = vertices;
    if (is_draco_)
      corners = 3 * draco_.triangles.size();
    else if (primitive_.indices >= 0)
      corners = accessor_count(document_, primitive_.indices);
    // Strips and fans have a triangle for each corner.
    const std::uint64_t triangles =
        mode == TINYGLTF_MODE_TRIANGLES || is_draco_ ? corners / 3 : corners;
    if (!has("NORMAL")) vertices += 3 * triangles;
    return saturating_product(vertices, vertex) + saturating_product(triangles, 3 * sizeof(int));
  }

  std::string attribute_field(const std::string& name) const {
    return field_ + ".attributes." + name;
  }

  Floats read_attribute(const std::string& name) {
    const auto decoded = draco_.attributes.find(name);
    if (decoded != draco_.attributes.end()) return std::move(decoded->second);
    return read_floats(document_, primitive_.attributes.at(name));
  }

  void check_components(const std::string& name, const Floats& floats, std::size_t at_least,
                        std::size_t at_most) const {
    if (floats.components < at_least || floats.components > at_most)
      fail(attribute_field(name),
           fmt::format("has {} components per vertex; export the file again", floats.components));
  }

  void check_length(const std::string& name, const Floats& floats, const Mesh& mesh) const {
    if (floats.count != mesh.positions.size())
      fail(attribute_field(name),
           fmt::format("has {} vertices but POSITION has {}; the file is damaged, export it again",
                       floats.count, mesh.positions.size()));
  }

  void read_positions(Mesh& mesh) {
    const Floats floats = read_attribute("POSITION");
    check_components("POSITION", floats, 3, 3);
    if (floats.count >= std::numeric_limits<std::uint32_t>::max() / 4)
      fail(attribute_field("POSITION"), "too many vertices; split the mesh");
    mesh.positions.resize(floats.count);
    for (std::size_t i = 0; i < floats.count; ++i) {
      const float* v = floats.values.data() + 3 * i;
      if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
        fail(
            attribute_field("POSITION"),
            fmt::format("vertex {} is at ({}, {}, {}), which is not a place; export the file again",
                        i, double(v[0]), double(v[1]), double(v[2])));
      mesh.positions[i] = Vec3f(v[0], v[1], v[2]);
    }
  }

  void read_triangles(Mesh& mesh, int mode) {
    if (is_draco_) {
      mesh.triangles = std::move(draco_.triangles);
      check_corners(mesh);
      return;
    }
    std::vector<std::uint32_t> corners;
    if (primitive_.indices >= 0) {
      corners = read_indices(document_, primitive_.indices);
    } else {
      corners.resize(mesh.positions.size());
      for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = std::uint32_t(i);
    }
    if (mode == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0)
      warn("the number of corners is not a multiple of three; the last triangle is incomplete and "
           "left out");
    mesh.triangles = assemble(corners, mode);
    check_corners(mesh);
  }

  void check_corners(const Mesh& mesh) const {
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle)
        if (corner >= mesh.positions.size())
          fail(field_ + ".indices",
               fmt::format(
                   "{}points at vertex {}, but there are only {}; the file is damaged, export "
                   "it again",
                   primitive_.indices >= 0 ? accessor_field(primitive_.indices) + " " : "", corner,
                   mesh.positions.size()));
  }

  void read_tex_coords(const std::string& name, std::vector<Vec2f>& out, const Mesh& mesh) {
    if (!has(name)) return;
    const Floats floats = read_attribute(name);
    check_components(name, floats, 2, 2);
    check_length(name, floats, mesh);
    out.resize(floats.count);
    bool is_broken = false;
    for (std::size_t i = 0; i < floats.count; ++i) {
      const Vec2f uv(floats.values[2 * i], floats.values[2 * i + 1]);
      out[i] = usable(uv);
      is_broken = is_broken || out[i].x != uv.x || out[i].y != uv.y; // true for NaN
    }
    if (is_broken) warn(name + " holds values that are not numbers; its textures may look wrong");
  }

  void read_optional(Mesh& mesh) {
    if (has("NORMAL")) {
      const Floats floats = read_attribute("NORMAL");
      check_components("NORMAL", floats, 3, 4); // octahedral filters write four bytes
      check_length("NORMAL", floats, mesh);
      mesh.normals.resize(floats.count);
      for (std::size_t i = 0; i < floats.count; ++i) {
        const float* v = floats.values.data() + floats.components * i;
        mesh.normals[i] = Vec3f(v[0], v[1], v[2]);
      }
    }
    if (has("NORMAL") && has("TANGENT")) { // computed normals need computed tangents
      const Floats floats = read_attribute("TANGENT");
      check_components("TANGENT", floats, 4, 4);
      check_length("TANGENT", floats, mesh);
      mesh.tangents.resize(floats.count);
      for (std::size_t i = 0; i < floats.count; ++i) {
        const float* v = floats.values.data() + 4 * i;
        mesh.tangents[i] = Vec4f(v[0], v[1], v[2], v[3]);
      }
    }
    read_tex_coords("TEXCOORD_0", mesh.tex_coord_0, mesh);
    read_tex_coords("TEXCOORD_1", mesh.tex_coord_1, mesh);
    if (has("COLOR_0")) {
      const Floats floats = read_attribute("COLOR_0");
      check_components("COLOR_0", floats, 3, 4);
      check_length("COLOR_0", floats, mesh);
      mesh.colors.resize(floats.count);
      for (std::size_t i = 0; i < floats.count; ++i) {
        const float* v = floats.values.data() + floats.components * i;
        mesh.colors[i] = Vec4f(usable(v[0]), usable(v[1]), usable(v[2]),
                               floats.components == 4 ? usable(v[3]) : 1.0f);
      }
    }
  }

  // --- deformation -----------------------------------------------------------------------------

  static void keep_usable(Mesh& mesh) {
    for (Vec2f& uv : mesh.tex_coord_0)
      uv = usable(uv);
    for (Vec2f& uv : mesh.tex_coord_1)
      uv = usable(uv);
    for (Vec4f& c : mesh.colors)
      c = Vec4f(usable(c.x), usable(c.y), usable(c.z), usable(c.w));
  }

  static float usable(float color) {
    return color >= 0 && color < 1e6f ? color : 0.0f;
  } // 0 for NaN
  static Vec2f usable(Vec2f uv) {
    return std::abs(uv.x) < 1e9f && std::abs(uv.y) < 1e9f ? uv : Vec2f(0, 0);
  }

  // False where the primitive does not say which joints move it.
  bool apply_skin(Mesh& mesh, std::span<const Transform> joints) {
    Influences influences;
    std::vector<Floats> sets; // joints, weights, joints, ...
    for (int set = 0;; ++set) {
      const std::string joint = fmt::format("JOINTS_{}", set);
      const std::string weight = fmt::format("WEIGHTS_{}", set);
      if (!has(joint) || !has(weight)) break;
      for (const std::string& name : {joint, weight}) {
        sets.push_back(read_attribute(name));
        check_components(name, sets.back(), 4, 4);
        check_length(name, sets.back(), mesh);
      }
    }
    if (sets.empty()) {
      warn("its node has a skin but it has no JOINTS_0 and WEIGHTS_0; it is not bent");
      return false;
    }
    influences.per_vertex = 2 * sets.size();
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      for (std::size_t set = 0; set < sets.size(); set += 2) {
        for (std::size_t c = 0; c < 4; ++c) {
          const float joint = sets[set].values[4 * v + c];
          const float weight = sets[set + 1].values[4 * v + c];
          if (!(joint >= 0) || !(joint < float(joints.size())))
            fail(attribute_field(fmt::format("JOINTS_{}", set / 2)),
                 fmt::format("vertex {} follows joint {}, but the skin has only {}; the file is "
                             "damaged, export it again",
                             v, double(joint), joints.size()));
          influences.joints.push_back(std::uint32_t(joint));
          influences.weights.push_back(weight > 0 && std::isfinite(weight) ? weight : 0.0f);
        }
      }
    }
    bend(mesh, influences, joints);
    return true;
  }

  void check_positions(const Mesh& mesh) const {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Vec3f p = mesh.positions[i];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        fail(field_,
             fmt::format("its morph targets or joints move vertex {} to ({}, {}, {}), which "
                         "is not a place; export the file again",
                         i, double(p.x), double(p.y), double(p.z)));
    }
  }

  void provide_tex_coords(Mesh& mesh, const VertexNeeds& needs) {
    for (int set = 0; set < 2; ++set) {
      auto& tex_coord = set == 0 ? mesh.tex_coord_0 : mesh.tex_coord_1;
      if (!needs.tex_coord[set] || !tex_coord.empty()) continue;
      warn(fmt::format("its material has a texture for TEXCOORD_{}, which the mesh lacks; the "
                       "texture's first corner is used everywhere",
                       set));
      tex_coord.assign(mesh.positions.size(), Vec2f(0, 0));
    }
  }

  void provide_tangents(Mesh& mesh, const VertexNeeds& needs) {
    if (needs.tangent_tex_coord < 0) {
      mesh.tangents.clear();
      return;
    }
    if (!mesh.tangents.empty() && !repair_tangents(mesh))
      warn("some tangents are unusable; all were computed from the texture coordinates");
    if (mesh.tangents.empty()) compute_tangents(mesh, needs.tangent_tex_coord);
  }

  Document& document_;
  const tinygltf::Primitive& primitive_;
  std::string field_;
  std::string name_;
  DracoMesh draco_;
  bool is_draco_ = false;
};

} // namespace

Primitive read_primitive(Document& document, std::size_t mesh, std::size_t primitive,
                         const VertexNeeds& needs, const Deformation& deformation) {
  return Reader(document, mesh, primitive).read(needs, deformation);
}

} // namespace openltc::scene::gltf
