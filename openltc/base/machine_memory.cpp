// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How much of the machine's memory files may ask for: what memory_budget.h wants of the system.

#include "openltc/base/memory_budget.h"

#include <algorithm>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace openltc {

namespace {

constexpr std::uint64_t k_unknown = std::uint64_t(-1);

std::uint64_t machine_bytes() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page_size = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page_size > 0 ? std::uint64_t(pages) * std::uint64_t(page_size) : k_unknown;
}

// In a container the file system root shows the container's own group. Version 2, then 1; without a
// limit they say "max" or a number beyond any machine.
std::uint64_t control_group_bytes() {
  for (const char* path :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::ifstream file(path);
    std::uint64_t bytes = 0;
    if (file >> bytes && bytes > 0) return bytes;
  }
  return k_unknown;
}

std::uint64_t resource_limit_bytes() {
  struct rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return k_unknown;
  return std::uint64_t(limit.rlim_cur);
}

} // namespace

std::uint64_t default_memory_limit() {
  const std::uint64_t bytes =
      std::min({machine_bytes(), control_group_bytes(), resource_limit_bytes()});
  return bytes == k_unknown ? std::uint64_t(4) << 30 : bytes / 2;
}

} // namespace openltc
