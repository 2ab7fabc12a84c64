// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The comment at the beginning of a shader file.

#pragma once

#include "openltc/shaders/shader_file.h"

#include <string>

namespace openltc::shaders {

/// The command that makes the file, less where it is written to.
std::string command_of(const ShaderRequest& request);

/// What the file is, by whom, of which BRDF, how exact, and how to call it.
std::string head_of(const ShaderRequest& request);

} // namespace openltc::shaders
