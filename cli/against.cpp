// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/against.h"

#include "cli/lobe_file.h"
#include "openltc/fit/identify.h"
#include "openltc/fit/polynomial_fit.h"
#include "openltc/table/packed_file.h"
#include "openltc/table/polynomial_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <utility>

namespace openltc::cli {

namespace {

fit::Candidate candidate_of(table::PackedTable packed, const std::string& label) {
  const auto shared = std::make_shared<const table::PackedTable>(std::move(packed));
  const table::TableMetadata& m = shared->metadata;
  fit::Candidate c;
  c.label = label;
  c.lobes = [shared](double roughness, double cos_theta) {
    return table::fetch_packed(*shared, roughness, cos_theta);
  };
  c.horizon = fit::horizon_of(*shared);
  c.metadata = {
      {"layout", fmt::format("{}, {}, {} x {}", name_of(shared->layout), name_of(shared->precision),
                             shared->columns(), shared->rows())}};
  for (const table::MetadataField& field : table::k_metadata_fields)
    if (field.text && !(m.*field.text).empty()) c.metadata.emplace_back(field.name, m.*field.text);
  return c;
}

fit::Candidate candidate_of(table::LobePolynomial polynomial, const std::string& label) {
  const auto shared = std::make_shared<const table::LobePolynomial>(std::move(polynomial));
  fit::Candidate c;
  c.label = label;
  c.lobes = [shared, lobes = fit::lobes_of(*shared)](double roughness, double cos_theta) {
    return lobes(roughness, cos_theta);
  };
  c.horizon = fit::Horizon::clipped;
  c.metadata = {{"form", fmt::format("polynomial of degree {}", shared->degree)},
                {"brdf", shared->metadata.brdf},
                {"objective", shared->metadata.objective}};
  return c;
}

} // namespace

Result<fit::Candidate> read_candidate(const std::string& path, std::string& note) {
  const std::string label = std::filesystem::path(path).filename().string();
  if (is_polynomial_file(path)) {
    const Result<table::LobePolynomial> polynomial = table::read_polynomial(path);
    if (!polynomial) return polynomial.error();
    return candidate_of(*polynomial, label);
  }
  const Result<table::PackedTable> packed = table::read_packed(path);
  if (packed) return candidate_of(*packed, label);

  // A bare texture does not say what it is; anything else that is wrong stays an error.
  const Result<table::TextureFiles> files = table::read_textures(path);
  if (!files || !files->description.empty()) return packed.error();
  const Result<std::vector<fit::Identification>> found = fit::identify(files->textures);
  if (!found || found->empty() || !found->front().layout || found->front().mean_tv > 0.5)
    return Error{fmt::format("{}: a bare texture that reads as no known table; openltc inspect "
                             "lists the attempts",
                             path)};
  const fit::Identification& best = found->front();
  note = fmt::format("{}: does not say what it is; read as {}, which fits {} best (mean TV {:.4f})",
                     path, name_of(*best.layout), best.brdf, best.mean_tv);
  const Result<table::PackedTable> bare = table::read_packed(path, *best.layout);
  if (!bare) return bare.error();
  return candidate_of(*bare, label);
}

} // namespace openltc::cli
