// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Runs a program of docs/examples.

#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <string>
#include <sys/wait.h>

namespace openltc::testing {

struct Run {
  int exit_code = -1;
  std::string out; // with stderr behind stdout
};

inline Run run_example(const std::string& program, const std::string& argument) {
  const std::string command = "'" + program + "' '" + argument + "' 2>&1";
  Run run;
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 256> line{};
  while (std::fgets(line.data(), int(line.size()), pipe) != nullptr)
    run.out += line.data();
  const int status = pclose(pipe);
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  return run;
}

} // namespace openltc::testing
