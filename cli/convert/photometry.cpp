// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/convert/photometry.h"

#include "cli/output_place.h"
#include "cli/process/message.h"
#include "openltc/base/atomic_file.h"
#include "openltc/light/photometry/photometry.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

namespace openltc::cli {

Status convert_photometry(const std::string& input, const std::string& output, bool quiet) {
  const std::string extension = std::filesystem::path(output).extension().string();
  if (extension != ".ies" && extension != ".IES")
    return Error{
        fmt::format("{}: a photometric file is written as .ies, not to {}", input, output)};
  if (Status status = check_place(output); !status) return status.error();
  const Result<light::IesProfile> profile = light::read_photometry(input);
  if (!profile) return profile.error();
  if (Status status = check_not_read({output}); !status) return status.error();
  const std::string text = light::to_lm63(*profile);
  const Status written = write_atomically(output, [&](const std::string& temporary) -> Status {
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    file.close();
    if (!file) return Error{output + ": cannot be written"};
    return Success{};
  });
  if (!written || quiet) return written;
  for (const std::string& warning : profile->warnings)
    say("warning: {}\n", warning);
  say("wrote {}, {:.5g} lm\n", output, profile->flux_lumens);
  return Success{};
}

} // namespace openltc::cli
