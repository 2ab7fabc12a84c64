// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How the lights of a scene get into the materials of WebGPURenderer, on both of its back ends: in the list of lights
// that each picture gets, one node stands for all of ours.

import {CodeNode, LightingNode, PhysicalLightingModel, TSL} from 'three/webgpu';
import {glsl} from './glsl.js';
import {SceneLights, makeEnable} from './scene_lights.js';
import {functionsFor} from './shader_text.js';
import {wgsl} from './wgsl.js';

// Before r186 three/tsl does not have all of them.
const {cameraPosition, cameraViewMatrix, clearcoatNormalView, diffuseContribution, float, glslFn, mat3,
       materialClearcoatRoughness, materialRoughness, normalView, positionView, positionViewDirection,
       specularColorBlended, specularF90, texture, transpose, vec3, wgslFn} = TSL;

// The functions for the forms of a scene's shapes, and the textures that they read.
class FunctionsNode extends CodeNode {
  constructor(forms, words, map, pictures) {
    super();
    Object.assign(this, {forms, words, map, pictures});
  }

  generate(builder) {
    const [map, ...pictures] = [this.map, ...this.pictures].map(one => one.build(builder, 'texture'));
    this.code = this.words.element(map) + functionsFor(this.forms, this.words, pictures);
    return super.generate(builder);
  }
}

// openltc_shade_layer, its two parts as columns of a matrix.
function layerFunction(words, native, functions) {
  const {mat3, vec3, real} = words;
  const parameters = [[mat3, 'to_world'], [vec3, 'eye'], [vec3, 'position'], [vec3, 'normal'], [vec3, 'view'],
                      [vec3, 'albedo'], [vec3, 'f0'], [real, 'f90'], [real, 'roughness']];
  const call = `openltc_shade_layer(${parameters.map(([, name]) => name).join(', ')})`;
  return native(words.fn(mat3, 'openltc_layer', parameters,
                         words.variable('openltc_ShadedLight', 'lit', call) +
                         `  return ${mat3}(lit.diffuse, lit.specular, ${vec3}(0.0));\n`), [functions]);
}

/// All lights of a scene, for the forms that their shapes have now.
class AreaLightsNode extends LightingNode {
  static get type() { return 'OpenLTCAreaLightsNode'; }

  constructor(forms, map, pictures) {
    super();
    this.forms = forms.split(' ');
    this.map = texture(map);
    this.pictures = pictures.map(picture => texture(picture));
  }

  setup(builder) {
    const {lightingModel, reflectedLight} = builder.context, {material} = builder;
    if (!(lightingModel instanceof PhysicalLightingModel)) return;
    const words = builder.renderer.backend.isWebGPUBackend ? wgsl : glsl;
    const layer = layerFunction(words, words === wgsl ? wgslFn : glslFn,
                                new FunctionsNode(this.forms, words, this.map, this.pictures));
    const shared = {to_world: transpose(mat3(cameraViewMatrix)), eye: cameraPosition, position: positionView,
                    view: positionViewDirection};
    const own = (node, otherwise) => node ? float(node) : otherwise; // not what three.js widens for point lights
    const lit = layer({...shared, normal: normalView, albedo: diffuseContribution, f0: specularColorBlended,
                       f90: specularF90, roughness: own(material.roughnessNode, materialRoughness)}).toVar();
    reflectedLight.directDiffuse.addAssign(lit.element(0));
    reflectedLight.directSpecular.addAssign(lit.element(1));
    if (lightingModel.clearcoat)
      lightingModel.clearcoatSpecularDirect.addAssign(
          layer({...shared, normal: clearcoatNormalView, albedo: vec3(0), f0: vec3(0.04), f90: float(1),
                 roughness: own(material.clearcoatRoughnessNode, materialClearcoatRoughness)}).toVar().element(1));
  }
}

class WebGPUSceneLights extends SceneLights {
  depth = 0; // pictures of this scene that are being drawn, one within the other: they share a texture
  forms = '';
  textures = []; // that the node reads
  node = null;
  warned = false;
  lists = new Map(); // three.js's nodes of the lights of this scene, and their setLights

  begin(renderer, camera) {
    if (this.depth++ === 0) {
      this.update(camera);
      // Meshes and materials that stay as they are keep their bindings, of whose textures three.js then asks nothing.
      this.textures.forEach(one => renderer.initTexture(one));
    }
    this.takeList(renderer.lighting.getNode(this.scene, camera));
  }

  end() { if (this.depth > 0) --this.depth; }

  update(camera) {
    const forms = this.collect(camera), textures = [this.rows.texture, ...this.pictures];
    if (this.rows.casts && !this.warned)
      console.warn('openltc-three: castShadow of area lights does nothing with WebGPURenderer; WebGLRenderer has their ' +
                   'shadows, by openltc-three/shadows');
    this.warned ||= this.rows.casts;
    if (forms !== this.forms || textures.some((one, k) => one !== this.textures[k]))
      this.node = forms ? new AreaLightsNode(forms, this.rows.texture, this.pictures) : null;
    Object.assign(this, {forms, textures});
  }

  takeList(list) {
    if (this.lists.has(list)) return;
    const {setLights} = list;
    this.lists.set(list, setLights);
    list.setLights = lights =>
        setLights.call(list, [...lights.filter(light => !light.isAreaLight), ...(this.node ? [this.node] : [])]);
  }

  dispose() {
    super.dispose();
    for (const [list, setLights] of this.lists) list.setLights = setLights;
    this.node = null;
  }
}

/// Lets the area lights of a scene shine, from the next picture on, for WebGPURenderer. Call it once a scene, after
/// you have set its onBeforeRender and onAfterRender, if you have. Returns an object: update(camera) is only for
/// WebGLRenderer; dispose() ends it.
export const enableAreaLights = makeEnable(WebGPUSceneLights);
