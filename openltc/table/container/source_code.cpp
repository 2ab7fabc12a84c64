// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/container/source_code.h"

#include "openltc/table/container/description.h"

#include <fmt/format.h>

namespace openltc::table {

namespace {

// Letters, digits and single underscores; GLSL reserves double ones, "gl_" and leading ones.
std::string identifier(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool digit = c >= '0' && c <= '9';
    if (letter || (digit && !out.empty()))
      out += c;
    else if (digit)
      out += fmt::format("t{}", c);
    else if (!out.empty() && out.back() != '_')
      out += '_';
  }
  while (!out.empty() && out.back() == '_')
    out.pop_back();
  if (out.empty() || out.compare(0, 3, "gl_") == 0) out = "table" + out;
  return out;
}

// One line of a comment: nothing that could end it or run into the next line.
std::string comment_text(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
    if (c == '\\') c = '/';
    if (c == '?') c = '.'; // trigraphs
  }
  return text;
}

std::string literal(float value, const char* suffix) {
  std::string text = json_number(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + suffix;
}

// The texels one a line: OPEN channels CLOSE, separated by commas, with the rows put in `row_open`
// and `row_close`.
std::string texels(const Texture& texture, const std::string& open, const char* close,
                   const char* suffix, const std::string& row_open = "",
                   const char* row_close = "") {
  std::string out;
  std::size_t at = 0;
  for (int row = 0; row < texture.height; ++row) {
    out += row_open;
    for (int column = 0; column < texture.width; ++column) {
      out += open;
      for (int c = 0; c < texture.channels; ++c)
        out += literal(texture.values[at++], suffix) + (c + 1 < texture.channels ? ", " : "");
      out += close;
      if (column + 1 < texture.width) out += ",\n";
    }
    out += row_close;
    out += row + 1 < texture.height ? ",\n" : "\n";
  }
  return out;
}

std::string texture_text(const Texture& t, SourceLanguage language, const std::string& name) {
  const int count = t.width * t.height, n = t.channels;
  switch (language) {
  case SourceLanguage::c:
    return fmt::format("static const float {}[{}] = {{\n{}}};\n", name, count * n,
                       texels(t, "", "", "f"));
  case SourceLanguage::glsl:
    return fmt::format("const vec{0} {1}[{2}] = vec{0}[{2}](\n{3});\n", n, name, count,
                       texels(t, fmt::format("vec{}(", n), ")", ""));
  case SourceLanguage::hlsl:
    return fmt::format("static const float{} {}[{}] = {{\n{}}};\n", n, name, count,
                       texels(t, fmt::format("float{}(", n), ")", ""));
  case SourceLanguage::wgsl: {
    const std::string row = fmt::format("array<vec{}<f32>, {}>", n, t.width);
    return fmt::format("const {} = array<{}, {}>(\n{});\n", name, row, t.height,
                       texels(t, fmt::format("vec{}<f32>(", n), ")", "", row + "(\n", ")"));
  }
  case SourceLanguage::javascript:
    return fmt::format("export const {} = new Float32Array([\n{}]);\n", name,
                       texels(t, "", "", ""));
  }
  return {};
}

} // namespace

std::string to_source(const PackedTable& packed, SourceLanguage language, const std::string& name) {
  const std::string id = identifier(name);
  const KeyValues description = describe(packed);
  std::string out;
  for (const auto& [key, value] : description)
    out += fmt::format("// {}: {} .\n", key, comment_text(value));
  out += "// Texel (column, row) of texture NAME_1 is element row * columns + column.\n\n";
  if (language == SourceLanguage::c) {
    out += fmt::format("#ifndef {0}_INCLUDED\n#define {0}_INCLUDED\n\n", id);
    out += fmt::format("enum {{ {0}_columns = {1}, {0}_rows = {2}", id, packed.columns(),
                       packed.rows());
    for (std::size_t t = 0; t < packed.textures.size(); ++t)
      out += fmt::format(", {}_channels_{} = {}", id, t + 1, packed.textures[t].channels);
    out += " };\n\n";
  }
  if (language == SourceLanguage::javascript)
    out += fmt::format("export const {}_info = {};\n\n", id, description_to_json(description));
  for (std::size_t t = 0; t < packed.textures.size(); ++t)
    out += texture_text(packed.textures[t], language, fmt::format("{}_{}", id, t + 1)) + "\n";
  if (language == SourceLanguage::c) out += "#endif\n";
  return out;
}

} // namespace openltc::table
