// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Makes the npm package of this folder: its files, and shaders_*.js, which `openltc shaders` gives.
//
//   node web/three/build.mjs OPENLTC FOLDER
//
// FOLDER is then what `npm pack` or an import map takes.

import {execFileSync} from 'node:child_process';
import {cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {helpers, withoutBranches} from './branchless.mjs';

const prefix = 'openltc_';

// Without comments and empty lines.
function code(text) {
  return text.replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, '').replace(/[ \t]+$/gm, '').replace(/\n{2,}/g, '\n').trim() + '\n';
}

// What stands at the top level, in its order: [name, text].
function definitions(text) {
  const found = [];
  let depth = 0, begin = 0;
  for (let i = 0; i < text.length; ++i) {
    if (text[i] === '{' || text[i] === '(') ++depth;
    if (text[i] === '}' || text[i] === ')') --depth;
    const ends = depth === 0 && (text[i] === ';' || (text[i] === '}' && text[i + 1] !== ';'));
    if (!ends) continue;
    const part = text.slice(begin, i + 1).trim();
    begin = i + 1;
    if (part.startsWith('precision ')) continue; // three.js has its own, high by default
    const name = part.match(/^(?:struct\s+|fn\s+|const\s+(?:\w+\s+)?|\w+\s+)(openltc_\w+)/)?.[1];
    if (!name?.startsWith(prefix)) throw new Error('a definition without a name of ours: ' + part.slice(0, 80));
    found.push([name, part]);
  }
  if (text.slice(begin).trim()) throw new Error('what follows the last definition: ' + text.slice(begin, begin + 80));
  return found;
}

function shaders(openltc, language) {
  const folder = mkdtempSync(join(tmpdir(), 'openltc-three-'));
  try {
    execFileSync(openltc, ['shaders', '--language', language, '--lean', '--sampling', '--shapes', 'quad,polygon,disk,sphere,tube,line,textured',
                           '--prefix', prefix, '--quiet', '-o', folder]);
    const [name] = readdirSync(folder);
    const found = definitions(code(readFileSync(join(folder, name), 'utf8'))).map(([own, text]) => [own, withoutBranches(text)]);
    const left = found.find(([, text]) => /[?]|&&|[|][|]/.test(text));
    if (left) throw new Error('a condition that is no call: ' + left[1]);
    return [...helpers[language], ...found];
  } finally {
    rmSync(folder, {recursive: true});
  }
}

const [openltc, folder] = process.argv.slice(2);
if (!folder) {
  console.error('usage: node build.mjs OPENLTC FOLDER');
  process.exit(2);
}
const here = fileURLToPath(new URL('.', import.meta.url));
mkdirSync(folder, {recursive: true});
for (const name of readdirSync(here))
  if (/\.(js|d\.ts|md|json)$/.test(name)) cpSync(join(here, name), join(folder, name));
cpSync(join(here, '../../LICENSE'), join(folder, 'LICENSE'));
for (const [file, language] of [['shaders_glsl.js', 'glsl-es'], ['shaders_wgsl.js', 'wgsl']])
  writeFileSync(join(folder, file), `// Made by build.mjs of \`openltc shaders --language ${language}\`; MIT licence.
/// The closed form of area lights: [name, text] of each definition, each after those that it names.
export const definitions = ${JSON.stringify(shaders(openltc, language), null, 1)};
`);
