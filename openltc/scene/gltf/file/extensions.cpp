// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/file/extensions.h"

#include "openltc/base/quote.h"
#include "openltc/image/file.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/meshopt.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace openltc::scene::gltf {

namespace {

constexpr std::string_view k_supported[] = {
    "EXT_lights_area",
    "EXT_lights_ies",
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_unlit",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_xmp_json_ld", // metadata, nothing to draw
};

struct Meaning {
  std::string_view extension;
  std::string_view without;
};

constexpr std::string_view k_without_textures =
    "the plain PNG or JPEG is used where the file has one, other such textures are left out";

constexpr Meaning k_unsupported[] = {
    {"KHR_materials_clearcoat", "the clear coat is left out"},
    {"KHR_materials_transmission", "such surfaces are opaque"},
    {"KHR_materials_volume", "such bodies do not tint or refract light"},
    {"KHR_materials_volume_scatter", "light does not scatter inside such bodies"},
    {"KHR_materials_diffuse_transmission", "no light shines through such surfaces"},
    {"KHR_materials_dispersion", "refraction shows no rainbow"},
    {"KHR_materials_sheen", "the sheen of cloth is left out"},
    {"KHR_materials_iridescence", "thin-film colours are left out"},
    {"KHR_materials_anisotropy", "brushed surfaces reflect alike in all directions"},
    {"KHR_materials_pbrSpecularGlossiness",
     "such materials use their metallic-roughness values or plain white"},
    {"KHR_materials_variants", "the file's first variant is shown"},
    {"KHR_texture_basisu", k_without_textures},
    {"EXT_texture_webp", k_without_textures},
    {"EXT_texture_avif", k_without_textures},
    {"MSFT_texture_dds", k_without_textures},
    {"EXT_lights_image_based", "the environment's light is left out"},
    {"MSFT_lod", "the first level of detail is shown"},
    {"KHR_animation_pointer", "what it moves stays at rest"},
    {"KHR_node_visibility", "hidden objects are shown"},
};

// What concerns textures alone leaves shapes and lights as they are.
bool is_about_textures(const std::string& name) {
  return name.find("_texture_") != std::string::npos;
}

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

} // namespace

void check_extensions(const std::vector<std::string>& used,
                      const std::vector<std::string>& required, Document& document) {
  const auto is_supported = [](const std::string& name) {
    return std::find(std::begin(k_supported), std::end(k_supported), name) !=
               std::end(k_supported) ||
           (name == "EXT_texture_webp" && image::can_read_webp());
  };
  for (std::size_t i = 0; i < required.size(); ++i) {
    const std::string field = fmt::format("extensionsRequired[{}]", i);
    if (!is_supported(required[i]) && !is_about_textures(required[i]))
      fail(field,
           fmt::format("{} is not supported; export the file without it", quote(required[i])));
    if (required[i] == "EXT_meshopt_compression" && !has_meshopt_decoder())
      fail(field,
           "EXT_meshopt_compression is not supported by this build; install meshoptimizer and "
           "build again, or export the file without it");
  }
  std::vector<std::string> names = used;
  for (const std::string& name : required)
    if (!contains(used, name)) names.push_back(name);
  for (const std::string& name : names) {
    if (is_supported(name)) continue;
    const auto known = std::find_if(std::begin(k_unsupported), std::end(k_unsupported),
                                    [&](const Meaning& m) { return m.extension == name; });
    document.warnings.add(fmt::format("{} is not supported yet: {}", quote(name),
                                      known != std::end(k_unsupported) ? known->without
                                      : is_about_textures(name)        ? k_without_textures
                                                                : "what it adds is left out"));
  }
}

} // namespace openltc::scene::gltf
