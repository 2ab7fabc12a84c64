// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How the lights of a scene get into the materials of WebGLRenderer: before each picture each standard and physical
// material of the scene is given the shader for the shapes that are there.

import {glsl} from './glsl.js';
import {rayFunctions, ratioFunctions} from './rays.js';
import {LightRows} from './rows.js';
import {SceneLights, makeEnable} from './scene_lights.js';
import {functionsFor, picturesOf} from './shader_text.js';

const pars = '#include <lights_physical_pars_fragment>', begin = '#include <lights_fragment_begin>', end = '#include <dithering_fragment>';

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

// And in the pass that sums, which has the same arguments.
const rayStatements = `
{
  mat3 sums = openltc_trace(transpose(mat3(viewMatrix)), cameraPosition, geometryPosition, geometryNormal,
      geometryViewDir, material.diffuseContribution, material.specularColorBlended, material.specularF90, roughnessFactor,
      cross(dFdx(vViewPosition), dFdy(vViewPosition)), gl_FragCoord.xy, openltc_frame
#ifdef USE_CLEARCOAT
      , geometryClearcoatNormal, material.clearcoatRoughness - geometryRoughness, material.clearcoat
#endif
  );
  openltc_all = sums[0];
  openltc_open = sums[1];
}
`;

// And at its end, in place of the colour.
const sumStatements = `
gl_FragColor = vec4(texelFetch(openltc_unshadowed, ivec2(gl_FragCoord.xy), 0).rgb + openltc_all, 1.0);
openltc_shadowed_sum = vec4(texelFetch(openltc_shadowed, ivec2(gl_FragCoord.xy), 0).rgb + openltc_open, 1.0);
`;

const ratioStatements = `
openltc_ratio = openltc_ratio_of(texelFetch(openltc_unshadowed, ivec2(gl_FragCoord.xy), 0).rgb,
                                 texelFetch(openltc_shadowed, ivec2(gl_FragCoord.xy), 0).rgb);
`;

// Uniforms are the same objects for all materials; the scene that is rendered sets their values. Others, which share
// its materials, find no lights. All materials have all of them, since three.js keeps those of one of its programs.
const none = new LightRows(), pictureNames = [0, 1, 2, 3].map(k => `openltc_picture_${k}`);
export const sharedUniforms = Object.fromEntries(
    ['openltc_elements', ...pictureNames, 'openltc_unshadowed', 'openltc_shadowed', 'openltc_branches', 'openltc_frame']
        .map(name => [name, {value: null}]));
sharedUniforms.openltc_elements.value = none.texture;

function setUniforms(elements, pictures) {
  sharedUniforms.openltc_elements.value = elements;
  pictures.forEach((picture, k) => sharedUniforms[pictureNames[k]].value = picture);
}

// What a shader does, before the forms of its shapes: the closed form alone, times the ratio of shadows, or rays, for
// that ratio or of the material itself.
const ratio = 'ratio', rays = 'rays', exact = 'exact', tasks = [ratio, rays, exact];
const sends = task => task === rays || task === exact;

const shadersOf = new Map(); // by that, as words, the text before main()
const formsOf = new WeakMap(); // by material, what it was last compiled for

function makeFunctions(words) {
  const [task] = words, forms = words.filter(word => !tasks.includes(word));
  const pictures = pictureNames.slice(0, picturesOf(forms));
  const elements = ['openltc_elements', ...pictures].map(name => `uniform highp sampler2D ${name};\n`).join('') +
      glsl.element('openltc_elements');
  const sums = 'uniform highp sampler2D openltc_unshadowed, openltc_shadowed;\n';
  const rays = coat => rayFunctions(forms, glsl, pictures, task === exact, coat);
  if (sends(task))
    return `${elements}${sums}uniform highp sampler2D openltc_branches;
uniform uint openltc_frame;
layout(location = 1) out highp vec4 openltc_shadowed_sum;
${glsl.tree('openltc_branches')}#ifdef USE_CLEARCOAT
${rays(true)}#else
${rays(false)}#endif
`;
  if (task === ratio) return elements + sums + ratioFunctions(glsl) + functionsFor(forms, glsl, pictures, 'openltc_radiance(head)');
  return elements + functionsFor(forms, glsl, pictures);
}

function functionsOf(words) {
  if (!shadersOf.has(words)) shadersOf.set(words, makeFunctions(words.split(' ')));
  return shadersOf.get(words);
}

function statementsOf(words) {
  const [task] = words.split(' ');
  return sends(task) ? rayStatements : (task === ratio ? ratioStatements : '') + statements;
}

// Chains our change of the shader behind what the material has.
function take(material) {
  const {onBeforeCompile, customProgramCacheKey} = material;
  material.onBeforeCompile = function(shader, renderer) {
    onBeforeCompile.call(this, shader, renderer);
    Object.assign(shader.uniforms, sharedUniforms); // without forms as well: three.js keeps those of the program made last
    const forms = formsOf.get(material);
    if (!forms) return;
    for (const text of [pars, begin])
      if (!shader.fragmentShader.includes(text))
        return console.warn(`openltc-three: the shader of material "${material.name}" has no ${text}: no area lights`);
    shader.fragmentShader = shader.fragmentShader.replace(pars, () => `${pars}\n${functionsOf(forms)}`)
        .replace(begin, () => begin + statementsOf(forms))
        .replace(end, () => sends(forms.split(' ')[0]) ? sumStatements : end);
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
  shadows = null; // shadows.js
  isTracing = false;

  begin(renderer, camera) {
    this.outer.push(Object.values(sharedUniforms).map(uniform => uniform.value));
    if (this.isTracing) return;
    const forms = this.look(camera), casts = forms && this.rows.casts && this.shadows?.canTrace(renderer);
    if (casts)
      this.shadows.trace(renderer, camera, () => {
        this.prepareMaterials(`${this.shadows.exact ? exact : rays} ${forms}`);
        this.isTracing = true;
        try {
          renderer.render(this.scene, camera);
        } finally {
          this.isTracing = false;
        }
      });
    this.prepareMaterials(casts ? `${ratio} ${forms}` : forms);
  }

  end() {
    this.outer.pop()?.forEach((value, i) => Object.values(sharedUniforms)[i].value = value);
  }

  look(camera) {
    const forms = this.collect(camera);
    setUniforms(this.rows.texture, this.pictures);
    return forms;
  }

  update(camera) { this.prepareMaterials(this.look(camera)); }

  prepareMaterials(forms) {
    const materials = new Set([this.scene.overrideMaterial]);
    this.scene.traverse(object => [object.material].flat().forEach(material => materials.add(material)));
    for (const material of materials) prepare(material, forms);
  }

  dispose() {
    this.shadows?.dispose();
    super.dispose();
    this.prepareMaterials('');
  }
}

/// Lets the area lights of a scene shine, from the next picture on, for WebGLRenderer. Call it once a scene, after
/// you have set its onBeforeRender and onAfterRender, if you have. Returns an object: update(camera) prepares
/// materials for renderer.compile or compileAsync; dispose() ends it.
export const enableAreaLights = makeEnable(WebGLSceneLights);
