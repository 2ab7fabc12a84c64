// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/fit/report/candidate_file.h"

#include "openltc/fit/measure/identify.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/table/divided.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/polynomial_file.h"
#include "openltc/table/shading_lobes.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <utility>

namespace openltc::fit {

namespace {

Candidate candidate_of(table::PackedTable packed, const std::string& label) {
  const auto shared = std::make_shared<const table::PackedTable>(std::move(packed));
  const table::TableMetadata& m = shared->metadata;
  Candidate c;
  c.label = label;
  c.lobes = [shared](double roughness, double cos_theta) {
    return fetch_measured(*shared, roughness, cos_theta);
  };
  c.horizon = horizon_of(*shared);
  c.metadata = {
      {"layout", fmt::format("{}, {}, {} x {}", name_of(shared->layout), name_of(shared->precision),
                             shared->columns(), shared->rows())}};
  for (const table::MetadataField& field : table::k_metadata_fields)
    if (field.text && !(m.*field.text).empty()) c.metadata.emplace_back(field.name, m.*field.text);
  return c;
}

Candidate candidate_of(table::LobePolynomial polynomial, const std::string& label) {
  const auto shared = std::make_shared<const table::LobePolynomial>(std::move(polynomial));
  Candidate c;
  c.label = label;
  c.lobes = [shared, lobes = lobes_of(*shared)](double roughness, double cos_theta) {
    return lobes(roughness, cos_theta);
  };
  c.horizon = Horizon::clipped;
  c.metadata = {{"form", fmt::format("polynomial{} of degree {}",
                                     shared->two_lobes() ? " of two lobes" : "", shared->degree)},
                {"brdf", shared->metadata.brdf},
                {"objective", shared->metadata.objective}};
  return c;
}

// The texture that is missing where a table has two: DIR/ltc_2.dds for DIR/ltc_1.dds.
std::string other_texture(const std::string& path) {
  const std::filesystem::path p(path);
  std::string stem = p.stem().string();
  const std::string end = stem.size() > 2 ? stem.substr(stem.size() - 2) : "";
  if (end == "_1" || end == "_2") {
    stem.back() = end == "_1" ? '2' : '1';
    return fmt::format("{} must lie beside it",
                       (p.parent_path() / (stem + p.extension().string())).string());
  }
  return fmt::format("the two must lie side by side as {0}_1{1} and {0}_2{1}",
                     (p.parent_path() / stem).string(), p.extension().string());
}

} // namespace

Result<Candidate> read_candidate(const std::string& path, std::string& note) {
  const std::string label = std::filesystem::path(path).filename().string();
  if (table::is_polynomial_file(path)) {
    const Result<table::LobePolynomial> polynomial = table::read_polynomial(path);
    if (!polynomial) return polynomial.error();
    return candidate_of(*polynomial, label);
  }
  const Result<table::PackedTable> packed = table::read_packed(path);
  if (packed) return candidate_of(*packed, label);

  // A bare texture does not say what it is; anything else that is wrong stays an error.
  const Result<table::TextureFiles> files = table::read_textures(path);
  if (!files || !files->description.empty()) return packed.error();
  const Result<std::vector<Identification>> found = identify(files->textures);
  const bool known = found && !found->empty() && found->front().layout;
  if (!known && files->textures.size() == 1)
    return Error{fmt::format("{}: a bare texture that reads as no known table by itself; if it is "
                             "one of a table's two textures, {}",
                             path, other_texture(path))};
  if (!known || found->front().mean_tv > 0.5)
    return Error{fmt::format("{}: a bare texture that reads as no known table; openltc inspect "
                             "lists the attempts",
                             path)};
  const Identification& best = found->front();
  note = fmt::format("{}: does not say what it is; read as {}, which fits {} best (mean TV {:.4f})",
                     path, name_of(*best.layout), best.brdf, best.mean_tv);
  const Result<table::PackedTable> bare = table::read_packed(path, *best.layout);
  if (!bare) return bare.error();
  return candidate_of(*bare, label);
}

} // namespace openltc::fit
