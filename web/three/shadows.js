// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Shadows of area lights, for WebGLRenderer: `openltc-three/shadows`. Before each picture a pass over the scene sends
// one ray to each light with castShadow from each pixel, and adds what it finds to two sums, with and without what
// stands between. The closed form is multiplied by their ratio (rays.js).

import {BufferAttribute, BufferGeometry, Color, FloatType, Matrix4, NearestFilter, Vector2, Vector3,
        WebGLRenderTarget} from 'three';
import {BVHShaderGLSL, MeshBVH, MeshBVHUniformStruct} from 'three-mesh-bvh';
import {enableAreaLights, sharedUniforms, tracer} from './scene.js';

tracer.functions = [BVHShaderGLSL.common_functions, BVHShaderGLSL.bvh_struct_definitions, BVHShaderGLSL.bvh_ray_functions]
    .join('\n');

// Where in the world a mesh is drawn.
function placesOf(mesh) {
  if (!mesh.isInstancedMesh) return [mesh.matrixWorld];
  return Array.from({length: mesh.count}, (_, k) => {
    const place = new Matrix4();
    mesh.getMatrixAt(k, place);
    return place.premultiply(mesh.matrixWorld);
  });
}

// All triangles of meshes, in the world.
function mergedGeometry(meshes) {
  const positions = [], corners = [], vertex = new Vector3();
  for (const mesh of meshes)
    for (const place of placesOf(mesh)) {
      const {index, attributes: {position}} = mesh.geometry, first = positions.length / 3;
      for (let i = 0; i < position.count; ++i)
        positions.push(...mesh.getVertexPosition(i, vertex).applyMatrix4(place));
      for (let i = 0; i < (index ?? position).count; ++i) corners.push(first + (index ? index.getX(i) : i));
    }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setIndex(corners);
  return geometry;
}

const sameNumbers = (a, b) => a.length === b.length && a.every((x, i) => x === b[i]);

class AreaShadows {
  /// Pictures since the last change, and after how many no ray is sent any more.
  frame = 0;
  frames;

  bvh = new MeshBVHUniformStruct();
  meshes = [];
  view = [];
  targets = [];
  warned = false;

  constructor(lights, frames, exact) {
    this.lights = lights;
    this.frames = frames;
    this.exact = exact;
    lights.shadows = this;
  }

  /// Textures of floats: of each pixel the light of its rays, of `frame` pictures together, without and with what
  /// stands between. With `exact` they are a reference: what the material reflects of lights with castShadow.
  get sums() {
    const [unshadowed, shadowed] = this.targets[this.frame % 2].textures;
    return {unshadowed, shadowed};
  }

  /// Begins anew, for changes that are not seen by themselves: of materials, and of what vertices do.
  reset() { this.frame = 0; }

  /// Ends shadows; lights shine on without.
  dispose() {
    this.lights.shadows = null;
    this.targets.forEach(target => target.dispose());
    this.bvh.dispose();
  }

  // What casts shadows: meshes that are seen, but for those that show a light, its children.
  occluders() {
    const found = [];
    const visit = object => {
      if (!object.visible || object.isAreaLight) return;
      if (object.isMesh && object.geometry.attributes.position?.count > 0) found.push(object);
      object.children.forEach(visit);
    };
    visit(this.lights.scene);
    return found;
  }

  // Looks for changes of what is seen.
  lookAt(camera, size) {
    const meshes = this.occluders();
    const state = meshes.flatMap(mesh => [mesh.id, mesh.geometry.id, mesh.geometry.attributes.position.version,
                                          mesh.count ?? 1, mesh.instanceMatrix?.version ?? 0,
                                          ...mesh.matrixWorld.elements]);
    if (!sameNumbers(state, this.meshes)) {
      this.meshes = state;
      if (meshes.length) this.bvh.updateFrom(new MeshBVH(mergedGeometry(meshes)));
      this.frame = 0;
    }
    const view = [size.x, size.y, this.exact ? 1 : 0, ...camera.matrixWorld.elements, ...camera.projectionMatrix.elements,
                  ...this.lights.rows.data];
    if (!sameNumbers(view, this.view)) {
      this.view = view;
      this.frame = 0;
    }
  }

  reserve({x, y}) {
    if (this.targets[0]?.width === x && this.targets[0]?.height === y) return;
    this.targets.forEach(target => target.dispose());
    this.targets = [0, 1].map(() => new WebGLRenderTarget(x, y, {
      count: 2, type: FloatType, minFilter: NearestFilter, magFilter: NearestFilter, generateMipmaps: false}));
  }

  /// Whether this renderer, in this picture, can have shadows.
  canTrace(renderer) {
    const can = renderer.extensions.has('EXT_color_buffer_float');
    if (!can && !this.warned) console.warn('openltc-three: no shadows, since this browser cannot add to textures of floats');
    this.warned = !can;
    return can && !renderer.xr.isPresenting;
  }

  /// Adds a ray to each pixel. `draw` draws the scene.
  trace(renderer, camera, draw) {
    const outer = renderer.getRenderTarget(), size = new Vector2();
    if (outer) size.set(outer.width, outer.height);
    else renderer.getDrawingBufferSize(size);
    this.lookAt(camera, size);
    this.reserve(size);
    if (this.frame < this.frames) this.addRays(renderer, outer, draw);
    const {unshadowed, shadowed} = this.sums;
    sharedUniforms.openltc_unshadowed.value = unshadowed;
    sharedUniforms.openltc_shadowed.value = shadowed;
  }

  addRays(renderer, outer, draw) {
    const {scene} = this.lights, {background} = scene, {autoClear} = renderer, color = renderer.getClearColor(new Color());
    const alpha = renderer.getClearAlpha(), [from, to] = [this.frame % 2, (this.frame + 1) % 2];
    scene.background = null;
    renderer.setClearColor(0, 0);
    if (this.frame === 0) {
      renderer.setRenderTarget(this.targets[from]);
      renderer.clear();
    }
    sharedUniforms.openltc_bvh.value = this.bvh;
    sharedUniforms.openltc_frame.value = this.frame;
    [sharedUniforms.openltc_unshadowed.value, sharedUniforms.openltc_shadowed.value] = this.targets[from].textures;
    renderer.setRenderTarget(this.targets[to]);
    renderer.autoClear = true;
    draw();
    renderer.autoClear = autoClear;
    renderer.setRenderTarget(outer);
    renderer.setClearColor(color, alpha);
    scene.background = background;
    ++this.frame;
  }
}

/// Lets lights of a scene with castShadow have shadows, from the next picture of WebGLRenderer on. Returns an object:
/// frame of frames rays of a pixel have been sent to each light since the last change. `exact`, which may be changed at
/// any time: the sums are those of the material itself, noisier in smooth surfaces under tubes and in coats.
export function enableAreaShadows(scene, {frames = 256, exact = false} = {}) {
  const lights = enableAreaLights(scene);
  return lights.shadows ?? new AreaShadows(lights, frames, exact);
}
