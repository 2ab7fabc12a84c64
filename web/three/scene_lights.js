// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The lights of a scene before each of its pictures, for both renderers.

import {Vector3} from 'three';
import {LightRows, shapes} from './rows.js';
import {formOf} from './shader_text.js';

/// Chains itself to the scene's onBeforeRender and onAfterRender. An entry's own class has `shine(forms, renderer)`,
/// which gives the lights to materials, and `restore()`, after the picture.
export class SceneLights {
  constructor(scene) {
    this.scene = scene;
    this.rows = new LightRows();
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

  /// Looks at the scene as `camera` sees it: writes its lights, and returns the forms of their shapes, by spaces.
  collect(camera) {
    const lights = [];
    this.scene.traverseVisible(object => {
      if (object.isAreaLight && object.layers.test(camera.layers)) lights.push(object);
    });
    this.origin.setFromMatrixPosition(camera.matrixWorld);
    this.rows.write(lights, this.origin);
    return shapes.map(shape => formOf(shape, lights.filter(light => light.shape === shape).length)).filter(Boolean)
        .join(' ');
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
