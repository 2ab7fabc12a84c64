// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/light/light_list.h"

namespace openltc::light {

void append_lights(const Lights& from, Lights& to) {
  const auto append = [](const auto& some, auto& all) {
    all.insert(all.end(), some.begin(), some.end());
  };
  append(from.polygons, to.polygons);
  append(from.ellipses, to.ellipses);
  append(from.spheres, to.spheres);
  append(from.tubes, to.tubes);
  append(from.lines, to.lines);
  append(from.punctual, to.punctual);
}

} // namespace openltc::light
