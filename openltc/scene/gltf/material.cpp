// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Materials: glTF 2.0 specification, section 3.9; KHR_materials_emissive_strength, _ior, _specular,
// _unlit; KHR_texture_transform.

#include "openltc/scene/gltf/material.h"

#include "openltc/base/quote.h"
#include "openltc/scene/gltf/file/document.h"
#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/tinygltf.h"
#include "openltc/scene/gltf/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace openltc::scene::gltf {

namespace {

enum class ColorSpace { data, color };

const tinygltf::Value* find_extension(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

double number(const tinygltf::Value& object, const char* name, double otherwise) {
  return object.Has(name) ? object.Get(name).GetNumberAsDouble() : otherwise;
}

double number(const tinygltf::Value& object, const char* name, int element, double otherwise) {
  return object.Has(name) ? object.Get(name).Get(element).GetNumberAsDouble() : otherwise;
}

Wrap wrap_from(int gl) {
  if (gl == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp_to_edge;
  if (gl == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirrored_repeat;
  return Wrap::repeat;
}

class Reader {
public:
  Reader(Document& document, Scene& scene)
      : document_(document), scene_(scene), pictures_(document, *scene.memory) {}

  void read() {
    for (std::size_t i = 0; i < document_.model->materials.size(); ++i) {
      field_ = fmt::format("materials[{}]", i);
      scene_.materials.push_back(read_material(document_.model->materials[i]));
    }
  }

private:
  Material read_material(const tinygltf::Material& from) {
    Material to;
    to.name = from.name;
    const auto& pbr = from.pbrMetallicRoughness;
    const auto& factor = pbr.baseColorFactor;
    const std::string pbr_field = field_ + ".pbrMetallicRoughness";
    to.base_color = Vec4f(clamped(factor[0], pbr_field + ".baseColorFactor"),
                          clamped(factor[1], pbr_field + ".baseColorFactor"),
                          clamped(factor[2], pbr_field + ".baseColorFactor"),
                          clamped(factor[3], pbr_field + ".baseColorFactor"));
    to.base_color_texture = read_texture(pbr.baseColorTexture, ColorSpace::color);
    to.metallic = clamped(pbr.metallicFactor, pbr_field + ".metallicFactor");
    to.roughness = clamped(pbr.roughnessFactor, pbr_field + ".roughnessFactor");
    to.metallic_roughness_texture = read_texture(pbr.metallicRoughnessTexture, ColorSpace::data);
    to.normal_texture = read_texture(from.normalTexture, ColorSpace::data);
    to.normal_scale = float(from.normalTexture.scale);
    to.occlusion_texture = read_texture(from.occlusionTexture, ColorSpace::data);
    to.occlusion_strength =
        clamped(from.occlusionTexture.strength, field_ + ".occlusionTexture.strength");
    to.alpha_mode = from.alphaMode == "MASK"    ? AlphaMode::mask
                    : from.alphaMode == "BLEND" ? AlphaMode::blend
                                                : AlphaMode::opaque;
    to.alpha_cutoff = float(from.alphaCutoff);
    to.double_sided = from.doubleSided;
    to.unlit = find_extension(from.extensions, "KHR_materials_unlit") != nullptr;
    read_emission(from, to);
    if (const auto* ior = find_extension(from.extensions, "KHR_materials_ior"))
      to.ior = checked_ior(number(*ior, "ior", 1.5));
    if (const auto* specular = find_extension(from.extensions, "KHR_materials_specular"))
      read_specular(*specular, to);
    return to;
  }

  void read_emission(const tinygltf::Material& from, Material& to) {
    double strength = 1;
    if (const auto* extension = find_extension(from.extensions, "KHR_materials_emissive_strength"))
      strength = number(*extension, "emissiveStrength", 1);
    const double emission[3] = {from.emissiveFactor[0] * strength,
                                from.emissiveFactor[1] * strength,
                                from.emissiveFactor[2] * strength};
    to.emission = Vec3f(not_negative(emission[0], field_ + ".emissiveFactor"),
                        not_negative(emission[1], field_ + ".emissiveFactor"),
                        not_negative(emission[2], field_ + ".emissiveFactor"));
    const bool emits = to.emission.x > 0 || to.emission.y > 0 || to.emission.z > 0;
    // A picture that is multiplied by black need not be read.
    if (emits) to.emission_texture = read_texture(from.emissiveTexture, ColorSpace::color);
    // Most emission textures are black but for a few places; without it nobody knows where.
    const bool is_lost = from.emissiveTexture.index >= 0 && to.emission_texture.texture < 0;
    if (emits && is_lost) {
      document_.warnings.add(field_ + ".emissiveTexture: without it, the material does not shine");
      to.emission = Vec3f(0, 0, 0);
    }
  }

  void read_specular(const tinygltf::Value& specular, Material& to) {
    const std::string field = field_ + ".extensions.KHR_materials_specular";
    to.specular = clamped(number(specular, "specularFactor", 1), field + ".specularFactor");
    to.specular_color = Vec3f(not_negative(number(specular, "specularColorFactor", 0, 1), field),
                              not_negative(number(specular, "specularColorFactor", 1, 1), field),
                              not_negative(number(specular, "specularColorFactor", 2, 1), field));
    to.specular_texture = read_texture_value(specular, "specularTexture", ColorSpace::data);
    to.specular_color_texture =
        read_texture_value(specular, "specularColorTexture", ColorSpace::color);
  }

  float clamped(double value, const std::string& field) {
    if (value >= 0 && value <= 1) return float(value);
    document_.warnings.add(
        fmt::format("{}: {} is outside 0 to 1; the nearest value is used", field, value));
    return float(std::clamp(value, 0.0, 1.0));
  }

  float not_negative(double value, const std::string& field) {
    if (value >= 0) return float(std::min(value, 1e30));
    document_.warnings.add(fmt::format("{}: {} is negative; 0 is used", field, value));
    return 0;
  }

  // 0 is the extension's way of saying "reflects everything".
  float checked_ior(double ior) {
    if (ior == 0 || ior >= 1) return float(ior);
    document_.warnings.add(
        fmt::format("{}.extensions.KHR_materials_ior.ior: {} is below 1; 1 is used", field_, ior));
    return 1;
  }

  template <class Info> TextureRef read_texture(const Info& info, ColorSpace space) {
    if (info.index < 0) return {};
    return make_reference(info.index, info.texCoord,
                          find_extension(info.extensions, "KHR_texture_transform"), space);
  }

  TextureRef read_texture_value(const tinygltf::Value& parent, const char* name, ColorSpace space) {
    if (!parent.Has(name)) return {};
    const tinygltf::Value& info = parent.Get(name);
    const tinygltf::Value* transform = nullptr;
    if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform"))
      transform = &info.Get("extensions").Get("KHR_texture_transform");
    return make_reference(info.Get("index").GetNumberAsInt(), int(number(info, "texCoord", 0)),
                          transform, space);
  }

  TextureRef make_reference(int index, int tex_coord, const tinygltf::Value* transform,
                            ColorSpace space) {
    TextureRef ref;
    ref.tex_coord = tex_coord;
    if (transform && transform->IsObject()) {
      ref.tex_coord = int(number(*transform, "texCoord", tex_coord));
      // uv' = T R S uv. The turn is counter-clockwise as one sees it with v pointing down, which is
      // what the extension's text, its example and Khronos' test model ask for; its GLSL sample,
      // read column by column, turns the other way.
      const double angle_rad = number(*transform, "rotation", 0);
      const double c = std::cos(angle_rad), s = std::sin(angle_rad);
      const double sx = number(*transform, "scale", 0, 1), sy = number(*transform, "scale", 1, 1);
      const double ox = number(*transform, "offset", 0, 0), oy = number(*transform, "offset", 1, 0);
      ref.uv_row0 = {float(c * sx), float(s * sy), float(ox)};
      ref.uv_row1 = {float(-s * sx), float(c * sy), float(oy)};
    }
    if (ref.tex_coord > 1) {
      document_.warnings.add(
          fmt::format("{}: it uses TEXCOORD_{}; only the first two sets are supported, the "
                      "texture is left out",
                      field_, ref.tex_coord));
      return {};
    }
    try {
      ref.texture = load_texture(index, space);
    } catch (const Failure& failure) {
      document_.warnings.add(failure.message + "; the texture is left out");
      return {};
    }
    return ref;
  }

  int load_texture(int index, ColorSpace space) {
    const auto& model = *document_.model;
    const tinygltf::Texture& from = model.textures[std::size_t(index)];
    const TextureSource& source = document_.texture_sources[std::size_t(index)];
    if (source.images.empty())
      fail(
          fmt::format("textures[{}]", index),
          source.foreign.empty()
              ? "has no source"
              : fmt::format("has its picture in {} only, which is not read; PNG, JPEG and WebP are",
                            quote(source.foreign)));
    Texture to;
    if (from.sampler >= 0) {
      const tinygltf::Sampler& sampler = model.samplers[std::size_t(from.sampler)];
      to.wrap_u = wrap_from(sampler.wrapS);
      to.wrap_v = wrap_from(sampler.wrapT);
      to.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    const Key key{source.images, space, to.wrap_u, to.wrap_v, to.nearest};
    const auto found = loaded_.find(key);
    if (found != loaded_.end()) return found->second;
    to.image = load_picture(source, space);
    scene_.textures.push_back(std::move(to));
    const int result = int(scene_.textures.size()) - 1;
    loaded_[key] = result;
    return result;
  }

  // Another form of the picture stands in for one that cannot be read.
  image::Texels load_picture(const TextureSource& source, ColorSpace space) {
    const bool is_color = space == ColorSpace::color;
    for (std::size_t i = 0; i + 1 < source.images.size(); ++i) {
      try {
        return pictures_.load(source.images[i], is_color);
      } catch (const Failure& failure) {
        document_.warnings.add(failure.message + "; the plain picture is used");
      }
    }
    return pictures_.load(source.images.back(), is_color);
  }

  using Key = std::tuple<std::vector<int>, ColorSpace, Wrap, Wrap, bool>;

  Document& document_;
  Scene& scene_;
  std::string field_;
  Pictures pictures_;
  std::map<Key, int> loaded_;
};

} // namespace

void read_materials(Document& document, Scene& scene) { Reader(document, scene).read(); }

VertexNeeds vertex_needs(const Material& material) {
  VertexNeeds needs;
  for (const TextureRef* ref :
       {&material.base_color_texture, &material.metallic_roughness_texture,
        &material.normal_texture, &material.occlusion_texture, &material.emission_texture,
        &material.specular_texture, &material.specular_color_texture})
    if (ref->texture >= 0) needs.tex_coord[ref->tex_coord] = true;
  if (material.normal_texture.texture >= 0)
    needs.tangent_tex_coord = material.normal_texture.tex_coord;
  return needs;
}

} // namespace openltc::scene::gltf
