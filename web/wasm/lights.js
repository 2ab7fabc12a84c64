// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The lights of glTF files, by the reader of OpenLTC. index.d.ts documents what is exported.

import {OpenltcError, bytesOf, checked, compileModule, describe, instantiate} from './module.js';

class LightReader {
  #compiled;
  #module = null;

  constructor(compiled) { this.#compiled = compiled; }

  get memoryBytes() { return this.#module?.memory.buffer.byteLength ?? 0; }

  readLights(file, options = {}) {
    if (typeof options !== 'object' || options === null)
      throw new OpenltcError(`readLights takes a file and an object of options, not ${describe(options)}`);
    const bytes = bytesOf(file, 'the file');
    const json = this.#ask({
      name: checked(options, 'name', 'string', 'scene'),
      recogniseShapes: checked(options, 'recogniseShapes', 'boolean', false),
    }, bytes);
    if (json.error !== undefined) throw new OpenltcError(json.error);
    return json;
  }

  #ask(request, bytes) {
    this.#module ??= instantiate(this.#compiled);
    const {exports, memory} = this.#module, taken = [];
    const put = data => {
      const at = exports.openltc_take(data.length) >>> 0;
      if (at === 0 && data.length > 0) throw new Error('out of memory');
      taken.push(at);
      new Uint8Array(memory.buffer, at, data.length).set(data);
      return at;
    };
    try {
      Object.assign(request, {at: put(bytes), size: bytes.length});
      const text = new TextEncoder().encode(JSON.stringify(request));
      exports.openltc_ask(put(text), text.length);
      for (const at of taken) exports.openltc_give(at);
      return JSON.parse(new TextDecoder().decode(
          new Uint8Array(memory.buffer, exports.openltc_answer() >>> 0, exports.openltc_answer_size() >>> 0)));
    } catch (error) {
      this.#module = null; // what it was doing is lost; the next call has another
      throw new OpenltcError(`${request.name}: the reader ended: ${error.message ?? 'an unknown exception'}; ` +
                             'is there enough memory?', {cause: error});
    }
  }
}

/// Loads the reader. In a page it is fetched from beside this file, in Node read from there.
export async function loadLightReader(options = {}) {
  return new LightReader(await compileModule('lights.wasm', options.wasm));
}
