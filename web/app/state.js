// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the laboratory begins with.

import {example} from './brdf_source.js';

/// Outlines of the light in its plane, metres.
export const shapes = {
  card: [[-0.8, -0.5], [0.8, -0.5], [0.8, 0.5], [-0.8, 0.5]],
  star: Array.from({length: 10}, (_, k) => {
    const r = k % 2 ? 0.34 : 0.8, a = Math.PI * (0.5 + k / 5);
    return [r * Math.cos(a), r * Math.sin(a)];
  }),
  arrow: [[-0.8, -0.2], [0.1, -0.2], [0.1, -0.55], [0.8, 0], [0.1, 0.55], [0.1, 0.2], [-0.8, 0.2]],
};

export const start = {
  brdf: '', text: example, width: 'alpha', form: 'table', size: '64', objective: 'balanced',
  roughness: 0.3, thetaDegrees: 65, exposure: 1,
  light: {center: [-1.55, -0.55, 0.85], turn: 22, tilt: -10, outline: shapes.card},
};
