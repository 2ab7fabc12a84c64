// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The dialect of openltc/shade as a tree: what the parser makes, passes change and writers read.

#pragma once

#include <string>
#include <vector>

namespace openltc::shaders {

/// Lines of comment without their slashes and the blank behind them; an empty line stands for a
/// blank line of the source, a line of one blank for an empty comment.
using Comments = std::vector<std::string>;

/// What a node is. `text` and `parts` of each are said here.
enum class Kind {
  // Expressions.
  name,        ///< text
  number,      ///< text, as written
  member,      ///< parts[0] . text
  index,       ///< parts[0] [ parts[1] ]
  call,        ///< text ( parts... ): a function, or a constructor of a type
  unary,       ///< text (- or !) parts[0]
  binary,      ///< parts[0] text parts[1]
  conditional, ///< parts[0] ? parts[1] : parts[2]
  // Statements.
  block,    ///< { parts... }
  branch,   ///< if (parts[0]) parts[1] else parts[2], which may be missing
  loop,     ///< for (parts[0]; parts[1]; parts[2]) parts[3]
  give,     ///< return parts[0]
  declare,  ///< text (a type) name [ size ] = parts[0], which may be missing
  assign,   ///< parts[0] = parts[1]
  step,     ///< ++ parts[0]
  evaluate, ///< parts[0], for what it does
};

/// A node of the tree.
struct Node {
  Kind kind = Kind::name;
  std::string text;
  std::vector<Node> parts = {};
  std::string name = {};  ///< of a declared variable
  std::string size = {};  ///< of a declared array
  Comments comments = {}; ///< before a statement
  std::string note = {};  ///< behind a statement, on its line
};

/// A field of a struct, or a parameter of a function.
struct Variable {
  std::string type;
  std::string name;
  Comments comments = {}; ///< before it
  std::string note = {};  ///< behind it
  std::string size = {};  ///< of an array
};

/// What an item of a file is.
enum class ItemKind { structure, constant, function };

/// A struct, a constant or a function.
struct Item {
  ItemKind kind = ItemKind::function;
  std::string type; ///< of a constant, or of what a function returns
  std::string name;
  Comments comments = {};
  std::vector<Variable> variables = {}; ///< fields or parameters
  Node body = {};                       ///< block of a function, value of a constant
  std::vector<Node> elements = {};      ///< of a constant that is an array
};

/// A file of the dialect: its opening comment, less licence, and what it has.
struct SourceFile {
  std::string name; ///< "edge" of openltc/shade/edge.glsl
  Comments opening = {};
  std::vector<Item> items = {};
};

/// A name as an expression.
inline Node name_of(std::string text) { return {Kind::name, std::move(text)}; }

/// Whether a node is this name.
inline bool is_name(const Node& node, const char* text) {
  return node.kind == Kind::name && node.text == text;
}

/// Whether a node calls this function.
inline bool is_call(const Node& node, const char* text) {
  return node.kind == Kind::call && node.text == text;
}

/// Whether a node compares two values.
inline bool compares(const Node& node) {
  return node.kind == Kind::binary &&
         (node.text[0] == '<' || node.text[0] == '>' || node.text == "==" || node.text == "!=");
}

/// The variable that an expression such as a.b[c] is a part of; empty where it is none.
inline std::string base_of(const Node& node) {
  const Node* at = &node;
  while (at->kind == Kind::member || at->kind == Kind::index)
    at = &at->parts[0];
  return at->kind == Kind::name ? at->text : std::string();
}

/// Calls visit(node) for a node and all below it, those above first.
template <class Visit> void walk(const Node& node, const Visit& visit) {
  visit(node);
  for (const Node& part : node.parts)
    walk(part, visit);
}

/// Whether a comparison is anywhere in a node.
inline bool has_comparison(const Node& node) {
  bool found = false;
  walk(node, [&](const Node& part) { found = found || compares(part); });
  return found;
}

/// walk for trees that are changed: those below first.
template <class Visit> void rewrite(Node& node, const Visit& visit) {
  for (Node& part : node.parts)
    rewrite(part, visit);
  visit(node);
}

} // namespace openltc::shaders
