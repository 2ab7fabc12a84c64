// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/simplify.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace openltc::shaders {

namespace {

Node truth(bool value) { return name_of(value ? "true" : "false"); }

std::optional<bool> known(const Node& node) {
  if (is_name(node, "true")) return true;
  if (is_name(node, "false")) return false;
  return {};
}

bool is_integer_literal(const Node& node) {
  return node.kind == Kind::number && node.text.find_first_of(".eE") == std::string::npos;
}

// Node takes the place of a tree that it is a part of.
void replace(Node& node, Node part) { node = std::move(part); }

class Simplifier {
public:
  Simplifier(const Facts& facts, const Item& item) : facts_(facts), integers_(facts.integers) {
    for (const Variable& parameter : item.variables)
      if (parameter.type == "int") integers_.insert(parameter.name);
    walk(item.body, [&](const Node& node) {
      if (node.kind == Kind::declare) {
        if (node.text == "int") integers_.insert(node.name);
        ++declared_[node.name];
      }
    });
  }

  void expressions(Node& node) const {
    if (node.kind == Kind::assign) { // a place is not a value
      expressions(node.parts[1]);
      if (node.parts[0].kind == Kind::index) expressions(node.parts[0].parts[1]);
      return;
    }
    for (Node& part : node.parts)
      expressions(part);
    expression(node);
  }

  // Of blocks: what is left of their statements.
  void statements(Node& block) const {
    std::vector<Node> kept;
    for (Node& statement : block.parts) {
      if (is_idle(statement)) continue;
      if (statement.kind == Kind::branch) {
        if (const std::optional<bool> condition = known(statement.parts[0])) {
          take_side(statement, *condition, kept);
          if (ends(kept)) break;
          continue;
        }
        tell(statement.parts[0], statement.parts[1]);
        inner(statement.parts[1]);
        if (statement.parts.size() > 2) inner(statement.parts[2]);
        if (statement.parts.size() > 2 && statement.parts[2].kind == Kind::block &&
            statement.parts[2].parts.empty())
          statement.parts.pop_back();
        if (statement.parts.size() == 2 && statement.parts[1].parts.empty()) continue;
      } else if (statement.kind == Kind::loop) {
        inner(statement.parts[3]);
      } else if (statement.kind == Kind::block) {
        statements(statement);
      }
      kept.push_back(std::move(statement));
      if (ends(kept)) break;
    }
    block.parts = std::move(kept);
  }

private:
  static bool ends(const std::vector<Node>& statements) {
    return !statements.empty() && statements.back().kind == Kind::give;
  }

  // An assertion, or the setting of a field that is known.
  bool is_idle(const Node& statement) const {
    if (statement.kind == Kind::evaluate) return is_call(statement.parts[0], "ASSERT_THAT");
    return statement.kind == Kind::assign && statement.parts[0].kind == Kind::member &&
           facts_.fields.count(statement.parts[0].text) > 0;
  }

  // Behind a condition that is a name, that is true.
  void tell(const Node& condition, Node& body) const {
    if (condition.kind != Kind::name) return;
    bool changes = false;
    walk(body, [&](const Node& node) {
      changes =
          changes || (node.kind == Kind::assign && is_name(node.parts[0], condition.text.c_str()));
    });
    if (changes) return;
    rewrite(body, [&](Node& node) {
      if (is_name(node, condition.text.c_str())) node = truth(true);
    });
    expressions(body);
  }

  // The body of a branch or loop, a block or a branch.
  void inner(Node& statement) const {
    if (statement.kind == Kind::block) {
      statements(statement);
      return;
    }
    Node block{Kind::block, "", {std::move(statement)}};
    statements(block);
    if (block.parts.size() == 1 && block.parts[0].kind == Kind::branch)
      replace(statement, std::move(block.parts[0]));
    else
      statement = std::move(block);
  }

  // What a branch whose condition is known comes to.
  void take_side(Node& branch, bool condition, std::vector<Node>& kept) const {
    const std::size_t side = condition ? 1 : 2;
    if (side >= branch.parts.size()) return;
    Node block = std::move(branch.parts[side]);
    if (block.kind != Kind::block) block = Node{Kind::block, "", {std::move(block)}};
    statements(block);
    const bool blank = !branch.comments.empty() && branch.comments[0].empty();
    if (!block.parts.empty() && blank && block.parts[0].comments.empty())
      block.parts[0].comments.emplace_back();
    const bool shadows = std::any_of(block.parts.begin(), block.parts.end(), [&](const Node& node) {
      return node.kind == Kind::declare && declared_.at(node.name) > 1;
    });
    if (shadows) {
      kept.push_back(std::move(block));
      return;
    }
    for (Node& statement : block.parts)
      kept.push_back(std::move(statement));
  }

  bool is_integer(const Node& node) const {
    switch (node.kind) {
    case Kind::name:
    case Kind::call:
      return integers_.count(node.text) > 0;
    case Kind::number:
      return is_integer_literal(node);
    case Kind::binary:
      return is_integer(node.parts[0]) && is_integer(node.parts[1]);
    case Kind::conditional:
      return is_integer(node.parts[1]) && is_integer(node.parts[2]);
    default:
      return false;
    }
  }

  void expression(Node& node) const {
    if (node.kind == Kind::member) {
      const auto field = facts_.fields.find(node.text);
      if (field != facts_.fields.end()) replace(node, truth(field->second));
    }
    if (node.kind == Kind::call) call(node);
    if (node.kind == Kind::unary && node.text == "!") {
      if (const auto value = known(node.parts[0])) replace(node, truth(!*value));
    } else if (node.kind == Kind::binary) {
      binary(node);
    } else if (node.kind == Kind::conditional) {
      if (const auto value = known(node.parts[0])) replace(node, Node(node.parts[*value ? 1 : 2]));
    }
  }

  void call(Node& node) const {
    if (node.text == "all_lanes" || node.text == "any_lane") {
      replace(node, Node(node.parts[0]));
    } else if (node.text == "lanes_agree") {
      replace(node, truth(false));
    } else if (node.text == "one_lane") {
      replace(node, truth(true));
    } else if (node.text == "select") {
      node.kind = Kind::conditional;
      node.text.clear();
    } else if (node.text == "reciprocal") {
      replace(node, Node{Kind::binary, "/", {Node{Kind::number, "1.0"}, Node(node.parts[0])}});
    } else if (node.text == "Real" && !is_integer(node.parts[0])) {
      replace(node, Node(node.parts[0]));
    }
  }

  static void binary(Node& node) {
    const Node& a = node.parts[0];
    const Node& b = node.parts[1];
    if (a.kind == Kind::number && b.kind == Kind::number && node.text == "<") {
      replace(node, truth(std::stod(a.text) < std::stod(b.text)));
      return;
    }
    if (node.text != "&&" && node.text != "||") return;
    const bool decides = node.text == "||";
    for (const int side : {0, 1}) {
      const auto value = known(node.parts[std::size_t(side)]);
      if (!value) continue;
      replace(node, *value == decides ? truth(decides) : Node(node.parts[std::size_t(1 - side)]));
      return;
    }
  }

  const Facts& facts_;
  std::set<std::string> integers_;
  std::map<std::string, int> declared_;
};

// How often each variable is read; a place that is set is not, nor is what only itself is made of.
void count_reads(const Node& node, const std::string& set, std::map<std::string, int>& reads) {
  if (node.kind == Kind::name && node.text != set) ++reads[node.text];
  if (node.kind != Kind::assign) {
    for (const Node& part : node.parts)
      count_reads(part, set, reads);
    return;
  }
  count_reads(node.parts[1], base_of(node.parts[0]), reads);
  for (const Node* at = &node.parts[0]; at->kind != Kind::name; at = &at->parts[0])
    if (at->kind == Kind::index) count_reads(at->parts[1], set, reads);
}

bool remove_statements(Node& node, const std::set<std::string>& unread) {
  bool removed = false;
  for (Node& part : node.parts)
    removed = remove_statements(part, unread) || removed;
  if (node.kind != Kind::block) return removed;
  const auto is_unread = [&](const Node& statement) {
    return (statement.kind == Kind::declare && unread.count(statement.name) > 0) ||
           (statement.kind == Kind::assign && unread.count(base_of(statement.parts[0])) > 0);
  };
  const auto end = std::remove_if(node.parts.begin(), node.parts.end(), is_unread);
  removed = removed || end != node.parts.end();
  node.parts.erase(end, node.parts.end());
  return removed;
}

} // namespace

void note_integers(const SourceFile& file, Facts& facts) {
  for (const Item& item : file.items)
    if (item.kind != ItemKind::structure && item.type == "int") facts.integers.insert(item.name);
}

void simplify(Item& item, const Facts& facts) {
  if (item.kind == ItemKind::structure) return;
  const Simplifier simplifier(facts, item);
  simplifier.expressions(item.body);
  if (item.kind == ItemKind::function) simplifier.statements(item.body);
}

bool remove_unread_variables(Item& function) {
  bool any = false;
  for (bool again = true; again; any = any || again) {
    std::map<std::string, int> reads;
    count_reads(function.body, "", reads);
    std::set<std::string> unread;
    walk(function.body, [&](const Node& node) {
      if (node.kind == Kind::declare && reads[node.name] == 0) unread.insert(node.name);
    });
    again = remove_statements(function.body, unread);
  }
  return any;
}

} // namespace openltc::shaders
