// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The lights of a scene before each of its pictures, for both renderers.

import {Vector3} from 'three';
import {pictureOf} from './picture.js';
import {LightRows, shapes} from './rows.js';
import {formOf} from './shader_text.js';

// A shader has sixteen textures, most of which are the material's.
const mostPictures = 4;

export const sameItems = (a, b) => a.length === b.length && a.every((x, i) => x === b[i]);

/// Chains itself to the scene's onBeforeRender and onAfterRender. An entry's own class has begin(renderer, camera)
/// and end(), which stand around a picture.
export class SceneLights {
  constructor(scene) {
    this.scene = scene;
    this.rows = new LightRows();
    this.pictures = []; // textures
    this.origin = new Vector3();
    const {onBeforeRender, onAfterRender} = scene;
    this.hooks = {onBeforeRender, onAfterRender};
    scene.onBeforeRender = (...values) => {
      onBeforeRender.apply(scene, values);
      this.begin(values[0], values[2]);
    };
    scene.onAfterRender = (...values) => {
      this.end();
      onAfterRender.apply(scene, values);
    };
  }

  /// Looks at the scene as `camera` sees it: writes its lights, sets `pictures`, and returns the forms of their
  /// shapes, by spaces.
  collect(camera) {
    const lights = [];
    this.scene.traverseVisible(object => {
      if (object.isAreaLight && object.layers.test(camera.layers)) lights.push(this.read(object));
    });
    const own = lights.filter(one => one.picture);
    for (const one of own.slice(mostPictures)) Object.assign(one, {shape: one.light.shape, factor: one.mean});
    this.origin.setFromMatrixPosition(camera.matrixWorld);
    this.rows.write(lights, this.origin);
    const of = shape => lights.filter(one => one.shape === shape);
    this.pictures = shapes.filter(shape => shape.endsWith('_picture')).flatMap(of).map(one => one.picture);
    return shapes.map(shape => formOf(shape, of(shape).length)).filter(Boolean).join(' ');
  }

  // A light, its shape here, a factor of its colour, and its picture.
  read(light) {
    const plain = {light, shape: light.shape, factor: [1, 1, 1]};
    if (!light.texture?.image) return plain; // not loaded yet
    return {...plain, ...pictureOf(light.texture, light.shape === 'ellipse'), shape: `${light.shape}_picture`};
  }

  dispose() {
    Object.assign(this.scene, this.hooks);
    this.rows.dispose();
  }
}

/// enableAreaLights for a class of SceneLights: one object for each scene.
export function makeEnable(Lights) {
  const scenes = new WeakMap();
  return scene => {
    if (!scenes.has(scene)) {
      const lights = new Lights(scene), {dispose} = lights;
      lights.dispose = () => {
        dispose.call(lights);
        scenes.delete(scene);
      };
      scenes.set(scene, lights);
    }
    return scenes.get(scene);
  };
}
