// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The pictures of a scene: by our closed form, by three.js's own lights, by a reference that sends rays, and how far
// the first two are from it.
//
// The reference is direct light: the sums of openltc-three/webgpu/shadows with `exact`, points of the lights weighed by
// the BRDF itself, and what else the scene shows, drawn without area lights.

import {FloatType, HalfFloatType, NearestFilter, RenderTarget} from 'three';
import {enableAreaLights} from 'openltc-three';
import {Display} from './display.js';
import {readPixels} from './graphics.js';

const k_hidden = 31; // a layer that no camera sees

/// Views and their names.
export const views = {ltc: 'LTC', theirs: 'three.js', reference: 'Reference', error: 'Error of LTC', error_theirs: 'Error of three.js'};
/// Pictures until a view is done.
export const mostFrames = {shadows: 128, reference: 512};

export class Pictures {
  view = 'ltc';
  castShadows = false;
  tonemap = 'neutral';
  exposure = 1;
  most = 8; // steps of 255 that are the brightest in views of an error
  lights = []; // ours
  own = {made: [], others: 0, missing: 0}; // three.js's
  mean = null; // of the difference, in steps of 255, over surfaces
  isSmooth = false;
  #targets = {};
  #isFresh = false; // the pictures that stay while rays are added

  constructor(renderer, world) {
    this.world = world;
    this.setRenderer(renderer);
    enableAreaLights(world);
    this.shadows = null;
  }

  /// Another one, after the first has lost its device.
  setRenderer(renderer) {
    this.renderer = renderer;
    this.screen = new Display(renderer);
    this.#targets = {};
    this.reset();
  }

  /// Fetches what a view needs. To be awaited before it is drawn.
  async prepare(view, castShadows) {
    if (view !== 'ltc' && view !== 'theirs' || (view === 'ltc' && castShadows)) {
      const {enableAreaShadows} = await import('openltc-three/webgpu/shadows');
      this.shadows ??= enableAreaShadows(this.world);
    }
    if (view === 'theirs' || view === 'error_theirs') this.theirs ??= await import('./their_lights.js');
  }

  get isReference() { return !['ltc', 'theirs'].includes(this.view); }
  get sendsRays() { return this.isReference || (this.view === 'ltc' && this.castShadows && this.lights.length > 0); }
  get frames() { return this.sendsRays ? this.shadows.frames : 1; }
  get frame() { return this.sendsRays ? this.shadows.frame : 1; }
  get isDone() { return !this.sendsRays || this.lights.length === 0 || this.shadows.frame >= this.shadows.frames; }

  /// Something of the scene has changed, its lights or the camera.
  change() {
    this.#isFresh = false;
    this.mean = null;
  }

  /// A material has.
  reset() {
    this.change();
    this.shadows?.reset();
  }

  #target(name, width, height, more = {}) {
    const old = this.#targets[name];
    if (old?.width === width && old.height === height) return old;
    old?.dispose();
    return this.#targets[name] = new RenderTarget(width, height, {
      type: FloatType, minFilter: NearestFilter, magFilter: NearestFilter, ...more});
  }

  #render(target, camera, {ours = true, casts = false, theirs = false}) {
    for (const light of this.lights) {
      light.layers.set(ours ? 0 : k_hidden);
      light.castShadow = casts;
    }
    if (theirs) {
      this.own = this.theirs.theirLights(this.lights);
      if (this.own.made.length) this.world.add(...this.own.made);
    }
    this.renderer.setRenderTarget(target);
    this.renderer.render(this.world, camera);
    for (const light of this.own.made) this.world.remove(light);
  }

  // Of radiance by one of the first two views; smooth ones have edges of four samples.
  #picture(width, height) {
    return this.isSmooth ? this.#target('smooth', width, height, {type: HalfFloatType, samples: 4})
                         : this.#target('picture', width, height, {type: HalfFloatType});
  }

  /// Draws the view to the canvas of `width` × `height` pixels, with one more ray a pixel where it sends any.
  draw(camera, width, height) {
    if (this.isReference) this.#drawReference(camera, width, height);
    else {
      const target = this.#picture(width, height);
      if (this.shadows) Object.assign(this.shadows, {exact: false, frames: mostFrames.shadows});
      this.#render(target, camera, this.view === 'theirs' ? {ours: false, theirs: true} : {casts: this.castShadows});
      this.#show('picture', {picture: target.texture});
    }
    this.renderer.setRenderTarget(null);
  }

  /// Displays the picture by LTC that was drawn last once more, with another exposure.
  display() { this.#show('picture', {picture: this.#targets[this.isSmooth ? 'smooth' : 'picture'].texture}); }

  #show(task, values) {
    this.renderer.setRenderTarget(null);
    this.screen.draw(task, this.tonemap, this.exposure, values);
  }

  #drawReference(camera, width, height) {
    const base = this.#target('base', width, height), picture = this.#target('float', width, height);
    Object.assign(this.shadows, {exact: true, frames: mostFrames.reference});
    const byRatio = this.view === 'error' && this.castShadows;
    if (!this.#isFresh) {
      this.#render(base, camera, {ours: false});
      if (this.view === 'error_theirs') this.#render(picture, camera, {ours: false, theirs: true});
      if (this.view === 'error' && !byRatio) this.#render(picture, camera, {});
      this.#isFresh = true;
    }
    // The rays; with their shadows the closed form as well.
    this.#render(byRatio ? picture : this.#target('aside', width, height), camera, {casts: true});
    const rays = this.lights.length ? this.shadows.sums[this.castShadows ? 'shadowed' : 'unshadowed'] : base.texture;
    const values = {base: base.texture, rays, count: this.lights.length ? this.shadows.frame : 1e9, picture: picture.texture};
    if (this.view === 'reference') return this.#show('reference', values);
    const difference = this.#target('difference', width, height);
    this.renderer.setRenderTarget(difference);
    this.screen.draw('difference', this.tonemap, this.exposure, values);
    this.#show('colors', {picture: difference.texture, most: this.most});
  }

  /// The mean difference of the picture that was drawn last, in steps of 255, over pixels with a surface.
  async measure() {
    const {difference} = this.#targets;
    if (!this.view.startsWith('error') || !difference) return this.mean = null;
    const pixels = await readPixels(this.renderer, difference);
    let sum = 0, count = 0;
    for (let i = 0; i < pixels.length; i += 4)
      if (pixels[i + 1] > 0) {
        sum += pixels[i];
        ++count;
      }
    return this.mean = count ? sum / count : 0;
  }

  /// The factor from nits that suits the picture by LTC that was drawn last, or null where nothing is lit: the
  /// geometric mean of what shows no light becomes a fourth of white, and no more than 1 in 50 of that white, if this
  /// takes no more than three stops.
  async measureExposure() {
    const width = 96, height = 54, target = this.#target('small', width, height);
    const picture = this.#targets[this.isSmooth ? 'smooth' : 'picture'];
    this.renderer.setRenderTarget(target);
    this.screen.draw('fewer', 'none', 1, {picture: picture.texture, stepX: picture.width / width, stepY: picture.height / height});
    this.renderer.setRenderTarget(null);
    const pixels = await readPixels(this.renderer, target);
    const nits = this.lights.filter(light => light.type !== 'LineLight').map(light => light.intensity * Math.max(...light.color.toArray()));
    const lamp = Math.min(Infinity, ...nits.filter(x => x > 0)) / 2, lit = [];
    for (let i = 0; i < pixels.length; i += 4) {
      const most = Math.max(pixels[i], pixels[i + 1], pixels[i + 2]);
      if (most > 0 && most < lamp && Number.isFinite(most)) lit.push(most);
    }
    if (lit.length === 0) return null;
    lit.sort((a, b) => a - b);
    const middle = 0.25 / Math.exp(lit.reduce((sum, x) => sum + Math.log(x), 0) / lit.length);
    return Math.max(Math.min(middle, 0.9 / lit[Math.floor(0.98 * (lit.length - 1))]), middle / 8);
  }

  /// Frees what a scene that goes away has held.
  forget() {
    this.lights = [];
    this.own = {made: [], others: 0, missing: 0};
    this.change();
  }
}
