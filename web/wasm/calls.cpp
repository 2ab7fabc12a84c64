// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The fitter's answers by the name of their call.

#include "fits.h"
#include "openltc/image/colormap.h"

#include <fmt/format.h>

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
