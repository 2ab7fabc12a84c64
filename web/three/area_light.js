// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What all lights have, as three.js has its own: objects of a scene, which shine along their -z.

import {Light} from 'three';

/// The place of an object: its middle, less `origin`, its axes as unit vectors, and by what its lengths are
/// multiplied: the largest component of its world scale, as EXT_lights_area says.
class Frame {
  constructor(matrixWorld, origin) {
    const e = matrixWorld.elements;
    const columns = [0, 4, 8].map(k => [e[k], e[k + 1], e[k + 2]]);
    const lengths = columns.map(c => Math.hypot(...c));
    this.scale = Math.max(...lengths);
    [this.x, this.y, this.z] = columns.map((c, k) => c.map(a => a / (lengths[k] || 1)));
    this.position = [e[12] - origin.x, e[13] - origin.y, e[14] - origin.z];
  }

  /// A vector of the light, of the light's own lengths, in the world.
  vector(x, y, z = 0) {
    return [0, 1, 2].map(k => this.scale * (x * this.x[k] + y * this.y[k] + z * this.z[k]));
  }

  /// A point likewise.
  point(x, y, z = 0) {
    return this.vector(x, y, z).map((a, k) => a + this.position[k]);
  }
}

// Says to three.js's own shadows that there is no map to draw; ours are rays (shadows.js).
const noShadowMap = {autoUpdate: false, needsUpdate: false};

/// A light with a shape. `color` is linear, a factor.
export class AreaLight extends Light {
  constructor(color, intensity) {
    super(color, intensity);
    this.isAreaLight = true;
    this.shadow = noShadowMap;
  }

  /// Its place in the world, less `origin`, a Vector3.
  frame(origin = {x: 0, y: 0, z: 0}) { return new Frame(this.matrixWorld, origin); }

  /// What is given to the shader beside the color.
  radiance() { return this.intensity; }

  /// Copies properties of these names.
  copyOwn(source, ...names) {
    for (const name of names) this[name] = source[name];
    return this;
  }
}

/// A light with a surface. `luminance` is in nits (candela per square metre) along the surface's normal, the same in
/// all directions.
export class SurfaceLight extends AreaLight {
  /// three.js's `intensity` is nits for lights with an area.
  get luminance() { return this.intensity; }
  set luminance(nits) { this.intensity = nits; }

  /// Lumens of the whole light, both sides, without its node's scale. Setting it sets the luminance; a size that
  /// changes afterwards does not.
  get power() { return this.luminance * Math.PI * this.emittingArea(); }
  set power(lumens) { this.luminance = lumens / (Math.PI * this.emittingArea()); }
}
