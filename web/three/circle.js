// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Circles, as helpers draw them.

const corners = 48;

/// A closed polyline of point(cosine, sine).
export function circle(point) {
  return Array.from({length: corners}, (_, i) => point(Math.cos(2 * Math.PI * i / corners),
                                                       Math.sin(2 * Math.PI * i / corners)));
}
