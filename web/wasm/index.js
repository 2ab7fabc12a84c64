// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The fitter of OpenLTC in a page, a worker or Node. index.d.ts documents what is exported.

import {OpenltcError, bytesOf, checked, compileModule, describe, instantiate} from './module.js';

export {OpenltcError};
export {loadLightReader} from './lights.js';

const forms = ['table', 'two-lobe', 'polynomial', 'two-lobe-polynomial'];

// Of what a batch function returned, or left in `out`, the first thing that is no number.
function takeValues(returned, out) {
  if (returned === undefined || returned === out) return;
  if (typeof returned === 'object' && returned !== null && typeof returned.then === 'function')
    throw new OpenltcError('it returned a promise; it has to give its values at once');
  if (!Array.isArray(returned) && !ArrayBuffer.isView(returned))
    throw new OpenltcError(`it returned ${describe(returned)}; fill out, or return an array of ${out.length} numbers`);
  if (returned.length !== out.length)
    throw new OpenltcError(`it returned ${returned.length} values for ${out.length} directions`);
  for (let i = 0; i < out.length; ++i) {
    if (typeof returned[i] !== 'number')
      throw new OpenltcError(`value ${i} that it returned is ${describe(returned[i])}, not a number`);
    out[i] = returned[i];
  }
}

/// Fits, of one module. A module that ends, for lack of memory, is replaced by the next call.
class Openltc {
  #compiled;
  #module = null;
  #generation = 0;
  #failed = null; // what the BRDF's function threw
  #current = null;
  #progress = null;
  #catalogue;

  constructor(compiled) {
    this.#compiled = compiled;
    const {json, read} = this.#answer({call: 'catalogue'}, {});
    for (const name in json.colormaps) json.colormaps[name] = floats(read(json.colormaps[name]));
    this.#catalogue = json;
  }

  get version() { return this.#catalogue.version; }
  get brdfs() { return this.#catalogue.brdfs; }
  get layouts() { return this.#catalogue.layouts; }
  get engines() { return this.#catalogue.engines; }
  get colormaps() { return this.#catalogue.colormaps; }
  get memoryBytes() { return this.#module?.memory.buffer.byteLength ?? 0; }

  fit(options = {}) {
    if (typeof options !== 'object' || options === null) throw new OpenltcError('fit takes an object of options');
    const request = {call: 'fit'};
    for (const name of ['form', 'objective', 'layout', 'precision', 'refine', 'engine']) {
      const value = checked(options, name, 'string');
      if (value !== undefined) request[name] = value;
    }
    for (const name of ['size', 'degree']) {
      const value = checked(options, name, 'number');
      if (value !== undefined) request[name] = value;
    }
    request.clipAware = checked(options, 'clipAware', 'boolean', false);
    if (request.form !== undefined && !forms.includes(request.form))
      throw new OpenltcError(`form "${request.form}" is not known; take ${forms.join(', ')}`);
    const {description, evaluate, bytes} = describeBrdf(options.brdf ?? 'ggx');
    request.brdf = description;
    const {json, read} = this.#answer(request, {evaluate, bytes, progress: checked(options, 'progress', 'function')});
    const generation = this.#generation;
    return new Fit(json, read, (call, more) => {
      if (generation !== this.#generation) throw new OpenltcError('the module ended since this fit was made; fit again');
      return this.#answer({call, id: json.id, ...more}, {evaluate});
    }, () => {
      if (generation === this.#generation) this.#ask({call: 'free', id: json.id});
    });
  }

  #ask(request) { return this.#answer(request, {}).json; }

  // The answer's JSON, and a function that copies its bytes, which the next request overwrites.
  #answer(request, {evaluate, bytes, progress}) {
    if (this.#current !== null) throw new OpenltcError('a fit is under way; a BRDF or progress function cannot ask for another');
    this.#module ??= this.#instantiate();
    const {exports, memory} = this.#module;
    this.#current = {name: request.brdf?.name ?? 'function', evaluate};
    this.#progress = progress ?? null;
    this.#failed = null;
    const taken = [];
    const put = (data) => {
      const at = exports.openltc_take(data.length) >>> 0;
      if (at === 0 && data.length > 0) throw new OpenltcError('out of memory');
      taken.push(at);
      new Uint8Array(memory.buffer, at, data.length).set(data);
      return at;
    };
    let json;
    try {
      if (bytes) Object.assign(request.brdf, {at: put(bytes), size: bytes.length});
      const text = new TextEncoder().encode(JSON.stringify(request));
      exports.openltc_ask(put(text), text.length);
      for (const at of taken) exports.openltc_give(at);
      json = JSON.parse(new TextDecoder().decode(
          new Uint8Array(memory.buffer, exports.openltc_answer() >>> 0, exports.openltc_answer_size() >>> 0)));
    } catch (error) {
      // A trap: what the module was doing is lost, and so are its fits.
      this.#module = null;
      ++this.#generation;
      if (error instanceof OpenltcError) throw error;
      throw new OpenltcError(`the fitter ended: ${error.message}; is there enough memory?`, {cause: error});
    } finally {
      this.#current = null;
      this.#progress = null;
    }
    if (this.#failed !== null) {
      const {name, error} = this.#failed;
      this.#failed = null;
      const message = error instanceof OpenltcError ? error.message : `it threw ${error?.message !== undefined ?
          `${error.name ?? 'Error'}: ${error.message}` : describe(error)}`;
      throw new OpenltcError(`brdf ${name}: ${message}`, {cause: error});
    }
    if (json.error !== undefined) throw new OpenltcError(json.error);
    const read = (i) => {
      const at = exports.openltc_bytes(i) >>> 0, size = exports.openltc_bytes_size(i) >>> 0;
      return new Uint8Array(memory.buffer, at, size).slice();
    };
    return {json, read};
  }

  #instantiate() {
    return instantiate(this.#compiled, {
      brdf: (x, y, z, wi, count, roughness, values, memory) => {
        const out = new Float64Array(memory.buffer, values, count);
        if (this.#failed !== null) return void out.fill(NaN);
        try {
          const given = new Float64Array(count);
          takeValues(this.#current.evaluate([x, y, z], new Float64Array(memory.buffer, wi, 3 * count).slice(),
                                            roughness, given), given);
          new Float64Array(memory.buffer, values, count).set(given);
        } catch (error) {
          this.#failed = {name: this.#current.name, error};
          new Float64Array(memory.buffer, values, count).fill(NaN);
        }
      },
      progress: (share) => {
        if (this.#failed !== null) return 0;
        if (this.#progress === null) return 1;
        try {
          return this.#progress(share) === false ? 0 : 1;
        } catch (error) {
          this.#failed = {name: this.#current.name, error};
          return 0;
        }
      },
    });
  }
}

// A BRDF as the module is told of it.
function describeBrdf(brdf) {
  if (typeof brdf === 'string') return {description: {name: brdf}};
  if (typeof brdf === 'function') brdf = {evaluate: brdf};
  if (typeof brdf !== 'object' || brdf === null)
    throw new OpenltcError(`brdf is ${describe(brdf)}; it is a name, {merl: bytes} or {evaluate: function}`);
  const name = checked(brdf, 'name', 'string');
  if (brdf.merl !== undefined) {
    return {description: {name: name ?? 'material.binary'}, bytes: bytesOf(brdf.merl, 'merl')};
  }
  if (typeof brdf.evaluate !== 'function')
    throw new OpenltcError(`evaluate is ${describe(brdf.evaluate)}; it is a function of (wo, wi, roughness, out)`);
  const width = checked(brdf, 'width', 'string', 'alpha');
  if (width !== 'alpha' && width !== 'one') throw new OpenltcError(`width "${width}" is not known; take alpha or one`);
  return {
    description: {function: true, name: name ?? 'function', width, parameter: checked(brdf, 'parameter', 'boolean', true)},
    evaluate: brdf.evaluate,
  };
}

const floats = (bytes) => new Float32Array(bytes.buffer);

/// Lobes that were fitted.
class Fit {
  #call;
  #free;

  constructor(json, read, call, free) {
    for (const name of ['brdf', 'width', 'layout', 'precision', 'objective', 'command', 'note', 'warning', 'seconds', 'mean', 'max'])
      this[name] = json[name];
    this.columns = json.columns ?? 0;
    this.rows = json.rows ?? 0;
    this.textures = (json.textures ?? []).map((t) => ({...t, values: floats(read(t.values))}));
    this.map = {...json.map, tv: floats(read(json.map.tv)), albedo: floats(read(json.map.albedo))};
    this.#call = call;
    this.#free = free;
  }

  files(path = '') {
    const {json, read} = this.#ask('files', {path});
    return json.files.map((name, i) => ({name, bytes: read(i)}));
  }

  report({lights = 2000, limit = false} = {}) {
    return JSON.parse(new TextDecoder().decode(this.#ask('report', {lights, limit}).read(0)));
  }

  cells({roughness, thetaDegrees, side = 120}) {
    const {json, read} = this.#ask('cells', {roughness: [...roughness], thetaDegrees: [...thetaDegrees], side});
    return json.cells.map((cell) => ({...cell, side, brdf: floats(read(cell.brdf)), lobe: floats(read(cell.lobe))}));
  }

  polygon({roughness, thetaDegrees, corners, samples = 400}) {
    return this.#ask('polygon', {roughness, thetaDegrees, corners: corners.flat(), samples}).json;
  }

  free() {
    this.#free?.();
    this.#free = null;
  }

  #ask(call, more) {
    if (this.#free === null) throw new OpenltcError('this fit was freed');
    return this.#call(call, more);
  }
}

/// Loads the module. In a page it is fetched from beside this file, in Node read from there.
export async function loadOpenltc(options = {}) {
  return new Openltc(await compileModule('openltc.wasm', options.wasm));
}
