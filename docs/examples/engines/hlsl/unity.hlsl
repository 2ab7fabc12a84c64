// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Shader Graph in Unity. Not run in Unity.
//
// 1. Copy this folder and shaders/ltc_lights.hlsl into one folder below Assets.
// 2. A Custom Function node: type File, source unity.hlsl, name AreaLights, precision Single. Inputs and outputs
//    are those below, in this order.
// 3. Position from a Position node (Absolute World, of the lamps' space), Normal from Normal Vector (World), View
//    from View Direction (World) through Normalize.
// 4. Light goes to Emission of a Lit graph, or to Base Color of an Unlit one; in HDRP multiply it by the exposure.
//
// With half_u along transform.right and half_v along transform.up the quad shines along transform.forward. A smooth
// node gives smoothness: Roughness is 1 - smoothness.

#ifndef OPENLTC_AREA_LIGHTS
#define OPENLTC_AREA_LIGHTS

#include "star.hlsl"
#include "ltc_lights.hlsl"
#include "area_lights.hlsl"

void AreaLights_float(float3 Position, float3 Normal, float3 View, float3 BaseColor, float Metallic,
                      float Roughness, float3 QuadCenter, float3 QuadHalfU, float3 QuadHalfV,
                      float3 QuadRadiance, float3 StarRadiance, out float3 Light) {
  Light = area_lights(Position, Normal, View, BaseColor, Metallic, Roughness, QuadCenter, QuadHalfU,
                      QuadHalfV, QuadRadiance, StarRadiance);
}

#endif
