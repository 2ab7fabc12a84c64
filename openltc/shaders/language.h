// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The shading languages, and what each calls things.

#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace openltc::shaders {

/// A shading language.
enum class Language { glsl, glsl_es, hlsl, metal, wgsl, gdshader };

/// All of them, in the order of the help.
const std::vector<Language>& all_languages();

/// "glsl-es": how the command line names a language.
std::string name_of(Language language);

/// The words of a language.
struct Words {
  const char* title;                        ///< for people: its name and version
  const char* extension;                    ///< of files, with its dot
  std::map<std::string, std::string> types; ///< those of the dialect in it
  std::map<std::string, std::string> calls; ///< built-in functions with another name
  std::set<std::string> reserved;           ///< words that no variable may have as its name
  const char* texture;                      ///< type of a texture
  const char* sampler;                      ///< type of a sampler; empty: the texture has it
  const char* polygon = "int";              ///< type of a Polygon
  const char* function = "";                ///< before the type of a function
  const char* constant = "const";           ///< before the type of a constant
};

/// The words of `language`.
const Words& words_of(Language language);

} // namespace openltc::shaders
