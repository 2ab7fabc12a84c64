// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The worker as the page sees it: calls that answer, a fit that can be ended.

const k_silence = 10000; // ms without a sign of life, after which a BRDF is taken for one that never ends

/// What could not be done, with the line and column of the BRDF's text where that is known, else 0.
export class FitFailure extends Error {
  constructor({message, line = 0, column = 0, syntax = false, cancelled = false}) {
    super(message);
    Object.assign(this, {line, column, syntax, cancelled});
  }
}

export class Fitter {
  #wasm;
  #worker = null;
  #last = 0;
  #waiting = new Map();
  #timer = 0;
  #ready = false; // the worker has loaded
  #strange = false; // what was fitted last is a function of the reader's, which may never end

  /// Fetches the module once for all workers.
  static async load() {
    const response = await fetch(new URL('./openltc/openltc.wasm', import.meta.url));
    if (!response.ok) throw new Error(`openltc.wasm: ${response.status} ${response.statusText}`);
    const fitter = new Fitter();
    fitter.#wasm = await WebAssembly.compile(await response.arrayBuffer());
    fitter.catalogue = await fitter.#start();
    return fitter;
  }

  /// Whether something is under way that another fit cannot wait for: all but figures of a BRDF of ours.
  get busy() { return [...this.#waiting.values()].some(({isFigure}) => !isFigure || this.#strange); }

  /// Asks the worker; `onProgress` hears of a fit's share.
  call(call, more = {}, onProgress = () => {}) {
    if (this.#worker === null) this.#start().catch(() => {});
    const id = ++this.#last;
    return new Promise((done, fail) => {
      // A function of the reader's may be called; all else comes to an end.
      const isFigure = call === 'cells' || call === 'polygon', strange = more.options?.brdf?.text !== undefined;
      if (call === 'fit') this.#strange = strange;
      this.#waiting.set(id, {done, fail, onProgress, isFigure, watched: isFigure || strange});
      this.#worker.postMessage({id, call, ...more});
      this.#watch();
    });
  }

  /// Ends what is under way; what was fitted is lost.
  cancel(message = 'cancelled') {
    if (this.#worker === null) return;
    this.#worker.terminate();
    this.#worker = null;
    this.#ready = false;
    clearTimeout(this.#timer);
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const {fail} of waiting) fail(new FitFailure({message, cancelled: message === 'cancelled'}));
  }

  #start() {
    this.#worker = new Worker(new URL('./worker.js', import.meta.url), {type: 'module'});
    this.#worker.onmessage = ({data}) => this.#hear(data);
    this.#worker.onerror = (event) => {
      event.preventDefault();
      this.cancel(`the worker ended: ${event.message ?? 'its files could not be loaded'}`);
    };
    return this.call('load', {wasm: this.#wasm}).then((catalogue) => {
      this.#ready = true;
      this.#watch();
      return catalogue;
    });
  }

  #hear({id, share, result, failed}) {
    this.#watch();
    const waiting = this.#waiting.get(id);
    if (!waiting) return;
    if (share !== undefined) return waiting.onProgress(share);
    this.#waiting.delete(id);
    this.#watch();
    if (failed) waiting.fail(new FitFailure(failed));
    else waiting.done(result);
  }

  #watch() {
    clearTimeout(this.#timer);
    if (!this.#ready || ![...this.#waiting.values()].some((call) => call.watched)) return;
    this.#timer = setTimeout(() => this.cancel(
        `the BRDF gave no answer for ${k_silence / 1000} seconds and was ended; does it loop for ever?`), k_silence);
  }
}
