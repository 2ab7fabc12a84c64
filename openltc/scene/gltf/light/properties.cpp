// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/scene/gltf/light/properties.h"

#include "openltc/base/quote.h"
#include "openltc/scene/gltf/file/failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::scene::gltf {

namespace {

using nlohmann::json;

constexpr double k_largest = 1e30; // squares still fit into single precision's exponent, almost
constexpr std::size_t k_most_points = 4096;

bool is_usable(const json& value) {
  return value.is_number() && std::abs(value.get<double>()) <= k_largest; // false for NaN
}

} // namespace

void Properties::refuse(const std::string& name, const std::string& what) const {
  fail(field_ + "." + quote(name), what);
}

const json* Properties::find(const char* name) {
  known_.push_back(name);
  const auto found = object_.find(name);
  return found == object_.end() ? nullptr : &*found;
}

std::optional<double> Properties::number(const char* name) {
  const json* value = find(name);
  if (!value) return {};
  if (!is_usable(*value)) refuse(name, "must be a number");
  return value->get<double>();
}

double Properties::number(const char* name, double otherwise) {
  return number(name).value_or(otherwise);
}

double Properties::not_negative(const char* name, double otherwise) {
  const double value = number(name, otherwise);
  if (value < 0) refuse(name, fmt::format("{} must not be negative", value));
  return value;
}

double Properties::positive(const char* name) {
  const auto value = number(name);
  if (!value) refuse(name, "is missing");
  if (!(*value > 0)) refuse(name, fmt::format("{} must be greater than 0", *value));
  return *value;
}

bool Properties::flag(const char* name) {
  const json* value = find(name);
  if (!value) return false;
  if (value->is_boolean()) return value->get<bool>();
  if (value->is_number() && (*value == 0 || *value == 1)) return *value == 1;
  refuse(name, "must be true or false");
}

std::string Properties::text(const char* name, const std::string& otherwise) {
  const json* value = find(name);
  if (!value) return otherwise;
  if (!value->is_string()) refuse(name, "must be a text");
  return value->get<std::string>();
}

Vec3d Properties::color(const char* name) {
  const json* value = find(name);
  if (!value) return {1, 1, 1};
  const bool is_color = value->is_array() && value->size() == 3 &&
                        std::all_of(value->begin(), value->end(), [](const json& v) {
                          return is_usable(v) && v.get<double>() >= 0;
                        });
  if (!is_color) refuse(name, "must be three numbers, each 0 or more");
  return {(*value)[0].get<double>(), (*value)[1].get<double>(), (*value)[2].get<double>()};
}

std::string Properties::choice(const char* name, const std::vector<std::string>& words) {
  const std::string word = text(name, words[0]);
  if (std::find(words.begin(), words.end(), word) == words.end())
    refuse(name, fmt::format("\"{}\" is not one of: {}", quote(word), fmt::join(words, " ")));
  return word;
}

std::vector<Vec2d> Properties::outline_of(const json& value, const std::string& name) const {
  const auto wrong = [&] { refuse(name, "must be points of the plane, [[x, y], [x, y], ...]"); };
  if (!value.is_array() || value.size() > 2 * k_most_points) wrong();
  std::vector<Vec2d> points;
  const bool is_flat = !value.empty() && value[0].is_number();
  if (is_flat) {
    if (value.size() % 2 != 0 || !std::all_of(value.begin(), value.end(), is_usable)) wrong();
    for (std::size_t i = 0; i < value.size(); i += 2)
      points.push_back({value[i].get<double>(), value[i + 1].get<double>()});
  } else {
    for (const json& point : value) {
      const bool is_point = point.is_array() && (point.size() == 2 || point.size() == 3) &&
                            std::all_of(point.begin(), point.end(), is_usable);
      if (!is_point) wrong();
      if (point.size() == 3 && point[2].get<double>() != 0)
        refuse(name, fmt::format("the outline is not planar: the third coordinate {} is not 0; it "
                                 "lies in the node's XY plane",
                                 point[2].get<double>()));
      points.push_back({point[0].get<double>(), point[1].get<double>()});
    }
  }
  if (points.size() > k_most_points)
    refuse(name,
           fmt::format("has {} points; at most {} can be used", points.size(), k_most_points));
  return points;
}

std::vector<Vec2d> Properties::outline(const char* name) {
  const json* value = find(name);
  if (!value) refuse(name, "is missing");
  return outline_of(*value, name);
}

std::vector<std::vector<Vec2d>> Properties::outlines(const char* name) {
  std::vector<std::vector<Vec2d>> outlines;
  const json* value = find(name);
  if (!value) return outlines;
  if (!value->is_array()) refuse(name, "must be an array of outlines");
  for (std::size_t i = 0; i < value->size(); ++i)
    outlines.push_back(outline_of((*value)[i], fmt::format("{}[{}]", name, i)));
  return outlines;
}

void Properties::check_all_known(const std::string& what) const {
  for (const auto& [key, value] : object_.items())
    if (std::find(known_.begin(), known_.end(), key) == known_.end())
      refuse(key,
             fmt::format("{} has no such property; known are: {}", what, fmt::join(known_, " ")));
}

} // namespace openltc::scene::gltf
