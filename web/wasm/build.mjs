// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Makes the npm package of this folder: its files, and the modules that CMake builds.
//
//   node web/wasm/build.mjs BUILD FOLDER
//
// BUILD is the folder with the modules.
// FOLDER is then what `npm pack` or an import map takes.

import {cpSync, mkdirSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

const [build, folder] = process.argv.slice(2);
if (!folder) {
  console.error('usage: node build.mjs BUILD FOLDER');
  process.exit(2);
}
const here = fileURLToPath(new URL('.', import.meta.url));
mkdirSync(folder, {recursive: true});
for (const name of readdirSync(here))
  if (/\.(js|d\.ts|md|json)$/.test(name)) cpSync(join(here, name), join(folder, name));
for (const name of ['openltc.wasm', 'lights.wasm']) cpSync(join(build, name), join(folder, name));
cpSync(join(here, '../../LICENSE'), join(folder, 'LICENSE'));
