// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A scene ready to render: world-space triangles, materials, textures, cameras, lights.
//
// Everything is flattened: node transforms are applied, strips and fans are triangles, instances
// are copies, skins and morph targets have bent the vertices. World space is glTF's: right-handed,
// +Y up, metres; but it is moved, so that single precision suffices however far from the file's
// origin a scene lies (Scene::origin).

#pragma once

#include "openltc/base/memory_budget.h"
#include "openltc/image/texels.h"
#include "openltc/light/light.h"
#include "openltc/target/vec.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace openltc::scene {

enum class Wrap { repeat, clamp_to_edge, mirrored_repeat };

/// An image with its sampler. Colour textures (base colour, emissive, specular colour) are looked
/// at as linear; data textures (normal, roughness-metallic, specular factor) as they are.
struct Texture {
  image::Texels image;
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  bool nearest = false; ///< magnification without interpolation
};

/// Use of a texture by a material: which one, which coordinates, KHR_texture_transform applied as
/// uv' = (uv_row0 . (u, v, 1), uv_row1 . (u, v, 1)).
struct TextureRef {
  int texture = -1;  ///< index into Scene::textures, -1 = none
  int tex_coord = 0; ///< 0 or 1
  std::array<float, 3> uv_row0{1, 0, 0};
  std::array<float, 3> uv_row1{0, 1, 0};
};

enum class AlphaMode { opaque, mask, blend };

/// glTF metallic-roughness with KHR_materials_specular, _ior, _emissive_strength and _unlit.
struct Material {
  std::string name;
  Vec4f base_color{1, 1, 1, 1}; ///< linear, straight alpha
  TextureRef base_color_texture;
  float metallic = 1;
  float roughness = 1;                   ///< perceptual
  TextureRef metallic_roughness_texture; ///< G = roughness, B = metallic
  TextureRef normal_texture;
  float normal_scale = 1;
  TextureRef occlusion_texture; ///< kept for completeness; direct light is not attenuated by it
  float occlusion_strength = 1;
  Vec3f emission{0, 0, 0}; ///< nits: emissiveFactor * emissive_strength
  TextureRef emission_texture;
  float specular = 1; ///< KHR_materials_specular, times its texture's alpha
  TextureRef specular_texture;
  Vec3f specular_color{1, 1, 1};
  TextureRef specular_color_texture;
  float ior = 1.5f;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;
};

/// An indexed triangle mesh in world space. Per-vertex arrays are either empty or as long as
/// `positions`; normals are never empty. All positions are finite, all indices in range.
struct Mesh {
  std::string name;
  int material = 0;                                    ///< index into Scene::materials
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise seen from the front
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;  ///< unit
  std::vector<Vec4f> tangents; ///< unit xyz, w = sign of the bitangent; empty without a normal map
  std::vector<Vec2f> tex_coord_0;
  std::vector<Vec2f> tex_coord_1;
  std::vector<Vec4f> colors; ///< linear
  int node = -1;             ///< of the glTF file that shows it
  /// Metres by which each coordinate may be off because the file holds it in single precision.
  float rounding = 0;
  /// Whether its emission makes lights; not where its node carries the light that stands for it.
  bool emits_light = true;
};

enum class Projection { perspective, orthographic };

/// Looks along -Z of its frame, +Y up.
struct Camera {
  std::string name;
  Projection projection = Projection::perspective;
  Vec3f position{0, 0, 0};
  Vec3f right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1}; ///< orthonormal, world space
  float fov_y_rad = 0.8f;                               ///< perspective: full vertical angle
  float height = 2; ///< orthographic: full height of the view, metres
  float aspect = 0; ///< width / height, 0 = that of the picture
  float near = 0;   ///< metres; geometry closer is not seen
  float far = 0;    ///< metres, 0 = infinite
};

struct Bounds {
  Vec3f lower{0, 0, 0}, upper{0, 0, 0};
};

/// An animation of the file, which can pose the scene.
struct Animation {
  std::string name;
  double duration_seconds = 0; ///< the time of its last key
};

struct Scene {
  /// What to add to a coordinate of this scene, in double, to have the file's: positions, lights,
  /// cameras and bounds are all relative to it. Zero for scenes about the file's origin.
  Vec3d origin{0, 0, 0};
  std::vector<Mesh> meshes;
  std::vector<Material> materials; ///< never empty: a default one stands last if any mesh needs it
  std::vector<Texture> textures;
  std::vector<Camera> cameras;
  light::Lights lights;
  std::vector<Animation> animations; ///< of the file; those that cannot be read are missing
  Bounds bounds;                     ///< of all positions
  /// Whether the file says expressly that there is light: a node that is shown carries one, also
  /// one that cannot be read, or a material has KHR_materials_emissive_strength. Plain emissive
  /// factors do not say it.
  bool describes_lights = false;
  std::vector<std::string> warnings; ///< for the user, each one line
  /// What of the memory budget the scene has; given back with its last copy.
  std::shared_ptr<MemoryShare> memory = std::make_shared<MemoryShare>();
};

} // namespace openltc::scene
