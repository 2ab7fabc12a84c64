// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights in a plane, which shine along -z.

import {SurfaceLight} from './area_light.js';
import {circle} from './circle.js';
import {outlineOf} from './polygon.js';

// What lights in a plane have: `twoSided`.
class PlanarLight extends SurfaceLight {
  constructor(color, luminance, twoSided) {
    super(color, luminance);
    this.twoSided = twoSided;
  }

  get sides() { return this.twoSided ? 2 : 1; }

  copy(source, recursive) {
    return super.copy(source, recursive).copyOwn(source, 'twoSided');
  }
}

/// One with axes: its `texture`, a Texture or null, fills the rectangle around it, and is upright for who looks at the
/// emitting side. The luminance is that of white.
class FramedLight extends PlanarLight {
  texture = null;

  // Middle and half axes; the light emits along half_u x half_v. From there -x is to the right, so that a picture's
  // lower left corner is at middle - half_u - half_v.
  halves(frame, u, v) {
    return [[...frame.position, this.sides - 1], [...frame.vector(-u, 0), 0], [...frame.vector(0, v), 0]];
  }

  copy(source, recursive) {
    return super.copy(source, recursive).copyOwn(source, 'texture');
  }
}

/// A rectangle, as three's RectAreaLight.
export class RectLight extends FramedLight {
  constructor(color, luminance, width = 1, height = 1, twoSided = false) {
    super(color, luminance, twoSided);
    this.type = 'RectLight';
    this.shape = 'quad';
    this.width = width;
    this.height = height;
  }

  emittingArea() { return this.width * this.height * this.sides; }

  elements(frame) { return this.halves(frame, this.width / 2, this.height / 2); }

  /// Closed polylines in its own space, for helpers.
  outlines() {
    const [w, h] = [this.width / 2, this.height / 2];
    return [[[-w, -h, 0], [w, -h, 0], [w, h, 0], [-w, h, 0]]];
  }

  copy(source, recursive) {
    return super.copy(source, recursive).copyOwn(source, 'width', 'height');
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
    return super.copy(source, recursive).setOutline(source.points, source.holes);
  }
}

/// An ellipse, exact.
export class EllipseLight extends FramedLight {
  constructor(color, luminance, radiusX = 0.5, radiusY = 0.5, twoSided = false) {
    super(color, luminance, twoSided);
    this.type = 'EllipseLight';
    this.shape = 'ellipse';
    this.radiusX = radiusX;
    this.radiusY = radiusY;
  }

  emittingArea() { return Math.PI * this.radiusX * this.radiusY * this.sides; }

  elements(frame) { return this.halves(frame, this.radiusX, this.radiusY); }

  outlines() { return [circle((c, s) => [this.radiusX * c, this.radiusY * s, 0])]; }

  copy(source, recursive) {
    return super.copy(source, recursive).copyOwn(source, 'radiusX', 'radiusY');
  }
}

/// A disk: an ellipse of one radius.
export class DiskLight extends FramedLight {
  constructor(color, luminance, radius = 0.5, twoSided = false) {
    super(color, luminance, twoSided);
    this.type = 'DiskLight';
    this.shape = 'ellipse';
    this.radius = radius;
  }

  emittingArea() { return Math.PI * this.radius ** 2 * this.sides; }

  elements(frame) { return this.halves(frame, this.radius, this.radius); }

  outlines() { return [circle((c, s) => [this.radius * c, this.radius * s, 0])]; }

  copy(source, recursive) {
    return super.copy(source, recursive).copyOwn(source, 'radius');
  }
}
