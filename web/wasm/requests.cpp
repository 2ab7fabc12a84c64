// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "requests.h"

#include "openltc/image/colormap.h"

#include <fmt/format.h>

#include <cstring>

namespace openltc::wasm {

namespace {

// Everything that can be chosen by name.
Answer make_catalogue() {
  Answer answer;
  answer.json["version"] = OPENLTC_VERSION;
  answer.json["brdfs"] = Json::array();
  for (const brdf::Brdf& b : brdf::all_brdfs())
    answer.json["brdfs"].push_back(
        {{"name", b.name},
         {"variant", b.variant},
         {"source", b.source},
         {"parameter", b.parameter},
         {"width", b.width == brdf::LobeWidth::alpha ? "alpha" : "one"}});
  answer.json["layouts"] = Json::array();
  for (const table::Layout layout : table::all_layouts()) {
    const table::LayoutFacts& facts = table::facts_of(layout);
    answer.json["layouts"].push_back({{"name", table::name_of(layout)},
                                      {"readers", facts.readers},
                                      {"normalisation", facts.normalisation},
                                      {"usualSize", facts.usual_size},
                                      {"angleAxis", table::name_of(facts.angle_axis)},
                                      {"channels", facts.channels}});
  }
  answer.json["engines"] = Json::array();
  for (const table::Engine& e : table::all_engines())
    answer.json["engines"].push_back({{"name", e.name},
                                      {"title", e.title},
                                      {"layout", table::name_of(e.layout)},
                                      {"size", e.size},
                                      {"precision", table::name_of(e.precision)},
                                      {"files", e.files},
                                      {"place", e.place},
                                      {"slip", e.slip}});
  // Of 256 colours each, sRGB 0 to 1.
  answer.json["colormaps"] = Json::object();
  const auto add_map = [&](const char* name, image::Colormap map) {
    std::vector<double> colours;
    for (int i = 0; i < 256; ++i) {
      const Vec3f c = image::map_color(map, float(i) / 255);
      colours.insert(colours.end(), {double(c.x), double(c.y), double(c.z)});
    }
    answer.json["colormaps"][name] = answer.add_floats(colours);
  };
  add_map("magma", image::Colormap::magma);
  add_map("viridis", image::Colormap::viridis);
  add_map("blueRed", image::Colormap::blue_red);
  return answer;
}

} // namespace

std::size_t Answer::add_floats(const std::vector<double>& numbers) {
  std::vector<std::uint8_t> raw(numbers.size() * sizeof(float));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const float number = float(numbers[i]);
    std::memcpy(raw.data() + i * sizeof(float), &number, sizeof(float));
  }
  bytes.push_back(std::move(raw));
  return bytes.size() - 1;
}

std::string text_of(const Json& object, const char* name, const std::string& otherwise) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

double number_of(const Json& object, const char* name, double otherwise) {
  const auto found = object.find(name);
  if (found == object.end()) return otherwise;
  if (found->is_boolean()) return found->get<bool>() ? 1 : 0;
  return found->is_number() ? found->get<double>() : otherwise;
}

std::vector<double> numbers_of(const Json& object, const char* name) {
  std::vector<double> numbers;
  const auto found = object.find(name);
  if (found != object.end() && found->is_array())
    for (const Json& number : *found)
      if (number.is_number()) numbers.push_back(number.get<double>());
  return numbers;
}

Result<Answer> answer(const Json& request) {
  if (!request.is_object()) return Error{"the request is not a JSON object"};
  const std::string call = text_of(request, "call");
  if (call == "catalogue") return make_catalogue();
  if (call == "fit") return make_fit(request);
  if (call == "free") {
    forget_fit(request);
    return Answer{};
  }
  const Result<const Kept*> kept = kept_fit(request);
  if (!kept) return kept.error();
  if (call == "files") return make_files(**kept, request);
  if (call == "report") return make_report_text(**kept, request);
  if (call == "cells") return make_cells(**kept, request);
  if (call == "polygon") return make_polygon(**kept, request);
  return Error{fmt::format("there is no call \"{}\"", call)};
}

} // namespace openltc::wasm
