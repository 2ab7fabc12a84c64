// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How the lights of a scene get into the materials of WebGLRenderer: before each picture the scene's
// `onBeforeRender` writes them into a texture, and gives each standard and physical material that it meets the
// shader for the shapes that are there.

import {Vector3} from 'three';
import {functionsFor, statements} from './glsl.js';
import {LightRows, shapes} from './rows.js';

const pars = '#include <lights_physical_pars_fragment>', begin = '#include <lights_fragment_begin>';

// Uniforms are the same objects for all materials; the scene that is rendered sets their values.
const uniforms = {openltc_elements: {value: null}, openltc_origin: {value: null}};
for (const shape of shapes) uniforms[`openltc_range_${shape}`] = {value: null};

const shadersOf = new Map(); // by names of shapes, the text before main()
const shapesOf = new WeakMap(); // by material, the names that it was last compiled for
const scenes = new WeakMap();

function functionsOf(names) {
  if (!shadersOf.has(names)) shadersOf.set(names, functionsFor(names.split(' ')));
  return shadersOf.get(names);
}

// Chains our change of the shader behind what the material has.
function take(material) {
  const {onBeforeCompile, customProgramCacheKey} = material;
  material.onBeforeCompile = function(shader, renderer) {
    onBeforeCompile.call(this, shader, renderer);
    const names = shapesOf.get(material);
    if (!names) return;
    for (const text of [pars, begin])
      if (!shader.fragmentShader.includes(text))
        return console.warn(`openltc-three: the shader of material "${material.name}" has no ${text}: no area lights`);
    Object.assign(shader.uniforms, uniforms);
    shader.fragmentShader = shader.fragmentShader.replace(pars, () => `${pars}\n${functionsOf(names)}`)
        .replace(begin, () => begin + statements);
  };
  // The default one is the text of onBeforeCompile, which is ours now.
  const own = customProgramCacheKey === material.constructor.prototype.customProgramCacheKey
      ? () => onBeforeCompile.toString() : customProgramCacheKey;
  material.customProgramCacheKey = function() { return `${own.call(this)} openltc ${shapesOf.get(material)}`; };
}

function prepare(material, names) {
  if (!material?.isMeshStandardMaterial) return;
  const before = shapesOf.get(material);
  if (before === names || (before === undefined && !names)) return;
  if (before === undefined) take(material);
  shapesOf.set(material, names);
  material.needsUpdate = true;
}

class SceneLights {
  constructor(scene) {
    this.scene = scene;
    this.rows = new LightRows();
    this.origin = new Vector3();
    this.outer = []; // values of the uniforms of pictures that are being drawn, while this one is
    const {onBeforeRender, onAfterRender} = scene;
    this.hooks = {onBeforeRender, onAfterRender};
    scene.onBeforeRender = (...values) => {
      onBeforeRender.apply(scene, values);
      this.outer.push(Object.values(uniforms).map(uniform => uniform.value));
      this.update(values[2]);
    };
    scene.onAfterRender = (...values) => {
      this.outer.pop()?.forEach((value, i) => Object.values(uniforms)[i].value = value);
      onAfterRender.apply(scene, values);
    };
  }

  /// Looks at the scene as `camera` sees it. World matrices must be right.
  update(camera) {
    const lights = [], materials = new Set([this.scene.overrideMaterial]);
    this.scene.traverseVisible(object => {
      if (object.isAreaLight && object.layers.test(camera.layers)) lights.push(object);
      for (const material of [object.material].flat()) materials.add(material);
    });
    this.origin.setFromMatrixPosition(camera.matrixWorld);
    this.rows.write(lights, this.origin);
    uniforms.openltc_elements.value = this.rows.texture;
    uniforms.openltc_origin.value = this.origin;
    for (const shape of shapes) uniforms[`openltc_range_${shape}`].value = this.rows.ranges[shape];
    const names = shapes.filter(shape => lights.some(light => light.shape === shape)).join(' ');
    for (const material of materials) prepare(material, names);
  }

  dispose() {
    Object.assign(this.scene, this.hooks);
    this.rows.dispose();
    scenes.delete(this.scene);
  }
}

/// Lets the area lights of a scene shine, from the next picture on, for WebGLRenderer. Call it once a scene, after
/// you have set its onBeforeRender and onAfterRender, if you have. Returns an object: update(camera) prepares
/// materials for renderer.compile or compileAsync; dispose() ends it.
export function enableAreaLights(scene) {
  if (!scenes.has(scene)) scenes.set(scene, new SceneLights(scene));
  return scenes.get(scene);
}
