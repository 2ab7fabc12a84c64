// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// All lights of a scene in one texture: four-component elements, a row of 256 after the other.
//
// First stands where what is: for each shape where its first light begins and its last one ends, and the origin of
// positions. A light is a head and its shape's elements: the head is its radiance and the number of elements to the
// next light, below 0 where it casts shadows. Lights of a shape stand together. Positions are relative to the origin, the camera's place, axes those
// of the world, so that single precision serves scenes far from theirs.

import {DataTexture, FloatType, NearestFilter, RGBAFormat} from 'three';

const rowLength = 256; // shaders take an index apart by 255 and 8

/// In the order in which they stand in the texture.
export const shapes = ['quad', 'polygon', 'ellipse', 'sphere', 'tube', 'line', 'quad_picture', 'ellipse_picture'];

/// The element that says where the lights of a shape are, and the one that has the origin.
export const heads = Object.fromEntries(shapes.map((shape, i) => [shape, i])), originIndex = shapes.length;

export class LightRows {
  constructor() {
    this.casts = false; // whether any light casts shadows
    this.brightest = 0; // the largest radiance of a light
    this.reserve(1);
  }

  reserve(rows) {
    this.texture?.dispose();
    this.data = new Float32Array(4 * rowLength * rows);
    this.texture = new DataTexture(this.data, rowLength, rows, RGBAFormat, FloatType);
    this.texture.minFilter = this.texture.magFilter = NearestFilter;
    this.rows = rows;
  }

  /// Writes the lights, each with its shape and a factor of its colour, as seen from `origin`, a Vector3.
  write(lights, origin) {
    const elements = Array(shapes.length + 1);
    this.casts = lights.some(({light}) => light.castShadow);
    this.brightest = 0;
    for (const shape of shapes) {
      const begin = elements.length;
      for (const {light, factor} of lights.filter(one => one.shape === shape)) {
        const frame = light.frame(origin), own = light.elements(frame), radiance = light.radiance(frame);
        const next = light.castShadow ? -own.length - 1 : own.length + 1;
        const color = light.color.toArray().map((c, k) => c * factor[k] * radiance);
        this.brightest = Math.max(this.brightest, ...color);
        elements.push([...color, next], ...own);
      }
      elements[heads[shape]] = [begin, elements.length, 0, 0];
    }
    elements[originIndex] = [...origin.toArray(), 0];
    const rows = Math.ceil(elements.length / rowLength);
    if (rows > this.rows) this.reserve(2 * rows);
    elements.forEach((element, i) => this.data.set(element, 4 * i));
    this.texture.needsUpdate = true;
  }

  dispose() { this.texture.dispose(); }
}
