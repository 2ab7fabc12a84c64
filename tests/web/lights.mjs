// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The reader of glTF files of the npm package `openltc` in Node; lights.py compares what it prints with what the
// command line says.
//
//   node lights.mjs PACKAGE FILES
//
// Its last line is JSON: for each file what readLights gave, or {error}, and the module's memory.

import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [packageFolder, ...files] = process.argv.slice(2);
const {OpenltcError, loadLightReader} = await import(pathToFileURL(resolve(packageFolder, 'index.js')));
const reader = await loadLightReader();

function read(name, bytes, more) {
  try {
    return reader.readLights(bytes, {name, ...more});
  } catch (error) {
    if (!(error instanceof OpenltcError)) throw error;
    return {error: error.message};
  }
}

const found = Object.fromEntries(files.map(name => [name, read(name, readFileSync(name))]));
const wrong = {
  'a string': read('x', 'glTF').error,
  'a number as a name': (() => {
    try {
      reader.readLights(new Uint8Array(4), {name: 4});
    } catch (error) {
      return error.message;
    }
  })(),
};
// Nothing is kept: what is read again and again, whole and damaged.
const [first] = files, bytes = readFileSync(first), half = bytes.subarray(0, bytes.length / 2);
for (let i = 0; i < 20; ++i) read(first, i % 2 ? bytes : half);
const before = reader.memoryBytes;
for (let i = 0; i < 200; ++i) read(first, i % 2 ? bytes : half);
console.log(JSON.stringify({found, wrong, memory: [before, reader.memoryBytes]}));
