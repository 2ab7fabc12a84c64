// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Shadows of area lights, for WebGPURenderer on both of its back ends: `openltc-three/webgpu/shadows`. As shadows.js
// has them, but that each pass draws into targets of its own, which a second one adds to the sums.

import {Color, FloatType, HalfFloatType, NearestFilter, NodeMaterial, QuadMesh, RenderTarget, RendererUtils, Scene,
        Vector2} from 'three/webgpu';
import {AreaShadows} from './area_shadows.js';
import {sameItems} from './scene_lights.js';
import {AreaRaysNode, enableAreaLights, foundNames} from './scene_webgpu.js';
import {ivec2, mrt, property, renderGroup, screenCoordinate, textureLoad, uniform, vec4} from './tsl.js';

function makeTarget({x, y}, type, depthBuffer) {
  const target = new RenderTarget(x, y, {count: 2, type, depthBuffer, minFilter: NearestFilter, magFilter: NearestFilter,
                                         generateMipmaps: false});
  target.textures.forEach((one, k) => one.name = foundNames[k]); // `output` would blend
  return target;
}

const outputs = node => mrt(Object.fromEntries(foundNames.map((name, k) => [name, node(name, k)])));

// A picture that fills both textures of a target.
function makeQuad(node) {
  const material = new NodeMaterial();
  material.fragmentNode = outputs(node);
  return new QuadMesh(material);
}

const texelHere = texture => textureLoad(texture, ivec2(screenCoordinate));

class WebGPUAreaShadows extends AreaShadows {
  // The scene beside its own lights, fog and background.
  stage = new Scene();
  lists = new WeakSet();
  parts = [];
  node = null;
  count = uniform(0, 'uint').setGroup(renderGroup);
  scale = uniform(1).setGroup(renderGroup);
  before = uniform(0); // how much of the sums counts: 0 after a change
  outputs = outputs(name => vec4(property('vec3', name).mul(this.scale).min(60000), 1));
  state = {};

  constructor(lights, frames, exact) {
    super(lights, frames, exact);
    this.stage.matrixWorldAutoUpdate = false;
    this.stage.children.push(lights.scene); // whose parent stays what it is
    this.reserve(new Vector2(1, 1));
  }

  // New targets, since nodes of r182 do not notice when the textures of one are made anew: for what one picture adds, in
  // thousandths of the brightest light so that half floats, which all devices blend, hold it; for the sums with it; and
  // for the sums, whose textures then stay the same.
  reserve(size) {
    if (this.total?.width === size.x && this.total.height === size.y) return;
    this.release();
    this.found = makeTarget(size, HalfFloatType, true);
    this.next = makeTarget(size, FloatType, false);
    this.total = makeTarget(size, FloatType, false);
    this.sum = makeQuad((_, k) => texelHere(this.total.textures[k]).mul(this.before)
        .add(texelHere(this.found.textures[k]).div(this.scale)));
    this.copy = makeQuad((_, k) => texelHere(this.next.textures[k]));
  }

  release() {
    for (const one of [this.found, this.next, this.total, this.sum?.material, this.copy?.material]) one?.dispose();
  }

  /// Textures of floats: of each pixel the light of its rays, of `frame` pictures together, without and with what
  /// stands between. With `exact` they are a reference: what the material reflects of lights with castShadow.
  get sums() {
    const [unshadowed, shadowed] = this.total.textures;
    return {unshadowed, shadowed};
  }

  dispose() {
    super.dispose();
    this.release();
  }

  /// Whether this renderer, in this picture, can have shadows.
  canTrace(renderer) { return !renderer.xr.isPresenting; }

  /// Adds a ray to each pixel.
  trace(renderer, camera) {
    this.prepare(renderer, camera);
    if (this.frame < this.frames) this.addRays(renderer, camera);
  }

  addRays(renderer, camera) {
    const {lights} = this;
    this.take();
    renderer.initTexture(this.tree.texture);
    this.count.value = this.frame;
    this.scale.value = 1000 / (lights.rows.brightest || 1);
    this.before.value = this.frame ? 1 : 0;
    RendererUtils.resetRendererState(renderer, this.state);
    try {
      renderer.setClearColor(new Color(0), 0);
      renderer.setMRT(this.outputs);
      renderer.setRenderTarget(this.found);
      this.takeList(renderer.lighting.getNode(this.stage, camera));
      renderer.render(this.stage, camera);
      renderer.setMRT(null);
      for (const [quad, target] of [[this.sum, this.next], [this.copy, this.total]]) {
        renderer.setRenderTarget(target);
        quad.render(renderer);
      }
    } finally {
      RendererUtils.restoreRendererState(renderer, this.state);
    }
    ++this.frame;
  }

  // A new node where what it is made of is other.
  take() {
    const {forms, rows, pictures} = this.lights, parts = [forms, rows.texture, this.tree.texture, this.exact, ...pictures];
    if (sameItems(parts, this.parts)) return;
    this.parts = parts;
    this.node = new AreaRaysNode(forms, rows.texture, pictures, this);
  }

  takeList(list) {
    if (this.lists.has(list)) return;
    this.lists.add(list);
    const {setLights} = list;
    list.setLights = () => setLights.call(list, [this.node]);
  }
}

/// Lets lights of a scene with castShadow have shadows, from the next picture of WebGPURenderer on. Returns an object:
/// frame of frames rays of a pixel have been sent to each light since the last change. `exact`, which may be changed at
/// any time: the sums are those of the material itself, noisier in smooth surfaces under lines and in coats.
export function enableAreaShadows(scene, {frames = 256, exact = false} = {}) {
  const lights = enableAreaLights(scene);
  return lights.shadows ?? new WebGPUAreaShadows(lights, frames, exact);
}
