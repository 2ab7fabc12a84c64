// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Asking before a library takes memory that does not bear to get none.

#pragma once

#include <cstdint>

namespace openltc {

/// Whether this process may have so many bytes more of address space at this moment, which it asks
/// for and gives back. It knows of limits (ulimit -v), not of what the machine has.
bool has_address_space(std::uint64_t bytes);

} // namespace openltc
