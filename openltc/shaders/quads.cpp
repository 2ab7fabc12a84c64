// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/quads.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace openltc::shaders {

namespace {

// The value of the constant of that name.
constexpr const char* k_quad_points = "5";

bool is_of_polygon(const Item& item) {
  return item.kind == ItemKind::function &&
         std::any_of(item.variables.begin(), item.variables.end(),
                     [](const Variable& parameter) { return parameter.type == "Polygon"; });
}

std::string quad_name(std::string name) {
  const std::size_t at = name.find("polygon");
  if (at != std::string::npos) return name.replace(at, 7, "quad");
  return name.find("quad") != std::string::npos ? name : "quad_" + name;
}

bool asks_for_four(const Node& node) {
  return node.kind == Kind::binary && node.text == "==" &&
         is_call(node.parts[0], "polygon_point_count") && is_name(node.parts[1], "k_quad_points");
}

Item quad_function(Item item, const std::set<std::string>& of_polygons) {
  item.name = quad_name(item.name);
  for (Variable& parameter : item.variables)
    if (parameter.type == "Polygon") parameter = {"Quad", "quad"};
  rewrite(item.body, [&](Node& node) {
    if (is_name(node, "polygon"))
      node.text = "quad";
    else if (is_call(node, "polygon_point_count"))
      node = {Kind::number, k_quad_points};
    else if (is_call(node, "polygon_starts_ring"))
      node = name_of("false");
    else if (is_call(node, "polygon_is_parallelogram"))
      node = name_of("true");
    else if (node.kind == Kind::binary && node.text == "==" &&
             node.parts[0].text == k_quad_points && is_name(node.parts[1], "k_quad_points"))
      node = name_of("true");
    else if (node.kind == Kind::call &&
             (of_polygons.count(node.text) > 0 ||
              (node.text.rfind("polygon_", 0) == 0 && is_name(node.parts[0], "quad"))))
      node.text = quad_name(node.text);
  });
  return item;
}

} // namespace

void add_quad_functions(std::vector<SourceFile>& files) {
  std::set<std::string> of_polygons;
  for (const SourceFile& file : files)
    for (const Item& item : file.items)
      if (is_of_polygon(item)) of_polygons.insert(item.name);
  for (SourceFile& file : files) {
    std::vector<Item> items;
    for (Item& item : file.items) {
      if (!is_of_polygon(item)) {
        items.push_back(std::move(item));
        continue;
      }
      // What is of four corners already is theirs alone.
      if (quad_name(item.name) != item.name) items.push_back(item);
      items.push_back(quad_function(std::move(item), of_polygons));
    }
    file.items = std::move(items);
  }
}

void drop_quad_case(std::vector<SourceFile>& files) {
  for (SourceFile& file : files)
    for (Item& item : file.items)
      rewrite(item.body, [](Node& node) {
        if (asks_for_four(node) || is_call(node, "polygon_is_parallelogram"))
          node = name_of("false");
      });
}

} // namespace openltc::shaders
