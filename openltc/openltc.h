// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// OpenLTC for an engine, in one include: physically based area lights without noise. Headers alone,
// C++17, no dependency, one namespace; docs/api.md lists what there is,
// docs/examples/shade_quad.cpp shows it.
//
//   openltc::Material material;                          // glTF 2.0, metallic-roughness
//   const auto surface = openltc::make_surface(position, normal, view, material,
//                                              openltc::built_in_table());
//   const auto light = openltc::Polygon::rectangle(center, half_u, half_v);
//   const openltc::Vec3f radiance = openltc::shade(surface, light, light_radiance);
//
// Everywhere: world space, metres, directions away from the surface, colours linear Rec.709.
// Nothing throws but for lack of memory, nothing prints, no state is kept, and every function may
// be called from many threads. What is not finite, or has no direction or size, gives black, never
// NaN; with -ffast-math that is not promised.

#pragma once

// The first and the last say which words are ours in between.
// clang-format off
#include "openltc/target/own_names.inc"
#include "openltc/api/area_lights.h"
#include "openltc/api/light_sampling.h"
#include "openltc/api/lobes.h"
#include "openltc/api/material.h"
#include "openltc/api/polygon.h"
#include "openltc/api/punctual_lights.h"
#include "openltc/api/shading.h"
#include "openltc/api/surface.h"
#include "openltc/target/names_back.inc"
// clang-format on
