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

} // namespace

bool settle_arguments(std::vector<SourceFile>& files, const Facts& facts) {
  bool any = false;
  for (SourceFile& file : files)
    for (Item& item : file.items) {
      if (item.kind != ItemKind::function) continue;
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
