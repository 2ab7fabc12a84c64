// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/address_space.h"

#include <cstddef>
#include <limits>
#include <sys/mman.h>

namespace openltc {

bool has_address_space(std::uint64_t bytes) {
  if (bytes == 0) return true;
  if (bytes > std::numeric_limits<std::size_t>::max()) return false;
  void* block = ::mmap(nullptr, std::size_t(bytes), PROT_NONE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (block == MAP_FAILED) return false;
  ::munmap(block, std::size_t(bytes));
  return true;
}

} // namespace openltc
