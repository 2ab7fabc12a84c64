// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The laboratory's picture: by WebGPU where the browser has it, by WebGL 2 otherwise, with the shader file that
// `openltc shaders` writes in the language of either.

import {cornersOf, dataOf} from './polygon_light.js';
import {cameraAt, k_field, placeIn, rayIn} from './preview_camera.js';
import {k_most_data, k_numbers, lightColor} from './preview_scene.js';
import {WebGLPicture} from './preview_webgl.js';
import {WebGPUPicture, requestDevice, untilThere} from './preview_webgpu.js';

const hasTwo = (fit) => fit.textures.length === 3;

export class Preview {
  #canvas;
  #picture;
  #fit = null;
  #shaders = new Map(); // their texts, by whether there are two lobes

  /// Fails where there is neither. `forceWebGL`: not by WebGPU. `lost` and `restored` are called when the graphics
  /// device goes, and when another preview can be made.
  static async make(canvas, {forceWebGL = false, lost, restored}) {
    const preview = new Preview(), device = forceWebGL ? null : await requestDevice();
    preview.#canvas = canvas;
    preview.#picture = device ? new WebGPUPicture(canvas, device, {lost: () => {
      lost();
      untilThere(1000).then(restored);
    }}) : new WebGLPicture(canvas, {lost, restored});
    return preview;
  }

  /// "WebGPU" or "WebGL 2".
  get graphics() { return this.#picture instanceof WebGPUPicture ? 'WebGPU' : 'WebGL 2'; }

  /// Fetches the shader file that reads a fit.
  async prepare(fit) {
    const two = hasTwo(fit), name = `shaders/${this.#picture.constructor.language}-${two ? 'two-lobe' : 'table'}`;
    if (this.#shaders.has(two)) return;
    const response = await fetch(new URL(name, import.meta.url));
    if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`);
    this.#shaders.set(two, await response.text());
  }

  /// Takes the textures of a fit that it is prepared for.
  setFit(fit) {
    this.#picture.setTextures(fit.textures);
    this.#fit = fit;
  }

  /// `density`: pixels of the picture to one of the page; 2 for smooth edges.
  draw({light, roughness, thetaDegrees, exposure}, density) {
    if (this.#fit === null || this.#picture.isLost) return;
    const canvas = this.#canvas;
    const width = Math.round(canvas.clientWidth * density), height = Math.round(canvas.clientHeight * density);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const {eye, right, up, forward} = cameraAt(thetaDegrees);
    const values = {eye_roughness: [...eye, roughness], right_exposure: [...right, exposure], up_field: [...up, k_field],
                    forward_wide: [...forward, this.#fit.width === 'one' ? 1 : 0], color: lightColor, size: [width, height]};
    const numbers = new Float32Array(4 * (k_most_data + k_numbers.length));
    numbers.set(dataOf(light).subarray(0, 4 * k_most_data));
    k_numbers.forEach((name, i) => numbers.set(values[name], 4 * (k_most_data + i)));
    this.#picture.draw(this.#shaders.get(hasTwo(this.#fit)), numbers, width, height);
  }

  /// Whether the last picture is there, not only asked for.
  get isDrawn() { return this.#picture.isDrawn; }

  /// As rayIn, of this canvas.
  rayAt(x, y, thetaDegrees) {
    return rayIn(x, y, thetaDegrees, this.#canvas.clientWidth, this.#canvas.clientHeight);
  }

  /// Corners as they are seen.
  corners(light, thetaDegrees) {
    return cornersOf(light).map((p) => placeIn(p, thetaDegrees, this.#canvas.clientWidth, this.#canvas.clientHeight));
  }
}
