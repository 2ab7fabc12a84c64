// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/language.h"

#include <iterator>

namespace openltc::shaders {

namespace {

using Types = std::map<std::string, std::string>;

Types types(const char* real, const char* two, const char* three, const char* four,
            const char* integer = "int") {
  return {{"Real", real},   {"Vec2", two},    {"Vec3", three},  {"Vec4", four},
          {"Mask", "bool"}, {"bool", "bool"}, {"int", integer}, {"float", real}};
}

const Types k_glsl_types = types("float", "vec2", "vec3", "vec4");
const Types k_float3_types = types("float", "float2", "float3", "float4");

// Words that a variable of the dialect might have as its name and some language keeps for itself.
// What is common to C is not among them: the dialect is C++ as well.
const std::set<std::string> k_glsl_reserved = {
    "active",        "attribute", "buffer",    "centroid", "coherent",  "common",
    "filter",        "fixed",     "flat",      "half",     "highp",     "in",
    "input",         "inout",     "invariant", "layout",   "lowp",      "mediump",
    "noperspective", "out",       "output",    "packed",   "partition", "patch",
    "precise",       "precision", "readonly",  "resource", "sample",    "shared",
    "smooth",        "superp",    "texture",   "uniform",  "varying",   "writeonly"};

const Words k_glsl = {
    "GLSL 4.50 (and 3.30 or later)", ".glsl", k_glsl_types, {}, k_glsl_reserved, "sampler2D", ""};

const Words k_glsl_es = {
    "GLSL ES 3.00 (WebGL 2)", ".glsl", k_glsl_types, {}, k_glsl_reserved, "sampler2D", ""};

const Words k_hlsl = {
    "HLSL, shader model 5.0 or later",
    ".hlsl",
    k_float3_types,
    {{"inversesqrt", "rsqrt"}},
    {"centroid",      "compile",       "discard",     "export",     "globallycoherent",
     "groupshared",   "half",          "in",          "inline",     "inout",
     "line",          "lineadj",       "linear",      "matrix",     "nointerpolation",
     "noperspective", "out",           "packoffset",  "pass",       "pixelfragment",
     "point",         "precise",       "register",    "row_major",  "sample",
     "sampler",       "shared",        "snorm",       "stateblock", "technique",
     "texture",       "triangle",      "triangleadj", "uniform",    "unorm",
     "vector",        "vertexfragment"},
    "Texture2D<float4>",
    "SamplerState",
    "int",
    "",
    "static const"};

const Words k_metal = {"Metal Shading Language 2.0 or later",
                       ".metal",
                       k_float3_types,
                       {{"inversesqrt", "rsqrt"}},
                       {"constant", "device", "fragment", "half", "kernel", "level", "sampler",
                        "texture", "thread", "threadgroup", "vertex"},
                       "texture2d<float>",
                       "sampler",
                       "constant float4*",
                       "static inline",
                       "constant"};

const Words k_wgsl = {"WGSL",
                      ".wgsl",
                      types("f32", "vec2f", "vec3f", "vec4f", "i32"),
                      {{"inversesqrt", "inverseSqrt"}},
                      {"active",    "alias",     "as",          "async",         "coherent",
                       "common",    "compile",   "diagnostic",  "enable",        "enum",
                       "export",    "external",  "filter",      "final",         "fn",
                       "from",      "get",       "groupshared", "handle",        "highp",
                       "in",        "inout",     "instanceof",  "let",           "layout",
                       "loop",      "lowp",      "match",       "mediump",       "meta",
                       "mod",       "module",    "move",        "mut",           "noise",
                       "null",      "of",        "on",          "out",           "override",
                       "partition", "pass",      "patch",       "pixelfragment", "precise",
                       "precision", "quat",      "readonly",    "ref",           "regardless",
                       "require",   "requires",  "resource",    "restrict",      "self",
                       "set",       "shared",    "smooth",      "snorm",         "super",
                       "target",    "technique", "texture",     "trait",         "type",
                       "uniform",   "unless",    "unorm",       "use",           "var",
                       "varying",   "vector",    "where",       "with",          "writeonly",
                       "yield"},
                      "texture_2d<f32>",
                      "sampler"};

std::set<std::string> gdshader_reserved() {
  std::set<std::string> words = k_glsl_reserved;
  words.insert(
      {"global", "group_uniforms", "hint_range", "instance", "render_mode", "shader_type"});
  return words;
}

const Words k_gdshader = {"Godot's shading language, Godot 4",
                          ".gdshaderinc",
                          k_glsl_types,
                          {},
                          gdshader_reserved(),
                          "sampler2D",
                          ""};

} // namespace

const std::vector<Language>& all_languages() {
  static const std::vector<Language> languages = {Language::glsl, Language::glsl_es,
                                                  Language::hlsl, Language::metal,
                                                  Language::wgsl, Language::gdshader};
  return languages;
}

std::string name_of(Language language) {
  constexpr const char* k_names[] = {"glsl", "glsl-es", "hlsl", "metal", "wgsl", "gdshader"};
  return k_names[int(language)];
}

const Words& words_of(Language language) {
  const Words* words[] = {&k_glsl, &k_glsl_es, &k_hlsl, &k_metal, &k_wgsl, &k_gdshader};
  return *words[int(language)];
}

} // namespace openltc::shaders
