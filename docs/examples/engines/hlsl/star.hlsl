// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Where ltc_lights.hlsl finds the numbers of a polygon. Here they are constants, made by polygon.js from the star of
// scene.js, whose index is 0; for lamps that move read them from an array or a buffer that your program fills.

static const float4 k_star[19] = {
    float4(11.0, 0.0, 1.0430919, 0.0),
    float4(1.35, 1.8, -0.5, 0.0),
    float4(0.0, 0.0, 0.0, 0.0),
    float4(0.0, 0.0, 0.0, 0.0),
    float4(-0.32330975, 0.05705466, 0.9445716, 0.0),
    float4(1.2, 0.95, -0.5, 0.90906864),
    float4(-0.43432665, 0.07664588, -0.15329176, 0.0),
    float4(-0.07664588, -0.43432665, 0.0, 0.0),
    float4(1.35, 1.8, -0.5, 1.0),
    float4(1.0297807, 1.2991245, -0.579351, 0.0),
    float4(0.43795452, 1.355323, -0.78531694, 0.0),
    float4(0.8153622, 0.8959973, -0.62839264, 0.0),
    float4(0.57903, 0.35050336, -0.6763356, 0.0),
    float4(1.1325, 0.5675, -0.5, 0.0),
    float4(1.578265, 0.17416777, -0.32366443, 0.0),
    float4(1.5429205, 0.7676047, -0.37160736, 0.0),
    float4(2.0547507, 1.070006, -0.21468304, 0.0),
    float4(1.4794365, 1.2197735, -0.420649, 0.0),
    float4(1.35, 1.8, -0.5, 0.0)};

float4 ltc_polygon_data(int i) { return k_star[i]; }
