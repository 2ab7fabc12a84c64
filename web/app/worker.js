// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Fits beside the page, so that a BRDF that never ends can be ended. fitter.js talks to it.

import {loadOpenltc} from './openltc/index.js';
import {SourceError, compile, placeOf} from './brdf_source.js';

let openltc, fit = null, url = '';

// A function that says now and then that it is called.
function watched(evaluate) {
  const k_beat = 500; // ms
  let last = 0;
  return (...given) => {
    const now = performance.now();
    if (now - last > k_beat) {
      last = now;
      postMessage({id: 0});
    }
    return evaluate(...given);
  };
}

// What the package calls a BRDF.
async function sourceOf(brdf) {
  if (brdf.text === undefined) return brdf.merl ? {merl: brdf.merl, name: brdf.name} : brdf.name;
  const compiled = await compile(brdf.text);
  url = compiled.url;
  return {evaluate: watched(compiled.evaluate), name: brdf.name, width: brdf.width};
}

async function makeFit(options, id) {
  return openltc.fit({...options, brdf: await sourceOf(options.brdf), progress: (share) => {
    postMessage({id, share});
  }});
}

const plain = ({brdf, width, layout, precision, objective, command, note, warning, mean, max, columns, rows, textures, map}) =>
    ({brdf, width, layout, precision, objective, command, note, warning, mean, max, columns, rows, textures, map});

const calls = {
  async load({wasm}) {
    openltc = await loadOpenltc({wasm});
    const {version, brdfs, layouts, engines, colormaps} = openltc;
    return {version, brdfs, layouts, engines, colormaps};
  },
  async fit({options}, id) {
    const begin = performance.now();
    const made = await makeFit(options, id);
    fit?.free();
    fit = made;
    return {...plain(fit), seconds: (performance.now() - begin) / 1000};
  },
  // A table to take away, which is fitted for its layout.
  async files({options, path}, id) {
    const made = await makeFit(options, id);
    const files = made.files(path);
    const {warning} = made;
    made.free();
    return {files, warning};
  },
  cells: ({options}) => fit.cells(options),
  polygon: ({options}) => fit.polygon(options),
  report: ({options}) => fit.report(options),
};

onmessage = async ({data: {id, call, ...more}}) => {
  try {
    postMessage({id, result: await calls[call](more, id)});
  } catch (error) {
    const thrown = error.cause ?? error;
    const [line, column] = error instanceof SourceError ? [error.line, error.column] : placeOf(thrown, url);
    postMessage({id, failed: {message: error.message, line, column, syntax: error.syntax === true}});
  }
};
