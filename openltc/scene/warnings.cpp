// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/warnings.h"

#include "openltc/base/quote.h"

#include <fmt/format.h>

#include <algorithm>

namespace openltc::scene {

namespace {

constexpr std::size_t k_listed_meshes = 3;

std::string line_of(const std::vector<std::string>& meshes, const std::string& what) {
  if (meshes.empty()) return what;
  std::string line = meshes.size() == 1 ? "mesh " : "meshes ";
  const std::size_t listed = std::min(meshes.size(), k_listed_meshes);
  for (std::size_t i = 0; i < listed; ++i)
    line += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", quote(meshes[i]));
  if (meshes.size() > listed) line += fmt::format(" and {} more", meshes.size() - listed);
  return line + ": " + what;
}

} // namespace

void Warnings::add(const std::string& text) {
  const std::string message = escaped(text); // names may hold anything, but a warning is one line
  for (const Entry& entry : entries_)
    if (entry.meshes.empty() && entry.what == message) return;
  entries_.push_back({message, {}});
}

void Warnings::add_for_mesh(const std::string& mesh_name, const std::string& what) {
  for (Entry& entry : entries_) {
    if (entry.meshes.empty() || entry.what != what) continue;
    if (std::find(entry.meshes.begin(), entry.meshes.end(), mesh_name) == entry.meshes.end())
      entry.meshes.push_back(mesh_name);
    return;
  }
  entries_.push_back({what, {mesh_name}});
}

std::vector<std::string> Warnings::lines() const {
  std::vector<std::string> lines;
  for (const Entry& entry : entries_)
    lines.push_back(line_of(entry.meshes, entry.what));
  return lines;
}

} // namespace openltc::scene
