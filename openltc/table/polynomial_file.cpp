// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/table/polynomial_file.h"

#include "openltc/base/regular_file.h"
#include "openltc/table/container/lobe_json.h"
#include "openltc/table/container/polynomial_source.h"
#include "openltc/table/lobe_check.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace openltc::table {

namespace {

constexpr const char* k_format = "openltc-lobe-polynomial";
constexpr int k_version = 1;
constexpr int k_two_version = 2; // of two lobes
// Of a term of two lobes: A B C D n1 s t A2 B2 C2 D2.
constexpr int k_two_channels = 11;

// The terms of two lobes, k_two_channels numbers each.
std::vector<float> both_lobes(const LobePolynomial& p) {
  std::vector<float> values;
  for (int i = 0; i < polynomial_terms(p.degree); ++i) {
    values.insert(values.end(), p.term(i), p.term(i) + 7);
    values.insert(values.end(), p.second_term(i),
                  p.second_term(i) + LobePolynomial::k_second_channels);
  }
  return values;
}

// The extension that `path` ends with, with its dot; empty when none of ours.
std::string extension_of(const std::string& path) {
  for (const char* extension : {".json", ".cpp", ".inc", ".h", ".glsl", ".hlsl", ".wgsl", ".js"}) {
    const std::string ending(extension);
    if (path.size() >= ending.size() &&
        path.compare(path.size() - ending.size(), ending.size(), ending) == 0)
      return ending;
  }
  return {};
}

std::optional<SourceLanguage> language_of(const std::string& extension) {
  if (extension == ".h") return SourceLanguage::c;
  if (extension == ".glsl") return SourceLanguage::glsl;
  if (extension == ".hlsl") return SourceLanguage::hlsl;
  if (extension == ".wgsl") return SourceLanguage::wgsl;
  if (extension == ".js") return SourceLanguage::javascript;
  return {};
}

} // namespace

std::string to_json(const LobePolynomial& polynomial) {
  std::string out = "{\n";
  out += fmt::format("\"format\": \"{}\",\n\"version\": {},\n", k_format,
                     polynomial.two_lobes() ? k_two_version : k_version);
  out += metadata_json(polynomial.metadata);
  out += fmt::format("\"degree\": {},\n", polynomial.degree);
  out += fmt::format("\"width\": \"{}\",\n",
                     polynomial.width == brdf::LobeWidth::alpha ? "alpha" : "one");
  out += "\"axes\": [\"u = 2 sqrt(alpha) - 1 = 2 roughness - 1\", "
         "\"v = 2 sqrt(1 - cos theta) - 1\"],\n";
  out +=
      "\"terms\": \"T_i(u) T_j(v), Chebyshev, i + j <= degree: j slow from 0, i fast from 0\",\n";
  out += "\"packing\": \"mirror frame: M^-1 = [A 0 aB; 0 1 0; aC 0 aD], a = alpha or 1, acting on "
         "(x', y, z'), x' = (cos, 0, sin), z' = (-sin, 0, cos)\",\n";
  out += "\"channels\": [\"A\", \"B\", \"C\", \"D\", \"n1\", \"s\"";
  if (polynomial.two_lobes()) out += ", \"t\", \"A2\", \"B2\", \"C2\", \"D2\"";
  out += "],\n\"n5\": \"n1 s^5\",\n";
  if (polynomial.two_lobes()) out += "\"weight\": \"(1 + t / sqrt(1 + t^2)) / 2\",\n";
  out += "\"coefficients\": [\n";
  out += polynomial.two_lobes()
             ? number_rows(both_lobes(polynomial), k_two_channels, k_two_channels)
             : number_rows(polynomial.coefficients, LobePolynomial::k_channels);
  return out + "]\n}\n";
}

Result<LobePolynomial> polynomial_from_json(const std::string& text, const std::string& name) {
  const nlohmann::json root = nlohmann::json::parse(text, nullptr, false);
  if (root.is_discarded()) return Error{name + ": not a complete JSON file; was it cut off?"};
  const std::string format = root.is_object() ? text_of(root, "format") : std::string();
  if (format == "openltc-lobe-table")
    return Error{name + ": holds a lobe table, not a polynomial; openltc fit --form polynomial "
                        "writes one"};
  if (format != k_format)
    return Error{fmt::format("{}: format is not \"{}\"; openltc fit --form polynomial writes such "
                             "files",
                             name, k_format)};
  const double version = number_of(root, "version");
  if (version != k_version && version != k_two_version)
    return Error{fmt::format("{}: version is not {} or {}, those this build reads", name, k_version,
                             k_two_version)};

  const double degree = number_of(root, "degree");
  if (!(degree >= LobePolynomial::k_min_degree && degree <= LobePolynomial::k_max_degree &&
        degree == std::floor(degree)))
    return Error{fmt::format("{}: degree must be a whole number from {} to {}", name,
                             LobePolynomial::k_min_degree, LobePolynomial::k_max_degree)};
  LobePolynomial polynomial;
  polynomial.degree = int(degree);
  const std::string width = text_of(root, "width");
  if (width != "alpha" && width != "one")
    return Error{fmt::format("{}: width must be \"alpha\" or \"one\"", name)};
  if (width == "one") polynomial.width = brdf::LobeWidth::one;
  const auto coefficients = root.find("coefficients");
  if (coefficients == root.end() || !coefficients->is_array())
    return Error{name + ": coefficients is missing"};
  const std::size_t terms = std::size_t(polynomial_terms(polynomial.degree));
  const bool two = version == k_two_version;
  const std::size_t channels = std::size_t(two ? k_two_channels : k_stored_channels);
  if (coefficients->size() != terms * channels)
    return Error{fmt::format("{}: coefficients holds {} numbers, but degree {} needs {}", name,
                             coefficients->size(), polynomial.degree, terms * channels)};
  polynomial.coefficients.assign(terms * LobePolynomial::k_channels, 0.0f);
  if (two) polynomial.second.assign(terms * LobePolynomial::k_second_channels, 0.0f);
  for (std::size_t i = 0; i < terms * channels; ++i) {
    const nlohmann::json& value = (*coefficients)[i];
    const std::size_t term = i / channels, k = i % channels;
    float& number = k < 7 ? polynomial.term(int(term))[k]
                          : polynomial.second[term * LobePolynomial::k_second_channels + (k - 7)];
    if (value.is_number()) number = float(value.get<double>());
    if (!value.is_number() || !std::isfinite(number))
      return Error{fmt::format("{}: coefficients[{}] is not a finite number", name, i)};
  }
  if (Status status = check_determinants(polynomial, name); !status) return status.error();

  if (Status status = read_metadata(root, name, polynomial.metadata); !status)
    return status.error();
  return polynomial;
}

Result<LobePolynomial> read_polynomial(const std::string& path) {
  const Result<std::string> text = read_regular_text(path, std::uint64_t(1) << 24);
  if (!text) return text.error();
  return polynomial_from_json(*text, path);
}

std::string to_builtin_source(const LobePolynomial& polynomial) {
  if (polynomial.two_lobes()) {
    std::string out = builtin_head(
        polynomial.metadata, "One term a line: A B C D n1 s t 0, then A B C D of the second lobe; "
                             "see LobePolynomialView (openltc/target/resources.h).");
    out += builtin_metadata("k_ggx_two_lobe_polynomial_metadata", polynomial.metadata);
    out += fmt::format("inline constexpr int k_ggx_two_lobe_polynomial_degree = {};\n\n",
                       polynomial.degree);
    out += builtin_array("k_ggx_two_lobe_polynomial", polynomial.coefficients,
                         LobePolynomial::k_channels) +
           "\n";
    return out +
           builtin_array("k_ggx_two_lobe_polynomial_second", polynomial.second,
                         LobePolynomial::k_second_channels) +
           builtin_end();
  }
  std::string out =
      builtin_head(polynomial.metadata, "One term a line: A B C D n1 s 0 0; see LobePolynomialView "
                                        "(openltc/target/resources.h).");
  out += builtin_metadata("k_ggx_polynomial_metadata", polynomial.metadata);
  out += fmt::format("inline constexpr int k_ggx_polynomial_degree = {};\n\n", polynomial.degree);
  return out + builtin_numbers("k_ggx_polynomial", polynomial.coefficients);
}

Status check_polynomial_extension(const std::string& path) {
  if (!extension_of(path).empty()) return Success{};
  return Error{path + ": a polynomial is written as .json, as .h, .glsl, .hlsl, .wgsl or .js to "
                      "paste, or as .cpp or .inc, the source of the built-in"};
}

Result<FileBytes> polynomial_bytes(const LobePolynomial& polynomial, const std::string& path) {
  if (Status status = check_polynomial_extension(path); !status) return status.error();
  const std::string extension = extension_of(path);
  const std::optional<SourceLanguage> language = language_of(extension);
  return file_of_text(path, language               ? to_source(polynomial, *language)
                            : extension == ".json" ? to_json(polynomial)
                                                   : to_builtin_source(polynomial));
}

Status write_polynomial(const LobePolynomial& polynomial, const std::string& path) {
  const Result<FileBytes> file = polynomial_bytes(polynomial, path);
  if (!file) return file.error();
  const auto written = write_files({&*file, 1});
  if (!written) return written.error();
  return Success{};
}

} // namespace openltc::table
