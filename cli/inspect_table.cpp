// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/inspect.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace openltc::cli {

Result<Description> inspect_table(const std::string& path) {
  const Result<table::LobeTable> read = table::read_table(path);
  if (!read) return read.error();
  const table::LobeTable& t = *read;
  const table::TableMetadata& m = t.metadata;
  Description out;
  out.text =
      fmt::format("lobe table, {} x {} nodes over roughness and view angle\n", t.columns, t.rows);
  out.text += fmt::format("brdf       {} ({})\n", m.brdf, m.variant);
  out.text += fmt::format("objective  {}\n", m.objective);
  out.text += fmt::format("made by    {} (OpenLTC {})\n", m.command, m.tool_version);
  out.text +=
      fmt::format("mean TV    {}   max {}   roughness .06-1, interpolated\n", m.mean_tv, m.max_tv);
  out.json = {{"file", path},         {"kind", "table"},
              {"size", t.columns},    {"brdf", m.brdf},
              {"variant", m.variant}, {"objective", m.objective},
              {"command", m.command}, {"tool_version", m.tool_version},
              {"mean_tv", m.mean_tv}, {"max_tv", m.max_tv}};
  const char* const names[] = {"A", "B", "C", "D", "n1", "n5"};
  for (int k = 0; k < 6; ++k) {
    float low = t.texels[std::size_t(k)], high = low;
    for (std::size_t i = std::size_t(k); i < t.texels.size(); i += table::LobeTable::k_channels) {
      low = std::min(low, t.texels[i]);
      high = std::max(high, t.texels[i]);
    }
    out.text += fmt::format("{:<10} {:.6g} to {:.6g}\n", names[k], low, high);
    out.json["channels"][names[k]] = {{"min", low}, {"max", high}};
  }
  return out;
}

} // namespace openltc::cli
