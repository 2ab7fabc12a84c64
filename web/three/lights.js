// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The lights, as three.js has its own: objects of a scene, which shine along their -z.

import {Light} from 'three';
import {outlineOf} from './polygon.js';

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

/// What all have. `color` is linear, `luminance` in nits (candela per square metre) along the normal, the same in
/// all directions; what a surface is given is their product.
class AreaLight extends Light {
  constructor(color, luminance) {
    super(color, luminance);
    this.isAreaLight = true;
  }

  /// three.js's `intensity` is nits for lights with an area.
  get luminance() { return this.intensity; }
  set luminance(nits) { this.intensity = nits; }

  /// Lumens of the whole light, both sides, without its node's scale. Setting it sets the luminance; a size that
  /// changes afterwards does not.
  get power() { return this.luminance * Math.PI * this.emittingArea(); }
  set power(lumens) { this.luminance = lumens / (Math.PI * this.emittingArea()); }

  /// Its place in the world, less `origin`, a Vector3.
  frame(origin = {x: 0, y: 0, z: 0}) { return new Frame(this.matrixWorld, origin); }
}

/// What lights in a plane have: `twoSided`.
class PlanarLight extends AreaLight {
  constructor(color, luminance, twoSided) {
    super(color, luminance);
    this.twoSided = twoSided;
  }

  get sides() { return this.twoSided ? 2 : 1; }

  copy(source, recursive) {
    super.copy(source, recursive);
    this.twoSided = source.twoSided;
    return this;
  }
}

/// A rectangle, as three's RectAreaLight.
export class RectLight extends PlanarLight {
  constructor(color, luminance, width = 1, height = 1, twoSided = false) {
    super(color, luminance, twoSided);
    this.type = 'RectLight';
    this.shape = 'quad';
    this.width = width;
    this.height = height;
  }

  emittingArea() { return this.width * this.height * this.sides; }

  // It emits along half_u x half_v.
  elements(frame) {
    return [[...frame.position, this.sides - 1],
            [...frame.vector(this.width / 2, 0), 0],
            [...frame.vector(0, -this.height / 2), 0]];
  }

  /// Closed polylines in its own space, for helpers.
  outlines() {
    const [w, h] = [this.width / 2, this.height / 2];
    return [[[-w, -h, 0], [w, -h, 0], [w, h, 0], [-w, h, 0]]];
  }

  copy(source, recursive) {
    super.copy(source, recursive);
    this.width = source.width;
    this.height = source.height;
    return this;
  }
}

/// A polygon of any outline, convex or not, with holes: `points` and each of `holes` are arrays of [x, y] or Vector2
/// in its xy plane, either way round. Outlines must not cross themselves or each other.
export class PolygonLight extends PlanarLight {
  constructor(color, luminance, points = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]], holes = [],
              twoSided = false) {
    super(color, luminance, twoSided);
    this.type = 'PolygonLight';
    this.shape = 'polygon';
    this.setOutline(points, holes);
  }

  /// Another outline. Throws an Error where one has no three corners, no area, or what is no number; then the light
  /// stays as it was.
  setOutline(points, holes = []) {
    this.outline = outlineOf(points, holes);
    this.points = points;
    this.holes = holes;
    return this;
  }

  emittingArea() { return this.outline.area * this.sides; }

  elements(frame) {
    const {rings, area, centroid, radius, spreads} = this.outline;
    const corners = rings.flatMap(ring => [...ring, ring[0]].map(([x, y], i) => [...frame.point(x, -y), i ? 0 : 1]));
    return [[corners.length, this.sides - 1, area * frame.scale ** 2, 0],
            [...corners[0].slice(0, 3), 0],
            [0, 0, 0, 0],
            [0, 0, 0, 0],
            [...frame.z.map(a => -a), 0],
            [...frame.point(centroid[0], -centroid[1]), radius * frame.scale],
            ...spreads.map(([x, y]) => [...frame.vector(x, -y), 0]),
            ...corners];
  }

  outlines() { return this.outline.rings.map(ring => ring.map(([x, y]) => [x, -y, 0])); }

  copy(source, recursive) {
    super.copy(source, recursive);
    return this.setOutline(source.points, source.holes);
  }
}
