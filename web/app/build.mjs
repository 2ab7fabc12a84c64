// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Makes the laboratory: static files, for any server of files.
//
//   node web/app/build.mjs OPENLTC MODULE FOLDER
//
// OPENLTC is the tool, which writes the shaders, MODULE the fitter, openltc.wasm. build_viewer.mjs adds the viewer.

import {execFileSync} from 'node:child_process';
import {cpSync, mkdirSync, mkdtempSync, readdirSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {languages} from './downloads.js';

const [openltc, module, folder] = process.argv.slice(2);
if (!folder) {
  console.error('usage: node build.mjs OPENLTC MODULE FOLDER');
  process.exit(2);
}
const here = fileURLToPath(new URL('.', import.meta.url));
rmSync(folder, {recursive: true, force: true});
mkdirSync(join(folder, 'shaders'), {recursive: true});
for (const name of readdirSync(here))
  if (/\.(js|html|css)$/.test(name)) cpSync(join(here, name), join(folder, name));
mkdirSync(join(folder, 'openltc'));
for (const name of ['index.js', 'lights.js', 'module.js']) cpSync(join(here, '../wasm', name), join(folder, 'openltc', name));
cpSync(module, join(folder, 'openltc/openltc.wasm'));
cpSync(join(here, '../../LICENSE'), join(folder, 'openltc/LICENSE'));
for (const language in languages)
  for (const lobe of ['table', 'two-lobe']) {
    const made = mkdtempSync(join(tmpdir(), 'openltc-app-'));
    execFileSync(openltc, ['shaders', '--language', language, '--lobe', lobe, '--shapes', 'polygon', '--quiet', '-o', made]);
    cpSync(join(made, readdirSync(made)[0]), join(folder, 'shaders', `${language}-${lobe}`));
    rmSync(made, {recursive: true});
  }
