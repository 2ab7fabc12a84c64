// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// From radiance in textures to what the page shows: exposure and tone mapping as `openltc render` has them, or how far
// two pictures are apart, in colours.

import {DataTexture, FloatType, NodeMaterial, QuadMesh, RGBAFormat} from 'three';
import {acesFilmicToneMapping, ivec2, linearToneMapping, mix, neutralToneMapping, screenCoordinate, step, textureLoad, uniform,
        vec2, vec3, vec4} from 'three/tsl';

/// Tone curves by name, as --tonemap has them.
export const tonemaps = {neutral: neutralToneMapping, aces: acesFilmicToneMapping, none: linearToneMapping};

/// The factor from nits of an EV100: openltc/image/tonemap.h.
export const exposureOf = ev100 => 1 / (1.2 * 2 ** ev100);
export const ev100Of = exposure => -Math.log2(1.2 * exposure);

/// Colours of the scale of differences, from none to the most.
export const scaleColors = ['#000004', '#3b0f70', '#8c2981', '#de4968', '#fe9f6d', '#fcfdbf'];
const colorNode = hex => vec3(...[1, 3, 5].map(k => parseInt(hex.slice(k, k + 2), 16) / 255));

// The pixel, by the values that the tasks below read: textures, and numbers.
function outputOf(task, tone, {picture, base, rays, count, most, stepX, stepY, exposure}) {
  const displayed = nits => {
    const c = tone(nits.clamp(0, 1e6), exposure).clamp();
    return mix(c.mul(12.92), c.pow(vec3(1 / 2.4)).mul(1.055).sub(0.055), step(0.0031308, c));
  };
  const reference = () => base.rgb.add(rays.rgb.div(count.max(1)));
  if (task === 'picture') return vec4(displayed(picture.rgb), 1);
  if (task === 'reference') return vec4(displayed(reference()), 1);
  if (task === 'difference') { // steps of 255, the mean of three channels, and whether a surface is there
    const d = displayed(picture.rgb).sub(displayed(reference())).abs();
    return vec4(d.dot(vec3(255 / 3)), rays.a, 0, 1);
  }
  if (task === 'fewer') return vec4(picture.load(ivec2(screenCoordinate.mul(vec2(stepX, stepY)))).rgb, 1);
  const t = picture.r.div(most).clamp().mul(scaleColors.length - 1), [first, ...others] = scaleColors.map(colorNode);
  return vec4(others.reduce((color, next, k) => mix(color, next, t.sub(k).clamp()), first), 1);
}

/// Draws a rectangle over the whole of a target.
export class Display {
  materials = new Map();
  quad = new QuadMesh();

  constructor(renderer) { this.renderer = renderer; }

  // A material of a task, and its values as nodes.
  #make(task, tonemap) {
    const none = new DataTexture(new Float32Array(4), 1, 1, RGBAFormat, FloatType);
    const values = Object.fromEntries([
      ...['picture', 'base', 'rays'].map(name => [name, textureLoad(none, ivec2(screenCoordinate))]),
      ...['count', 'most', 'stepX', 'stepY', 'exposure'].map(name => [name, uniform(1)])]);
    const material = new NodeMaterial();
    material.depthTest = material.depthWrite = false;
    material.fragmentNode = outputOf(task, tonemaps[tonemap], values);
    return {material, values};
  }

  /// `task`: of outputOf; `values`: what it reads. To the renderer's target.
  draw(task, tonemap, exposure, values) {
    const key = `${task} ${tonemap}`;
    if (!this.materials.has(key)) this.materials.set(key, this.#make(task, tonemap));
    const made = this.materials.get(key);
    made.values.exposure.value = exposure;
    for (const name in values) made.values[name].value = values[name];
    this.quad.material = made.material;
    this.quad.render(this.renderer);
  }
}
