// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The scene of both pages: a warm quad and a cool star over a dark floor, as in scenes/engines.glb. Metres, +Y up.

import {pack_polygon} from './polygon.js';

const size = [960, 540];
const eye = [0, 1.8, 6], target = [0, 0.2, 0], fov_y = 34 * Math.PI / 180;
const floor = {color: [0.4, 0.4, 0.4], metallic: 0.4, roughness: 0.2};

// Both shine along half_u x half_v.
const quad = {center: [-1.25, 0.85, -0.4], half_u: [0.6, 0, -0.4], half_v: [0.12, 0.7, 0.18], radiance: [6, 2.1, 0.5]};
const star = {center: [1.2, 0.95, -0.5], half_u: [0.85, -0.15, 0.3], half_v: [0.15, 0.85, 0], radiance: [0.7, 2, 6]};
const outline = Array.from({length: 10}, (_, k) => {
  const angle = (90 + 36 * k) * Math.PI / 180, r = k % 2 == 0 ? 1 : 0.45;
  const u = r * Math.cos(angle), v = r * Math.sin(angle);
  return star.center.map((c, i) => c + u * star.half_u[i] + v * star.half_v[i]);
});

// The camera's axes; what it sees of the plane at distance 1 reaches from -up to up.
const unit = a => a.map(x => x / Math.hypot(...a));
const back = unit(eye.map((x, i) => x - target[i]));
const right = unit([back[2], 0, -back[0]]);
const up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
            back[0] * right[1] - back[1] * right[0]];
const tangent = Math.tan(fov_y / 2);

/// The uniform block `Scene` of the shaders, all of it vectors of four.
export const scene = new Float32Array([
  ...size, 0, 0,
  ...eye, 0,
  ...right.map(x => x * tangent), 0,
  ...up.map(x => x * tangent), 0,
  ...back, 0,
  ...floor.color, floor.metallic,
  floor.roughness, 0, 0, 0,
  ...quad.center, 0,
  ...quad.half_u, 0,
  ...quad.half_v, 0,
  ...quad.radiance, 0,
  ...star.radiance, 0,
  ...pack_polygon(outline),
]);
