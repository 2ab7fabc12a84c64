// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The members of a JSON object that a person wrote: each asked for by name and type, none unknown.

#pragma once

#include "openltc/target/vec.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace openltc::scene::gltf {

/// All functions throw Failure, which names the property, for a value of the wrong kind.
class Properties {
public:
  /// `field` stands for the object in messages; `object` must outlive this.
  Properties(const nlohmann::json& object, std::string field)
      : object_(object), field_(std::move(field)) {}

  bool has(const char* name) const { return object_.contains(name); }
  std::optional<double> number(const char* name); ///< finite and within +-1e30
  double number(const char* name, double otherwise);
  double not_negative(const char* name, double otherwise);
  double positive(const char* name); ///< must be there
  bool flag(const char* name);       ///< false when it is missing; 0 and 1 count
  std::string text(const char* name, const std::string& otherwise); ///< may be missing
  Vec3d color(const char* name); ///< three numbers, 0 or more; white when it is missing
  /// One of `words`, the first when it is missing.
  std::string choice(const char* name, const std::vector<std::string>& words);
  /// Points of a plane, [[x, y], ...], or [x, y, x, y, ...]; a third coordinate must be 0.
  std::vector<Vec2d> outline(const char* name); ///< must be there
  std::vector<std::vector<Vec2d>> outlines(const char* name);

  /// Throws for a property that nobody asked for; `what` is what has none such, e.g. "a sphere".
  void check_all_known(const std::string& what) const;

  [[noreturn]] void refuse(const std::string& name, const std::string& what) const;
  const std::string& field() const { return field_; }

private:
  const nlohmann::json* find(const char* name);
  std::vector<Vec2d> outline_of(const nlohmann::json& value, const std::string& name) const;

  const nlohmann::json& object_;
  std::string field_;
  std::vector<std::string> known_;
};

} // namespace openltc::scene::gltf
