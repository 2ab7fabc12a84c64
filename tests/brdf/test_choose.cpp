// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What a user types, to a BRDF.

#include "openltc/brdf/choose.h"

#include <doctest/doctest.h>

#include <string>

using namespace openltc;

TEST_CASE("every name is chosen by itself") {
  for (const brdf::Brdf& b : brdf::all_brdfs()) {
    const Result<brdf::Brdf> chosen = brdf::choose_brdf(b.name);
    REQUIRE(chosen.ok());
    CHECK(chosen->name == b.name);
  }
}

TEST_CASE("an unknown name is refused with the list of known ones") {
  for (const char* name : {"", "GGX", "ggx.json", "no such"}) {
    const Result<brdf::Brdf> chosen = brdf::choose_brdf(name);
    REQUIRE_FALSE(chosen.ok());
    const std::string& message = chosen.error().message;
    CAPTURE(message);
    CHECK(message.find(name) != std::string::npos);
    CHECK(message.find(".binary") != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
    for (const brdf::Brdf& b : brdf::all_brdfs())
      CHECK(message.find(b.name) != std::string::npos);
  }
}

TEST_CASE("a path that ends in .binary is a MERL file") {
  const Result<brdf::Brdf> chosen = brdf::choose_brdf("/no/such/paint.binary");
  REQUIRE_FALSE(chosen.ok());
  CHECK(chosen.error().message.rfind("/no/such/paint.binary: cannot open", 0) == 0);
}
