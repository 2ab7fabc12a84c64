// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The polygon as the point on the floor sees it, and what M^-1 makes of it; and its corners to be dragged, in
// the picture and in the figure.

import {cornersOf, meetPlane} from './polygon_light.js';
import {dotsPath, fromDisc, horizonPath, outlinePath, toDisc} from './disc_view.js';

const k_space = 'http://www.w3.org/2000/svg';
const k_step = 0.05; // of an arrow key, in metres

function element(name, attributes, parent) {
  const made = document.createElementNS(k_space, name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  parent?.append(made);
  return made;
}

/// One of the two discs: the picture of a density, the polygon over it, what is kept of it, and samples; `horizon`
/// is the normal of the other space's.
export function drawSpace(svg, {density, space, horizon}) {
  // Handles stay until they are drawn anew: one of them may have the focus.
  for (const old of [...svg.children]) if (!old.classList.contains('handle')) old.remove();
  const id = svg.id + '-inside';
  element('circle', {r: 1}, element('clipPath', {id}, svg));
  element('image', {href: density, x: -1, y: -1, width: 2, height: 2, 'clip-path': `url(#${id})`}, svg);
  element('circle', {r: 1, fill: 'none', stroke: 'var(--soft)', 'stroke-width': 0.008}, svg);
  if (horizon) element('path', {d: horizonPath(horizon), fill: 'none', stroke: 'var(--soft)', 'stroke-width': 0.008, 'stroke-dasharray': '0.03 0.03'}, svg);
  if (!space) return;
  const samples = (inside) => space.samples.filter((_, i) => space.inside[i] === inside);
  const whole = outlinePath(space.corners), kept = outlinePath(space.kept), join = {'stroke-linejoin': 'round'};
  element('path', {d: dotsPath(samples(false), 0.01), fill: '#000', 'fill-opacity': 0.45}, svg);
  element('path', {d: whole, fill: 'none', stroke: 'var(--accent)', 'stroke-width': 0.014, 'stroke-dasharray': '0.04 0.03'}, svg);
  element('path', {d: kept, fill: '#fff', 'fill-opacity': 0.16, stroke: '#000', 'stroke-opacity': 0.7, 'stroke-width': 0.045, ...join}, svg);
  element('path', {d: kept, fill: 'none', stroke: '#fff', 'stroke-width': 0.02, ...join}, svg);
  element('path', {d: dotsPath(samples(true), 0.014), fill: '#fff', stroke: '#000', 'stroke-opacity': 0.5, 'stroke-width': 0.006}, svg);
}

/// The density of the lobe of a matrix M^-1, nine numbers by rows, over the disc, three decades: the address of a
/// picture. For null an empty disc.
export function lobePicture(matrix, colours) {
  const side = 160, canvas = document.createElement('canvas');
  canvas.width = canvas.height = side;
  const density = Array.from({length: side * side}, (_, i) => {
    const [x, y, z] = fromDisc([2 * (i % side + 0.5) / side - 1, 1 - 2 * (Math.floor(i / side) + 0.5) / side]);
    if (matrix === null || z <= 0) return 0;
    const o = [0, 3, 6].map((row) => matrix[row] * x + matrix[row + 1] * y + matrix[row + 2] * z);
    return Math.max(o[2], 0) / (o[0] * o[0] + o[1] * o[1] + o[2] * o[2]) ** 2; // times det / pi
  });
  const most = density.reduce((a, b) => Math.max(a, b), 1e-30);
  // Not one of the graphics processor: to read that, the page would wait for all pictures that are under way there.
  const context = canvas.getContext('2d', {willReadFrequently: true}), image = context.createImageData(side, side);
  density.forEach((d, i) => {
    const at = 3 * Math.round(255 * Math.max(0, 1 + Math.log10(Math.max(d / most, 1e-9)) / 3));
    for (let c = 0; c < 3; ++c) image.data[4 * i + c] = 255 * colours.viridis[at + c];
    image.data[4 * i + 3] = 255;
  });
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}

/// Handles over a picture. `places(light)` gives the corners in the coordinates of the svg, null where one is not
/// seen; `meet(x, y, light)` the point of the light's plane at a place, null where it is not met.
export class Handles {
  #svg;
  #light;
  #dragged = null; // {corner, from, outline, pointer}
  #options;

  constructor(svg, options) {
    this.#svg = svg;
    this.#options = options;
    svg.addEventListener('pointerdown', (event) => this.#begin(event));
    svg.addEventListener('pointermove', (event) => this.#move(event));
    for (const name of ['pointerup', 'pointercancel']) svg.addEventListener(name, () => this.#dragged = null);
    svg.addEventListener('keydown', (event) => this.#key(event));
  }

  draw(light) {
    this.#light = light;
    const places = this.#options.places(light), focused = document.activeElement?.dataset?.corner;
    const own = this.#svg.contains(document.activeElement);
    if (!this.#options.keep) this.#svg.replaceChildren();
    else for (const old of this.#svg.querySelectorAll('.handle')) old.remove();
    if (places.every((p) => p !== null))
      element('polygon', {class: 'handle', points: places.map((p) => p.join(',')).join(' '), fill: 'transparent', style: 'cursor: move'}, this.#svg);
    places.forEach((place, i) => {
      if (place === null) return;
      const [x, y] = place;
      const circle = element('circle', {class: 'handle', cx: x, cy: y, r: this.#options.radius, 'data-corner': i, tabindex: 0, role: 'button',
                                        fill: '#1d1c1a', stroke: '#fff', 'stroke-width': this.#options.radius / 3, style: 'cursor: grab',
                                        'aria-label': `Corner ${i + 1}`}, this.#svg);
      if (own && focused === String(i)) circle.focus();
    });
  }

  // The place of an event in the coordinates of the svg.
  #place(event) {
    const matrix = this.#svg.getScreenCTM();
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return [point.x, point.y];
  }

  #begin(event) {
    const corner = event.target.dataset?.corner;
    if (!event.target.classList.contains('handle')) return;
    const from = this.#options.meet(...this.#place(event), this.#light);
    if (from === null) return;
    event.preventDefault();
    this.#svg.setPointerCapture(event.pointerId);
    if (corner !== undefined) event.target.focus();
    this.#dragged = {corner: corner === undefined ? -1 : Number(corner), from, outline: this.#light.outline};
  }

  #move(event) {
    if (this.#dragged === null) return;
    const {corner, from, outline} = this.#dragged;
    const to = this.#options.meet(...this.#place(event), this.#light);
    if (to === null) return;
    this.#set(outline, corner, to[0] - from[0], to[1] - from[1]);
  }

  #key(event) {
    const corner = event.target.dataset?.corner;
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    if (corner === undefined || !step) return;
    event.preventDefault();
    this.#set(this.#light.outline, event.shiftKey ? -1 : Number(corner), -step[0] * k_step, step[1] * k_step);
  }

  #set(outline, corner, dx, dy) {
    const limit = (x) => Math.min(Math.max(x, -6), 6);
    this.#options.changed(outline.map(([x, y], i) =>
        corner === -1 || i === corner ? [limit(x + dx), limit(y + dy)] : [x, y]));
  }
}

/// Of the figure: where corners are in the disc, and back.
export const discPlaces = {
  places: (light) => cornersOf(light).map((p) => {
    const [x, y] = toDisc(p);
    return [x, -y];
  }),
  meet: (x, y, light) => meetPlane(light, [0, 0, 0], fromDisc([x, -y])),
};
