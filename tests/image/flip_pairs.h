// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The pictures of tools/make_flip_reference.py, made by the same arithmetic.

#pragma once

#include "openltc/image/image.h"

#include <string>

namespace openltc::image::test {

struct FlipPair {
  Image test, reference;
};

/// `name` is that of an entry of k_flip_references.
FlipPair make_flip_pair(const std::string& name);

} // namespace openltc::image::test
