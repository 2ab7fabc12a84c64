// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What the page knows of each kind of light: its name, its sizes, a new one, and how it takes a stretch by hand.

import {DiskLight, EllipseLight, LineLight, PolygonLight, RectLight, SphereLight, TubeLight} from 'openltc-three';

const star = size => Array.from({length: 10}, (_, k) => {
  const radius = size * (k % 2 ? 0.45 : 1), angle = Math.PI * (0.5 + k / 5);
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
});
// The factor that differs most from 1.
const strongest = factors => factors.reduce((a, b) => Math.abs(Math.log(a)) > Math.abs(Math.log(b)) ? a : b);
const times = (light, factors) => Object.fromEntries(Object.entries(factors).map(([name, factor]) => [name, light[name] * factor]));

/// By a light's type: `fields`, its sizes in metres, each [property, label]; `make(size)`; `stretched(light, x, y, z)`,
/// its sizes after a stretch along its axes.
export const kinds = {
  RectLight: {title: 'Rectangle', flat: true, fields: [['width', 'Width'], ['height', 'Height']],
              make: s => new RectLight(0xffffff, 1, 2 * s, 1.2 * s), stretched: (l, x, y) => times(l, {width: x, height: y})},
  DiskLight: {title: 'Disk', flat: true, fields: [['radius', 'Radius']],
              make: s => new DiskLight(0xffffff, 1, s), stretched: (l, x, y) => times(l, {radius: strongest([x, y])})},
  EllipseLight: {title: 'Ellipse', flat: true, fields: [['radiusX', 'Radius x'], ['radiusY', 'Radius y']],
                 make: s => new EllipseLight(0xffffff, 1, s, 0.6 * s), stretched: (l, x, y) => times(l, {radiusX: x, radiusY: y})},
  PolygonLight: {title: 'Star', flat: true, fields: [], make: s => new PolygonLight(0xffffff, 1, star(s)),
                 stretched: (l, x, y) => {
                   const scaled = ring => Array.from(ring, p => Array.isArray(p) ? [p[0] * x, p[1] * y] : [p.x * x, p.y * y]);
                   return {points: scaled(l.points), holes: l.holes.map(scaled)};
                 }},
  SphereLight: {title: 'Sphere', fields: [['radius', 'Radius']], make: s => new SphereLight(0xffffff, 1, 0.5 * s),
                stretched: (l, ...f) => times(l, {radius: strongest(f)})},
  TubeLight: {title: 'Tube', fields: [['length', 'Length'], ['radius', 'Radius']], make: s => new TubeLight(0xffffff, 1, 2 * s, 0.08 * s),
              stretched: (l, x, y, z) => times(l, {length: x, radius: strongest([y, z])})},
  LineLight: {title: 'Line', fields: [['length', 'Length']], make: s => new LineLight(0xffffff, 1, 2 * s),
              stretched: (l, x) => times(l, {length: x})},
};

/// What a light is called in lists.
export const titleOf = light => light.type === 'PolygonLight' ? 'Polygon' : kinds[light.type].title;

/// Gives a light sizes that `stretched` returned.
export function resize(light, sizes) {
  if (sizes.points) light.setOutline(sizes.points, sizes.holes);
  else Object.assign(light, sizes);
}

/// Moves a light into `root`, which stands at the origin, with the scale of its nodes taken into its sizes, so that metres are metres.
export function settle(light, root) {
  light.name = light.userData.name ?? light.name; // GLTFLoader changes names
  const {scale} = light.frame(), shown = [...light.children];
  for (const child of shown) root.attach(child);
  root.attach(light);
  light.scale.set(1, 1, 1);
  light.updateMatrixWorld(true);
  resize(light, kinds[light.type].stretched(light, scale, scale, scale));
  for (const child of shown) light.attach(child);
}
