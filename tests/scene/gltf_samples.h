// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Small valid files that together use all that the importer reads: where fuzzing starts from.

#pragma once

#include "gltf_builder.h"

#include <vector>

namespace openltc::test {

std::vector<GltfBuilder> make_samples();

} // namespace openltc::test
