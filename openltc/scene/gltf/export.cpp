// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The file's JSON is edited as JSON, so that whatever the importer does not read stays in it.
//
// A light gets a node of its own below the node that it came from, so that it moves along with it,
// when that node is not sheared, mirrored or scaled unevenly: there the light's place, in the
// node's space, is a rotation and a translation. Elsewhere the light's node stands in the scene.

#include "openltc/scene/gltf/export.h"

#include "openltc/light/light_list.h"
#include "openltc/light/photometry/photometry.h"
#include "openltc/scene/area_light.h"
#include "openltc/scene/gltf/file/container.h"
#include "openltc/scene/gltf/file/uri.h"
#include "openltc/scene/gltf/glb_writer.h"
#include "openltc/scene/gltf/import.h"
#include "openltc/scene/gltf/light/extras.h"
#include "openltc/scene/gltf/light/ies_light.h"
#include "openltc/scene/gltf/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace openltc::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* k_extension = "EXT_lights_area";

// (x, y, z, w) of the rotation with these columns, by the largest of its four components.
std::array<double, 4> quaternion(Vec3d x, Vec3d y, Vec3d z) {
  const double w4 = 1 + x.x + y.y + z.z, x4 = 1 + x.x - y.y - z.z, y4 = 1 - x.x + y.y - z.z,
               z4 = 1 - x.x - y.y + z.z;
  const double largest = std::max({w4, x4, y4, z4});
  std::array<double, 4> q;
  if (largest == w4)
    q = {y.z - z.y, z.x - x.z, x.y - y.x, w4};
  else if (largest == x4)
    q = {x4, x.y + y.x, z.x + x.z, y.z - z.y};
  else if (largest == y4)
    q = {x.y + y.x, y4, y.z + z.y, z.x - x.z};
  else
    q = {z.x + x.z, y.z + z.y, z4, x.y - y.x};
  const double l = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& c : q)
    c /= l;
  return q;
}

// The scale of a transform that rotates, moves and scales evenly; none for others.
std::optional<double> even_scale(const Transform& t) {
  const double x = length(t.column[0]), y = length(t.column[1]), z = length(t.column[2]);
  const double determinant = t.determinant();
  const bool is_even = x > 0 && std::abs(y - x) <= 1e-6 * x && std::abs(z - x) <= 1e-6 * x &&
                       std::abs(determinant - x * x * x) <= 1e-6 * x * x * x;
  if (!is_even) return {};
  return x;
}

class Exporter {
public:
  Exporter(Json& root, const gltf::Imported& imported) : root_(root), imported_(imported) {}

  /// Photometric files that lights[i] of EXT_lights_ies still has to get.
  const std::map<std::size_t, std::string>& profiles() const { return profiles_; }

  ExportReport run() {
    for (const gltf::NodeLight& light : imported_.extras_lights)
      write_extras_light(light);
    write_mesh_lights();
    if (report_.written > 0) use(k_extension);
    if (report_.profiles_written > 0) use(gltf::k_lights_ies);
    report_.warnings = imported_.scene.warnings;
    return std::move(report_);
  }

private:
  Json& node(int index) { return root_["nodes"][std::size_t(index)]; }

  void use(const char* extension) {
    Json& used = root_["extensionsUsed"];
    if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
  }

  void leave(const AreaLights& found) {
    for (const std::string& refused : found.refused)
      report_.left.push_back(
          fmt::format("{}, which {} cannot say; it is left as it is", refused, k_extension));
  }

  // What EXT_lights_ies can say: a profile, times a factor and a colour within 0 .. 1.
  static bool has_plain_profile(const light::Lights& lights) {
    if (lights.punctual.size() != 1) return false;
    const light::PunctualLight& light = lights.punctual[0];
    return light.profile && light.type == light::PunctualType::point && light.range == 0;
  }

  // Both place the profile by their node alike, and neither is scaled.
  void write_profile(const light::PunctualLight& light, Json& to) {
    const auto [known, is_new] = profile_index_.try_emplace(light.profile.get(), 0);
    if (is_new) {
      Json& lights = root_["extensions"][gltf::k_lights_ies]["lights"];
      lights.push_back({{"name", light.profile->name}});
      known->second = lights.size() - 1;
      profiles_[known->second] = light::to_lm63(*light.profile);
    }
    const double candela =
        double(std::max({light.intensity.x, light.intensity.y, light.intensity.z}));
    const auto channel = [&](float c) { return candela > 0 ? double(c) / candela : 1.0; };
    to["extensions"][gltf::k_lights_ies] = {
        {"light", known->second},
        {"multiplier", candela / light.profile->max_candela},
        {"color",
         {channel(light.intensity.x), channel(light.intensity.y), channel(light.intensity.z)}}};
    ++report_.profiles_written;
  }

  void take_extras_light(int index) {
    Json& extras = node(index)["extras"];
    gltf::erase_light(extras);
    if (node(index).contains("mesh")) extras[gltf::k_extras_emits_light] = false;
    if (extras.empty()) node(index).erase("extras");
  }

  void write_extras_light(const gltf::NodeLight& light) {
    const bool is_taken = node(light.node).contains("extensions") &&
                          node(light.node)["extensions"].contains(gltf::k_lights_ies);
    if (has_plain_profile(light.light) && !is_taken) {
      take_extras_light(light.node);
      return write_profile(light.light.punctual[0], node(light.node));
    }
    const AreaLights found = area_lights_of(light.light);
    leave(found);
    if (!found.refused.empty()) return;
    take_extras_light(light.node);
    for (const AreaLight& area : found.lights)
      add(area, light.node);
  }

  void write_mesh_lights() {
    std::map<int, light::Lights> by_node;
    for (std::size_t i = 0; i < imported_.mesh_lights.size(); ++i)
      light::append_lights(imported_.mesh_lights[i], by_node[imported_.scene.meshes[i].node]);
    for (const auto& [index, lights] : by_node) {
      if (index < 0 || lights.empty()) continue;
      AreaLights found = area_lights_of(lights);
      Json& from = node(index);
      if (from.contains("extras") && !from["extras"].is_object() && found.refused.empty())
        found.refused.push_back(fmt::format("nodes[{}]: its extras are no object", index));
      if (!found.refused.empty()) {
        report_.left.push_back(summary(found, lights));
        continue;
      }
      from["extras"][gltf::k_extras_emits_light] = false;
      for (const AreaLight& area : found.lights)
        add(area, index);
    }
  }

  // A curved surface is thousands of lights; one line is enough.
  static std::string summary(const AreaLights& found, const light::Lights& lights) {
    const std::size_t count = lights.area_light_count();
    return fmt::format("{}{}, which {} cannot say; the mesh goes on emitting", found.refused[0],
                       count > 1 ? fmt::format(", one of the mesh's {} lights", count) : "",
                       k_extension);
  }

  void add(const AreaLight& light, int from) {
    ++report_.written;
    const Transform& to_world = imported_.to_world[std::size_t(from)];
    const auto scale = even_scale(to_world);
    const auto to_node = [&](Vec3d v) {
      return Vec3d(dot(to_world.column[0], v), dot(to_world.column[1], v),
                   dot(to_world.column[2], v)) /
             *scale;
    };
    const auto q = scale ? quaternion(to_node(light.x), to_node(light.y), to_node(light.z))
                         : quaternion(light.x, light.y, light.z);
    const Vec3d center = light.center + imported_.scene.origin; // in the file's coordinates
    const Vec3d at = scale ? to_node(center - to_world.column[3]) / *scale : center;
    Json placed = {{"name", light.name},
                   {"translation", {at.x, at.y, at.z}},
                   {"rotation", {q[0], q[1], q[2], q[3]}}};
    placed["extensions"][k_extension]["light"] = definition(light, scale.value_or(1.0));
    if (light.surface_deviation > 0)
      placed["extras"][gltf::k_extras_surface_deviation] = light.surface_deviation;
    root_["nodes"].push_back(std::move(placed));
    const std::size_t index = root_["nodes"].size() - 1;
    if (scale)
      node(from)["children"].push_back(index);
    else if (root_.contains("scenes") && !root_["scenes"].empty())
      root_["scenes"][root_.value("scene", std::size_t(0))]["nodes"].push_back(index);
  }

  // Index of the light; lights that are alike share one.
  std::size_t definition(const AreaLight& light, double node_scale) {
    const double nits = double(std::max({light.radiance.x, light.radiance.y, light.radiance.z}));
    const auto channel = [&](float c) { return nits > 0 ? double(c) / nits : 1.0; };
    Json value = {
        {"type", light.is_disk ? "disk" : "rect"},
        {"color",
         {channel(light.radiance.x), channel(light.radiance.y), channel(light.radiance.z)}},
        {"intensity", nits},
        {"size", light.height / node_scale}};
    if (!light.is_disk) value["rect"] = {{"aspect", light.width / light.height}};
    const auto [known, is_new] = definitions_.try_emplace(value.dump(), 0);
    if (is_new) {
      Json& lights = root_["extensions"][k_extension]["lights"];
      lights.push_back(std::move(value));
      known->second = lights.size() - 1;
    }
    return known->second;
  }

  Json& root_;
  const gltf::Imported& imported_;
  ExportReport report_;
  std::map<std::string, std::size_t> definitions_;
  std::map<const light::IesProfile*, std::size_t> profile_index_;
  std::map<std::size_t, std::string> profiles_;
};

} // namespace

Result<ExportReport> export_area_lights(const std::string& input, const std::string& output,
                                        const EmissiveOptions& emissive,
                                        const ReadOptions& reading) {
  MemoryShare memory;
  Json root;
  gltf::Binary binary;
  const Result<ExportReport> report = gltf::guarded(input, [&] {
    const std::vector<std::uint8_t> bytes = gltf::read_scene_file(input, memory);
    const gltf::Folder folder = gltf::folder_of(input, reading.allow_outside);
    const gltf::Imported imported = gltf::import_gltf(bytes, folder, emissive);
    const gltf::Container container = gltf::split_container(bytes);
    root = Json::parse(container.json.begin(), container.json.end());
    binary.bytes.assign(container.binary.begin(), container.binary.end());
    binary.exists = container.has_binary;
    Exporter exporter(root, imported);
    ExportReport made = exporter.run();
    gltf::embed_references(root, binary, folder, memory);
    for (const auto& [index, text] : exporter.profiles()) {
      const std::vector<std::uint8_t> file(text.begin(), text.end());
      const std::size_t view = gltf::add_view(root, binary, file);
      Json& light = root["extensions"][gltf::k_lights_ies]["lights"][index];
      light["bufferView"] = view;
      light["mimeType"] = gltf::k_ies_mime_type;
    }
    return made;
  });
  if (!report) return report.error();
  if (const Status status = gltf::write_glb(output, root, binary); !status) return status.error();
  return *report;
}

} // namespace openltc::scene
