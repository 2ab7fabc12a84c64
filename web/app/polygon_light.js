// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The polygon that shines: an outline in a plane of its own. Shading space of the point at the origin is the
// space of the scene, z up; the viewer is at x > 0.

const rad = Math.PI / 180;

/// x y z of the plane's axes and of its front: `turn` degrees around z, `tilt` degrees back.
export function axesOf({turn, tilt}) {
  const c = Math.cos(turn * rad), s = Math.sin(turn * rad), ct = Math.cos(tilt * rad), st = Math.sin(tilt * rad);
  return {u: [-s, c, 0], v: [-c * st, -s * st, ct], front: [c * ct, s * ct, st]};
}

/// The corners in space.
export function cornersOf(light) {
  const {u, v} = axesOf(light);
  return light.outline.map(([a, b]) => light.center.map((x, i) => x + a * u[i] + b * v[i]));
}

/// Where the plane is met from `origin` along `direction`, in its own coordinates; null if it is not.
export function meetPlane(light, origin, direction) {
  const {u, v, front} = axesOf(light);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const slope = dot(front, direction);
  const distance = dot(front, light.center.map((x, i) => x - origin[i])) / slope;
  if (!(Math.abs(slope) > 1e-4) || !(distance > 0) || distance > 50) return null;
  const local = light.center.map((x, i) => origin[i] + distance * direction[i] - x);
  return [dot(local, u), dot(local, v)];
}

/// The signed area of an outline, counter-clockwise positive.
export function areaOf(outline) {
  return outline.reduce((sum, [x, y], i) => {
    const [a, b] = outline[(i + 1) % outline.length];
    return sum + x * b - a * y;
  }, 0) / 2;
}

/// What the shader reads: sixteen floats to a point of its "polygon data", in a Float32Array of vec4.
export function dataOf(light) {
  const {u, v, front} = axesOf(light);
  const outline = areaOf(light.outline) < 0 ? [...light.outline].reverse() : light.outline;
  const corners = cornersOf({...light, outline});
  const area = areaOf(outline);
  // Centroid and second moments about it, of the fan of triangles.
  const [x0, y0] = outline[0];
  let cx = 0, cy = 0;
  const triangles = outline.slice(1, -1).map(([x1, y1], i) => {
    const [x2, y2] = outline[i + 2];
    return {p: [[x0, y0], [x1, y1], [x2, y2]], area: ((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2};
  });
  for (const {p, area: part} of triangles) {
    cx += part * (p[0][0] + p[1][0] + p[2][0]) / (3 * area);
    cy += part * (p[0][1] + p[1][1] + p[2][1]) / (3 * area);
  }
  let xx = 0, xy = 0, yy = 0;
  for (const {p, area: part} of triangles) {
    const sum = (f, g) => part / (12 * area) * (p.reduce((s, q) => s + f(q) * g(q), 0) +
                                                p.reduce((s, q) => s + f(q), 0) * p.reduce((s, q) => s + g(q), 0));
    const x = (q) => q[0] - cx, y = (q) => q[1] - cy;
    xx += sum(x, x);
    xy += sum(x, y);
    yy += sum(y, y);
  }
  // Principal axes; sqrt(2) times the deviation along each.
  const angle = 0.5 * Math.atan2(2 * xy, xx - yy), c = Math.cos(angle), s = Math.sin(angle);
  const along = Math.sqrt(2 * Math.max(xx * c * c + 2 * xy * c * s + yy * s * s, 0));
  const across = Math.sqrt(2 * Math.max(xx * s * s - 2 * xy * c * s + yy * c * c, 0));
  const vector = (a, b) => u.map((x, i) => a * x + b * v[i]);
  const center = vector(cx, cy).map((x, i) => x + light.center[i]);
  const radius = Math.max(...corners.map((p) => Math.hypot(...p.map((x, i) => x - center[i]))));
  const closed = [...corners, corners[0]];
  return new Float32Array([
    closed.length, 1, area, 0, ...corners[0], 0, 0, 0, 0, 0, 0, 0, 0, 0, ...front, 0, ...center, radius,
    ...vector(along * c, along * s), 0, ...vector(-across * s, across * c), 0,
    ...closed.flatMap((p, i) => [...p, i === 0 ? 1 : 0])]);
}
