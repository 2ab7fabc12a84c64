// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The shading source as one file of a shading language, which needs no other.

#pragma once

#include "openltc/base/result.h"
#include "openltc/shaders/language.h"

#include <string>
#include <vector>

namespace openltc::shaders {

/// A shape of light in a shader file.
enum class Shape { quad, polygon, disk, sphere, tube, line, textured };

/// All of them, in the order in which files and the help have them.
const std::vector<Shape>& all_shapes();

/// "quad": how the command line names a shape.
std::string name_of(Shape shape);

/// Where a shader has its fitted lobes from: constants of one lobe or of two, textures of one or of
/// two.
enum class Lobe { polynomial, two_lobe_polynomial, table, two_lobe };

/// Whether there are two lobes.
constexpr bool has_two(Lobe lobe) {
  return lobe == Lobe::two_lobe_polynomial || lobe == Lobe::two_lobe;
}

/// Whether they are constants of the file.
constexpr bool is_constant(Lobe lobe) {
  return lobe == Lobe::polynomial || lobe == Lobe::two_lobe_polynomial;
}

/// "polynomial": how the command line names it.
std::string name_of(Lobe lobe);

/// What a file should be.
struct ShaderRequest {
  Language language = Language::glsl;
  Lobe lobe = Lobe::polynomial;
  std::vector<Shape> shapes = {Shape::quad};
  bool lean = false;           ///< without set_geometric_normal and correct_at_mean
  bool sampling = false;       ///< with points of the lights, for shadows by rays
  std::string prefix = "ltc_"; ///< of all names that the file gives to others
  std::string version;         ///< of the program
};

/// Whether names can begin with `prefix` in every language: a letter, then letters, digits and
/// single underscores. The error says what is wrong.
Status check_prefix(const std::string& prefix);

/// The name of the file, by prefix, shapes, lobe, language, whether it is lean and samples:
/// "ltc_quad.glsl".
std::string file_name(const ShaderRequest& request);

/// Its text: the same for the same request, on every machine. The error names the file of the
/// shading source, and the line, at which it is not the dialect.
Result<std::string> make_shader(const ShaderRequest& request);

} // namespace openltc::shaders
