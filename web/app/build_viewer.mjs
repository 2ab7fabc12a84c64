// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Makes the viewer: static files, for any server of files, beside the laboratory.
//
//   node web/app/build_viewer.mjs OUT
//
// OUT has what web/three/build.mjs made, OUT/openltc-three, and OUT/node_modules with three.js and esbuild. The page
// is OUT/app/viewer.html; decoders are fetched by it when a file needs them.

import {cpSync, mkdirSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {pack, unpack} from './viewer/table_bytes.js';

const [out] = process.argv.slice(2).map(folder => resolve(folder));
if (!out) {
  console.error('usage: node build_viewer.mjs OUT');
  process.exit(2);
}
const here = fileURLToPath(new URL('.', import.meta.url)), folder = join(out, 'app');
const modules = join(out, 'node_modules'), libraries = join(modules, 'three/examples/jsm/libs');
const language = join(modules, 'three/src/nodes/TSL.js');
const {build} = createRequire(join(modules, 'package.json'))('esbuild');
for (const name of ['viewer', 'decoders']) rmSync(join(folder, name), {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
for (const name of ['viewer.html', 'viewer.css', 'style.css']) cpSync(join(here, name), join(folder, name));
cpSync(join(here, '../../scenes/demo.glb'), join(folder, 'demo.glb'));
await build({
  entryPoints: [join(here, 'viewer/viewer.js')], outdir: join(folder, 'viewer'), bundle: true, splitting: true, minify: true,
  format: 'esm', target: 'es2022', legalComments: 'linked', logLevel: 'warning', chunkNames: '[name]-[hash]',
  // By its sources, of whose shading language the bundle then has what is used.
  alias: {three: join(modules, 'three/src/Three.WebGPU.js'), 'three/webgpu': join(modules, 'three/src/Three.WebGPU.js'),
          'three/tsl': language, 'three/addons': join(modules, 'three/examples/jsm'),
          'three-mesh-bvh': join(modules, 'three-mesh-bvh'), 'openltc-three': join(out, 'openltc-three/webgpu.js'),
          'openltc-three/webgpu/shadows': join(out, 'openltc-three/webgpu_shadows.js')},
  plugins: [{name: 'tsl', setup: build => build.onResolve({filter: /^\.\/tsl\.js$/}, () => ({path: language}))}],
});
// The tables of three.js's own area lights, as halves.
const {RectAreaLightTexturesLib} = await import(join(modules, 'three/examples/jsm/lights/RectAreaLightTexturesLib.js'));
RectAreaLightTexturesLib.init();
const halves = ['LTC_HALF_1', 'LTC_HALF_2'].flatMap(name => [...RectAreaLightTexturesLib[name].image.data]), packed = pack(halves, 64);
if (String(unpack(packed, 64)) !== String(halves)) throw new Error("three.js's tables are not those of 64 x 64 texels that the viewer reads");
writeFileSync(join(folder, 'viewer/their_tables.bin'), packed);
mkdirSync(join(folder, 'decoders'));
for (const name of ['draco_decoder.wasm', 'draco_wasm_wrapper.js'])
  cpSync(join(libraries, 'draco/gltf', name), join(folder, 'decoders/draco', name));
for (const name of ['basis_transcoder.js', 'basis_transcoder.wasm'])
  cpSync(join(libraries, 'basis', name), join(folder, 'decoders/basis', name));
