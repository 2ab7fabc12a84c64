// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf_extensions.h"

#include "openltc/scene/gltf_document.h"
#include "openltc/scene/gltf_failure.h"
#include "openltc/scene/gltf_meshopt.h"

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
    {"KHR_texture_basisu", "the plain PNG or JPEG is used where the file has one"},
    {"EXT_texture_webp", "the plain PNG or JPEG is used where the file has one"},
    {"EXT_texture_avif", "the plain PNG or JPEG is used where the file has one"},
    {"MSFT_texture_dds", "the plain PNG or JPEG is used where the file has one"},
    {"EXT_lights_image_based", "the environment's light is left out"},
    {"MSFT_lod", "the first level of detail is shown"},
    {"KHR_animation_pointer", "what it moves stays at rest"},
    {"KHR_node_visibility", "hidden objects are shown"},
};

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

} // namespace

void check_extensions(const std::vector<std::string>& used,
                      const std::vector<std::string>& required, Document& document) {
  const auto is_supported = [](const std::string& name) {
    return std::find(std::begin(k_supported), std::end(k_supported), name) != std::end(k_supported);
  };
  for (std::size_t i = 0; i < required.size(); ++i) {
    const std::string field = fmt::format("extensionsRequired[{}]", i);
    if (!is_supported(required[i]))
      fail(field, fmt::format("{} is not supported; export the file without it",
                              required[i].substr(0, 60)));
    if (required[i] == "EXT_meshopt_compression" && !has_meshopt_decoder())
      fail(field,
           "EXT_meshopt_compression is not supported by this build; install meshoptimizer and "
           "build again, or export the file without it");
  }
  for (const std::string& name : used) {
    if (is_supported(name) || contains(required, name)) continue;
    const auto known = std::find_if(std::begin(k_unsupported), std::end(k_unsupported),
                                    [&](const Meaning& m) { return m.extension == name; });
    document.warnings.add(fmt::format("{} is not supported yet: {}", name.substr(0, 60),
                                      known == std::end(k_unsupported) ? "what it adds is left out"
                                                                       : known->without));
  }
}

} // namespace openltc::scene::gltf
