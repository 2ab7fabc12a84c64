// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/options/reading_options.h"

#include "openltc/base/memory_budget.h"

#include <string>

namespace openltc::cli {

void add_memory_option(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--memory",
          [](const std::string& text) {
            const Result<std::uint64_t> size = parse_memory_size(text);
            if (!size) throw CLI::ValidationError("--memory", size.error().message);
            memory_budget().set_limit(*size);
          },
          "Most memory that files and pictures may ask for, such as 512M or 4G; what asks for more "
          "is "
          "refused, a texture left out [half of the machine's]")
      ->type_name("SIZE");
}

void add_reading_options(CLI::App& command, scene::ReadOptions& options) {
  add_memory_option(command);
  command.add_flag("--allow-outside", options.allow_outside,
                   "Read files outside the scene's folder when it names them: ../x.png, absolute "
                   "paths, links that lead out. Only for scenes that you trust");
}

} // namespace openltc::cli
