// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Whole shader files: what is in them, what is not, and that those in shaders/ are what is made
// today.

#include "openltc/shaders/shader_file.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>

using namespace openltc;
using namespace openltc::shaders;

namespace {

ShaderRequest request_of(Language language, std::vector<Shape> shapes = {Shape::quad},
                         Lobe lobe = Lobe::polynomial) {
  ShaderRequest request;
  request.language = language;
  request.shapes = std::move(shapes);
  request.lobe = lobe;
  request.version = OPENLTC_VERSION;
  return request;
}

ShaderRequest lean_request(Language language) {
  ShaderRequest request = request_of(language);
  request.lean = true;
  return request;
}

std::string shader(const ShaderRequest& request) {
  const Result<std::string> text = make_shader(request);
  REQUIRE_MESSAGE(text, text.error().message);
  return *text;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string without_comments(const std::string& text) {
  return std::regex_replace(text, std::regex("//[^\n]*"), "");
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

TEST_CASE("the files in shaders/ are what is made today, byte for byte") {
  // tools/make_shaders.sh writes them.
  for (const Language language : all_languages())
    for (const ShaderRequest& request :
         {request_of(language), request_of(language, {Shape::quad}, Lobe::two_lobe_polynomial),
          request_of(language, {Shape::quad}, Lobe::table), lean_request(language),
          request_of(language, all_shapes())}) {
      const std::string path = OPENLTC_SOURCE_DIR "/shaders/" + file_name(request);
      const bool same = read_text(path) == shader(request);
      CHECK_MESSAGE(same, path);
    }
}

TEST_CASE("every name that others see begins with the prefix") {
  const std::regex declared(
      "^(?:struct|fn|const int|const float|const vec[24]|const|static const \\w+|constant "
      "\\w+|(?:static inline )?(?:float|bool|int|vec[234]|float[234]|Zz\\w+)) (\\w+)",
      std::regex::multiline);
  for (const Language language : all_languages())
    for (const Lobe lobe : {Lobe::two_lobe_polynomial, Lobe::two_lobe}) {
      ShaderRequest request = request_of(language, all_shapes(), lobe);
      request.prefix = "Zz";
      request.sampling = true;
      const std::string text = without_comments(shader(request));
      int names = 0;
      for (std::sregex_iterator at(text.begin(), text.end(), declared), end; at != end;
           ++at, ++names)
        CHECK_MESSAGE((*at)[1].str().rfind("Zz", 0) == 0, name_of(language)
                                                              << ": " << (*at)[1].str());
      CHECK(names > 200);
    }
}

TEST_CASE("only what the shapes need is in a file") {
  const std::string quad = without_comments(shader(request_of(Language::glsl)));
  CHECK(contains(quad, "vec3 ltc_shade_quad("));
  for (const char* other :
       {"Ellipse", "Cone", "Sphere", "Tube", "ltc_Line", "olygon_data", "emission", "ample",
        "SecondLobe", "second_inv_share", "exact_line", "first_direction"})
    CHECK_MESSAGE(!contains(quad, other), std::string(other));
  const std::string sphere = without_comments(shader(request_of(Language::wgsl, {Shape::sphere})));
  CHECK(contains(sphere, "fn ltc_shade_sphere("));
  CHECK(contains(sphere, "ltc_Cone"));
  for (const char* other : {"uad", "olygon_point", "Tube", "sum_edges"})
    CHECK_MESSAGE(!contains(sphere, other), std::string(other));
  CHECK(contains(shader(request_of(Language::hlsl, {Shape::quad}, Lobe::two_lobe)),
                 "second_inv_share"));
  CHECK(!contains(shader(request_of(Language::hlsl, {Shape::quad}, Lobe::table)),
                  "ltc_sum_lobe_polynomial"));
}

TEST_CASE("a lean file has nothing of turned triangles and of the ratio") {
  const std::string lean = shader(lean_request(Language::glsl));
  CHECK(contains(lean, "--shapes quad --lean\n"));
  CHECK(contains(lean, "vec3 ltc_shade_quad("));
  for (const char* part :
       {"set_geometric_normal", "correct_at_mean", "tilted", "corrected", "blended_ratio",
        "concentration", "outline2", "vec3 front", "bool cut"}) {
    CHECK_MESSAGE(!contains(without_comments(lean), part), std::string(part));
    CHECK_MESSAGE(contains(shader(request_of(Language::glsl)), part), std::string(part));
  }
}

TEST_CASE("no function has two loops by a counter of one name, which HLSL takes for one variable") {
  const std::regex counter("for \\(int (\\w+)");
  for (const Lobe lobe : {Lobe::polynomial, Lobe::two_lobe}) {
    ShaderRequest request = request_of(Language::hlsl, all_shapes(), lobe);
    request.sampling = true;
    std::istringstream lines(without_comments(shader(request)));
    std::string function;
    std::multiset<std::string> counters;
    int loops = 0;
    for (std::string line; std::getline(lines, line);) {
      std::smatch found;
      if (!line.empty() && line[0] != ' ' && line[0] != '}') {
        function = line;
        counters.clear();
      } else if (std::regex_search(line, found, counter)) {
        counters.insert(found[1]);
        CHECK_MESSAGE(counters.count(found[1]) == 1, function);
        ++loops;
      }
    }
    CHECK(loops > 10);
  }
}

TEST_CASE("points of lights are in a file that is asked for them, those of its shapes alone") {
  ShaderRequest request = request_of(Language::wgsl, {Shape::sphere, Shape::line});
  CHECK(!contains(shader(request), "LightPoint"));
  request.sampling = true;
  CHECK(file_name(request) == "ltc_sphere_line_sampling.wgsl");
  const std::string text = without_comments(shader(request));
  for (const char* part : {"fn ltc_draw_sphere(", "fn ltc_meet_sphere(", "fn ltc_draw_line(",
                           "fn ltc_eval_point(", "fn ltc_point_density(", "fn ltc_lobe_direction("})
    CHECK_MESSAGE(contains(text, part), std::string(part));
  for (const char* other : {"quad", "tube", "polygon_data", "meet_line"})
    CHECK_MESSAGE(!contains(text, other), std::string(other));
}

TEST_CASE("sources, derivations and structure are in the file") {
  const std::string text = shader(request_of(Language::hlsl));
  CHECK(contains(
      text, "//   Lambert 1760; Baum, Rushmeier, Winget 1989, \"Improving Radiosity Solutions"));
  CHECK(contains(text, "// [ m00  0  m02 ]") == false); // indented, as it is in the source
  CHECK(contains(text, "//   [ m00  0  m02 ]"));
  CHECK(contains(text, "\n    // What joins the crossing to the first.\n"));
  CHECK(contains(text, "SPDX-License-Identifier: MIT"));
  CHECK(contains(text, "OpenLTC " OPENLTC_VERSION));
}

TEST_CASE("a quad takes three lines, which the head of each file shows") {
  CHECK(contains(shader(request_of(Language::glsl)),
                 "//   ltc_Surface surface = ltc_gltf_surface(position, normal, view, base_color, "
                 "metallic, roughness);\n"
                 "//   ltc_Quad lamp = ltc_make_quad(center, half_u, half_v, 0.0);\n"
                 "//   light += radiance * ltc_shade_quad(surface, lamp);\n"));
}

TEST_CASE("what the head of a file names is in it") {
  const std::regex word("ltc_\\w*\\w(?=[( ]|$)", std::regex::multiline);
  for (const Language language : all_languages())
    for (const Shape shape : all_shapes())
      for (const Lobe lobe : {Lobe::polynomial, Lobe::two_lobe_polynomial, Lobe::two_lobe}) {
        ShaderRequest request = request_of(language, {shape}, lobe);
        request.sampling = lobe == Lobe::polynomial;
        const std::string text = shader(request);
        const std::size_t end = text.find("\n\n");
        const std::string head = text.substr(0, end), code = without_comments(text.substr(end));
        int names = 0;
        for (std::sregex_iterator at(head.begin(), head.end(), word), last; at != last;
             ++at, ++names) {
          const std::string name = (*at)[0];
          // A polygon's elements come from the caller.
          CHECK_MESSAGE((contains(code, name + "(") || contains(code, "struct " + name + " ")),
                        name_of(language) << ", " << name_of(shape) << ": " << name);
        }
        CHECK(names >= 5);
      }
}

TEST_CASE("the same request gives the same text, whatever was made before") {
  const std::string first = shader(request_of(Language::wgsl, all_shapes()));
  shader(request_of(Language::metal, {Shape::line}, Lobe::two_lobe));
  CHECK(shader(request_of(Language::wgsl, all_shapes())) == first);
}

TEST_CASE("files are named by prefix, shapes, lobe and language") {
  CHECK(file_name(request_of(Language::glsl)) == "ltc_quad.glsl");
  CHECK(file_name(request_of(Language::glsl_es)) == "ltc_quad_es.glsl");
  CHECK(file_name(request_of(Language::wgsl, {Shape::quad, Shape::tube}, Lobe::table)) ==
        "ltc_quad_tube_table.wgsl");
  ShaderRequest request = request_of(Language::gdshader, all_shapes(), Lobe::two_lobe);
  request.prefix = "Area";
  CHECK(file_name(request) == "Area_lights_two_lobe.gdshaderinc");
}

TEST_CASE("prefixes that no language takes are refused") {
  for (const char* good : {"ltc_", "x", "Area7_", "a_b"})
    CHECK(check_prefix(good));
  for (const char* bad : {"", "7up", "_ltc", "a-b", "a__b", "gl_ltc", "ä", "a b"})
    CHECK_MESSAGE(!check_prefix(bad), bad);
}
