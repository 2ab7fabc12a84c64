// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Directions seen from above, in Lambert's equal-area projection: the hemisphere is the unit disc, the mirror
// direction lies to the right, and what is below the horizon lies outside.

/// A vector's place in the disc.
export function toDisc([x, y, z]) {
  const length = Math.hypot(x, y, z), shrink = 1 / (length * Math.sqrt(Math.max(1 + z / length, 1e-9)));
  return [-x * shrink, y * shrink];
}

/// The direction at a place.
export function fromDisc([x, y]) {
  const r2 = Math.min(x * x + y * y, 1.99), stretch = Math.sqrt(2 - r2);
  return [-x * stretch, y * stretch, 1 - r2];
}

/// The path of a polygon's outline: its edges are great circles, drawn by short straight pieces.
export function outlinePath(corners) {
  const k_pieces = 24;
  if (corners.length < 3) return '';
  const points = corners.flatMap((a, i) => {
    const b = corners[(i + 1) % corners.length];
    const la = Math.hypot(...a), lb = Math.hypot(...b);
    return Array.from({length: k_pieces}, (_, k) =>
        toDisc(a.map((x, c) => x / la * (1 - k / k_pieces) + b[c] / lb * k / k_pieces)));
  });
  return 'M' + points.map(([x, y]) => `${x.toFixed(4)} ${(-y).toFixed(4)}`).join('L') + 'Z';
}

/// The path of a great circle's upper half, of the plane with that normal.
export function horizonPath(normal) {
  const [x, y, z] = normal;
  const across = Math.hypot(x, y) < 1e-6 ? [1, 0, 0] : [-y, x, 0].map((c) => c / Math.hypot(x, y));
  const up = [y * 0 - z * across[1], z * across[0] - x * 0, x * across[1] - y * across[0]];
  const points = Array.from({length: 97}, (_, k) => {
    const angle = Math.PI * k / 96;
    return toDisc(across.map((c, i) => c * Math.cos(angle) + up[i] * Math.sin(angle)));
  });
  return 'M' + points.map(([px, py]) => `${px.toFixed(4)} ${(-py).toFixed(4)}`).join('L');
}

/// The path of dots at directions.
export function dotsPath(directions, size) {
  return directions.map((d) => {
    const [x, y] = toDisc(d);
    return `M${(x - size).toFixed(4)} ${(-y).toFixed(4)}a${size} ${size} 0 1 0 ${2 * size} 0a${size} ${size} 0 1 0 ${-2 * size} 0`;
  }).join('');
}
