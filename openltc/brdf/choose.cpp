// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/brdf/choose.h"

#include "openltc/brdf/merl.h"

#include <fmt/format.h>

#include <string_view>

namespace openltc::brdf {

Result<Brdf> choose_brdf(const std::string& name_or_path) {
  if (const Brdf* known = find_brdf(name_or_path)) return *known;
  constexpr std::string_view ending = ".binary";
  if (std::string_view(name_or_path).ends_with(ending)) return read_merl(name_or_path);
  std::string names;
  for (const Brdf& entry : all_brdfs())
    names += (names.empty() ? "" : ", ") + entry.name;
  return Error{fmt::format("brdf \"{}\" is not known; take one of {}, or a MERL file that ends in "
                           "{}",
                           name_or_path, names, ending)};
}

} // namespace openltc::brdf
