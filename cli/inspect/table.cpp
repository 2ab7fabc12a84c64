// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/inspect/inspect.h"
#include "openltc/base/quote.h"
#include "openltc/fit/measure/error.h"
#include "openltc/fit/measure/identify.h"
#include "openltc/table/divided.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/shading_lobes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace openltc::cli {

namespace {

constexpr std::size_t k_listed = 8; // readings of a bare texture

// Ranges of a texture's channels; those named "0" are padding.
void add_ranges(const table::Texture& texture, const std::vector<std::string>& names,
                Description& out) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == "0") continue;
    float low = texture.values[k], high = low;
    for (std::size_t i = k; i < texture.values.size(); i += std::size_t(texture.channels)) {
      low = std::min(low, texture.values[i]);
      high = std::max(high, texture.values[i]);
    }
    out.text += fmt::format("{:<10} {:.6g} to {:.6g}\n", names[k], low, high);
    out.json["channels"][names[k]] = {{"min", low}, {"max", high}};
  }
}

// What a renderer has to do at the surface's horizon.
const char* horizon_in_words(const table::PackedTable& packed) {
  if (is_divided(packed))
    return "divided: clip lights; n1 and n5 are over the lobe's share above already";
  if (packed.metadata.horizon.empty()) return "not known";
  return fit::horizon_of(packed) == fit::Horizon::clipped
             ? "clipped: clip lights and divide by the lobe's share above"
             : "leaking: the lobe as it is";
}

Description describe_packed(const std::string& path, const table::PackedTable& packed) {
  const table::TableMetadata& m = packed.metadata;
  const table::LayoutFacts& facts = facts_of(packed.layout);
  Description out;
  const bool two = packed.layout == table::Layout::native_two;
  out.text =
      fmt::format("lobe table{}, {} x {} nodes over roughness and {}\n", two ? " of two lobes" : "",
                  packed.columns(), packed.rows(), name_of(packed.angle_axis));
  out.text += fmt::format("layout     {}, {} ({})\n", name_of(packed.layout),
                          name_of(packed.precision), facts.readers);
  out.text += fmt::format("packing    {}\n", facts.normalisation);
  out.text += fmt::format("brdf       {} ({})\n", quote(m.brdf), quote(m.variant));
  out.text += fmt::format("objective  {}\n", quote(m.objective));
  out.text += fmt::format("horizon    {}\n", horizon_in_words(packed));
  out.text +=
      fmt::format("made by    {} (OpenLTC {})\n", quote(m.command, 400), quote(m.tool_version));
  out.text += stated_errors(m);
  out.json = {{"file", path},
              {"kind", "table"},
              {"size", packed.columns()},
              {"columns", packed.columns()},
              {"rows", packed.rows()},
              {"layout", name_of(packed.layout)},
              {"precision", name_of(packed.precision)},
              {"angle_axis", name_of(packed.angle_axis)},
              {"width", packed.width == brdf::LobeWidth::alpha ? "alpha" : "one"},
              {"brdf", m.brdf},
              {"variant", m.variant},
              {"objective", m.objective},
              {"horizon", m.horizon},
              {"command", m.command},
              {"tool_version", m.tool_version},
              {"mean_tv", known_or_null(m.mean_tv)},
              {"max_tv", known_or_null(m.max_tv)}};
  add_measured_errors(
      m.brdf, [&](double roughness, double c) { return fit::fetch_measured(packed, roughness, c); },
      fit::horizon_of(packed), out);
  for (std::size_t t = 0; t < packed.textures.size(); ++t)
    add_ranges(packed.textures[t], {facts.channels[t].begin(), facts.channels[t].end()}, out);
  return out;
}

// A texture that says nothing: what it most probably is.
Description describe_bare(const table::TextureFiles& files) {
  const table::Texture& first = files.textures[0];
  Description out;
  out.text = fmt::format("bare texture, {} x {}, {} channels, {}, {} file(s); it does not say what "
                         "it is\n",
                         first.width, first.height, first.channels, name_of(first.precision),
                         files.paths.size());
  out.json = {{"file", files.paths[0]},
              {"kind", "bare texture"},
              {"columns", first.width},
              {"rows", first.height},
              {"precision", name_of(first.precision)},
              {"files", files.paths}};
  for (std::size_t t = 0; t < files.textures.size(); ++t) {
    std::vector<std::string> names;
    for (int k = 0; k < files.textures[t].channels; ++k)
      names.push_back(fmt::format("{}.{}", t + 1, "rgba"[k]));
    add_ranges(files.textures[t], names, out);
  }
  const Result<std::vector<fit::Identification>> found = fit::identify(files.textures);
  if (!found) {
    out.text += fmt::format("no lobe table: {}\n", found.error().message);
    return out;
  }
  out.text += "mean TV  BRDF         read as\n";
  out.json["readings"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < std::min(k_listed, found->size()); ++i) {
    const fit::Identification& id = (*found)[i];
    std::string amplitudes;
    if (id.has_amplitudes)
      amplitudes = fmt::format("; n1 off by {:.1e}, n5 by {:.1e}", id.mean_n1, id.mean_n5);
    out.text += fmt::format("{:.4f}   {:<12} {}{}{}\n", id.mean_tv, id.brdf,
                            id.layout ? fmt::format("[{}] ", name_of(*id.layout)) : "", id.reading,
                            amplitudes);
    nlohmann::ordered_json entry = {
        {"mean_tv", id.mean_tv}, {"brdf", id.brdf}, {"reading", id.reading}};
    if (id.layout) entry["layout"] = name_of(*id.layout);
    if (id.has_amplitudes) {
      entry["mean_n1"] = id.mean_n1;
      entry["mean_n5"] = id.mean_n5;
    }
    out.json["readings"].push_back(entry);
  }
  const fit::Identification& best = found->front();
  // A table of another BRDF or another reading differs from each of these by more than this.
  if (best.mean_tv > 0.25) {
    out.text += "none of these fits: probably no lobe table, or of a BRDF not known here\n";
  } else if (best.layout) {
    out.text += fmt::format("most probably a table of {} in the layout {}; to give it a "
                            "description: openltc convert {} OUT --from-layout {} --brdf {}\n",
                            best.brdf, name_of(*best.layout), files.paths[0], name_of(*best.layout),
                            best.brdf);
  } else {
    out.text += fmt::format("most probably a table of {}, read as: {}\n", best.brdf, best.reading);
  }
  return out;
}

} // namespace

std::string stated_errors(const table::TableMetadata& metadata) {
  if (metadata.mean_tv == 0) return "mean TV    not known\n";
  return fmt::format("mean TV    {}   max {}   roughness .06-1, interpolated\n", metadata.mean_tv,
                     metadata.max_tv);
}

void add_measured_errors(const std::string& brdf_name, const fit::LobeFunction& lobes,
                         fit::Horizon horizon, Description& out) {
  const brdf::Brdf* brdf = brdf::find_brdf(brdf_name);
  if (!brdf) return;
  fit::MeasureOptions options;
  options.points = 24;
  options.horizon = horizon;
  const Result<fit::TableError> e = fit::measure_lobes(*brdf, lobes, options);
  if (!e) return;
  out.text +=
      fmt::format("measured   mean TV {:.4f}   max {:.4f}   n1 {:.1e}   n5 {:.1e}   "
                  "against {}, {} x {} points\n",
                  e->mean.tv, e->max.tv, e->mean.n1, e->mean.n5, brdf->name, e->points, e->points);
  out.json["measured"] = {{"mean_tv", e->mean.tv}, {"max_tv", e->max.tv},
                          {"mean_l2", e->mean.l2}, {"mean_l3", e->mean.l3},
                          {"mean_n1", e->mean.n1}, {"mean_n5", e->mean.n5}};
}

nlohmann::ordered_json known_or_null(double number) {
  return number == 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(number);
}

Result<Description> inspect_table(const std::string& path) {
  if (table::is_polynomial_file(path)) return inspect_polynomial(path);
  const bool json = std::filesystem::path(path).extension() == ".json";
  if (!json) {
    const Result<table::TextureFiles> files = table::read_textures(path);
    if (!files) return files.error();
    if (files->description.empty()) return describe_bare(*files);
  }
  const Result<table::PackedTable> packed = table::read_packed(path);
  if (!packed) return packed.error();
  return describe_packed(path, *packed);
}

Result<Description> inspect_exr(const std::string& path) {
  const Result<table::TextureFiles> files = table::read_textures(path);
  if (!files || (files->description.empty() && files->textures.size() < 2))
    return inspect_picture(path);
  Result<Description> table = inspect_table(path);
  if (table) {
    const bool described = !files->description.empty();
    const char* reason = described ? "its attributes openltc.* say so"
                                   : "NAME_1.exr and NAME_2.exr lie side by side";
    table->text += fmt::format("taken for a table, not a picture: {}\n", reason);
    table->json["taken_for_a_table"] = reason;
  }
  return table;
}

} // namespace openltc::cli
