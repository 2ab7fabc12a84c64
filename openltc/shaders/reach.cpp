// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/reach.h"

#include "openltc/shaders/simplify.h"

#include <algorithm>
#include <map>

namespace openltc::shaders {

namespace {

// Functions may share a name, if not the number of their parameters.
std::string key_of(const std::string& name, std::size_t parameters) {
  return name + "/" + std::to_string(parameters);
}

std::string key_of(const Item& item) {
  return item.kind == ItemKind::function ? key_of(item.name, item.variables.size()) : item.name;
}

// The keys of all items that an item may mean. In calls, what stands for several parameters may
// count as one, so that the number need not be that of any function of the name.
std::set<std::string> keys_in(const Item& item) {
  std::set<std::string> keys = {item.type};
  for (const Variable& variable : item.variables) {
    keys.insert(variable.type);
    keys.insert(variable.size);
  }
  walk(item.body, [&](const Node& node) {
    if (node.kind == Kind::name || node.kind == Kind::declare) keys.insert(node.text);
    if (node.kind == Kind::call) keys.insert(key_of(node.text, node.parts.size()));
    keys.insert(node.size);
  });
  return keys;
}

std::set<std::string> reached_keys(const std::vector<SourceFile>& files, const Roots& roots) {
  std::map<std::string, const Item*> items;
  std::vector<std::string> todo;
  for (const SourceFile& file : files)
    for (const Item& item : file.items) {
      items[key_of(item)] = &item;
      if (roots.functions.count(item.name) > 0) todo.push_back(key_of(item));
    }
  std::set<std::string> reached;
  while (!todo.empty()) {
    const std::string key = todo.back();
    todo.pop_back();
    const auto found = items.find(key);
    if (found != items.end()) {
      if (!reached.insert(key).second) continue;
      const std::set<std::string> keys = keys_in(*found->second);
      todo.insert(todo.end(), keys.begin(), keys.end());
    } else if (const std::size_t slash = key.find('/'); slash != std::string::npos) {
      const std::string name = key.substr(0, slash + 1);
      for (auto at = items.lower_bound(name); at != items.end() && at->first.rfind(name, 0) == 0;
           ++at)
        todo.push_back(at->first);
    }
  }
  return reached;
}

// Fields that are read, but for the setting of the same one.
void find_reads(const Node& node, const std::string& set, std::set<std::string>& read) {
  if (node.kind == Kind::assign) {
    const Node& place = node.parts[0];
    const std::string field = place.kind == Kind::member ? place.text : std::string();
    find_reads(node.parts[1], field, read);
    // On the way to a place: read only if the place is of interest.
    for (const Node* at = place.parts.empty() ? nullptr : &place.parts[0];
         at != nullptr && at->kind != Kind::name; at = &at->parts[0])
      if (at->kind == Kind::index) find_reads(at->parts[1], field, read);
    if (place.kind == Kind::index) find_reads(place.parts[1], field, read);
    return;
  }
  if (node.kind == Kind::member && node.text != set) read.insert(node.text);
  for (const Node& part : node.parts)
    find_reads(part, set, read);
}

// Whether the place is in a field that nothing reads.
bool is_unread_place(const Node& place, const std::set<std::string>& unread) {
  for (const Node* at = &place; at->kind != Kind::name; at = &at->parts[0])
    if (at->kind == Kind::member && unread.count(at->text) > 0) return true;
  return false;
}

bool remove_settings(Node& node, const std::set<std::string>& unread) {
  bool removed = false;
  for (Node& part : node.parts)
    removed = remove_settings(part, unread) || removed;
  if (node.kind != Kind::block) return removed;
  const auto end = std::remove_if(node.parts.begin(), node.parts.end(), [&](const Node& statement) {
    return statement.kind == Kind::assign && is_unread_place(statement.parts[0], unread);
  });
  removed = removed || end != node.parts.end();
  node.parts.erase(end, node.parts.end());
  return removed;
}

// One round; whether anything went.
bool remove_unread_fields(std::vector<SourceFile>& files, const Roots& roots) {
  std::set<std::string> read, unread;
  for (const SourceFile& file : files)
    for (const Item& item : file.items) {
      find_reads(item.body, "", read);
      if (item.kind == ItemKind::structure && roots.structs.count(item.name) > 0)
        for (const Variable& field : item.variables)
          read.insert(field.name);
    }
  bool removed = false;
  for (SourceFile& file : files)
    for (Item& item : file.items) {
      if (item.kind != ItemKind::structure) continue;
      const auto end =
          std::remove_if(item.variables.begin(), item.variables.end(), [&](const Variable& field) {
            const bool gone = read.count(field.name) == 0;
            if (gone) unread.insert(field.name);
            return gone;
          });
      removed = removed || end != item.variables.end();
      item.variables.erase(end, item.variables.end());
    }
  for (SourceFile& file : files)
    for (Item& item : file.items)
      removed = remove_settings(item.body, unread) || removed;
  return removed;
}

} // namespace

void keep_reached(std::vector<SourceFile>& files, const Roots& roots) {
  bool again = true;
  while (again) {
    again = false;
    const std::set<std::string> reached = reached_keys(files, roots);
    for (SourceFile& file : files) {
      const auto end = std::remove_if(file.items.begin(), file.items.end(), [&](const Item& item) {
        return reached.count(key_of(item)) == 0;
      });
      file.items.erase(end, file.items.end());
      for (Item& item : file.items)
        if (item.kind == ItemKind::function) again = remove_unread_variables(item) || again;
    }
    again = remove_unread_fields(files, roots) || again;
  }
}

} // namespace openltc::shaders
