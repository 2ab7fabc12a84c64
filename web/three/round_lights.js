// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights that shine all around: spheres, and tubes and lines along x.

import {AreaLight, SurfaceLight} from './area_light.js';
import {circle} from './circle.js';

/// A sphere.
export class SphereLight extends SurfaceLight {
  constructor(color, luminance, radius = 0.1) {
    super(color, luminance);
    this.type = 'SphereLight';
    this.shape = 'sphere';
    this.radius = radius;
  }

  emittingArea() { return 4 * Math.PI * this.radius ** 2; }

  elements(frame) { return [[...frame.position, this.radius * frame.scale]]; }

  /// Closed polylines in its own space, for helpers.
  outlines() {
    const r = this.radius;
    return [circle((c, s) => [r * c, r * s, 0]), circle((c, s) => [r * c, 0, r * s]), circle((c, s) => [0, r * c, r * s])];
  }

  copy(source, recursive) {
    return super.copy(source, recursive).copyOwn(source, 'radius');
  }
}

const capNumbers = {none: 0, flat: 1, round: 2}; // of ltc_make_tube

/// A cylinder or capsule along x. `length` is without round ends; `caps` is 'round', 'flat' or 'none': then it is
/// open, and its side shines outwards alone.
export class TubeLight extends SurfaceLight {
  constructor(color, luminance, length = 1, radius = 0.02, caps = 'round') {
    super(color, luminance);
    if (!(caps in capNumbers)) throw new Error(`TubeLight: caps are "round", "flat" or "none", not "${caps}"`);
    this.type = 'TubeLight';
    this.shape = 'tube';
    this.length = length;
    this.radius = radius;
    this.caps = caps;
  }

  emittingArea() {
    return 2 * Math.PI * this.radius * (this.length + capNumbers[this.caps] * this.radius);
  }

  elements(frame) {
    return [[...frame.point(-this.length / 2, 0), this.radius * frame.scale],
            [...frame.point(this.length / 2, 0), capNumbers[this.caps]]];
  }

  outlines() {
    const h = this.length / 2, r = this.radius;
    const sides = [[r, 0], [0, r]].map(([y, z]) => [[-h, y, z], [h, y, z], [h, -y, -z], [-h, -y, -z]]);
    return [...sides, ...[-h, h].map(x => circle((c, s) => [x, r * c, r * s]))];
  }

  copy(source, recursive) {
    return super.copy(source, recursive).copyOwn(source, 'length', 'radius', 'caps');
  }
}

/// A tube along x without thickness. `intensity` is in candela, of the whole line across it, whatever the scale of
/// its node; along it a line is dark.
export class LineLight extends AreaLight {
  constructor(color, intensity, length = 1) {
    super(color, intensity);
    this.type = 'LineLight';
    this.shape = 'line';
    this.length = length;
  }

  /// Lumens of the whole line.
  get power() { return Math.PI ** 2 * this.intensity; }
  set power(lumens) { this.intensity = lumens / Math.PI ** 2; }

  // Candela per metre.
  radiance(frame) { return this.intensity / (this.length * frame.scale); }

  elements(frame) {
    return [[...frame.point(-this.length / 2, 0), 0], [...frame.point(this.length / 2, 0), 0]];
  }

  outlines() { return [[[-this.length / 2, 0, 0], [this.length / 2, 0, 0]]]; }

  copy(source, recursive) {
    return super.copy(source, recursive).copyOwn(source, 'length');
  }
}
