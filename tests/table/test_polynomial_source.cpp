// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Functions to paste: each compiles with a real compiler of its language, and where it can be run
// it gives the numbers of shade/polynomial.glsl. A compiler that is not there is named and skipped.

#include "openltc/table/container/polynomial_source.h"
#include "openltc/target/shade_f64.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace openltc;
using table::SourceLanguage;
namespace fs = std::filesystem;

namespace {

// A folder of one test's files, gone with it.
struct Folder {
  fs::path path;
  explicit Folder(const char* name) : path(fs::temp_directory_path() / name) {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  std::string write(const char* name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return (path / name).string();
  }
};

struct Run {
  int status;
  std::string output;
};

Run run(const std::string& command) {
  Run result{-1, {}};
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return result;
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    result.output.append(buffer, n);
  result.status = pclose(pipe);
  return result;
}

bool has(const char* tool) {
  if (run(std::string("command -v ") + tool).status == 0) return true;
  MESSAGE("skipped: " << tool << " not found");
  return false;
}

std::string source(SourceLanguage language) {
  return table::to_source(table::builtin_ggx_polynomial(), language);
}

constexpr int k_steps = 12; // of the grid on which numbers are compared

std::string two_lobes(SourceLanguage language) {
  return table::to_source(table::builtin_ggx_two_lobe_polynomial(), language);
}

// Largest difference of "roughness cos_theta m00 m02 m20 m22 det share n1 n5" lines from ours,
// relative to max(|value|, scale of the lobe).
double largest_difference(const std::string& output, int& lines) {
  std::istringstream stream(output);
  double worst = 0, r, c, v[8];
  lines = 0;
  while (stream >> r >> c) {
    for (double& x : v)
      stream >> x;
    ++lines;
    const double alpha = f64::alpha_from_roughness(r);
    const f64::FittedLobe f =
        f64::eval_lobe_polynomial(table::builtin_ggx_polynomial().view(), alpha, c);
    const double expected[8] = {f.lobe.m00, f.lobe.m02, f.lobe.m20,
                                f.lobe.m22, f.lobe.det, f64::share_above_horizon(f.lobe),
                                f.n1,       f.n5};
    // m20, m22 and the determinant are proportional to alpha.
    const double scale[8] = {1, 1, alpha, alpha, alpha, 1, 1, 1};
    for (int k = 0; k < 8; ++k) {
      REQUIRE(std::isfinite(v[k]));
      worst = std::max(worst, std::abs(v[k] - expected[k]) / scale[k]);
    }
  }
  return worst;
}

} // namespace

TEST_CASE("the header compiles as C and as C++ without warnings and gives our numbers") {
  const Folder folder("openltc_test_source_c");
  folder.write("lobe.h", source(SourceLanguage::c));
  const std::string program = folder.write(
      "main.c", "#include \"lobe.h\"\n#include \"lobe.h\"\n#include <stdio.h>\n"
                "int main(void) {\n"
                "  for (int i = 0; i <= 12; ++i)\n    for (int j = 0; j <= 12; ++j) {\n"
                "      float r = (float)i / 12, y = (float)j / 12, c = 1 - y * y;\n"
                "      struct OpenltcLobe l = openltc_ggx_lobe(r, c);\n"
                "      printf(\"%.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g\\n\", (double)r, "
                "(double)c, (double)l.m00, (double)l.m02, (double)l.m20, (double)l.m22, "
                "(double)l.det, (double)l.share, (double)l.n1, (double)l.n5);\n    }\n"
                "  return 0;\n}\n");
  for (const std::string language : {"c -std=c99", "c++ -std=c++11"}) {
    const std::string binary = (folder.path / "program").string();
    const Run compiled = run(OPENLTC_CXX_COMPILER " -x " + language +
                             " -Wall -Wextra -Wshadow -Wdouble-promotion -Werror -o " + binary +
                             " " + program + " -lm");
    CAPTURE(compiled.output);
    REQUIRE(compiled.status == 0);
    const Run ran = run(binary);
    CHECK(ran.status == 0);
    int lines = 0;
    const double worst = largest_difference(ran.output, lines);
    MESSAGE(language << ": largest difference " << worst);
    CHECK(lines == (k_steps + 1) * (k_steps + 1));
    CHECK(worst < 5e-6);
  }
}

TEST_CASE("the JavaScript module gives our numbers") {
  if (!has("node")) return;
  const Folder folder("openltc_test_source_js");
  folder.write("lobe.mjs", source(SourceLanguage::javascript));
  const std::string program = folder.write(
      "main.mjs", "import {openltc_ggx_lobe} from './lobe.mjs';\n"
                  "for (let i = 0; i <= 12; ++i)\n  for (let j = 0; j <= 12; ++j) {\n"
                  "    const r = i / 12, c = 1 - (j / 12) ** 2, l = openltc_ggx_lobe(r, c);\n"
                  "    console.log(r, c, l.m00, l.m02, l.m20, l.m22, l.det, l.share, l.n1, l.n5);\n"
                  "  }\n");
  const Run ran = run("node " + program);
  CAPTURE(ran.output);
  REQUIRE(ran.status == 0);
  int lines = 0;
  const double worst = largest_difference(ran.output, lines);
  MESSAGE("largest difference " << worst);
  CHECK(lines == (k_steps + 1) * (k_steps + 1));
  // Literals are the shortest that read back as the same float, here read as doubles.
  CHECK(worst < 2e-6);
}

TEST_CASE("two lobes: the header and the module give our numbers of the second") {
  const Folder folder("openltc_test_source_two");
  const std::string print = "second_m00 second_m02 second_m20 second_m22 second_det second_share "
                            "second_weight m00 det n1 n5";
  const auto members = [&](const std::string& before) {
    std::istringstream names(print);
    std::string list, name;
    while (names >> name)
      list += ", " + before + name;
    return list;
  };
  folder.write("lobe.h", two_lobes(SourceLanguage::c));
  const std::string c = folder.write(
      "main.c", "#include \"lobe.h\"\n#include <stdio.h>\nint main(void) {\n"
                "  for (int i = 0; i <= 12; ++i)\n    for (int j = 0; j <= 12; ++j) {\n"
                "      float r = (float)i / 12, y = (float)j / 12, c = 1 - y * y;\n"
                "      struct OpenltcTwoLobes l = openltc_ggx_two_lobes(r, c);\n"
                "      printf(\"%.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g "
                "%.9g\\n\", (double)r, (double)c" +
                    members("(double)l.") + ");\n    }\n  return 0;\n}\n");
  const std::string binary = (folder.path / "program").string();
  const Run compiled = run(OPENLTC_CXX_COMPILER " -x c -std=c99 -Wall -Wextra -Wshadow "
                                                "-Wdouble-promotion -Werror -o " +
                           binary + " " + c + " -lm");
  CAPTURE(compiled.output);
  REQUIRE(compiled.status == 0);
  std::vector<std::string> outputs = {run(binary).output};
  if (has("node")) {
    folder.write("lobe.mjs", two_lobes(SourceLanguage::javascript));
    outputs.push_back(
        run("node " +
            folder.write("main.mjs",
                         "import {openltc_ggx_two_lobes} from './lobe.mjs';\n"
                         "for (let i = 0; i <= 12; ++i)\n  for (let j = 0; j <= 12; ++j) {\n"
                         "    const r = i / 12, c = 1 - (j / 12) ** 2;\n"
                         "    const l = openltc_ggx_two_lobes(r, c);\n    console.log(r, c" +
                             members("l.") + ");\n  }\n"))
            .output);
  }
  const LobePolynomialView view = table::builtin_ggx_two_lobe_polynomial().view();
  for (const std::string& output : outputs) {
    std::istringstream stream(output);
    double r, cosine, v[11];
    int lines = 0;
    while (stream >> r >> cosine) {
      for (double& x : v)
        stream >> x;
      ++lines;
      const double alpha = f64::alpha_from_roughness(r);
      const f64::FittedLobe first = f64::eval_lobe_polynomial(view, alpha, cosine);
      const f64::SecondLobe second = f64::eval_second_lobe_polynomial(view, alpha, cosine);
      const f64::Lobe& l = second.lobe;
      const double expected[11] = {l.m00,         l.m02,          l.m20,
                                   l.m22,         l.det,          f64::share_above_horizon(l),
                                   second.weight, first.lobe.m00, first.lobe.det,
                                   first.n1,      first.n5};
      const double scale[11] = {1, 1, alpha, alpha, alpha, 1, 1, 1, alpha, 1, 1};
      for (int k = 0; k < 11; ++k)
        CHECK(std::abs(v[k] - expected[k]) < 1e-5 * scale[k]);
    }
    CHECK(lines == (k_steps + 1) * (k_steps + 1));
  }
}

TEST_CASE("GLSL compiles, desktop and ES, old and new") {
  if (!has("glslangValidator")) return;
  const Folder folder("openltc_test_source_glsl");
  const std::string text = source(SourceLanguage::glsl);
  const std::string old_main = "void main() {\n  OpenltcLobe l = openltc_ggx_lobe(0.3, 0.7);\n"
                               "  gl_FragColor = vec4(l.m00, l.m22, l.share, l.n5);\n}\n";
  const std::string new_main = "layout(location = 0) out vec4 color;\nvoid main() {\n"
                               "  OpenltcLobe l = openltc_ggx_lobe(0.3, 0.7);\n"
                               "  color = vec4(l.m00, l.m22, l.share, l.n5);\n}\n";
  const std::string precision = "precision highp float;\n";
  const std::string variants[] = {
      "#version 110\n" + text + old_main, "#version 100\n" + precision + text + old_main,
      "#version 300 es\n" + precision + text + new_main, "#version 450\n" + text + new_main};
  for (const std::string& variant : variants) {
    const Run compiled = run("glslangValidator " + folder.write("lobe.frag", variant));
    CAPTURE(compiled.output);
    CHECK(compiled.status == 0);
  }
  // Both functions beside each other.
  const std::string both = "#version 100\n" + precision + text + two_lobes(SourceLanguage::glsl) +
                           "void main() {\n  OpenltcTwoLobes l = openltc_ggx_two_lobes(0.3, 0.7);\n"
                           "  gl_FragColor = vec4(l.second_m00, l.m22, l.second_weight, "
                           "openltc_ggx_lobe(0.3, 0.7).n5);\n}\n";
  const Run compiled = run("glslangValidator " + folder.write("two.frag", both));
  CAPTURE(compiled.output);
  CHECK(compiled.status == 0);
}

TEST_CASE("HLSL compiles") {
  if (!has("glslangValidator")) return;
  const Folder folder("openltc_test_source_hlsl");
  const std::string path =
      folder.write("lobe.hlsl", source(SourceLanguage::hlsl) + two_lobes(SourceLanguage::hlsl) +
                                    "float4 main() : SV_Target {\n"
                                    "  OpenltcLobe l = openltc_ggx_lobe(0.3, 0.7);\n"
                                    "  return float4(l.m00, l.m22, l.share,\n"
                                    "      openltc_ggx_two_lobes(0.3, 0.7).second_weight);\n}\n");
  const Run compiled = run("glslangValidator -D -S frag -e main -V -o " +
                           (folder.path / "lobe.spv").string() + " " + path);
  CAPTURE(compiled.output);
  CHECK(compiled.status == 0);
}

TEST_CASE("WGSL is valid") {
  if (!has("node")) return;
  const fs::path naga = fs::path(OPENLTC_NAGA_DIR) / "dist" / "node.js";
  if (!fs::exists(naga)) {
    MESSAGE("skipped: naga-wasm is not installed; the test tools_shaders_wgsl does that");
    return;
  }
  const Folder folder("openltc_test_source_wgsl");
  const std::string path =
      folder.write("lobe.wgsl", source(SourceLanguage::wgsl) + two_lobes(SourceLanguage::wgsl) +
                                    "@fragment\nfn main() -> @location(0) vec4<f32> {\n"
                                    "  let l = openltc_ggx_lobe(0.3, 0.7);\n"
                                    "  return vec4<f32>(l.m00, l.m22, l.share,\n"
                                    "      openltc_ggx_two_lobes(0.3, 0.7).second_weight);\n}\n");
  const std::string script = folder.write(
      "check.mjs",
      "import {readFileSync} from 'node:fs';\nimport {parseWgsl, validate} from 'file://" +
          naga.string() + "';\ntry {\n  validate(parseWgsl(readFileSync('" + path +
          "', 'utf8')));\n} catch (error) {\n  console.log(error.formatted ?? "
          "error.message ?? error);\n  process.exit(1);\n}\n");
  const Run checked = run("node " + script);
  CAPTURE(checked.output);
  CHECK(checked.status == 0);
}

TEST_CASE("metadata cannot break out of the text") {
  table::LobePolynomial p = table::builtin_ggx_polynomial();
  p.metadata.brdf = "my brdf; }\n#error";
  p.metadata.command = "a\nb\\";
  const std::string text = table::to_source(p, SourceLanguage::c);
  CHECK(text.find("openltc_my_brdf_____error_lobe(") != std::string::npos);
  CHECK(text.find("\n#error") == std::string::npos);
  CHECK(text.find("\nb") == std::string::npos);
  CHECK(text.find("b\\") == std::string::npos);
}
