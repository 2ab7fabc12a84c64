// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Small pieces of the dialect in every shading language; what is expected is written by hand, from
// the languages' own rules.

#include "openltc/shaders/arguments.h"
#include "openltc/shaders/parser.h"
#include "openltc/shaders/simplify.h"
#include "openltc/shaders/writer.h"

#include <doctest/doctest.h>

#include <string>

using namespace openltc;
using namespace openltc::shaders;

namespace {

// The last item of `source` in a language, by facts of a table of one lobe.
std::string written(Language language, const std::string& source) {
  Result<SourceFile> file = parse_file("// Test.\n\n" + source, "test.glsl");
  REQUIRE_MESSAGE(file, file.error().message);
  Facts facts;
  facts.fields = {{"exact", false}, {"two", false}};
  note_integers(*file, facts);
  std::set<std::string> globals;
  for (Item& item : file->items) {
    globals.insert(item.name);
    simplify(item, facts);
  }
  return make_writer(language, "x_", {}, globals)->item(file->items.back());
}

std::string error_of(const std::string& source) {
  const Result<SourceFile> file = parse_file(source, "test.glsl");
  return file ? "" : file.error().message;
}

} // namespace

TEST_CASE("brackets are where the order of evaluation needs them") {
  CHECK(written(Language::glsl,
                "FN Real f(Real a, Real b) { return a - (a - b) * (a / (a * b)); }") ==
        "float x_f(float a, float b) { return a - (a - b) * (a / (a * b)); }\n");
  CHECK(written(Language::glsl,
                "FN Real f(Real a, Real b) { return ((a * b) + (a)) - (-(a + b)); }") ==
        "float x_f(float a, float b) { return a * b + a - -(a + b); }\n");
  CHECK(
      written(Language::glsl,
              "FN bool f(Real a, Real b) { return (a < b) != (b < a) || (a > b && !(a == b)); }") ==
      "bool x_f(float a, float b) { return (a < b) != (b < a) || (a > b && !(a == b)); }\n");
}

TEST_CASE("words of the dialect are those of each language") {
  const std::string source = "FN Vec3 f(Vec3 v, Mask m, int i) {\n"
                             "  return select(m, v * inversesqrt(Real(2.0)), v) * Real(i);\n}";
  CHECK(written(Language::glsl, source) ==
        "vec3 x_f(vec3 v, bool m, int i) { return (m ? v * inversesqrt(2.0) : v) * float(i); }\n");
  CHECK(written(Language::hlsl, source) ==
        "float3 x_f(float3 v, bool m, int i) { return (m ? v * rsqrt(2.0) : v) * float(i); }\n");
  CHECK(written(Language::metal, source) == "static inline float3 x_f(float3 v, bool m, int i) { "
                                            "return (m ? v * rsqrt(2.0) : v) * float(i); }\n");
  CHECK(written(Language::wgsl, source) ==
        "fn x_f(v: vec3f, m: bool, i: i32) -> vec3f { return select(v, v * inverseSqrt(2.0), m) * "
        "f32(i); }\n");
}

TEST_CASE("constants and structs are declared as each language does it") {
  const std::string constant = "/// Half.\nCONSTANT k_half = 0.5;";
  CHECK(written(Language::glsl, constant) == "// Half.\nconst float x_k_half = 0.5;\n");
  CHECK(written(Language::hlsl, constant) == "// Half.\nstatic const float x_k_half = 0.5;\n");
  CHECK(written(Language::metal, constant) == "// Half.\nconstant float x_k_half = 0.5;\n");
  CHECK(written(Language::wgsl, constant) == "// Half.\nconst x_k_half: f32 = 0.5;\n");
  const std::string structure =
      "struct S {\n  Real a;  ///< one\n  // and\n  Vec2 from; ///< two\n};";
  CHECK(written(Language::glsl, structure) ==
        "struct x_S {\n  float a;   // one\n  // and\n  vec2 from; // two\n};\n");
  CHECK(written(Language::wgsl, structure) ==
        "struct x_S {\n  a: f32,       // one\n  // and\n  from_: vec2f, // two\n}\n");
}

TEST_CASE("WGSL: parameters are not changed, variables that are not are constants") {
  CHECK(written(Language::wgsl, "FN Real f(Real a) {\n  Real b = a;\n  Real c = b;\n"
                                "  for (int i = 0; i < 2; ++i) {\n    c = c + b;\n  }\n"
                                "  a = c;\n  return a;\n}") ==
        "fn x_f(a_in: f32) -> f32 {\n  var a = a_in;\n  let b = a;\n  var c = b;\n"
        "  for (var i = 0; i < 2; i++) {\n    c = c + b;\n  }\n  a = c;\n  return a;\n}\n");
}

TEST_CASE("WGSL: mixed logic is bracketed, and no comparison looks like a template") {
  CHECK(written(Language::wgsl, "FN bool f(bool a, bool b, bool c) { return a || b && c; }") ==
        "fn x_f(a: bool, b: bool, c: bool) -> bool { return a || (b && c); }\n");
  CHECK(written(Language::wgsl, "FN bool g(bool a, bool b) { return a; }\n"
                                "FN bool f(Real a, Real b) { return g(a < b, b > (a)); }") ==
        "fn x_f(a: f32, b: f32) -> bool { return x_g((a < b), b > a); }\n");
}

TEST_CASE("variables have no name that a language keeps for itself") {
  const std::string source =
      "FN Real f(Real line, Real from, Real sample) { return line + from + sample; }";
  CHECK(written(Language::hlsl, source) ==
        "float x_f(float line_, float from, float sample_) { return line_ + from + sample_; }\n");
  CHECK(written(Language::wgsl, source) ==
        "fn x_f(line: f32, from_: f32, sample: f32) -> f32 { return line + from_ + sample; }\n");
}

TEST_CASE("arguments that C++ passes by reference are values") {
  CHECK(written(Language::glsl, "FN_CALL Real f(GIVEN(Surface) s, Real a) { return a; }") ==
        written(Language::glsl, "FN_CALL Real f(Surface s, Real a) { return a; }"));
}

TEST_CASE("what is known beforehand is decided") {
  // One lobe, no exact mode, one lane.
  CHECK(written(Language::glsl,
                "FN Real f(Surface s, Real a) {\n"
                "  ASSERT_THAT(a > Real(0.0));\n"
                "  if (s.exact) {\n    return Real(1.0);\n  }\n"
                "  if (!s.two && any_lane(a > Real(2.0))) {\n    a = reciprocal(a);\n  }\n"
                "  if (lanes_agree(a > Real(1.0))) {\n    a = Real(3.0);\n"
                "  } else {\n    a = Real(4.0);\n  }\n"
                "  return a;\n}") ==
        "float x_f(Surface s, float a) {\n  if (a > 2.0) {\n    a = 1.0 / a;\n  }\n  a = 4.0;\n"
        "  return a;\n}\n");
}

TEST_CASE("an argument that is the same in all calls is none") {
  const auto settled = [](const std::string& calls) {
    Result<SourceFile> file =
        parse_file("// Test.\n\nFN Real f(Real a, bool b) {\n  if (b) {\n    a = Real(2.0);\n"
                   "  }\n  return a;\n}\nFN Real g(Real a, bool c) { return " +
                       calls + "; }",
                   "test.glsl");
    REQUIRE(file);
    std::vector<SourceFile> files = {*file};
    for (Item& item : files[0].items)
      simplify(item, Facts());
    settle_arguments(files, Facts(), {"g"});
    const std::unique_ptr<Writer> writer = make_writer(Language::glsl, "x_", {}, {"f", "g"});
    return writer->item(files[0].items[0]) + writer->item(files[0].items[1]);
  };
  CHECK(
      settled("f(a, false) + f(a, false)") ==
      "float x_f(float a) { return a; }\nfloat x_g(float a, bool c) { return x_f(a) + x_f(a); }\n");
  const std::string kept =
      "float x_f(float a, bool b) {\n  if (b) {\n    a = 2.0;\n  }\n  return a;\n}\n";
  CHECK(settled("f(a, false) + f(a, true)") ==
        kept + "float x_g(float a, bool c) { return x_f(a, false) + x_f(a, true); }\n");
  CHECK(settled("f(a, c)") == kept + "float x_g(float a, bool c) { return x_f(a, c); }\n");
}

TEST_CASE("nor is one that nobody reads, but in what callers call") {
  Result<SourceFile> file = parse_file("// Test.\n\nFN Real f(Real a, Vec3 unread) { return a; }\n"
                                       "FN Real g(Real a, Vec3 b) { return f(a, b); }\n"
                                       "FN Real twice(Real a, Real b) { return a; }\n"
                                       "FN Real twice(Real a) { return twice(a, a); }",
                                       "test.glsl");
  REQUIRE(file);
  std::vector<SourceFile> files = {*file};
  settle_arguments(files, Facts(), {"g"});
  const std::unique_ptr<Writer> writer = make_writer(Language::glsl, "", {}, {});
  CHECK(writer->item(files[0].items[0]) == "float f(float a) { return a; }\n");
  CHECK(writer->item(files[0].items[1]) == "float g(float a, vec3 b) { return f(a); }\n");
  // Two of one name stay two.
  CHECK(writer->item(files[0].items[2]) == "float twice(float a, float b) { return a; }\n");
}

TEST_CASE("a variable that only itself is made of goes") {
  Result<SourceFile> file = parse_file("// Test.\n\nFN Real f(Real a) {\n  Real b = a;\n"
                                       "  b = b + a;\n  return a;\n}",
                                       "test.glsl");
  REQUIRE(file);
  CHECK(remove_unread_variables(file->items[0]));
  CHECK(!remove_unread_variables(file->items[0]));
  const std::unique_ptr<Writer> writer = make_writer(Language::glsl, "", {}, {});
  CHECK(writer->item(file->items[0]) == "float f(float a) { return a; }\n");
}

TEST_CASE("comments stay where they are") {
  CHECK(written(Language::glsl,
                "/// Twice.\n///\n/// Really.\nFN Real f(Real a) {\n"
                "  // Why.\n  Real b = a + a; // so\n\n  // And then:\n  return b;\n}") ==
        "// Twice.\n//\n// Really.\nfloat x_f(float a) {\n  // Why.\n  float b = a + a; // so\n\n"
        "  // And then:\n  return b;\n}\n");
}

TEST_CASE("long lines are broken outside of inner brackets") {
  const std::string a(40, 'a'), b(40, 'b');
  CHECK(written(Language::glsl, "FN Real f(Real " + a + ", Real " + b + ") {\n  return " + a +
                                    " * " + b + " + (" + a + " - " + b + ");\n}") ==
        "float x_f(float " + a + ",\n          float " + b + ") {\n  return " + a + " * " + b +
            " +\n         (" + a + " - " + b + ");\n}\n");
}

TEST_CASE("what is not the dialect is named with its place") {
  CHECK(error_of("FN Real f(Real a) {\n  return a\n}") == "test.glsl:3: expected ';', not '}'");
  CHECK(error_of("FN Real f(const Real& a) { return a; }") ==
        "test.glsl:1: no word of the dialect begins with '&'");
  CHECK(error_of("Real f(Real a) { return a; }") ==
        "test.glsl:1: expected struct, CONSTANT, const, FN, FN_INLINE or FN_CALL, not 'f'");
  CHECK(error_of("FN Real f(") == "test.glsl:1: expected a name, not ''");
}
