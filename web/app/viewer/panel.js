// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The list of lights and the fields of the one that is chosen.

import {Color, Euler, SRGBColorSpace} from 'three';
import {kinds, resize, titleOf} from './light_kinds.js';

const degree = Math.PI / 180;
const rounded = (x, digits = 4) => String(Math.abs(x) < 1e-6 ? 0 : Number(x.toPrecision(digits)));

function element(tag, properties, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

// The colour as a page writes it; what is brighter than its white, or negative, is not.
const hexOf = color => `#${new Color(...color.toArray().map(c => Math.min(Math.max(c, 0), 1))).getHexString(SRGBColorSpace)}`;

// A place turned about y, then x, then z: which way a light faces, up or down, and its own spin.
const orientationOf = light => new Euler().setFromQuaternion(light.quaternion, 'YXZ');

export class Panel {
  #light = null;
  #writers = []; // that set the fields from the light

  /// `changed(light)` is called after a field has.
  constructor(list, form, {chosen, changed}) {
    Object.assign(this, {list, form, chosen, changed});
    form.addEventListener('submit', event => event.preventDefault());
  }

  /// Lists lights.
  show(lights, selected) {
    this.list.replaceChildren(...lights.map(light => {
      const button = element('button', {type: 'button', onclick: () => this.chosen(light)},
          element('i', {}), element('span', {className: 'name', textContent: light.name || titleOf(light)}),
          element('span', {className: 'what', textContent: titleOf(light)}));
      button.querySelector('i').style.background = hexOf(light.color);
      button.setAttribute('aria-pressed', String(light === selected));
      return element('li', {}, button);
    }));
    if (selected !== this.#light) this.#make(selected);
    this.write();
  }

  /// Writes the fields anew, but for the one that is typed into.
  write() {
    for (const write of this.#writers) write();
  }

  #make(light) {
    this.#light = light;
    this.#writers = [];
    this.form.replaceChildren();
    this.form.hidden = !light;
    if (!light) return;
    const set = change => {
      change();
      this.changed(light);
    };
    const number = (label, id, get, put, {min, step = 'any', digits} = {}) => {
      const input = element('input', {type: 'number', step, id, ariaLabel: label});
      input.addEventListener('input', () => {
        const value = Number(input.value);
        const isGood = input.value !== '' && Number.isFinite(value) && (min === undefined || value >= min) && Math.abs(value) <= 1e9;
        input.ariaInvalid = String(!isGood);
        if (isGood) set(() => put(value));
      });
      input.addEventListener('change', () => {
        input.ariaInvalid = 'false';
        input.value = rounded(get(), digits);
      });
      this.#writers.push(() => {
        if (document.activeElement !== input) input.value = rounded(get(), digits);
      });
      return input;
    };
    const row = (label, ...fields) => this.form.append(element('div', {className: 'row'}, element('span', {textContent: label}),
        fields.length > 1 ? element('span', {className: 'three'}, ...fields) : fields[0]));
    const name = element('input', {type: 'text', value: light.name, ariaLabel: 'Name', id: 'light-name', maxLength: 80});
    name.addEventListener('input', () => set(() => light.name = name.value));
    row('Name', name);
    row('Place, m', ...['x', 'y', 'z'].map(axis => number(`Place ${axis}, metres`, `place-${axis}`, () => light.position[axis], v => light.position[axis] = v, {step: 0.05})));
    row('Turn, °', ...[['y', 'Turn'], ['x', 'Tilt'], ['z', 'Roll']].map(([axis, label]) => number(`${label}, degrees`, `turn-${axis}`,
        () => orientationOf(light)[axis] / degree, v => {
          const turned = orientationOf(light);
          turned[axis] = v * degree;
          light.quaternion.setFromEuler(turned);
        }, {step: 1, digits: 3})));
    for (const [property, label] of kinds[light.type].fields)
      row(`${label}, m`, number(`${label}, metres`, `size-${property}`, () => light[property], v => resize(light, {[property]: v}), {min: 0.001, step: 0.01}));
    if (light.type === 'PolygonLight') {
      const extent = () => Math.max(...[0, 1].map(k => Math.max(...light.outline.rings[0].map(p => p[k])) - Math.min(...light.outline.rings[0].map(p => p[k]))));
      row('Extent, m', number('Extent, metres', 'size-extent', extent,
          v => resize(light, kinds.PolygonLight.stretched(light, v / extent(), v / extent())), {min: 0.001, step: 0.01}));
    }
    row(light.type === 'LineLight' ? 'Intensity, cd' : 'Luminance, nits', number(light.type === 'LineLight' ? 'Intensity, candela' : 'Luminance, nits',
        'luminance', () => light.intensity, v => light.intensity = v, {min: 0, step: 'any'}));
    const color = element('input', {type: 'color', id: 'color', ariaLabel: 'Colour'});
    color.addEventListener('input', () => set(() => light.color.set(color.value)));
    this.#writers.push(() => color.value = hexOf(light.color));
    row('Colour', color);
    if (kinds[light.type].flat) {
      const sides = element('input', {type: 'checkbox', id: 'two-sided', checked: light.twoSided});
      sides.addEventListener('change', () => set(() => light.twoSided = sides.checked));
      this.form.append(element('label', {className: 'check'}, sides, 'Shines to both sides'));
    }
  }
}
