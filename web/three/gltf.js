// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Lights of glTF files, as `openltc render` reads them: EXT_lights_area, and openltc_light in a node's extras.

import {Color, LoaderUtils, Object3D, SRGBColorSpace, TextureLoader} from 'three';
import {DiskLight, EllipseLight, PolygonLight, RectLight} from './flat_lights.js';
import {LineLight, SphereLight, TubeLight} from './round_lights.js';

const extension = 'EXT_lights_area', own = 'openltc_light', prefix = 'openltc_';

// The properties of a light, each asked for by name.
class Properties {
  constructor(values) {
    this.values = values;
    this.asked = new Set(['type']);
  }

  get(name, otherwise) {
    this.asked.add(name);
    return this.values[name] ?? otherwise;
  }

  positive(name) {
    const value = this.get(name);
    if (!(Number.isFinite(value) && value > 0)) throw new Error(`${name} must be a number above 0`);
    return value;
  }

  notNegative(name, otherwise) {
    const value = this.get(name, otherwise);
    if (!(Number.isFinite(value) && value >= 0)) throw new Error(`${name} must be a number, 0 or more`);
    return value;
  }

  color() {
    const color = this.get('color', [1, 1, 1]);
    if (!(Array.isArray(color) && color.length === 3 && color.every(c => Number.isFinite(c) && c >= 0)))
      throw new Error('color must be three numbers, 0 or more');
    return new Color().setRGB(...color);
  }

  checkAllKnown() {
    for (const name in this.values)
      if (!this.asked.has(name)) throw new Error(`this light cannot have "${name}" here`);
  }
}

// A light of each type, and its area as seen from where its intensity is meant: along its normal, or across it.
const types = {
  rect: p => new RectLight(undefined, 1, p.positive('width'), p.positive('height'), !!p.get('two_sided')),
  disk: p => new DiskLight(undefined, 1, p.positive('radius'), !!p.get('two_sided')),
  ellipse: p => new EllipseLight(undefined, 1, p.positive('radius_x'), p.positive('radius_y'), !!p.get('two_sided')),
  polygon: p => new PolygonLight(undefined, 1, p.get('points', []), p.get('holes', []), !!p.get('two_sided')),
  sphere: p => new SphereLight(undefined, 1, p.positive('radius')),
  tube: p => new TubeLight(undefined, 1, p.positive('length'), p.positive('radius'), p.get('caps', 'round')),
  line: p => new LineLight(undefined, 1, p.positive('length')),
};

function areaFromAside(light) {
  if (light.shape === 'sphere') return Math.PI * light.radius ** 2;
  if (light.shape !== 'tube') return light.emittingArea() / light.sides;
  return 2 * light.radius * light.length + (light.caps === 'round' ? Math.PI * light.radius ** 2 : 0);
}

// Brightness may be of the whole light, whose size in the world is known at the end: a function of the light's scale.
function brightnessOf(p, light) {
  const given = ['luminance_nits', 'flux_lumens', 'intensity_candela'].filter(name => p.values[name] !== undefined);
  if (given.length !== 1) throw new Error('one of luminance_nits, flux_lumens, intensity_candela must be given');
  const value = p.notNegative(given[0]), exposure = p.get('exposure', 0), isLine = light.shape === 'line';
  if (!Number.isFinite(exposure)) throw new Error('exposure must be a number');
  light.color = p.color().multiplyScalar(2 ** exposure);
  p.checkAllKnown();
  switch (given[0]) {
    case 'luminance_nits':
      if (isLine) throw new Error('a line has no luminance_nits');
      return () => light.luminance = value;
    case 'flux_lumens':
      return scale => light.power = isLine ? value : value / scale ** 2;
    default:
      return scale => light.intensity = isLine ? value : value / (areaFromAside(light) * scale ** 2);
  }
}

// openltc_light as an object, as its text, or as its type with the others beside it, openltc_ before their names.
function propertiesOf(extras) {
  const value = extras[own];
  if (typeof value !== 'string') return value;
  if (value.trimStart().startsWith('{')) return JSON.parse(value);
  const elsewhere = ['openltc_light', 'openltc_emits_light', 'openltc_surface_deviation'];
  const others = Object.entries(extras).filter(([name]) => name.startsWith(prefix) && !elsewhere.includes(name));
  return {type: value, ...Object.fromEntries(others.map(([name, other]) => [name.slice(prefix.length), other]))};
}

// A light of EXT_lights_area in the words of openltc_light.
function fromExtension({type, size = 1, intensity = 1000, rect: {aspect = 1} = {}, color = [1, 1, 1]}) {
  const light = {type, luminance_nits: intensity, color};
  return type === 'disk' ? {...light, radius: size / 2} : {...light, width: size * aspect, height: size};
}

/// A plugin of GLTFLoader: loader.register(parser => new GLTFAreaLights(parser)). What it cannot read is left out with
/// a warning on the console. enableAreaLights of the scene remains to be called.
export class GLTFAreaLights {
  constructor(parser) {
    this.parser = parser;
    this.name = extension;
    this.brightness = new Map();
  }

  /// Called by GLTFLoader for each node; the node gets the light.
  createNodeAttachment(index) {
    const sources = this.sourcesOf(index);
    return sources.length === 0 ? null : this.makeLights(sources, this.parser.json.nodes[index].name);
  }

  // What describes lights of a node: which field it is, and a function that reads it.
  sourcesOf(index) {
    const {json} = this.parser, node = json.nodes[index], reference = node.extensions?.[extension]?.light;
    const sources = [];
    if (reference !== undefined)
      sources.push([`extensions.${extension}.lights[${reference}]`, () => {
        const light = json.extensions?.[extension]?.lights?.[reference];
        if (light?.type !== 'rect' && light?.type !== 'disk') throw new Error('it is no rect and no disk');
        return fromExtension(light);
      }]);
    if (node.extras?.[own] !== undefined) sources.push([`nodes[${index}].extras.${own}`, () => propertiesOf(node.extras)]);
    return sources;
  }

  async makeLights(sources, name) {
    const made = await Promise.all(sources.map(([field, read]) => this.makeLight(field, read, name)));
    const lights = made.filter(Boolean);
    if (lights.length === 0) return new Object3D(); // GLTFLoader wants one
    for (const other of lights.slice(1)) lights[0].add(other);
    return lights[0];
  }

  async makeLight(field, read, name) {
    try {
      const p = new Properties(read() ?? {});
      if (!Object.hasOwn(types, p.values.type)) throw new Error(`type "${p.values.type}" is no light with an area`);
      const light = types[p.values.type](p);
      light.name = name ?? '';
      const picture = light.texture === null ? p.get('texture') : undefined, brightness = brightnessOf(p, light);
      if (picture !== undefined) light.texture = await this.loadPicture(picture);
      this.brightness.set(light, brightness);
      return light;
    } catch (error) {
      console.warn(`openltc-three: ${field}: ${error.message}; the light is left out`);
      return null;
    }
  }

  async loadPicture(name) {
    if (typeof name !== 'string' || !/\.(png|jpe?g|webp)$/i.test(name))
      throw new Error(`texture "${name}" is no .png, .jpg or .webp`);
    const {path, manager, crossOrigin} = this.parser.options;
    const loader = new TextureLoader(manager).setCrossOrigin(crossOrigin), url = LoaderUtils.resolveURL(name, path);
    const texture = await loader.loadAsync(url).catch(() => { throw new Error(`texture "${name}" cannot be read`); });
    return Object.assign(texture, {name, colorSpace: SRGBColorSpace});
  }

  /// Called by GLTFLoader at the end.
  afterRoot(gltf) {
    for (const scene of gltf.scenes) scene.updateMatrixWorld(true);
    for (const [light, set] of this.brightness) set(light.frame().scale);
    return null;
  }
}
