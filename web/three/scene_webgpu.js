// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How the lights of a scene get into the materials of WebGPURenderer, on both of its back ends: in the list of lights
// that each picture gets, one node stands for all of ours.

import {CodeNode, LightingNode, PhysicalLightingModel} from 'three/webgpu';
import {glsl} from './glsl.js';
import {SceneLights, makeEnable, sameItems} from './scene_lights.js';
import {rayFunctions, rayParameters, ratioFunctions} from './rays.js';
import {functionsFor, layerParameters} from './shader_text.js';
import {cameraPosition, cameraViewMatrix, clearcoatNormalView, diffuseContribution, float, glslFn, ivec2, mat3,
        materialClearcoat, materialClearcoatRoughness, materialRoughness, normalView, positionView, positionViewDirection,
        property, screenCoordinate, specularColorBlended, specularF90, texture, textureLoad, transpose, vec3, wgslFn} from './tsl.js';
import {wgsl} from './wgsl.js';

// Text that names textures: `write` gets their names.
class TextNode extends CodeNode {
  constructor(textures, write) {
    super();
    Object.assign(this, {textures, write});
  }

  generate(builder) {
    this.code = this.write(this.textures.map(one => one.build(builder, 'texture')));
    return super.generate(builder);
  }
}

// The layers of a material, as layerParameters has them.
const place = () => ({to_world: transpose(mat3(cameraViewMatrix)), eye: cameraPosition, position: positionView,
                      view: positionViewDirection});
const own = (node, otherwise) => node ? float(node) : otherwise; // not what three.js widens for point lights
const base = material => ({...place(), normal: normalView, albedo: diffuseContribution, f0: specularColorBlended,
                           f90: specularF90, roughness: own(material.roughnessNode, materialRoughness)});
const coatRoughness = material => own(material.clearcoatRoughnessNode, materialClearcoatRoughness);
const coat = material => ({...place(), normal: clearcoatNormalView, albedo: vec3(0), f0: vec3(0.04), f90: float(1),
                           roughness: coatRoughness(material)});

const namesOf = parameters => parameters.map(([, name]) => name).join(', ');

// A function of the material, for the forms of a scene's shapes and the textures that they read.
class LightsFunctionNode extends LightingNode {
  constructor(forms, textures) {
    super();
    this.forms = forms.split(' ');
    this.textures = textures.map(one => texture(one));
  }

  words(builder) { return builder.renderer.backend.isWebGPUBackend ? wgsl : glsl; }

  // A function of that name; `write` gives the text that stands before it, from the words of the language and names of
  // the textures.
  fn(builder, type, name, parameters, body, write) {
    const words = this.words(builder), native = words === wgsl ? wgslFn : glslFn;
    return native(words.fn(words[type], name, parameters(words), body(words)),
                  [new TextNode(this.textures, names => write(words, names))]);
  }
}

/// All lights of a scene. `sums`, where there are some, are those of their shadows.
class AreaLightsNode extends LightsFunctionNode {
  static get type() { return 'OpenLTCAreaLightsNode'; }

  constructor(forms, map, pictures, sums) {
    super(forms, [map, ...pictures]);
    this.sums = sums;
  }

  setup(builder) {
    const {lightingModel, reflectedLight} = builder.context, {material} = builder, {sums} = this;
    if (!(lightingModel instanceof PhysicalLightingModel)) return;
    // openltc_shade_layer, its two parts as columns of a matrix.
    const layer = this.fn(builder, 'mat3', 'openltc_layer',
        words => [...layerParameters(words), ...(sums ? [[words.vec3, 'all'], [words.vec3, 'open']] : [])],
        words => (sums ? '  openltc_ratio = openltc_ratio_of(all, open);\n' : '') +
            words.variable('openltc_ShadedLight', 'lit', `openltc_shade_layer(${namesOf(layerParameters(words))})`) +
            `  return ${words.mat3}(lit.diffuse, lit.specular, ${words.vec3}(0.0));\n`,
        (words, [map, ...pictures]) => words.element(map) + (sums ? ratioFunctions(words) : '') +
            functionsFor(this.forms, words, pictures, sums ? 'openltc_radiance(head)' : 'head.rgb'));
    const here = one => textureLoad(one, ivec2(screenCoordinate)).xyz;
    const shadows = sums ? {all: here(sums.unshadowed), open: here(sums.shadowed)} : {};
    const lit = layer({...base(material), ...shadows}).toVar();
    reflectedLight.directDiffuse.addAssign(lit.element(0));
    reflectedLight.directSpecular.addAssign(lit.element(1));
    if (lightingModel.clearcoat)
      lightingModel.clearcoatSpecularDirect.addAssign(layer({...coat(material), ...shadows}).toVar().element(1));
  }
}

/// What AreaRaysNode sets for the outputs of a picture.
export const foundNames = ['openltc_found_all', 'openltc_found_open'];

/// A ray to each of them that casts shadows, in a picture of two outputs: what they give, and what of it nothing hides.
export class AreaRaysNode extends LightsFunctionNode {
  static get type() { return 'OpenLTCAreaRaysNode'; }

  constructor(forms, map, pictures, {tree, count, exact}) {
    super(forms, [map, tree.texture, ...pictures]);
    Object.assign(this, {count, exact});
  }

  setup(builder) {
    const {lightingModel} = builder.context, {material} = builder;
    if (!(lightingModel instanceof PhysicalLightingModel)) return;
    const coat = lightingModel.clearcoat ? {coat_normal: clearcoatNormalView, coat_roughness: coatRoughness(material),
                                            coat_share: own(material.clearcoatNode, materialClearcoat)} : {};
    const parameters = words => rayParameters(words, lightingModel.clearcoat);
    const trace = this.fn(builder, 'mat3', 'openltc_sums', parameters,
        words => `  return openltc_trace(${namesOf(parameters(words))});\n`,
        (words, [map, tree, ...pictures]) => words.element(map) + words.tree(tree) +
            rayFunctions(this.forms, words, pictures, this.exact, lightingModel.clearcoat));
    const found = trace({...base(material), across: positionView.dFdx().cross(positionView.dFdy()), ...coat,
                         pixel: screenCoordinate, frame: this.count}).toVar();
    foundNames.forEach((name, k) => property('vec3', name).assign(found.element(k)));
  }
}

class WebGPUSceneLights extends SceneLights {
  depth = 0; // pictures of this scene that are being drawn, one within the other: they share a texture
  forms = '';
  textures = []; // that the node reads
  parts = []; // of the node
  node = null;
  shadows = null; // webgpu_shadows.js
  lists = new Map(); // three.js's nodes of the lights of this scene, and their setLights

  begin(renderer, camera) {
    if (this.depth++ === 0) {
      this.look(camera);
      // Meshes and materials that stay as they are keep their bindings, of whose textures three.js then asks nothing.
      this.textures.forEach(one => renderer.initTexture(one));
      const casts = this.forms && this.rows.casts && this.shadows?.canTrace(renderer);
      if (casts) this.shadows.trace(renderer, camera);
      this.take(casts ? this.shadows.sums : null);
    }
    this.takeList(renderer.lighting.getNode(this.scene, camera));
  }

  end() { if (this.depth > 0) --this.depth; }

  look(camera) {
    this.forms = this.collect(camera);
    this.textures = [this.rows.texture, ...this.pictures];
  }

  // A new node where what it is made of is other.
  take(sums) {
    const parts = [this.forms, ...this.textures, sums?.unshadowed];
    if (sameItems(parts, this.parts)) return;
    this.parts = parts;
    this.node = this.forms ? new AreaLightsNode(this.forms, this.rows.texture, this.pictures, sums) : null;
  }

  update(camera) {
    this.look(camera);
    this.take(null);
  }

  takeList(list) {
    if (this.lists.has(list)) return;
    const {setLights} = list;
    this.lists.set(list, setLights);
    list.setLights = lights =>
        setLights.call(list, [...lights.filter(light => !light.isAreaLight), ...(this.node ? [this.node] : [])]);
  }

  dispose() {
    this.shadows?.dispose();
    super.dispose();
    for (const [list, setLights] of this.lists) list.setLights = setLights;
    this.node = null;
  }
}

/// Lets the area lights of a scene shine, from the next picture on, for WebGPURenderer. Call it once a scene, after
/// you have set its onBeforeRender and onAfterRender, if you have. Returns an object: update(camera) is only for
/// WebGLRenderer; dispose() ends it.
export const enableAreaLights = makeEnable(WebGPUSceneLights);
