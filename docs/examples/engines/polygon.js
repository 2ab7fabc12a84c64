// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A polygon light as the shader files want it: "polygon data" in ltc_lights.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const minus = (a, b) => a.map((x, i) => x - b[i]);
const scaled = (a, s) => a.map(x => x * s);
const length = a => Math.sqrt(dot(a, a));

/// The numbers of one polygon, four for each element. `points` are its corners in one plane, world space,
/// counter-clockwise as seen from the side to which it shines; convex or not, without holes.
export function pack_polygon(points, two_sided = false) {
  const origin = points[0], corners = points.map(p => minus(p, origin));
  const sum = [0, 0, 0];
  corners.forEach((a, i) => cross(a, corners[(i + 1) % corners.length]).forEach((x, k) => sum[k] += x));
  const area = length(sum) / 2, normal = scaled(sum, 1 / length(sum));

  // Moments of the area in two axes of its plane: triangles (0, a, b) with signed areas.
  const axis_u = scaled(corners[1], 1 / length(corners[1])), axis_v = cross(normal, axis_u);
  const flat = corners.map(p => [dot(p, axis_u), dot(p, axis_v)]);
  let x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  flat.forEach(([ax, ay], i) => {
    const [bx, by] = flat[(i + 1) % flat.length], share = (ax * by - ay * bx) / 2 / area;
    x += share * (ax + bx) / 3;
    y += share * (ay + by) / 3;
    xx += share * (ax * ax + ax * bx + bx * bx) / 6;
    yy += share * (ay * ay + ay * by + by * by) / 6;
    xy += share * (2 * ax * ay + ax * by + bx * ay + 2 * bx * by) / 12;
  });
  xx -= x * x, yy -= y * y, xy -= x * y;

  // The principal axes of its spread.
  const world = (u, v) => axis_u.map((a, i) => u * a + v * axis_v[i]);
  const angle = Math.atan2(2 * xy, xx - yy) / 2, mean = (xx + yy) / 2, half = Math.hypot((xx - yy) / 2, xy);
  const long = Math.sqrt(2 * (mean + half)), short = Math.sqrt(2 * Math.max(mean - half, 0));
  const radius = Math.max(...flat.map(([px, py]) => Math.hypot(px - x, py - y)));

  return [points.length + 1, two_sided ? 1 : 0, area, 0,
          ...origin, 0,
          0, 0, 0, 0,
          0, 0, 0, 0,
          ...normal, 0,
          ...minus(origin, scaled(world(x, y), -1)), radius,
          ...world(Math.cos(angle) * long, Math.sin(angle) * long), 0,
          ...world(-Math.sin(angle) * short, Math.cos(angle) * short), 0,
          ...[...points, origin].flatMap((p, i) => [...p, i == 0 ? 1 : 0])];
}
