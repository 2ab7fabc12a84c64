// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How the lights of a scene get into the materials of WebGLRenderer: before each picture the scene's
// `onBeforeRender` writes them into a texture, and gives each standard and physical material that it meets the
// shader for the shapes that are there.

import {Vector3} from 'three';
import {formOf, functionsFor, statements} from './glsl.js';
import {LightRows, shapes} from './rows.js';

const pars = '#include <lights_physical_pars_fragment>', begin = '#include <lights_fragment_begin>';

// Uniforms are the same objects for all materials; the scene that is rendered sets their values. Others, which share
// its materials, find no lights.
const none = new LightRows(), uniforms = {openltc_elements: {value: none.texture}, openltc_origin: {value: new Vector3()}};
for (const shape of shapes) uniforms[`openltc_range_${shape}`] = {value: none.ranges[shape]};

const shadersOf = new Map(); // by forms of shapes, as words, the text before main()
const formsOf = new WeakMap(); // by material, the forms that it was last compiled for
const scenes = new WeakMap();

function functionsOf(forms) {
  if (!shadersOf.has(forms)) shadersOf.set(forms, functionsFor(forms.split(' ')));
  return shadersOf.get(forms);
}

// Chains our change of the shader behind what the material has.
function take(material) {
  const {onBeforeCompile, customProgramCacheKey} = material;
  material.onBeforeCompile = function(shader, renderer) {
    onBeforeCompile.call(this, shader, renderer);
    const forms = formsOf.get(material);
    if (!forms) return;
    for (const text of [pars, begin])
      if (!shader.fragmentShader.includes(text))
        return console.warn(`openltc-three: the shader of material "${material.name}" has no ${text}: no area lights`);
    Object.assign(shader.uniforms, uniforms);
    shader.fragmentShader = shader.fragmentShader.replace(pars, () => `${pars}\n${functionsOf(forms)}`)
        .replace(begin, () => begin + statements);
  };
  // The default one is the text of onBeforeCompile, which is ours now.
  const own = customProgramCacheKey === material.constructor.prototype.customProgramCacheKey
      ? () => onBeforeCompile.toString() : customProgramCacheKey;
  material.customProgramCacheKey = function() { return `${own.call(this)} openltc ${formsOf.get(material)}`; };
}

function prepare(material, forms) {
  if (!material?.isMeshStandardMaterial) return;
  const before = formsOf.get(material);
  if (before === forms || (before === undefined && !forms)) return;
  if (before === undefined) take(material);
  formsOf.set(material, forms);
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
    const lights = [];
    this.scene.traverseVisible(object => {
      if (object.isAreaLight && object.layers.test(camera.layers)) lights.push(object);
    });
    this.origin.setFromMatrixPosition(camera.matrixWorld);
    this.rows.write(lights, this.origin);
    uniforms.openltc_elements.value = this.rows.texture;
    uniforms.openltc_origin.value = this.origin;
    for (const shape of shapes) uniforms[`openltc_range_${shape}`].value = this.rows.ranges[shape];
    const forms = shapes.map(shape => formOf(shape, lights.filter(light => light.shape === shape).length))
        .filter(Boolean).join(' ');
    this.prepareMaterials(forms);
  }

  prepareMaterials(forms) {
    const materials = new Set([this.scene.overrideMaterial]);
    this.scene.traverse(object => [object.material].flat().forEach(material => materials.add(material)));
    for (const material of materials) prepare(material, forms);
  }

  dispose() {
    Object.assign(this.scene, this.hooks);
    this.prepareMaterials('');
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
