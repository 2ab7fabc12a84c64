// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How the lights of a scene get into the materials of WebGLRenderer: before each picture each standard and physical
// material of the scene is given the shader for the shapes that are there.

import {glsl} from './glsl.js';
import {LightRows} from './rows.js';
import {SceneLights, makeEnable} from './scene_lights.js';
import {functionsFor, picturesOf} from './shader_text.js';

const pars = '#include <lights_physical_pars_fragment>', begin = '#include <lights_fragment_begin>';

// What follows three.js's own lights in main(). The roughness is the material's own: three.js widens it where normals
// bend within a pixel, which point lights need.
const statements = `
{
  mat3 to_world = transpose(mat3(viewMatrix));
  openltc_ShadedLight lit = openltc_shade_layer(to_world, cameraPosition, geometryPosition, geometryNormal,
      geometryViewDir, material.diffuseContribution, material.specularColorBlended, material.specularF90,
      roughnessFactor);
  reflectedLight.directDiffuse += lit.diffuse;
  reflectedLight.directSpecular += lit.specular;
#ifdef USE_CLEARCOAT
  clearcoatSpecularDirect += openltc_shade_layer(to_world, cameraPosition, geometryPosition, geometryClearcoatNormal,
      geometryViewDir, vec3(0.0), material.clearcoatF0, material.clearcoatF90,
      material.clearcoatRoughness - geometryRoughness).specular;
#endif
}
`;

// Uniforms are the same objects for all materials; the scene that is rendered sets their values. Others, which share
// its materials, find no lights.
const none = new LightRows(), uniforms = {openltc_elements: {value: none.texture}}, pictureNames = [];

function setUniforms(elements, pictures) {
  uniforms.openltc_elements.value = elements;
  pictures.forEach((picture, k) => {
    pictureNames[k] = `openltc_picture_${k}`;
    (uniforms[pictureNames[k]] ??= {value: null}).value = picture;
  });
}

const shadersOf = new Map(); // by forms of shapes, as words, the text before main()
const formsOf = new WeakMap(); // by material, the forms that it was last compiled for

function functionsOf(forms) {
  if (!shadersOf.has(forms)) {
    const list = forms.split(' '), pictures = pictureNames.slice(0, picturesOf(list));
    shadersOf.set(forms, ['openltc_elements', ...pictures].map(name => `uniform highp sampler2D ${name};\n`).join('') +
                         glsl.element('openltc_elements') + functionsFor(list, glsl, pictures));
  }
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

class WebGLSceneLights extends SceneLights {
  outer = []; // textures of pictures that are being drawn, while this one is

  begin(renderer, camera) {
    this.outer.push(Object.values(uniforms).map(uniform => uniform.value));
    this.update(camera);
  }

  end() {
    if (this.outer.length) setUniforms(...(([elements, ...pictures]) => [elements, pictures])(this.outer.pop()));
  }

  update(camera) {
    const forms = this.collect(camera);
    setUniforms(this.rows.texture, this.pictures);
    this.prepareMaterials(forms);
  }

  prepareMaterials(forms) {
    const materials = new Set([this.scene.overrideMaterial]);
    this.scene.traverse(object => [object.material].flat().forEach(material => materials.add(material)));
    for (const material of materials) prepare(material, forms);
  }

  dispose() {
    super.dispose();
    this.prepareMaterials('');
  }
}

/// Lets the area lights of a scene shine, from the next picture on, for WebGLRenderer. Call it once a scene, after
/// you have set its onBeforeRender and onAfterRender, if you have. Returns an object: update(camera) prepares
/// materials for renderer.compile or compileAsync; dispose() ends it.
export const enableAreaLights = makeEnable(WebGLSceneLights);
