// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The npm package `openltc` in Node: writes files that openltc.py compares, and checks what a caller may do
// wrong.
//
//   node openltc.mjs PACKAGE FOLDER MERL
//
// Its last line is JSON: figures that openltc.py prints.

import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [packageFolder, folder, merlFile] = process.argv.slice(2);
const {OpenltcError, loadOpenltc} = await import(pathToFileURL(resolve(packageFolder, 'index.js')));
const openltc = await loadOpenltc();
let failures = 0;

// Of three fits, seconds without the error's measurement.
function best(make) {
  return Math.min(...[1, 2, 3].map(() => {
    const fit = make();
    fit.free();
    return fit.seconds;
  }));
}

function check(holds, what) {
  if (holds) return;
  ++failures;
  console.log(`failed: ${what}`);
}

function write(files, name) {
  mkdirSync(join(folder, name), {recursive: true});
  for (const file of files) writeFileSync(join(folder, name, file.name), file.bytes);
}

// The line with which it fails, which must be one of ours.
function failure(action) {
  try {
    action();
  } catch (error) {
    check(error instanceof OpenltcError, `${error} is an OpenltcError`);
    check(!/\n/.test(error.message), `one line: ${error.message}`);
    return error.message;
  }
  return '(none)';
}

function fails(action, expected) {
  const line = failure(action);
  check(line.includes(expected), `"${line}" says "${expected}"`);
}

// Files, which openltc.py compares with those of the command line.
function write_files() {
  for (const layout of openltc.layouts) {
    const fit = openltc.fit({size: 16, layout: layout.name});
    write(fit.files('table.json'), layout.name);
    if (layout.name === 'native')
      for (const extension of ['dds', 'ktx2', 'exr', 'npy', 'h', 'glsl', 'hlsl', 'wgsl', 'js', 'inc'])
        write(fit.files(`table.${extension}`), 'containers');
    fit.free();
  }
  const half = openltc.fit({size: 16, layout: 'ltc_code', precision: 'float16'});
  write(half.files('half.ktx2'), 'containers');
  write(half.files('half.exr'), 'containers');
  half.free();
  const two = openltc.fit({form: 'two-lobe', size: 8});
  write(two.files('table.json'), 'two-lobe');
  two.free();
  const engine = openltc.fit({engine: 'o3de', refine: 'off'});
  write(engine.files(), 'o3de');
  engine.free();
  const merl = openltc.fit({brdf: {merl: readFileSync(merlFile), name: 'made.binary'}, size: 16});
  check(merl.columns === 1 && merl.rows === 16, 'a measured material has one column');
  write(merl.files('table.json'), 'merl');
  merl.free();
  const progress = [];
  const full = openltc.fit({size: 64, progress: (share) => void progress.push(share)});
  const seconds = best(() => openltc.fit({size: 64}));
  write(full.files('table.json'), 'full');
  check(progress.length > 10 && progress.every((share, i) => share >= (progress[i - 1] ?? 0) && share <= 1),
        'progress rises');
  const report = full.report({lights: 0});
  check(Math.abs(report.regions[0].candidates[0].between_nodes.mean.tv - full.mean.tv) < 1e-5,
        'the report has the error of the fit');
  full.free();
  fails(() => full.files('a.json'), 'freed');
  return seconds;
}

// GGX as a page would write it, D V without Fresnel.
function ggx([ox, , oz], wi, roughness, out) {
  const a2 = Math.max(roughness * roughness, 1e-4) ** 2;
  for (let i = 0; i < out.length; ++i) {
    const ix = wi[3 * i], iy = wi[3 * i + 1], iz = wi[3 * i + 2];
    const x = ox + ix, z = oz + iz, length2 = x * x + iy * iy + z * z;
    const t = (x * x + iy * iy + a2 * z * z) / length2;
    const lambda = iz * Math.sqrt(oz * oz * (1 - a2) + a2) + oz * Math.sqrt(iz * iz * (1 - a2) + a2);
    out[i] = a2 / (Math.PI * t * t) * 0.5 / lambda;
  }
}

function check_function() {
  const own = openltc.fit({brdf: {evaluate: ggx, name: 'mine'}, size: 64});
  const seconds = best(() => openltc.fit({brdf: {evaluate: ggx}, size: 64}));
  const built_in = openltc.fit({size: 64});
  let apart = 0;
  own.textures[0].values.forEach((value, i) => apart = Math.max(apart, Math.abs(value - built_in.textures[0].values[i])));
  check(apart < 1e-6, `GGX in JavaScript gives the table of GGX in C++: ${apart}`);
  const [cell] = own.cells({roughness: [0.5], thetaDegrees: [45], side: 32});
  check(cell.brdf.length === 1024 && cell.error.tv > 0 && cell.error.tv < 0.2, 'a cell of a function');
  // A light around the whole hemisphere: the albedo, whatever the lobe.
  const far = 1e3;
  const square = [[-far, -far, 1], [far, -far, 1], [far, far, 1], [-far, far, 1]];
  const sky = own.polygon({roughness: 0.7, thetaDegrees: 30, corners: square, samples: 10});
  check(Math.abs(sky.lightByBrdf - sky.albedo) < 2e-3 && Math.abs(sky.lightByLobe - sky.albedo) < 5e-3,
        `a light all around is the albedo: ${sky.lightByBrdf}, ${sky.lightByLobe}, ${sky.albedo}`);
  // A concave outline has the light of its two convex halves.
  const tip = [-0.9, 0, 1.5], left = [-0.9, -1, 0.3], right = [-0.9, 1, 0.3], dent = [-0.9, 0, 0.8];
  const light = (corners) => own.polygon({roughness: 0.5, thetaDegrees: 50, corners, samples: 0}).lightByBrdf;
  check(Math.abs(light([tip, left, dent, right]) - light([tip, left, dent]) - light([tip, dent, right])) < 1e-5,
        'a concave polygon is the sum of its parts');
  own.free();
  built_in.free();
  const returning = openltc.fit({brdf: {evaluate: (wo, wi, r, out) => Array.from(out, () => 1 / Math.PI), width: 'one'}, size: 4});
  check(Math.abs(returning.map.albedo[5] - 1) < 1e-4, 'Lambert reflects all');
  returning.free();
  return seconds;
}

function check_bad_input() {
  const fit = (evaluate, more) => () => openltc.fit({brdf: {evaluate, name: 'bad'}, size: 4, ...more});
  fails(fit(() => { throw new TypeError('no such thing'); }), 'brdf bad: it threw TypeError: no such thing');
  fails(fit(() => { throw 'a string'; }), 'it threw the string "a string"');
  fails(fit((wo, wi, r, out) => void out.fill(NaN)), 'must be finite and not negative');
  fails(fit((wo, wi, r, out) => void out.fill(-1)), 'must be finite and not negative');
  fails(fit((wo, wi, r, out) => void out.fill(Infinity)), 'must be finite and not negative');
  fails(fit(() => 'red'), 'it returned the string "red"');
  fails(fit((wo, wi, r, out) => Array(out.length).fill('1')), 'value 0 that it returned is the string "1"');
  fails(fit((wo, wi, r, out) => [1]), 'it returned 1 values for');
  fails(fit(async () => {}), 'it returned a promise');
  fails(fit((wo, wi, r, out) => void out.fill(0)), 'it reflects nothing');
  fails(fit(() => void openltc.fit()), 'a fit is under way');
  fails(fit(ggx, {progress: () => false}), 'cancelled');
  fails(fit(ggx, {progress: () => { throw new Error('stop'); }}), 'it threw Error: stop');
  fails(fit('red'), 'evaluate is the string "red"; it is a function');
  fails(() => openltc.fit({brdf: 'gxx'}), 'brdf "gxx" is not known; take one of ggx');
  fails(() => openltc.fit({brdf: 7}), 'brdf is 7');
  fails(() => openltc.fit({brdf: {merl: 'x'}}), 'merl is the string "x"');
  fails(() => openltc.fit({brdf: {merl: new Uint8Array(20), name: 'x.binary'}}), 'x.binary');
  fails(() => openltc.fit({size: '64'}), 'size is the string "64"');
  fails(() => openltc.fit({size: 1}), 'size is 1; it is a whole number from 2 to 512');
  fails(() => openltc.fit({size: 4.5}), 'size is 4.5');
  fails(() => openltc.fit({size: NaN}), 'size is NaN');
  fails(() => openltc.fit({layout: 'cryengine'}), 'layout "cryengine" is not known');
  fails(() => openltc.fit({objective: 'best'}), 'best');
  fails(() => openltc.fit({engine: 'doom'}), 'engine "doom" is not known');
  fails(() => openltc.fit({form: 'three-lobe'}), 'form "three-lobe" is not known');
  const good = openltc.fit({size: 4});
  fails(() => good.files('table.bmp'), 'unknown extension');
  fails(() => good.cells({roughness: [2], thetaDegrees: [0]}), 'roughness is 2');
  fails(() => good.polygon({roughness: 0.5, thetaDegrees: 30, corners: [[0, 0, 1], [1, 0, 1]]}), 'three corners');
  check(good.files('table.json')[0].bytes.length > 500, 'the module goes on working');
  good.free();
}

function check_memory() {
  const refit = () => {
    openltc.fit({brdf: {evaluate: ggx, name: 'mine'}, size: 4, refine: 'off'}).free();
    failure(() => openltc.fit({brdf: {evaluate: () => 'red'}, size: 4}));
  };
  for (let i = 0; i < 20; ++i) refit();
  const before = openltc.memoryBytes;
  for (let i = 0; i < 200; ++i) refit();
  check(openltc.memoryBytes === before, `memory does not grow over 200 refits: ${before}, ${openltc.memoryBytes}`);
  return before;
}

// A fit that needs more than there is ends the module; the next call has another.
function check_trap() {
  const kept = openltc.fit({size: 4});
  const line = failure(() => openltc.fit({brdf: {merl: new Uint8Array(2 ** 30), name: 'huge.binary'}}));
  check(line.includes('huge.binary') || line.includes('memory'), `a file of a gigabyte: ${line}`);
  openltc.fit({size: 4}).free();
  void kept;
}

const seconds = write_files();
const seconds_own = check_function();
check_bad_input();
const memory = check_memory();
check_trap();
console.log(JSON.stringify({failures, seconds, seconds_own, memory}));
process.exit(failures === 0 ? 0 : 1);
