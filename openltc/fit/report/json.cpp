// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/report/report.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace openltc::fit {

namespace {

using Json = nlohmann::ordered_json;

// Six digits; what is not a number is null.
Json number(double x) {
  if (!std::isfinite(x)) return nullptr;
  return std::strtod(fmt::format("{:.5e}", x).c_str(), nullptr);
}

Json numbers(const std::vector<double>& values) {
  Json array = Json::array();
  for (const double x : values)
    array.push_back(number(x));
  return array;
}

Json json_of(const LobeError& e) {
  Json object = Json::object();
  for (const LobeErrorField& field : lobe_error_fields())
    object[field.name] = number(e.*field.member);
  return object;
}

Json json_of(const TableError& e) {
  return {{"mean", json_of(e.mean)},
          {"median", json_of(e.median)},
          {"p95", json_of(e.p95)},
          {"max", json_of(e.max)}};
}

Json json_of(const LightError& e) {
  return {{"rmse", number(e.rmse)},
          {"mean", number(e.mean)},
          {"p95", number(e.p95)},
          {"max", number(e.max)},
          {"bias", number(e.bias)},
          {"mean_light", number(e.mean_light)},
          {"bound_violations", e.violations},
          {"largest_share_of_bound", number(e.of_bound)}};
}

Json json_of(const LightFamily& f) {
  return {{"count", f.count},
          {"seed", f.seed},
          {"roughness", {number(f.roughness_from), number(f.roughness_to)}},
          {"theta_to_degrees", number(f.theta_to_degrees)},
          {"uniform_in", name_of(f.angle_axis)},
          {"distance", {number(f.distance_from), number(f.distance_to)}},
          {"side", {number(f.side_from), number(f.side_to)}}};
}

Json cells(const ErrorMap& map) {
  Json object = Json::object();
  for (const LobeErrorField& field : lobe_error_fields()) {
    Json array = Json::array();
    for (const LobeError& e : map.cells)
      array.push_back(number(e.*field.member));
    object[field.name] = std::move(array);
  }
  return object;
}

Json json_of(const RegionReport& region, const std::vector<CandidateReport>& candidates) {
  const MeasureOptions& o = region.region;
  Json object = {{"name", region.name},
                 {"roughness", {number(o.roughness_from), number(o.roughness_to)}},
                 {"theta_to_degrees", number(o.theta_to_degrees)},
                 {"points", o.points},
                 {"uniform_in", name_of(o.angle_axis)},
                 {"quadrature", {o.quadrature.radial, o.quadrature.azimuths}}};
  Json list = Json::array();
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    Json entry = {{"label", candidates[c].label}, {"between_nodes", json_of(region.errors[c])}};
    entry["on_nodes"] = region.nodes[c] ? json_of(*region.nodes[c]) : Json(nullptr);
    entry["cells"] = cells(region.maps[c]);
    list.push_back(std::move(entry));
  }
  object["axes"] = {{"roughness", numbers(region.maps[0].axes.roughness)},
                    {"theta_degrees", numbers(region.maps[0].axes.theta_degrees)}};
  object["albedo"] = numbers(region.maps[0].albedo);
  object["candidates"] = std::move(list);
  return object;
}

} // namespace

std::string to_json(const Report& report) {
  Json json = {{"title", report.title},
               {"command", report.command},
               {"tool_version", report.tool_version},
               {"brdf",
                {{"name", report.brdf},
                 {"variant", report.variant},
                 {"source", report.source},
                 {"parameter", report.parameter}}},
               {"bound", "|error| <= bound * L_max, bound = albedo * tv + n1, where F = 1, for any "
                         "light of radiance 0 to L_max; n1 is the error of the amplitude"},
               {"bound_tolerance", number(k_light_tolerance)}};
  json["light_family"] = json_of(report.lights);
  json["candidates"] = Json::array();
  for (const CandidateReport& c : report.candidates) {
    Json metadata = Json::object();
    for (const auto& [name, value] : c.metadata)
      metadata[name] = value;
    json["candidates"].push_back(
        {{"label", c.label},
         {"horizon", name_of(c.horizon)},
         {"is_limit", c.is_limit},
         {"metadata", metadata},
         {"second_difference", c.second_difference ? number(*c.second_difference) : Json()},
         {"lights", json_of(c.lights)}});
  }
  json["regions"] = Json::array();
  for (const RegionReport& region : report.regions)
    json["regions"].push_back(json_of(region, report.candidates));
  json["worst_cells"] = Json::array();
  for (const WorstCell& cell : report.worst) {
    Json entry = {{"worst_of", report.candidates[cell.of].label},
                  {"roughness", number(cell.roughness)},
                  {"theta_degrees", number(cell.theta_degrees)},
                  {"albedo", number(cell.albedo)}};
    entry["errors"] = Json::array();
    for (const LobeError& e : cell.errors)
      entry["errors"].push_back(json_of(e));
    json["worst_cells"].push_back(std::move(entry));
  }
  // Text that is not UTF-8, a file's name perhaps, must not stop a report.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace openltc::fit
