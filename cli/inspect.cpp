// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc inspect: what a file is.

#include "cli/commands.h"
#include "openltc/table/table_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace openltc::cli {

namespace {

Result<std::string> describe_table_file(const std::string& path) {
  const Result<table::LobeTable> read = table::read_table(path);
  if (!read) return read.error();
  const table::LobeTable& t = *read;
  const table::TableMetadata& m = t.metadata;
  std::string text =
      fmt::format("lobe table, {} x {} nodes over roughness and view angle\n", t.size, t.size);
  text += fmt::format("brdf       {} ({})\n", m.brdf, m.variant);
  text += fmt::format("objective  {}\n", m.objective);
  text += fmt::format("made by    {} (OpenLTC {})\n", m.command, m.tool_version);
  text +=
      fmt::format("mean TV    {}   max {}   roughness .06-1, interpolated\n", m.mean_tv, m.max_tv);
  const char* const names[] = {"A", "B", "C", "D", "n1", "n5"};
  for (int k = 0; k < 6; ++k) {
    float low = t.texels[std::size_t(k)], high = low;
    for (std::size_t i = std::size_t(k); i < t.texels.size(); i += table::LobeTable::k_channels) {
      low = std::min(low, t.texels[i]);
      high = std::max(high, t.texels[i]);
    }
    text += fmt::format("{:<10} {:.6g} to {:.6g}\n", names[k], low, high);
  }
  return text;
}

int run_inspect(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  Result<std::string> text =
      Error{fmt::format("{}: cannot tell what it is; known is .json (a lobe table)", path)};
  if (extension == ".json") text = describe_table_file(path);
  if (!text) {
    fmt::print(stderr, "openltc inspect: {}\n", text.error().message);
    return k_exit_failed;
  }
  fmt::print("{}", *text);
  return k_exit_ok;
}

} // namespace

void add_inspect(CLI::App& app, int& exit_code) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "inspect", "Say what a file is: a lobe table (.json) with its metadata and ranges.\n\n"
                 "Example:\n  openltc fit -o ggx.json && openltc inspect ggx.json");
  command->add_option("file", *path, "File to look at")->required();
  command->callback([path, &exit_code] { exit_code = run_inspect(*path); });
}

} // namespace openltc::cli
