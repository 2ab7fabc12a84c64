// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/wgsl_writer.h"

#include <fmt/format.h>

#include <utility>

namespace openltc::shaders {

namespace {

constexpr int k_width = 100;

} // namespace

std::string WgslWriter::constant(const Item& item) {
  if (!item.elements.empty()) {
    const std::string open = fmt::format("array<{}, {}>(", type(item.type), item.elements.size());
    return fmt::format("const {} = {};\n", global(item.name), elements(item, open.c_str(), ")"));
  }
  const std::string begin = fmt::format("const {}: {} = ", global(item.name), type(item.type));
  return lay_out(joined({piece(begin), expression(item.body).piece, piece(";")}), 0, k_width) +
         "\n";
}

std::string WgslWriter::type_of(const std::string& name, const std::string& size) const {
  return size.empty() ? type(name) : fmt::format("array<{}, {}>", type(name), array_size(size));
}

std::string WgslWriter::structure(const Item& item) {
  std::vector<std::string> lines;
  for (const Variable& field : item.variables)
    lines.push_back(fmt::format("{}: {},", variable(field.name), type_of(field.type, field.size)));
  return fmt::format("struct {} {{\n{}}}\n", global(item.name), with_notes(item.variables, lines));
}

std::string WgslWriter::header(const Item& item) {
  std::vector<std::string> texts;
  for (const Variable& parameter : parameters(item))
    texts.push_back(fmt::format("{}{}: {}", parameter.name,
                                changed_.count(parameter.name) > 0 ? "_in" : "", parameter.type));
  return head("fn " + global(item.name), texts, " -> " + type(item.type));
}

// Parameters cannot be changed: those that are have a copy.
std::string WgslWriter::first_statements(const Item& item) {
  std::string out;
  for (const Variable& parameter : parameters(item))
    if (changed_.count(parameter.name) > 0)
      out += fmt::format("  var {0} = {0}_in;\n", parameter.name);
  return out;
}

Piece WgslWriter::declaration(const Node& node, bool) {
  std::string begin = variable(node.name);
  if (node.parts.empty()) {
    return piece(fmt::format("var {}: {}", begin, type_of(node.text, node.size)));
  }
  begin = (changed_.count(node.name) > 0 ? "var " : "let ") + begin + " = ";
  return joined({piece(begin), expression(node.parts[0]).piece});
}

Writer::Written WgslWriter::conditional(const Node& node) {
  std::vector<Piece> parts;
  const bool compared = has_comparison(node.parts[0]);
  parts.push_back(
      joined({argument(node.parts[2], compared || has_comparison(node.parts[1])), piece(",")}));
  parts.push_back(joined({argument(node.parts[1], compared), piece(",")}));
  parts.push_back(argument(node.parts[0], false));
  return {joined({piece("select("), broken(std::move(parts)), piece(")")}), k_tightest};
}

// `f(a < b, c > (d))` would read as a template.
Piece WgslWriter::argument(const Node& node, bool comparison_follows) {
  Written written = expression(node);
  if (!comparison_follows || !compares(node)) return std::move(written.piece);
  return joined({piece("("), std::move(written.piece), piece(")")});
}

bool WgslWriter::needs_brackets(const Node& node, const Node& part, int level, int part_level,
                                bool right) const {
  const bool logic = part.kind == Kind::binary && (part.text == "&&" || part.text == "||");
  if (logic && (node.text == "&&" || node.text == "||") && part.text != node.text) return true;
  return Writer::needs_brackets(node, part, level, part_level, right);
}

std::unique_ptr<Writer> make_writer(Language language, std::string prefix, Handles handles,
                                    std::set<std::string> globals) {
  if (language == Language::wgsl)
    return std::make_unique<WgslWriter>(language, std::move(prefix), std::move(handles),
                                        std::move(globals));
  return std::make_unique<Writer>(language, std::move(prefix), std::move(handles),
                                  std::move(globals));
}

} // namespace openltc::shaders
