// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The canvas: camera, handles of lights, and when what is drawn.

import {Box3, Color, PerspectiveCamera, Scene, Spherical, Vector2, Vector3} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {TransformControls} from 'three/addons/controls/TransformControls.js';
import {AreaLightHelper} from 'openltc-three';
import {finish, makeRenderer, nameOf} from './graphics.js';
import {Pictures} from './pictures.js';
import {kinds, resize} from './light_kinds.js';

const k_slow = 90; // ms of a picture, from which a moving one gets fewer pixels
const k_still = 300; // ms without a change until it gets all of them
const k_near = 24; // pixels from a light's middle that choose it
const k_turn = 5 * Math.PI / 180; // of an arrow key
const k_selected = new Color(0x3d9be9).convertLinearToSRGB(); // the canvas is given what it shows
const k_pause = 1000; // ms until a device that was lost is asked for anew

export class Stage extends EventTarget {
  world = new Scene();
  overlay = new Scene();
  camera = new PerspectiveCamera(40, 1, 0.01, 1000);
  helpers = new Map(); // by light
  selected = null;
  showsLights = true;
  content = null;
  fov = 35; // degrees
  wide = 0; // the aspect that fov is meant for at least
  size = new Vector2();
  #wanted = false;
  #still = 0;
  #share = 0.35; // of the pixels along a side, while something moves
  #moving = false;
  #measured = 0;
  #isStill = false;

  #forceWebGL = false;
  #isLost = false;
  #isDrawing = false;
  #resizes = new ResizeObserver(() => this.invalidate());

  /// Fails where there is neither WebGPU nor WebGL 2.
  static async make(canvas, forceWebGL = false) {
    const stage = new Stage();
    stage.#forceWebGL = forceWebGL;
    stage.#setCanvas(canvas, await makeRenderer(canvas, forceWebGL));
    return stage;
  }

  #tell(type, detail) { this.dispatchEvent(new CustomEvent(type, {detail})); }

  /// "WebGPU" or "WebGL 2".
  get graphics() { return nameOf(this.renderer); }

  #setCanvas(canvas, renderer) {
    this.canvas = canvas;
    this.renderer = renderer;
    renderer.onDeviceLost = () => this.#restart();
    renderer.debug.onShaderError = (gl, program, vertex, fragment) =>
        this.#tell('broken', `A shader was refused: ${(gl.getShaderInfoLog(fragment) || gl.getProgramInfoLog(program) || '').slice(0, 300)}`);
    if (this.pictures) {
      this.pictures.setRenderer(renderer);
      this.orbit.disconnect();
      this.gizmo.disconnect();
      this.orbit.connect(canvas);
      this.gizmo.connect(canvas);
      this.orbit.domElement = this.gizmo.domElement = canvas;
    } else {
      this.pictures = new Pictures(renderer, this.world);
      this.#makeControls();
    }
    this.#listen(canvas);
    this.#resizes.observe(canvas);
  }

  // Another device, which wants another canvas.
  async #restart() {
    if (this.#isLost) return;
    this.#isLost = true;
    this.#tell('lost');
    for (;;) {
      await new Promise(done => setTimeout(done, k_pause));
      const old = this.canvas, canvas = old.cloneNode(false);
      try {
        const renderer = await makeRenderer(canvas, this.#forceWebGL);
        this.#resizes.unobserve(old);
        old.replaceWith(canvas);
        this.#setCanvas(canvas, renderer);
        break;
      } catch {
        // Not yet.
      }
    }
    this.#isLost = false;
    this.#tell('restored');
    this.invalidate();
  }

  #makeControls() {
    const {canvas, camera} = this;
    this.orbit = new OrbitControls(camera, canvas);
    this.orbit.addEventListener('change', () => this.invalidate());
    this.gizmo = new TransformControls(camera, canvas);
    this.gizmo.setSize(0.8);
    this.overlay.add(this.gizmo.getHelper());
    this.gizmo.addEventListener('change', () => this.#request());
    this.gizmo.addEventListener('dragging-changed', ({value}) => {
      this.orbit.enabled = !value;
      this.#tell('held', value);
    });
    let sizes = null;
    this.gizmo.addEventListener('mouseDown', () => sizes = this.selected.clone());
    this.gizmo.addEventListener('objectChange', () => {
      const light = this.selected;
      if (this.gizmo.mode === 'scale') {
        const factors = light.scale.toArray().map(x => Math.min(Math.max(Math.abs(x), 0.02), 50));
        resize(light, kinds[light.type].stretched(sizes, ...factors));
        light.scale.set(1, 1, 1);
      }
      this.#tell('moved');
      this.invalidate();
    });
  }

  #listen(canvas) {
    let down = null;
    canvas.addEventListener('pointerdown', event => down = [event.clientX, event.clientY]);
    canvas.addEventListener('pointerup', event => {
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4 && !this.gizmo.axis) this.#choose(event);
      down = null;
    });
    canvas.addEventListener('keydown', event => this.#onKey(event));
  }

  // The light whose middle is near a place of the page.
  #choose({clientX, clientY}) {
    const box = this.canvas.getBoundingClientRect(), at = new Vector3();
    let best = null, nearest = k_near;
    for (const light of this.pictures.lights) {
      at.setFromMatrixPosition(light.matrixWorld).project(this.camera);
      if (Math.abs(at.z) > 1) continue;
      const far = Math.hypot(box.x + (at.x + 1) / 2 * box.width - clientX, box.y + (1 - at.y) / 2 * box.height - clientY);
      if (far < nearest) [best, nearest] = [light, far];
    }
    if (best) this.#tell('chosen', best);
  }

  #onKey(event) {
    const offset = new Vector3().subVectors(this.camera.position, this.orbit.target), at = new Spherical().setFromVector3(offset);
    const changes = {ArrowLeft: () => at.theta -= k_turn, ArrowRight: () => at.theta += k_turn, ArrowUp: () => at.phi -= k_turn,
                     ArrowDown: () => at.phi += k_turn, '+': () => at.radius /= 1.1, '=': () => at.radius /= 1.1, '-': () => at.radius *= 1.1};
    if (!changes[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    changes[event.key]();
    this.camera.position.copy(this.orbit.target).add(offset.setFromSpherical(at.makeSafe()));
    this.orbit.update();
    this.invalidate();
  }

  /// Shows a scene: its root, its camera, or null, and our lights in `world`.
  setScene(content, camera, bounds) {
    this.content = content;
    this.#isStill = false;
    this.world.add(content);
    const size = bounds.isEmpty() ? 1 : bounds.getSize(new Vector3()).length() || 1, middle = bounds.isEmpty() ? new Vector3() : bounds.getCenter(new Vector3());
    if (camera?.isPerspectiveCamera) {
      camera.matrixWorld.decompose(this.camera.position, this.camera.quaternion, this.camera.scale);
      this.camera.scale.set(1, 1, 1);
      [this.fov, this.wide] = [camera.fov, camera.aspect];
      // It turns around what it looks at: the point of its axis that is nearest to the middle of the scene.
      const forward = this.camera.getWorldDirection(new Vector3());
      const far = Math.max(middle.sub(this.camera.position).dot(forward), 0.05 * size);
      this.orbit.target.copy(this.camera.position).addScaledVector(forward, far);
    } else {
      [this.fov, this.wide] = [35, 0];
      this.camera.position.copy(middle).add(new Vector3(0.5, 0.35, 1).setLength(0.62 * size / Math.tan(this.fov * Math.PI / 360)));
      this.orbit.target.copy(middle);
    }
    this.camera.near = size / 2000;
    this.camera.far = 20 * size;
    this.orbit.update();
    this.scale = size;
  }

  /// A copy of where one looks from, to take up later.
  get place() { return {position: this.camera.position.clone(), target: this.orbit.target.clone(), fov: this.fov, wide: this.wide}; }
  set place({position, target, fov, wide}) {
    this.camera.position.copy(position);
    this.orbit.target.copy(target);
    Object.assign(this, {fov, wide});
    this.orbit.update();
  }

  addLight(light) {
    if (light.parent !== this.content) this.content.add(light);
    this.pictures.lights.push(light);
    const helper = new AreaLightHelper(light, new Color(0xffffff));
    Object.assign(helper.material, {depthTest: false, transparent: true, opacity: 0.45});
    this.helpers.set(light, helper);
    this.overlay.add(helper);
  }

  #forget(light) {
    if (this.selected === light) this.select(null);
    this.pictures.lights = this.pictures.lights.filter(other => other !== light);
    this.helpers.get(light).removeFromParent();
    this.helpers.get(light).dispose();
    this.helpers.delete(light);
  }

  removeLight(light) {
    this.#forget(light);
    light.removeFromParent();
    this.invalidate();
  }

  select(light) {
    this.selected = light;
    if (light) this.gizmo.attach(light);
    else this.gizmo.detach();
    for (const [one, helper] of this.helpers) {
      helper.color = one === light ? k_selected : new Color(0xffffff);
      helper.material.opacity = one === light ? 1 : 0.45;
    }
    this.#request();
  }

  /// Whether what is shown is of the scene as it is, with all of its pixels; rays may follow.
  get isStill() { return this.#isStill; }

  /// The scene, its lights or the camera have changed.
  invalidate() {
    this.#move();
    this.#request();
  }

  // All pixels follow when nothing has moved for a while.
  #move() {
    this.pictures.change();
    this.#moving = true;
    this.#isStill = false;
    clearTimeout(this.#still);
    this.#still = setTimeout(() => {
      this.#moving = false;
      this.pictures.change();
      this.#request();
    }, k_still);
  }

  #request() {
    if (this.#wanted) return;
    this.#wanted = true;
    requestAnimationFrame(() => {
      this.#wanted = false;
      if (this.content && !this.#isLost) this.#draw();
    });
  }

  // One picture after the other.
  async #draw() {
    if (this.#isDrawing) return setTimeout(() => this.#request());
    this.#isDrawing = true;
    try {
      await this.#drawNow();
    } catch (error) {
      if (!this.#isLost) throw error;
    } finally {
      this.#isDrawing = false;
    }
  }

  async #drawNow() {
    const begin = performance.now(), {renderer, camera, content} = this;
    this.#fit(this.#moving ? this.#share : 1);
    this.pictures.isSmooth = !this.#moving;
    this.pictures.draw(camera, this.size.x, this.size.y);
    this.#drawOverlay();
    const isStill = !this.#moving;
    await finish(renderer);
    const took = performance.now() - begin;
    this.#isStill = isStill && !this.#moving && content === this.content;
    if (this.#moving && took > k_slow && this.#share > 0.3) this.#share = Math.max(this.#share * Math.sqrt(k_slow / took), 0.25);
    else if (this.#moving && took < k_slow / 4) this.#share = Math.min(this.#share * 1.2, 1);
    if (!this.pictures.isDone) setTimeout(() => this.#request(), took > k_slow ? took / 3 : 0); // the page breathes
    this.#tell('drawn');
    if (this.pictures.view.startsWith('error') && (this.pictures.isDone || performance.now() - this.#measured > 700)) {
      this.#measured = performance.now();
      this.pictures.measure().then(() => this.#tell('measured'));
    }
  }

  #fit(share) {
    const {canvas, renderer, camera} = this, ratio = Math.min(devicePixelRatio, 2) * share;
    const width = Math.max(Math.round(canvas.clientWidth * ratio), 1), height = Math.max(Math.round(canvas.clientHeight * ratio), 1);
    if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
    this.size.set(width, height);
    camera.aspect = canvas.clientWidth / Math.max(canvas.clientHeight, 1);
    // What the scene's own camera sees is seen in a narrower picture too.
    camera.fov = 360 / Math.PI * Math.atan(Math.tan(this.fov * Math.PI / 360) * Math.max(this.wide / camera.aspect, 1));
    camera.updateProjectionMatrix();
    this.world.updateMatrixWorld();
    camera.updateMatrixWorld();
  }

  #drawOverlay() {
    if (!this.showsLights) return;
    for (const helper of this.helpers.values()) helper.update();
    this.renderer.autoClear = false;
    this.renderer.render(this.overlay, this.camera);
    this.renderer.autoClear = true;
  }

  /// A factor from nits that suits the scene, or null where nothing is lit.
  async measureExposure() {
    const {pictures} = this, {view, castShadows} = pictures;
    this.#fit(this.#share);
    Object.assign(pictures, {view: 'ltc', castShadows: false, isSmooth: false});
    pictures.draw(this.camera, this.size.x, this.size.y);
    Object.assign(pictures, {view, castShadows});
    return pictures.measureExposure();
  }

  /// After measureExposure: what it has drawn, by the exposure that was set since.
  showMeasured() {
    if (this.pictures.view !== 'ltc' || this.pictures.castShadows) return this.invalidate();
    this.#move();
    this.pictures.display();
    this.#drawOverlay();
    this.#tell('drawn');
  }

  /// The picture without outlines, as a Blob. What is shown is drawn anew.
  picture(type = 'image/png') {
    this.#fit(1);
    this.pictures.isSmooth = true;
    this.pictures.draw(this.camera, this.size.x, this.size.y);
    const made = new Promise(resolve => this.canvas.toBlob(resolve, type)); // taken at once
    this.#request();
    return made;
  }

  /// The bounds of what is seen.
  static boundsOf(content) { return new Box3().setFromObject(content); }

  /// Empties the stage. Returns what was on it, lights and all, or null.
  clear() {
    for (const light of [...this.pictures.lights]) this.#forget(light);
    this.pictures.forget();
    const {content} = this;
    this.content = null;
    content?.removeFromParent();
    return content;
  }
}
