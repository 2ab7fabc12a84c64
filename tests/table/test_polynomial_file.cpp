// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Files of a polynomial: what is written reads back, what is broken is refused by name.

#include "openltc/table/polynomial_file.h"

#include <doctest/doctest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

using namespace openltc;
using nlohmann::json;
using table::LobePolynomial;

namespace {

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

std::string refusal(const std::string& text) {
  const Result<LobePolynomial> read = table::polynomial_from_json(text, "x.json");
  return read ? std::string() : read.error().message;
}

std::string refusal(const json& root) { return refusal(root.dump()); }

json good() { return json::parse(table::to_json(table::builtin_ggx_polynomial())); }

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace

TEST_CASE("a polynomial reads back to the bit, with its metadata") {
  LobePolynomial p = table::builtin_ggx_polynomial();
  p.metadata.variant = "quotes \" and\nlines";
  // Values that a careless writer rounds or turns into integers.
  p.term(3)[5] = -0.0f;
  p.term(4)[5] = std::numeric_limits<float>::denorm_min();
  p.term(5)[5] = 0.1f;
  const Result<LobePolynomial> read = table::polynomial_from_json(table::to_json(p), "x.json");
  REQUIRE(read.ok());
  CHECK(read->degree == p.degree);
  CHECK(same_bits(read->coefficients, p.coefficients));
  CHECK(read->metadata.brdf == p.metadata.brdf);
  CHECK(read->metadata.variant == p.metadata.variant);
  CHECK(read->metadata.objective == p.metadata.objective);
  CHECK(read->metadata.command == p.metadata.command);
  CHECK(read->metadata.tool_version == p.metadata.tool_version);
  CHECK(read->metadata.mean_tv == p.metadata.mean_tv);
  CHECK(read->metadata.max_tv == p.metadata.max_tv);
  CHECK(table::to_json(*read) == table::to_json(p));
}

TEST_CASE("the built-in source is what to_builtin_source makes of the built-in") {
  CHECK(contents(std::string(OPENLTC_SOURCE_DIR) + "/openltc/api/ggx_polynomial.inc") ==
        table::to_builtin_source(table::builtin_ggx_polynomial()));
  CHECK(contents(std::string(OPENLTC_SOURCE_DIR) + "/openltc/api/ggx_two_lobe_polynomial.inc") ==
        table::to_builtin_source(table::builtin_ggx_two_lobe_polynomial()));
}

TEST_CASE("a polynomial of two lobes reads back to the bit, and is refused where it is broken") {
  const LobePolynomial& p = table::builtin_ggx_two_lobe_polynomial();
  const std::string text = table::to_json(p);
  const Result<LobePolynomial> read = table::polynomial_from_json(text, "x.json");
  REQUIRE(read.ok());
  CHECK(read->two_lobes());
  CHECK(same_bits(read->coefficients, p.coefficients));
  CHECK(same_bits(read->second, p.second));
  CHECK(table::to_json(*read) == text);
  const auto changed = [&](auto change) {
    json root = json::parse(text);
    change(root);
    return refusal(root);
  };
  CHECK(changed([](json& r) { r["version"] = 1; }).find("degree 4 needs 90") != std::string::npos);
  CHECK(changed([](json& r) { r["coefficients"].erase(7); }).find("164") != std::string::npos);
  CHECK(changed([](json& r) { r["coefficients"][10] = -9; }).find("determinant") !=
        std::string::npos);
  CHECK(changed([](json& r) { r["coefficients"][10] = "x"; }).find("coefficients[10]") !=
        std::string::npos);
}

TEST_CASE("broken polynomials are refused, with the file and the field") {
  CHECK(refusal(good()).empty());
  const std::string text = good().dump();
  for (const std::size_t length :
       {std::size_t(0), std::size_t(1), text.size() / 2, text.size() - 1})
    CHECK(refusal(text.substr(0, length)).find("x.json") == 0);
  CHECK(refusal(json::array()).find("format") != std::string::npos);
  const auto changed = [](auto change) {
    json root = good();
    change(root);
    return refusal(root);
  };
  CHECK(changed([](json& r) { r["format"] = "openltc-lobe-table"; }).find("lobe table") !=
        std::string::npos);
  CHECK(changed([](json& r) { r["format"] = 3; }).find("format") != std::string::npos);
  CHECK(changed([](json& r) { r["version"] = 3; }).find("version") != std::string::npos);
  CHECK(changed([](json& r) { r.erase("degree"); }).find("degree") != std::string::npos);
  for (const double degree : {-1.0, 0.0, 2.0, 7.0, 4.5, 1e300})
    CHECK(changed([&](json& r) { r["degree"] = degree; }).find("degree") != std::string::npos);
  CHECK(changed([](json& r) { r["degree"] = 5; }).find("degree 5 needs 126") != std::string::npos);
  CHECK(changed([](json& r) { r.erase("coefficients"); }).find("coefficients") !=
        std::string::npos);
  CHECK(changed([](json& r) { r["coefficients"].erase(7); }).find("89") != std::string::npos);
  CHECK(changed([](json& r) { r["coefficients"][7] = nullptr; }).find("coefficients[7]") !=
        std::string::npos);
  CHECK(changed([](json& r) { r["coefficients"][8] = 1e39; }).find("coefficients[8]") !=
        std::string::npos);
  CHECK(changed([](json& r) { r["coefficients"][3] = -1; }).find("determinant") !=
        std::string::npos);
  CHECK(changed([](json& r) { r.erase("metadata"); }).find("metadata") != std::string::npos);
  CHECK(!table::read_polynomial("/nowhere/x.json").ok());
}

TEST_CASE("each extension gets its text, an unknown one is refused and nothing is written") {
  const auto folder = std::filesystem::temp_directory_path() / "openltc_test_polynomial_file";
  std::filesystem::create_directories(folder);
  const LobePolynomial& p = table::builtin_ggx_polynomial();
  for (const char* extension : {".json", ".cpp", ".inc", ".h", ".glsl", ".hlsl", ".wgsl", ".js"}) {
    const std::string path = (folder / "ggx").string() + extension;
    REQUIRE(table::write_polynomial(p, path).ok());
    CHECK(contents(path).size() > 1000);
  }
  const Result<LobePolynomial> read = table::read_polynomial((folder / "ggx.json").string());
  REQUIRE(read.ok());
  CHECK(same_bits(read->coefficients, p.coefficients));
  const Status refused = table::write_polynomial(p, (folder / "ggx.png").string());
  CHECK(!refused.ok());
  CHECK(refused.error().message.find("ggx.png") != std::string::npos);
  CHECK(!std::filesystem::exists(folder / "ggx.png"));
  std::filesystem::remove_all(folder);
}
