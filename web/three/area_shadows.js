// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shadows of a scene, as both renderers have them: what casts them, and when sums begin anew.

import {Vector2} from 'three';
import {sameItems} from './scene_lights.js';
import {TreeTexture} from './tree.js';

/// Base of an entry's own class, which has sums, reserve(size) for them, and draws what is added to them. `lights` is of
/// SceneLights.
export class AreaShadows {
  /// Pictures since the last change, and after how many no ray is sent any more.
  frame = 0;
  frames;

  tree = new TreeTexture();
  meshes = [];
  view = [];

  constructor(lights, frames, exact) {
    this.lights = lights;
    this.frames = frames;
    this.exact = exact;
    lights.shadows = this;
  }

  /// Begins anew, for changes that are not seen by themselves: of materials, and of what vertices do.
  reset() { this.frame = 0; }

  /// Ends shadows; lights shine on without.
  dispose() {
    this.lights.shadows = null;
    this.tree.dispose();
  }

  // What casts shadows: meshes that are seen, but for those that show a light, its children.
  occluders() {
    const found = [];
    const visit = object => {
      if (!object.visible || object.isAreaLight) return;
      if (object.isMesh && object.geometry.attributes.position?.count > 0) found.push(object);
      object.children.forEach(visit);
    };
    visit(this.lights.scene);
    return found;
  }

  // Before a picture: looks for changes of what is seen.
  prepare(renderer, camera) {
    const outer = renderer.getRenderTarget(), size = new Vector2();
    if (outer) size.set(outer.width, outer.height);
    else renderer.getDrawingBufferSize(size);
    this.reserve(size);
    const meshes = this.occluders();
    const state = meshes.flatMap(mesh => [mesh.id, mesh.geometry.id, mesh.geometry.attributes.position.version,
                                          mesh.count ?? 1, mesh.instanceMatrix?.version ?? 0,
                                          ...mesh.matrixWorld.elements]);
    if (!sameItems(state, this.meshes)) {
      this.meshes = state;
      this.tree.write(meshes);
      this.frame = 0;
    }
    const view = [size.x, size.y, this.exact ? 1 : 0, ...camera.matrixWorld.elements, ...camera.projectionMatrix.elements,
                  ...this.lights.rows.data];
    if (!sameItems(view, this.view)) {
      this.view = view;
      this.frame = 0;
    }
  }
}
