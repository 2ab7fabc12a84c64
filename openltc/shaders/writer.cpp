// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What GLSL, HLSL, Metal's language and Godot's have in common: nearly all.

#include "openltc/shaders/writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace openltc::shaders {

namespace {

constexpr int k_width = 100;

std::string spaces(int count) { return std::string(std::size_t(count), ' '); }

int level_of(const std::string& sign) {
  if (sign == "||") return 2;
  if (sign == "&&") return 3;
  if (sign == "==" || sign == "!=") return 4;
  if (sign[0] == '<' || sign[0] == '>') return 5;
  return sign == "*" || sign == "/" ? 7 : 6;
}

Piece bracketed(Piece inner) {
  std::vector<Piece> parts;
  parts.push_back(piece("("));
  parts.push_back(std::move(inner));
  parts.push_back(piece(")"));
  return joined(std::move(parts));
}

Piece ended(Piece inner, const std::string& end) { return joined({std::move(inner), piece(end)}); }

// Names of what a function sets, less declarations.
std::set<std::string> find_changed(const Node& body) {
  std::set<std::string> names;
  walk(body, [&](const Node& node) {
    if (node.kind == Kind::assign || node.kind == Kind::step) names.insert(base_of(node.parts[0]));
  });
  return names;
}

} // namespace

std::string comment_lines(const Comments& comments, int indent) {
  std::string out;
  for (const std::string& line : comments) {
    if (line.empty())
      out += "\n";
    else
      out += spaces(indent) + (line == " " ? "//" : "// " + line) + "\n";
  }
  return out;
}

Writer::Writer(Language language, std::string prefix, Handles handles,
               std::set<std::string> globals)
    : words_(words_of(language)), language_(language), prefix_(std::move(prefix)),
      handles_(std::move(handles)), globals_(std::move(globals)) {}

std::string Writer::type(const std::string& name) const {
  const auto found = words_.types.find(name);
  if (found != words_.types.end()) return found->second;
  return globals_.count(name) > 0 ? global(name) : name;
}

std::string Writer::variable(const std::string& name) const {
  return words_.reserved.count(name) > 0 ? name + "_" : name;
}

std::string Writer::item(const Item& item) {
  const std::string comments = comment_lines(item.comments, 0);
  if (item.kind == ItemKind::constant) return comments + constant(item);
  if (item.kind == ItemKind::structure) return comments + structure(item);
  return comments + function(item);
}

std::string Writer::elements(const Item& item, const char* open, const char* close) {
  std::string out = open;
  for (std::size_t i = 0; i < item.elements.size(); ++i)
    out += fmt::format("{}\n    {}", i == 0 ? "" : ",",
                       lay_out(expression(item.elements[i]).piece, 4, k_width));
  return out + close;
}

std::string Writer::constant(const Item& item) {
  const std::string begin =
      fmt::format("{} {} {}", words_.constant, type(item.type), global(item.name));
  if (item.elements.empty())
    return lay_out(joined({piece(begin + " = "), expression(item.body).piece, piece(";")}), 0,
                   k_width) +
           "\n";
  const bool constructor = language_ != Language::hlsl && language_ != Language::metal;
  const std::string open = fmt::format("{}[{}](", type(item.type), item.elements.size());
  return fmt::format("{}[{}] = {};\n", begin, item.elements.size(),
                     elements(item, constructor ? open.c_str() : "{", constructor ? ")" : "}"));
}

std::string Writer::with_notes(const std::vector<Variable>& fields,
                               const std::vector<std::string>& lines) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!fields[i].note.empty()) width = std::max(width, lines[i].size());
  std::string out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    out += comment_lines(fields[i].comments, 2) + "  ";
    out += fields[i].note.empty() ? lines[i]
                                  : fmt::format("{:<{}} // {}", lines[i], width, fields[i].note);
    out += "\n";
  }
  return out;
}

std::string Writer::structure(const Item& item) {
  std::vector<std::string> lines;
  for (const Variable& field : item.variables)
    lines.push_back(
        fmt::format("{} {}{};", type(field.type), variable(field.name),
                    field.size.empty() ? "" : fmt::format("[{}]", array_size(field.size))));
  return fmt::format("struct {} {{\n{}}};\n", global(item.name), with_notes(item.variables, lines));
}

std::vector<Variable> Writer::parameters(const Item& item) const {
  std::vector<Variable> all;
  for (const Variable& parameter : item.variables) {
    const auto handle = handles_.find(parameter.type);
    if (handle == handles_.end()) {
      all.push_back({type(parameter.type), variable(parameter.name)});
      continue;
    }
    for (const HandlePart& part : handle->second)
      all.push_back({type(part.type), variable(parameter.name + part.suffix)});
  }
  return all;
}

std::string Writer::head(const std::string& begin, const std::vector<std::string>& parameters,
                         const std::string& end) const {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    pieces.push_back(piece(parameters[i] + (i + 1 < parameters.size() ? "," : "")));
  std::vector<Piece> all;
  all.push_back(piece(begin + "("));
  if (!pieces.empty()) all.push_back(broken(std::move(pieces)));
  all.push_back(piece(")" + end));
  return lay_out(joined(std::move(all)), 0, k_width - 2); // " {" follows
}

std::string Writer::header(const Item& item) {
  std::vector<std::string> texts;
  for (const Variable& parameter : parameters(item))
    texts.push_back(parameter.type + " " + parameter.name);
  const std::string kind = words_.function;
  return head(
      fmt::format("{}{}{} {}", kind, kind.empty() ? "" : " ", type(item.type), global(item.name)),
      texts, "");
}

std::string Writer::function(const Item& item) {
  locals_.clear();
  for (const Variable& parameter : item.variables)
    locals_[parameter.name] = parameter.type;
  walk(item.body, [&](const Node& node) {
    if (node.kind == Kind::declare) locals_[node.name] = node.text;
  });
  changed_ = find_changed(item.body);
  const std::string begin = header(item);
  const std::vector<Node>& statements = item.body.parts;
  const std::string first = first_statements(item);
  if (first.empty() && statements.size() == 1 && statements[0].kind == Kind::give) {
    const std::string line = begin + " { " + lay_out(simple(statements[0]), 0, 10 * k_width) + " }";
    if (line.size() <= std::size_t(k_width) && statements[0].comments.empty() &&
        line.find('\n') == std::string::npos)
      return line + "\n";
  }
  return begin + " {\n" + first + block(item.body, 2) + "}\n";
}

std::string Writer::block(const Node& node, int indent) {
  std::string out;
  for (std::size_t i = 0; i < node.parts.size(); ++i)
    out += statement(node.parts[i], indent, i > 0);
  return out;
}

// `spaced`: whether a blank line before it may stay.
std::string Writer::statement(const Node& node, int indent, bool spaced) {
  Comments comments = node.comments;
  if (!spaced && !comments.empty() && comments[0].empty()) comments.erase(comments.begin());
  const std::string note = node.note.empty() ? "" : " // " + node.note;
  std::string out = comment_lines(comments, indent) + spaces(indent);
  const auto laid = [&](Piece p, const char* end) {
    return lay_out(ended(std::move(p), end), indent, k_width);
  };
  if (node.kind == Kind::block)
    return out + "{\n" + block(node, indent + 2) + spaces(indent) + "}\n";
  if (node.kind == Kind::branch) {
    out += laid(joined({piece("if ("), expression(node.parts[0]).piece}), ") {") + "\n" +
           block(node.parts[1], indent + 2) + spaces(indent) + "}";
    if (node.parts.size() < 3) return out + "\n";
    if (node.parts[2].kind == Kind::branch) {
      const std::string rest = statement(node.parts[2], indent, false);
      return out + " else " + rest.substr(rest.find_first_not_of(' '));
    }
    return out + " else {\n" + block(node.parts[2], indent + 2) + spaces(indent) + "}\n";
  }
  if (node.kind == Kind::loop) {
    out += laid(joined({piece("for ("), declaration(node.parts[0], true), piece("; "),
                        expression(node.parts[1]).piece, piece("; "), simple(node.parts[2])}),
                ") {");
    return out + "\n" + block(node.parts[3], indent + 2) + spaces(indent) + "}\n";
  }
  const bool ends_itself = node.kind == Kind::give;
  return out + laid(simple(node), ends_itself ? "" : ";") + note + "\n";
}

// A statement that has no others inside; return with its semicolon.
Piece Writer::simple(const Node& node) {
  switch (node.kind) {
  case Kind::give:
    return joined({piece("return "), expression(node.parts[0]).piece, piece(";")});
  case Kind::declare:
    return declaration(node, false);
  case Kind::assign:
    return joined({expression(node.parts[0]).piece, piece(" = "), expression(node.parts[1]).piece});
  case Kind::step:
    return piece(step(lay_out(expression(node.parts[0]).piece, 0, k_width)));
  default:
    return expression(node.parts[0]).piece;
  }
}

Piece Writer::declaration(const Node& node, bool) {
  if (node.kind != Kind::declare) return simple(node); // a loop that goes on with a variable
  std::string begin = type(node.text) + " " + variable(node.name);
  if (!node.size.empty()) begin += "[" + array_size(node.size) + "]";
  if (node.parts.empty()) return piece(begin);
  return joined({piece(begin + " = "), expression(node.parts[0]).piece});
}

bool Writer::needs_brackets(const Node& node, const Node& part, int level, int part_level,
                            bool right) const {
  if (part_level < level || (right && part_level == level)) return true;
  // Clear to a reader, and to compilers that ask for it.
  if (compares(node) && compares(part)) return true;
  return node.text == "||" && part.kind == Kind::binary && part.text == "&&";
}

Writer::Written Writer::expression(const Node& node) {
  switch (node.kind) {
  case Kind::name: {
    const bool is_global = locals_.count(node.text) == 0 && globals_.count(node.text) > 0;
    return {piece(is_global ? global(node.text) : variable(node.text)), k_tightest};
  }
  case Kind::number:
    return {piece(node.text), k_tightest};
  case Kind::member: {
    Written inner = expression(node.parts[0]);
    if (inner.level < k_tightest) inner.piece = bracketed(std::move(inner.piece));
    return {ended(std::move(inner.piece), "." + variable(node.text)), k_tightest};
  }
  case Kind::index:
    return {joined({expression(node.parts[0]).piece, piece("["), expression(node.parts[1]).piece,
                    piece("]")}),
            k_tightest};
  case Kind::unary: {
    Written inner = expression(node.parts[0]);
    if (inner.level < k_tightest) inner.piece = bracketed(std::move(inner.piece));
    return {joined({piece(node.text), std::move(inner.piece)}), 8};
  }
  case Kind::binary:
    return binary(node);
  case Kind::conditional:
    return conditional(node);
  default:
    return call(node);
  }
}

// Of functions in the preamble.
Writer::Written Writer::choice(const char* name, const Node& node) {
  std::vector<Piece> parts;
  for (const Node& part : node.parts) {
    parts.push_back(expression(part).piece);
    if (&part != &node.parts.back()) parts.back() = ended(std::move(parts.back()), ",");
  }
  return {joined({piece(global(name) + "("), broken(std::move(parts)), piece(")")}), k_tightest};
}

Writer::Written Writer::binary(const Node& node) {
  if (language_ == Language::glsl_es && (node.text == "&&" || node.text == "||"))
    return choice(node.text == "&&" ? "both_hold" : "either_holds", node);
  const int level = level_of(node.text);
  // What binds alike from left to right is one row of operands.
  std::vector<const Node*> row = {&node};
  while (row.back()->parts[0].kind == Kind::binary &&
         level_of(row.back()->parts[0].text) == level &&
         !needs_brackets(*row.back(), row.back()->parts[0], level, level, false))
    row.push_back(&row.back()->parts[0]);
  std::reverse(row.begin(), row.end());
  const auto operand = [&](const Node& whole, const Node& part, bool right) {
    Written written = expression(part);
    if (needs_brackets(whole, part, level, written.level, right))
      written.piece = bracketed(std::move(written.piece));
    return std::move(written.piece);
  };
  std::vector<Piece> parts;
  parts.push_back(operand(*row[0], row[0]->parts[0], false));
  for (const Node* whole : row) {
    parts.back() = ended(std::move(parts.back()), " " + whole->text);
    parts.push_back(operand(*whole, whole->parts[1], true));
  }
  return {broken(std::move(parts)), level};
}

Writer::Written Writer::conditional(const Node& node) {
  if (language_ == Language::glsl_es) return choice("select", node);
  std::vector<Piece> parts;
  for (const Node& part : node.parts) {
    Written written = expression(part);
    if (written.level <= 1) written.piece = bracketed(std::move(written.piece));
    parts.push_back(std::move(written.piece));
  }
  parts[0] = ended(std::move(parts[0]), " ?");
  parts[1] = ended(std::move(parts[1]), " :");
  return {broken(std::move(parts)), 1};
}

// Arguments of a call, handles taken apart.
std::vector<Piece> Writer::arguments(const Node& node) {
  std::vector<Piece> all;
  for (std::size_t i = 0; i < node.parts.size(); ++i) {
    const Node& part = node.parts[i];
    const auto local = part.kind == Kind::name ? locals_.find(part.text) : locals_.end();
    const auto handle = local == locals_.end() ? handles_.end() : handles_.find(local->second);
    if (handle == handles_.end()) {
      all.push_back(argument(part, std::any_of(node.parts.begin() + std::ptrdiff_t(i) + 1,
                                               node.parts.end(), has_comparison)));
      continue;
    }
    for (const HandlePart& component : handle->second)
      all.push_back(piece(variable(part.text + component.suffix)));
  }
  return all;
}

Writer::Written Writer::call(const Node& node) {
  const auto plain = [&](std::size_t i) {
    return lay_out(expression(node.parts[i]).piece, 0, 10 * k_width);
  };
  const bool one_object = *words_.sampler == '\0';
  if (node.text == "polygon_data") {
    if (language_ == Language::metal)
      return {piece(fmt::format("{}[{}]", plain(0), plain(1))), k_tightest};
    const std::string index = plain(1) == "0" ? plain(0) : plain(0) + " + " + plain(1);
    return {piece(fmt::format("{}({})", global(node.text), index)), k_tightest};
  }
  if (node.text == "texture_size" && language_ != Language::hlsl) {
    const std::string size =
        language_ == Language::metal
            ? fmt::format("float2(float({0}.get_width()), float({0}.get_height()))", plain(0))
        : language_ == Language::wgsl ? fmt::format("vec2f(textureDimensions({}))", plain(0))
                                      : fmt::format("vec2(textureSize({}, 0))", plain(0));
    return {piece(size), k_tightest};
  }
  if (node.text == "texture_at") {
    std::string text;
    if (one_object)
      text = fmt::format("textureLod({}, {}, {})", plain(0), plain(2), plain(3));
    else if (language_ == Language::hlsl)
      text = fmt::format("{}.SampleLevel({}, {}, {})", plain(0), plain(1), plain(2), plain(3));
    else if (language_ == Language::metal)
      text = fmt::format("{}.sample({}, {}, level({}))", plain(0), plain(1), plain(2), plain(3));
    else
      text =
          fmt::format("textureSampleLevel({}, {}, {}, {})", plain(0), plain(1), plain(2), plain(3));
    return {piece(text), k_tightest};
  }
  std::string name = node.text;
  const auto other = words_.calls.find(name);
  if (globals_.count(name) > 0)
    name = global(name);
  else if (other != words_.calls.end())
    name = other->second;
  else
    name = type(name);
  std::vector<Piece> parts = arguments(node);
  if (parts.empty()) return {piece(name + "()"), k_tightest};
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
    parts[i] = ended(std::move(parts[i]), ",");
  return {joined({piece(name + "("), broken(std::move(parts)), piece(")")}), k_tightest};
}

} // namespace openltc::shaders
