// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the shaders want to know of an outline: "polygon data" of `openltc shaders`.
//
// A light shines along its -z. Seen from there x runs to the left: the plane's own axes are (x, -y), so that
// (1, 0, 0) x (0, -1, 0) = (0, 0, -1).

function signedArea(ring) {
  let sum = 0;
  ring.forEach(([ax, ay], i) => {
    const [bx, by] = ring[(i + 1) % ring.length];
    sum += ax * by - ay * bx;
  });
  return sum / 2;
}

function readRing(points, what) {
  const ring = Array.from(points, p => Array.isArray(p) ? [p[0], -p[1]] : [p.x, -p.y]);
  const [first, last] = [ring[0], ring[ring.length - 1]];
  if (ring.length > 1 && first[0] === last[0] && first[1] === last[1]) ring.pop();
  if (ring.length < 3) throw new Error(`PolygonLight: ${what} has ${ring.length} corners; three are the least`);
  if (!ring.flat().every(Number.isFinite)) throw new Error(`PolygonLight: ${what} has a corner that is no number`);
  if (signedArea(ring) === 0) throw new Error(`PolygonLight: ${what} has no area`);
  return ring;
}

/// Area, rings and moments of an outline with holes: arrays of [x, y] or of Vector2, metres, either way round,
/// the first corner repeated at the end or not.
///
/// rings: corners in the axes (x, -y), the outline counter-clockwise, holes clockwise. centroid: in the same axes;
/// radius: the distance of the farthest corner from there. spreads: two vectors along the principal axes, sqrt(2)
/// times the standard deviation of the area.
export function outlineOf(points, holes = []) {
  const rings = [readRing(points, 'the outline'), ...holes.map((hole, i) => readRing(hole, `hole ${i}`))];
  rings.forEach((ring, i) => {
    if ((signedArea(ring) > 0) !== (i === 0)) ring.reverse();
  });
  const area = rings.reduce((sum, ring) => sum + signedArea(ring), 0);
  if (!(area > 0)) throw new Error('PolygonLight: its holes are larger than the outline');

  // Moments: triangles (corner 0 of the outline, a, b) with signed areas.
  const [ox, oy] = rings[0][0];
  let x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  for (const ring of rings)
    ring.forEach(([px, py], i) => {
      const [qx, qy] = ring[(i + 1) % ring.length];
      const [ax, ay, bx, by] = [px - ox, py - oy, qx - ox, qy - oy];
      const share = (ax * by - ay * bx) / 2 / area;
      x += share * (ax + bx) / 3;
      y += share * (ay + by) / 3;
      xx += share * (ax * ax + ax * bx + bx * bx) / 6;
      yy += share * (ay * ay + ay * by + by * by) / 6;
      xy += share * (2 * ax * ay + ax * by + bx * ay + 2 * bx * by) / 12;
    });
  xx -= x * x, yy -= y * y, xy -= x * y;

  const angle = Math.atan2(2 * xy, xx - yy) / 2, mean = (xx + yy) / 2, half = Math.hypot((xx - yy) / 2, xy);
  const long = Math.sqrt(2 * (mean + half)), short = Math.sqrt(2 * Math.max(mean - half, 0));
  const centroid = [x + ox, y + oy];
  return {
    rings, area, centroid,
    radius: Math.max(...rings.flat().map(([px, py]) => Math.hypot(px - centroid[0], py - centroid[1]))),
    spreads: [[Math.cos(angle) * long, Math.sin(angle) * long], [-Math.sin(angle) * short, Math.cos(angle) * short]],
  };
}
