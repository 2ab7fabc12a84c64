// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Shadows of area lights, for WebGLRenderer: `openltc-three/shadows`. Before each picture a pass over the scene sends
// one ray to each light with castShadow from each pixel, and adds what it finds to two sums, with and without what
// stands between. The closed form is multiplied by their ratio (rays.js).

import {Color, FloatType, NearestFilter, WebGLRenderTarget} from 'three';
import {AreaShadows} from './area_shadows.js';
import {enableAreaLights, sharedUniforms} from './scene.js';

class WebGLAreaShadows extends AreaShadows {
  targets = [];
  warned = false;

  /// Textures of floats: of each pixel the light of its rays, of `frame` pictures together, without and with what
  /// stands between. With `exact` they are a reference: what the material reflects of lights with castShadow.
  get sums() {
    const [unshadowed, shadowed] = this.targets[this.frame % 2].textures;
    return {unshadowed, shadowed};
  }

  dispose() {
    super.dispose();
    this.targets.forEach(target => target.dispose());
  }

  reserve({x, y}) {
    if (this.targets[0]?.width === x && this.targets[0]?.height === y) return;
    this.targets.forEach(target => target.dispose());
    this.targets = [0, 1].map(() => new WebGLRenderTarget(x, y, {
      count: 2, type: FloatType, minFilter: NearestFilter, magFilter: NearestFilter, generateMipmaps: false}));
  }

  /// Whether this renderer, in this picture, can have shadows.
  canTrace(renderer) {
    const can = renderer.extensions.has('EXT_color_buffer_float');
    if (!can && !this.warned) console.warn('openltc-three: no shadows, since this browser cannot add to textures of floats');
    this.warned = !can;
    return can && !renderer.xr.isPresenting;
  }

  /// Adds a ray to each pixel. `draw` draws the scene.
  trace(renderer, camera, draw) {
    this.prepare(renderer, camera);
    if (this.frame < this.frames) this.addRays(renderer, draw);
    const {unshadowed, shadowed} = this.sums;
    sharedUniforms.openltc_unshadowed.value = unshadowed;
    sharedUniforms.openltc_shadowed.value = shadowed;
  }

  addRays(renderer, draw) {
    const outer = renderer.getRenderTarget();
    const {scene} = this.lights, {background} = scene, {autoClear} = renderer, color = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha(), [from, to] = [this.frame % 2, (this.frame + 1) % 2];
    scene.background = null;
    renderer.setClearColor(0, 0);
    if (this.frame === 0) {
      renderer.setRenderTarget(this.targets[from]);
      renderer.clear();
    }
    sharedUniforms.openltc_branches.value = this.tree.texture;
    sharedUniforms.openltc_frame.value = this.frame;
    [sharedUniforms.openltc_unshadowed.value, sharedUniforms.openltc_shadowed.value] = this.targets[from].textures;
    renderer.setRenderTarget(this.targets[to]);
    renderer.autoClear = true;
    draw();
    renderer.autoClear = autoClear;
    renderer.setRenderTarget(outer);
    renderer.setClearColor(color, alpha);
    scene.background = background;
    ++this.frame;
  }
}

/// Lets lights of a scene with castShadow have shadows, from the next picture of WebGLRenderer on. Returns an object:
/// frame of frames rays of a pixel have been sent to each light since the last change. `exact`, which may be changed at
/// any time: the sums are those of the material itself, noisier in smooth surfaces under lines and in coats.
export function enableAreaShadows(scene, {frames = 256, exact = false} = {}) {
  const lights = enableAreaLights(scene);
  return lights.shadows ?? new WebGLAreaShadows(lights, frames, exact);
}
