// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Draws a light's outline.

import {BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments} from 'three';

/// Lines along the outline of a light, in its colour or `color`. Add it to the scene or the light; call update()
/// when the light's size has changed, dispose() at the end.
export class AreaLightHelper extends LineSegments {
  constructor(light, color) {
    super(new BufferGeometry(), new LineBasicMaterial({fog: false, toneMapped: false}));
    this.type = 'AreaLightHelper';
    this.light = light;
    this.color = color;
    this.update();
  }

  update() {
    const corners = this.light.outlines().flatMap(
        outline => outline.flatMap((point, i) => [...point, ...outline[(i + 1) % outline.length]]));
    const {position} = this.geometry.attributes;
    if (position?.array.length === corners.length) {
      position.set(corners);
      position.needsUpdate = true;
    } else this.geometry.setAttribute('position', new Float32BufferAttribute(corners, 3));
    this.geometry.computeBoundingSphere();
  }

  updateMatrixWorld() {
    const {color, material, light} = this;
    if (color !== undefined) material.color.set(color);
    else material.color.copy(light.color);
    // The light's place, with the scale that its lengths have.
    const frame = light.frame();
    this.matrixWorld.set(...[0, 1, 2].flatMap(k => [...['x', 'y', 'z'].map(axis => frame.scale * frame[axis][k]),
                                                    frame.position[k]]), 0, 0, 0, 1);
  }

  dispose() {
    this.geometry.dispose();
    this.material.dispose();
  }
}
