// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Makes the npm package of this folder: its files, and the module that CMake builds.
//
//   node web/wasm/build.mjs OPENLTC.wasm FOLDER
//
// FOLDER is then what `npm pack` or an import map takes.

import {cpSync, mkdirSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

const [module, folder] = process.argv.slice(2);
if (!folder) {
  console.error('usage: node build.mjs OPENLTC.wasm FOLDER');
  process.exit(2);
}
const here = fileURLToPath(new URL('.', import.meta.url));
mkdirSync(folder, {recursive: true});
for (const name of readdirSync(here))
  if (/\.(js|d\.ts|md|json)$/.test(name)) cpSync(join(here, name), join(folder, name));
cpSync(module, join(folder, 'openltc.wasm'));
cpSync(join(here, '../../LICENSE'), join(folder, 'LICENSE'));
