// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "gltf_builder.h"

#include <doctest/doctest.h>

#include <array>

namespace openltc::test {

namespace {

void put_u32(std::vector<std::uint8_t>& out, std::uint32_t value, bool big_endian = false) {
  for (int i = 0; i < 4; ++i)
    out.push_back(std::uint8_t(value >> (big_endian ? 24 - 8 * i : 8 * i) & 0xFF));
}

std::uint32_t crc32(const std::uint8_t* data, std::size_t size) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= data[i];
    for (int bit = 0; bit < 8; ++bit)
      crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

void put_chunk(std::vector<std::uint8_t>& png, const char* type,
               const std::vector<std::uint8_t>& data) {
  put_u32(png, std::uint32_t(data.size()), true);
  const std::size_t start = png.size();
  png.insert(png.end(), type, type + 4);
  png.insert(png.end(), data.begin(), data.end());
  put_u32(png, crc32(png.data() + start, png.size() - start), true);
}

} // namespace

GltfBuilder::GltfBuilder() {
  root["asset"] = {{"version", "2.0"}};
  root["scene"] = 0;
  root["scenes"] = json::array({{{"nodes", json::array()}}});
}

int GltfBuilder::add(const char* array, const json& object) {
  root[array].push_back(object);
  return int(root[array].size()) - 1;
}

void GltfBuilder::use(const char* extension, bool is_required) {
  root["extensionsUsed"].push_back(extension);
  if (is_required) root["extensionsRequired"].push_back(extension);
}

int GltfBuilder::add_view(const void* data, std::size_t size, std::size_t stride) {
  while (buffer.size() % 4 != 0)
    buffer.push_back(0);
  json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", size}};
  if (stride != 0) view["byteStride"] = stride;
  const auto* bytes = static_cast<const std::uint8_t*>(data);
  buffer.insert(buffer.end(), bytes, bytes + size);
  return add("bufferViews", view);
}

int GltfBuilder::add_accessor_over(int view, std::size_t count, const char* type,
                                   int component_type, bool normalized) {
  json accessor = {
      {"bufferView", view}, {"count", count}, {"type", type}, {"componentType", component_type}};
  if (normalized) accessor["normalized"] = true;
  return add("accessors", accessor);
}

int GltfBuilder::add_mesh_node(const json& primitive, const json& node) {
  json with_mesh = node;
  with_mesh["mesh"] = add("meshes", {{"primitives", json::array({primitive})}});
  const int index = add("nodes", with_mesh);
  root["scenes"][0]["nodes"].push_back(index);
  return index;
}

json GltfBuilder::square_primitive() {
  const int positions = add_vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  const int normals = add_vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  const int uv = add_vec2({0, 1, 1, 1, 1, 0, 0, 0});
  const int indices = add_indices({0, 1, 2, 0, 2, 3});
  return {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}}},
          {"indices", indices}};
}

int GltfBuilder::add_texture(int width, int height, const std::vector<std::uint8_t>& rgba,
                             const json& sampler) {
  const std::string uri = "data:image/png;base64," + base64(make_png(width, height, rgba));
  const int image = add("images", {{"uri", uri}});
  return add("textures", {{"source", image}, {"sampler", add("samplers", sampler)}});
}

std::string GltfBuilder::to_text() const {
  json complete = root;
  if (!buffer.empty() && !complete.contains("buffers"))
    complete["buffers"] =
        json::array({{{"byteLength", buffer.size()},
                      {"uri", "data:application/octet-stream;base64," + base64(buffer)}}});
  return complete.dump();
}

std::vector<std::uint8_t> GltfBuilder::to_glb() const {
  json complete = root;
  if (!buffer.empty() && !complete.contains("buffers"))
    complete["buffers"] = json::array({{{"byteLength", buffer.size()}}});
  std::string text = complete.dump();
  while (text.size() % 4 != 0)
    text += ' ';
  std::vector<std::uint8_t> binary = buffer;
  while (binary.size() % 4 != 0)
    binary.push_back(0);
  std::vector<std::uint8_t> glb = {'g', 'l', 'T', 'F'};
  put_u32(glb, 2);
  put_u32(glb, std::uint32_t(12 + 8 + text.size() + (binary.empty() ? 0 : 8 + binary.size())));
  put_u32(glb, std::uint32_t(text.size()));
  put_u32(glb, 0x4E4F534A);
  glb.insert(glb.end(), text.begin(), text.end());
  if (!binary.empty()) {
    put_u32(glb, std::uint32_t(binary.size()));
    put_u32(glb, 0x004E4942);
    glb.insert(glb.end(), binary.begin(), binary.end());
  }
  return glb;
}

Result<scene::Scene> GltfBuilder::load() const {
  const std::string text = to_text();
  return load_bytes(std::vector<std::uint8_t>(text.begin(), text.end()));
}

Result<scene::Scene> GltfBuilder::load_glb() const { return load_bytes(to_glb()); }

std::string base64(const std::vector<std::uint8_t>& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::vector<std::uint8_t> make_png(int width, int height, const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> header;
  put_u32(header, std::uint32_t(width), true);
  put_u32(header, std::uint32_t(height), true);
  for (const int byte : {8, 6, 0, 0, 0})
    header.push_back(std::uint8_t(byte)); // 8-bit RGBA

  std::vector<std::uint8_t> rows; // each with filter type 0
  const std::size_t row_size = std::size_t(width) * 4;
  for (std::size_t y = 0; y < std::size_t(height); ++y) {
    rows.push_back(0);
    rows.insert(rows.end(), rgba.begin() + std::ptrdiff_t(y * row_size),
                rgba.begin() + std::ptrdiff_t((y + 1) * row_size));
  }
  // zlib with stored blocks
  std::vector<std::uint8_t> zlib = {0x78, 0x01};
  for (std::size_t at = 0; at < rows.size(); at += 65535) {
    const std::size_t size = std::min<std::size_t>(65535, rows.size() - at);
    zlib.push_back(at + size == rows.size());
    for (const std::size_t v : {size, ~size}) {
      zlib.push_back(std::uint8_t(v & 0xFF));
      zlib.push_back(std::uint8_t(v >> 8 & 0xFF));
    }
    zlib.insert(zlib.end(), rows.begin() + std::ptrdiff_t(at),
                rows.begin() + std::ptrdiff_t(at + size));
  }
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : rows) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  put_u32(zlib, b << 16 | a, true);

  std::vector<std::uint8_t> png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  put_chunk(png, "IHDR", header);
  put_chunk(png, "IDAT", zlib);
  put_chunk(png, "IEND", {});
  return png;
}

Result<scene::Scene> load_bytes(const std::vector<std::uint8_t>& bytes) {
  return scene::load_gltf_memory(bytes, "test.gltf");
}

bool fails_naming(const Result<scene::Scene>& result, const std::string& part) {
  if (result.ok()) return false;
  const std::string& message = result.error().message;
  const bool is_good = message.rfind("test.gltf: ", 0) == 0 &&
                       message.find(part) != std::string::npos &&
                       message.find('\n') == std::string::npos;
  if (!is_good) MESSAGE("unexpected error: " << message);
  return is_good;
}

bool warns_about(const scene::Scene& scene, const std::string& part) {
  for (const std::string& warning : scene.warnings)
    if (warning.find(part) != std::string::npos) return true;
  for ([[maybe_unused]] const std::string& warning : scene.warnings)
    MESSAGE("warning: " << warning);
  return false;
}

double area_of(const scene::Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += 0.5 * double(length(cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                     mesh.positions[t[2]] - mesh.positions[t[0]])));
  return sum;
}

} // namespace openltc::test
