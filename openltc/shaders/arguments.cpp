// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/arguments.h"

#include <cstddef>
#include <string>

namespace openltc::shaders {

namespace {

bool is_call_of(const Node& node, const Item& function) {
  return is_call(node, function.name.c_str()) && node.parts.size() == function.variables.size();
}

// What parameter `place` gets in all calls: "true", "false", or nothing.
std::string value_in_all_calls(const std::vector<SourceFile>& files, const Item& function,
                               std::size_t place) {
  std::string value;
  bool differs = false;
  for (const SourceFile& file : files)
    for (const Item& item : file.items)
      walk(item.body, [&](const Node& node) {
        if (!is_call_of(node, function)) return;
        const Node& argument = node.parts[place];
        const bool known = is_name(argument, "true") || is_name(argument, "false");
        differs = differs || !known || (!value.empty() && value != argument.text);
        value = argument.text;
      });
  return differs ? std::string() : value;
}

void take_out(std::vector<SourceFile>& files, Item& function, std::size_t place,
              const std::string& value) {
  for (SourceFile& file : files)
    for (Item& item : file.items)
      rewrite(item.body, [&](Node& node) {
        if (is_call_of(node, function))
          node.parts.erase(node.parts.begin() + std::ptrdiff_t(place));
      });
  const std::string name = function.variables[place].name;
  function.variables.erase(function.variables.begin() + std::ptrdiff_t(place));
  rewrite(function.body, [&](Node& node) {
    if (is_name(node, name.c_str())) node.text = value;
  });
}

bool reads(const Item& function, const std::string& name) {
  bool found = false;
  walk(function.body, [&](const Node& node) { found = found || is_name(node, name.c_str()); });
  return found;
}

// Whether all calls of that name are of this function.
bool is_alone(const std::vector<SourceFile>& files, const Item& function) {
  bool alone = true;
  for (const SourceFile& file : files)
    for (const Item& item : file.items) {
      alone = alone && (&item == &function || item.name != function.name);
      walk(item.body, [&](const Node& node) {
        alone = alone && (!is_call(node, function.name.c_str()) || is_call_of(node, function));
      });
    }
  return alone;
}

// Not a handle, of which what stands for it is read.
bool is_value(const std::string& type) {
  return type == "bool" || type == "int" || type == "Real" || type.rfind("Vec", 0) == 0;
}

// Takes out values that the function does not read. Returns whether there was any.
bool take_out_unread(std::vector<SourceFile>& files, Item& function) {
  bool any = false;
  for (std::size_t place = function.variables.size(); place-- > 0;)
    if (is_value(function.variables[place].type) &&
        !reads(function, function.variables[place].name) && is_alone(files, function)) {
      take_out(files, function, place, "");
      any = true;
    }
  return any;
}

} // namespace

bool settle_arguments(std::vector<SourceFile>& files, const Facts& facts,
                      const std::set<std::string>& kept) {
  bool any = false;
  for (SourceFile& file : files)
    for (Item& item : file.items) {
      if (item.kind != ItemKind::function) continue;
      if (kept.count(item.name) == 0) any = take_out_unread(files, item) || any;
      for (std::size_t place = 0; place < item.variables.size(); ++place) {
        if (item.variables[place].type != "bool") continue;
        const std::string value = value_in_all_calls(files, item, place);
        if (value.empty()) continue;
        take_out(files, item, place, value);
        simplify(item, facts);
        any = true;
        --place;
      }
    }
  return any;
}

} // namespace openltc::shaders
