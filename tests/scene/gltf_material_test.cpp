// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "gltf_builder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace openltc;
using namespace openltc::test;

scene::Material load_material(GltfBuilder& file, const json& material) {
  json primitive = file.square_primitive();
  primitive["material"] = file.add("materials", material);
  file.add_mesh_node(primitive);
  const auto loaded = file.load();
  if (!loaded.ok()) FAIL(loaded.error().message);
  return loaded->materials[std::size_t(loaded->meshes[0].material)];
}

TEST_CASE("an_empty_material_has_the_defaults_of_the_specification") {
  GltfBuilder file;
  const scene::Material m = load_material(file, json::object());
  CHECK(m.base_color.x == 1.0f);
  CHECK(m.metallic == 1.0f);
  CHECK(m.roughness == 1.0f);
  CHECK(m.ior == 1.5f);
  CHECK(m.specular == 1.0f);
  CHECK(m.emission.x == 0.0f);
  CHECK(m.alpha_mode == scene::AlphaMode::opaque);
  CHECK(m.alpha_cutoff == 0.5f);
  CHECK(!m.double_sided);
  CHECK(!m.unlit);
  CHECK(m.base_color_texture.texture == -1);
}

TEST_CASE("material_values_and_extensions_are_read") {
  GltfBuilder file;
  const scene::Material m =
      load_material(file, {{"name", "paint"},
                           {"pbrMetallicRoughness",
                            {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                             {"metallicFactor", 0.5},
                             {"roughnessFactor", 0.25}}},
                           {"emissiveFactor", {1, 0.5, 0}},
                           {"alphaMode", "MASK"},
                           {"alphaCutoff", 0.75},
                           {"doubleSided", true},
                           {"extensions",
                            {{"KHR_materials_emissive_strength", {{"emissiveStrength", 5000}}},
                             {"KHR_materials_ior", {{"ior", 1.33}}},
                             {"KHR_materials_specular",
                              {{"specularFactor", 0.5}, {"specularColorFactor", {0.25, 0.5, 2}}}},
                             {"KHR_materials_unlit", json::object()}}}});
  CHECK(m.name == "paint");
  CHECK(m.base_color.w == doctest::Approx(0.4f));
  CHECK(m.metallic == doctest::Approx(0.5f));
  CHECK(m.roughness == doctest::Approx(0.25f));
  CHECK(m.emission.x == doctest::Approx(5000.0f));
  CHECK(m.emission.y == doctest::Approx(2500.0f));
  CHECK(m.alpha_mode == scene::AlphaMode::mask);
  CHECK(m.alpha_cutoff == doctest::Approx(0.75f));
  CHECK(m.double_sided);
  CHECK(m.unlit);
  CHECK(m.ior == doctest::Approx(1.33f));
  CHECK(m.specular == doctest::Approx(0.5f));
  CHECK(m.specular_color.z == doctest::Approx(2.0f));
}

TEST_CASE("values_out_of_range_are_moved_into_it_with_a_warning") {
  GltfBuilder file;
  json primitive = file.square_primitive();
  primitive["material"] =
      file.add("materials", {{"pbrMetallicRoughness", {{"roughnessFactor", 1.5}}},
                             {"emissiveFactor", {-1, 0, 0}},
                             {"extensions", {{"KHR_materials_ior", {{"ior", 0.5}}}}}});
  file.add_mesh_node(primitive);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->materials[0].roughness == 1.0f);
  CHECK(loaded->materials[0].ior == 1.0f);
  CHECK(loaded->materials[0].emission.x == 0.0f);
  CHECK(warns_about(*loaded, "materials[0].pbrMetallicRoughness.roughnessFactor"));
  CHECK(warns_about(*loaded, "KHR_materials_ior.ior"));
  CHECK(warns_about(*loaded, "materials[0].emissiveFactor"));
}

TEST_CASE("colour_textures_are_decoded_to_linear_and_data_textures_are_not") {
  GltfBuilder file;
  // mid grey: sRGB 188/255 is 0.5029 linear
  const int texture = file.add_texture(1, 1, {188, 188, 188, 188});
  json primitive = file.square_primitive();
  primitive["material"] =
      file.add("materials", {{"pbrMetallicRoughness",
                              {{"baseColorTexture", {{"index", texture}}},
                               {"metallicRoughnessTexture", {{"index", texture}}}}},
                             {"occlusionTexture", {{"index", texture}, {"strength", 0.5}}}});
  file.add_mesh_node(primitive);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  const scene::Material& m = loaded->materials[0];
  // once for each colour space
  CHECK(loaded->textures.size() == 2);
  CHECK(m.metallic_roughness_texture.texture == m.occlusion_texture.texture);
  CHECK(m.occlusion_strength == doctest::Approx(0.5f));
  const auto& color = loaded->textures[std::size_t(m.base_color_texture.texture)].image;
  const auto& data = loaded->textures[std::size_t(m.occlusion_texture.texture)].image;
  CHECK(color.rgba(0, 0).x == doctest::Approx(0.5029f).epsilon(1e-3));
  CHECK(color.rgba(0, 0).w == doctest::Approx(188.0f / 255.0f)); // alpha is linear
  CHECK(data.rgba(0, 0).x == doctest::Approx(188.0f / 255.0f));
  CHECK(color.byte_count() == 4); // as in the file
}

TEST_CASE("samplers_are_read_and_rows_run_from_the_top") {
  GltfBuilder file;
  const int texture = file.add_texture(1, 2, {255, 0, 0, 255, 0, 255, 0, 255},
                                       {{"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}});
  const scene::Material m =
      load_material(file, {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  const auto loaded = file.load();
  const scene::Texture& t = loaded->textures[std::size_t(m.base_color_texture.texture)];
  CHECK(t.nearest);
  CHECK(t.wrap_u == scene::Wrap::clamp_to_edge);
  CHECK(t.wrap_v == scene::Wrap::mirrored_repeat);
  CHECK(t.image.height == 2);
  CHECK(t.image.rgb(0, 0).x == 1.0f);
  CHECK(t.image.rgb(0, 1).y == 1.0f);
}

TEST_CASE("texture_transform_scales_then_rotates_then_shifts") {
  GltfBuilder file;
  const int texture = file.add_texture(1, 1, {255, 255, 255, 255});
  json primitive = file.square_primitive();
  primitive["attributes"]["TEXCOORD_1"] = primitive["attributes"]["TEXCOORD_0"];
  primitive["material"] = file.add("materials", {{"pbrMetallicRoughness",
                                                  {{"baseColorTexture",
                                                    {{"index", texture},
                                                     {"texCoord", 0},
                                                     {"extensions",
                                                      {{"KHR_texture_transform",
                                                        {{"offset", {0.1, 0.2}},
                                                         {"rotation", std::numbers::pi / 2},
                                                         {"scale", {2, 3}},
                                                         {"texCoord", 1}}}}}}}}}});
  file.add_mesh_node(primitive);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  const scene::TextureRef& ref = loaded->materials[0].base_color_texture;
  CHECK(ref.tex_coord == 1); // the extension's own wins
  // the extension's matrix [c s; -s c] by a quarter turn takes (2u, 3v) to (3v, -2u)
  const auto apply = [&](float u, float v) {
    return Vec2f(ref.uv_row0[0] * u + ref.uv_row0[1] * v + ref.uv_row0[2],
                 ref.uv_row1[0] * u + ref.uv_row1[1] * v + ref.uv_row1[2]);
  };
  CHECK(apply(1, 0).x == doctest::Approx(0.1f));
  CHECK(apply(1, 0).y == doctest::Approx(0.2f - 2.0f));
  CHECK(apply(0, 1).x == doctest::Approx(0.1f + 3.0f));
  CHECK(apply(0, 1).y == doctest::Approx(0.2f));
}

TEST_CASE("a_mesh_without_the_texture_coordinates_of_its_material_gets_zeros_and_a_warning") {
  GltfBuilder file;
  const int texture = file.add_texture(1, 1, {255, 255, 255, 255});
  json primitive = file.square_primitive();
  primitive["attributes"].erase("TEXCOORD_0");
  primitive["material"] = file.add(
      "materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  file.add_mesh_node(primitive);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->meshes[0].tex_coord_0.size() == loaded->meshes[0].positions.size());
  CHECK(warns_about(*loaded, "TEXCOORD_0"));
}

TEST_CASE("textures_in_unsupported_formats_fall_back_to_the_plain_picture") {
  GltfBuilder file;
  const int texture = file.add_texture(1, 1, {255, 255, 255, 255});
  file.use("KHR_texture_basisu");
  file.root["textures"][texture]["extensions"] = {{"KHR_texture_basisu", {{"source", 7}}}};
  json primitive = file.square_primitive();
  primitive["material"] = file.add(
      "materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  file.add_mesh_node(primitive);
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(loaded->textures.size() == 1);
  CHECK(warns_about(*loaded, "KHR_texture_basisu"));
  file.root["textures"][texture].erase("source");
  const auto without = file.load();
  REQUIRE(without.ok());
  CHECK(without->textures.empty());
  CHECK(warns_about(*without, "textures[0]: has its picture in KHR_texture_basisu only"));
}

TEST_CASE("pictures_inside_the_binary_chunk_are_read") {
  GltfBuilder file;
  const auto png = make_png(1, 1, {0, 0, 255, 255});
  const int view = file.add_view(png.data(), png.size());
  const int image = file.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  const int texture = file.add("textures", {{"source", image}});
  json primitive = file.square_primitive();
  primitive["material"] = file.add(
      "materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  file.add_mesh_node(primitive);
  const auto loaded = file.load_glb();
  REQUIRE(loaded.ok());
  CHECK(loaded->textures.at(0).image.rgb(0, 0).z == 1.0f);
}

TEST_CASE("optional_extensions_are_named_with_what_is_missing_and_required_ones_are_refused") {
  GltfBuilder file;
  file.add_mesh_node(file.square_primitive());
  file.use("KHR_materials_clearcoat");
  file.use("ACME_glitter");
  const auto loaded = file.load();
  REQUIRE(loaded.ok());
  CHECK(warns_about(*loaded, "KHR_materials_clearcoat is not supported yet: the clear coat"));
  CHECK(warns_about(*loaded, "ACME_glitter"));
  file.use("ACME_magic", true);
  CHECK(fails_naming(file.load(), "extensionsRequired[0]: ACME_magic"));
}

} // namespace
