// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The laboratory: one state, what changes it, and what is shown of it.

import {Editor} from './editor.js';
import {Fitter} from './fitter.js';
import {Preview} from './preview.js';
import {Handles, discPlaces, drawSpace, lobePicture} from './polygon_figure.js';
import {cellNear, drawDifference, drawErrorMap, drawLobe, drawStrip, worstCells} from './figures.js';
import {cornersOf, meetPlane} from './polygon_light.js';
import {example, findSyntaxError} from './brdf_source.js';
import {fillChoices, requestOf, save} from './downloads.js';
import {fromLink, toLink} from './link.js';
import {shapes, start} from './state.js';

const $ = (id) => document.getElementById(id);
const k_own = '', k_merl = '?'; // values of the choice of a BRDF that are no name of one
const k_still = 400; // ms without a change before the picture gets smooth edges
const k_pause = 250; // ms after the last key before a fit begins

const state = {...start};
let fitter, preview = null, editor, colours, fit = null, merl = null, cosine;
let trusted = true; // the text is the reader's own, or was read
let typed = 0, still = 0, latest = 0, drawing = false, wanted = false, rough = false;

// ---- fits

const brdfOf = () => state.brdf === k_own ? {text: state.text, name: 'mine', width: state.width}
    : state.brdf === k_merl ? merl : {name: state.brdf};
const fitOptions = () => ({brdf: brdfOf(), form: state.form, size: Number(state.size), objective: state.objective});

function say(text, busy = false) {
  $('status').textContent = text;
  $('cancel').hidden = !busy;
  $('progress').hidden = !busy;
}

function complain(text) {
  $('message').textContent = text;
  $('message').hidden = text === '';
}

async function refit() {
  clearTimeout(typed);
  if (state.brdf === k_own && !trusted) return say('waiting for you');
  if (fitter.busy) fitter.cancel();
  const mine = ++latest;
  clearTimeout(still);
  say('fitting', true);
  $('progress').value = 0;
  try {
    const made = await fitter.call('fit', {options: fitOptions()}, (share) => $('progress').value = share);
    await preview?.prepare(made).catch(withoutPicture);
    if (mine !== latest) return;
    fit = made;
    complain(made.warning);
    editor.mark(0);
    say('up to date');
    showFit();
  } catch (error) {
    if (mine !== latest) return;
    await showFailure(error);
  }
}

async function showFailure(error) {
  smoothLater();
  if (error.cancelled) return say('cancelled');
  let {line, column} = error;
  if (error.syntax) [line, column] = await findSyntaxError(state.text);
  const own = state.brdf === k_own;
  if (own) editor.mark(line);
  complain(own && line > 0 ? `Line ${line}${column > 0 ? `, column ${column}` : ''}: ${error.message}` : error.message);
  say(fit === null ? 'no fit yet' : 'shown is the last fit');
}

const later = () => {
  clearTimeout(typed);
  typed = setTimeout(refit, k_pause);
};

// ---- what is shown

function showFit() {
  $('mean-tv').textContent = fit.mean.tv.toFixed(4);
  $('max-tv').textContent = fit.max.tv.toFixed(2);
  $('seconds').textContent = `${fit.seconds.toFixed(2)} s`;
  const most = Math.max(0.05, Math.ceil(fit.max.tv * 20) / 20);
  drawErrorMap($('map'), fit.map, most, colours);
  $('map-most').textContent = most.toFixed(2);
  $('worst').replaceChildren(...worstCells(fit.map, 5).map((cell) => {
    const item = document.createElement('li'), button = document.createElement('button');
    button.type = 'button';
    button.textContent = `${cell.tv.toFixed(3)} at roughness ${cell.roughness.toFixed(2)}, seen at ${cell.thetaDegrees.toFixed(0)}°`;
    button.onclick = () => change({roughness: cell.roughness, thetaDegrees: Math.min(cell.thetaDegrees, 88)});
    item.append(button);
    return item;
  }));
  if (preview) guarded(() => preview.setFit(fit));
  show();
}

// Where there is no picture all else works on.
function withoutPicture(error) {
  preview = null;
  $('no-preview').textContent = error.message;
  $('no-preview').hidden = false;
}

function guarded(action) {
  try {
    action();
  } catch (error) {
    withoutPicture(error);
  }
}

function markMap() {
  const {column, row} = cellNear(fit.map, state.roughness, state.thetaDegrees);
  const columns = fit.map.roughness.length, rows = fit.map.thetaDegrees.length;
  $('map-mark').setAttribute('viewBox', `0 0 ${columns} ${rows}`);
  const y = rows - 1 - row;
  $('map-mark').innerHTML = `<rect x="${column - 0.6}" y="${y - 0.6}" width="2.2" height="2.2" fill="none" stroke="#000" stroke-width="0.7"/>` +
      `<rect x="${column - 0.6}" y="${y - 0.6}" width="2.2" height="2.2" fill="none" stroke="#fff" stroke-width="0.35"/>`;
}

function drawPreview(density) {
  rough = density === 1;
  preview.draw({...state, exposure: 2 ** state.exposure}, density);
}

// Four times the pixels; not while a fit is under way, nor where the rough picture is not there yet: a slow machine.
function smoothLater() {
  clearTimeout(still);
  still = setTimeout(() => preview?.isDrawn && rough && guarded(() => drawPreview(2)), k_still);
}

// Pictures follow at once, the figures of the worker as soon as it is free.
function show() {
  writeControls();
  if (fit === null) return;
  markMap();
  if (preview)
    guarded(() => {
      drawPreview(1);
      handles.preview.draw(state.light);
      smoothLater();
    });
  wanted = true;
  if (!drawing) drawFigures();
}

async function drawFigures() {
  drawing = true;
  while (wanted) {
    wanted = false;
    const {roughness, thetaDegrees, light} = state, mine = latest;
    try {
      const [cell] = await fitter.call('cells', {options: {roughness: [roughness], thetaDegrees: [thetaDegrees], side: 128}});
      if (mine !== latest) continue;
      showCell(cell);
      const polygon = await fitter.call('polygon', {options: {roughness, thetaDegrees, corners: cornersOf(light), samples: 400}})
          .catch((error) => ({failed: error}));
      if (mine !== latest) continue;
      showPolygon(polygon);
    } catch (error) {
      if (!error.cancelled && mine === latest) complain(error.message);
      break;
    }
  }
  drawing = false;
}

const percent = (x) => `${(100 * x).toFixed(Math.abs(x) < 0.1 ? 1 : 0)}\u00a0%`;

function showCell(cell) {
  drawLobe($('lobe-brdf'), cell, cell.brdf, colours);
  drawLobe($('lobe-fit'), cell, cell.lobe, colours);
  drawDifference($('lobe-difference'), cell, colours);
  const {tv, l2, peak} = cell.error;
  $('lobe-facts').textContent = `Roughness ${cell.roughness.toFixed(2)}, seen at ${cell.thetaDegrees.toFixed(0)}°: total variation ` +
      `${tv.toFixed(3)}, relative L2 ${l2.toFixed(3)}, peak off by ${percent(peak)}, albedo ${cell.albedo.toFixed(3)}. ` +
      `From above, ${cell.window.half < 1 ? 'around the lobe alone, ' : ''}three decades; the mirror direction is to the right.`;
}

function showPolygon(polygon) {
  const failed = polygon.failed;
  const lobe = lobePicture(failed ? null : polygon.matrix, colours);
  drawSpace($('polygon-shading'), {density: lobe, space: failed ? null : polygon.shading, horizon: failed ? null : polygon.horizonOfLobe});
  drawSpace($('polygon-cosine'), {density: cosine, space: failed ? null : polygon.cosine,
                                  horizon: failed ? null : polygon.horizonInCosine});
  handles.figure.draw(state.light);
  const off = failed ? 0 : polygon.lightByLobe - polygon.lightByBrdf;
  $('polygon-facts').textContent = failed ? failed.message.replace(/^corners: /, '') + '.' :
      `${state.form === 'two-lobe' ? 'Shown is the first of two lobes. ' : ''}Both integrals are ${polygon.cosine.integral.toFixed(4)}. Of light of radiance 1 the surface reflects ` +
      `${polygon.lightByLobe.toFixed(4)} by the lobe${state.form === 'two-lobe' ? 's' : ''} and ${polygon.lightByBrdf.toFixed(4)} by the BRDF itself` +
      `: ${polygon.lightByBrdf > 1e-4 ? `${off < 0 ? '−' : '+'}${percent(Math.abs(off) / polygon.lightByBrdf)}` : 'nothing to compare'}.`;
}

// ---- controls

const controls = [
  ['roughness', 'roughness', (x) => x.toFixed(2)], ['theta', 'thetaDegrees', (x) => `${x.toFixed(0)}°`],
  ['turn', 'turn', (x) => `${x}°`], ['tilt', 'tilt', (x) => `${x}°`], ['exposure', 'exposure', (x) => x.toFixed(1)],
];
const holder = (name) => name === 'turn' || name === 'tilt' ? state.light : state;

function writeControls() {
  for (const [id, name, text] of controls) {
    const value = holder(name)[name];
    $(id).value = value;
    $(id).parentElement.querySelector('output').textContent = text(value);
  }
  for (const name of ['form', 'size', 'objective', 'width']) $(name).value = state[name];
  $('brdf').value = state.brdf;
  $('own').hidden = state.brdf !== k_own;
  $('trust').hidden = trusted;
}

function change(more) {
  Object.assign(state, more);
  history.replaceState(null, '', linkOfState());
  show();
}

// A measured material is too large for a link.
const linkOfState = () => toLink({...state, brdf: state.brdf === k_merl ? start.brdf : state.brdf});

function chooseBrdf(name) {
  change({brdf: name});
  const known = fitter.catalogue.brdfs.find((b) => b.name === name);
  $('about').textContent = known ? `${known.variant}. ${known.source}.` : name === k_merl ? `${merl.name}: measured, luminance of its three channels.` : '';
  complain('');
  refit();
}

async function takeMerl(file) {
  if (!file) return;
  if (file.size > 4 * 2 ** 26) return complain(`${file.name} is too large for a file of the MERL database`);
  merl = {name: file.name, merl: new Uint8Array(await file.arrayBuffer())};
  let choice = $('brdf').querySelector(`option[value="${k_merl}"]`);
  if (!choice) choice = $('brdf').appendChild(Object.assign(document.createElement('option'), {value: k_merl}));
  choice.textContent = file.name;
  chooseBrdf(k_merl);
}

async function takeTable(event) {
  event.preventDefault();
  const {options, path} = requestOf($('layout').value, $('container').value, $('precision').value, fitOptions());
  $('take-facts').textContent = 'Fitting for this layout …';
  try {
    const {files, warning} = await fitter.call('files', {options, path});
    const saved = save(files, `${options.brdf.name}_${options.engine ?? 'table'}`);
    const engine = fitter.catalogue.engines.find((e) => e.name === options.engine);
    $('take-facts').textContent = `${saved.name}: ${files.map((f) => f.name).join(', ')}.` +
        (engine ? ` Put them into ${engine.place}.` : '') + (warning ? ` ${warning}` : '');
    dispatchEvent(new CustomEvent('taken', {detail: saved}));
  } catch (error) {
    $('take-facts').textContent = `${error.message}.`;
  }
}

async function takeShader(event) {
  event.preventDefault();
  const name = `${$('language').value}-${state.form === 'two-lobe' ? 'two-lobe' : 'table'}`;
  const response = await fetch(`shaders/${name}`);
  if (!response.ok) return $('take-facts').textContent = `shaders/${name}: ${response.status} ${response.statusText}.`;
  const extension = {'glsl-es': 'glsl', glsl: 'glsl'}[$('language').value] ?? $('language').value;
  const saved = save([{name: `ltc_${name.replace(/-/g, '_')}.${extension}`, bytes: new Uint8Array(await response.arrayBuffer())}]);
  $('take-facts').textContent = `${saved.name}: its head says how to call it.`;
}

// ---- handles

const handles = {
  preview: new Handles($('handles'), {
    radius: 7, keep: false,
    places: (light) => preview.corners(light, state.thetaDegrees),
    meet: (x, y, light) => meetPlane(light, ...preview.rayAt(x, y, state.thetaDegrees)),
    changed: (outline) => change({light: {...state.light, outline}}),
  }),
  figure: new Handles($('polygon-shading'), {
    radius: 0.035, keep: true, ...discPlaces, changed: (outline) => change({light: {...state.light, outline}}),
  }),
};

// ---- start

function listen() {
  for (const [id, name] of controls)
    $(id).addEventListener('input', () => {
      const value = Number($(id).value);
      change(holder(name) === state ? {[name]: value} : {light: {...state.light, [name]: value}});
    });
  for (const name of ['form', 'size', 'objective', 'width'])
    $(name).addEventListener('change', () => {
      change({[name]: $(name).value, ...(name === 'form' ? {size: $(name).value === 'two-lobe' ? '16' : '64'} : {})});
      refit();
    });
  $('brdf').addEventListener('change', () => chooseBrdf($('brdf').value));
  $('cancel').onclick = () => fitter.cancel();
  $('run').onclick = () => {
    trusted = true;
    change({});
    refit();
  };
  $('copy-link').onclick = async () => {
    change({});
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    $('copy-link').textContent = 'Copied';
    setTimeout(() => $('copy-link').textContent = 'Copy link', 1500);
  };
  for (const button of document.querySelectorAll('[data-shape]'))
    button.onclick = () => change({light: {...state.light, outline: shapes[button.dataset.shape]}});
  const point = (event) => {
    const box = $('map').getBoundingClientRect(), columns = fit.map.roughness.length, rows = fit.map.thetaDegrees.length;
    const at = (share, count) => Math.min(Math.max(Math.floor(share * count), 0), count - 1);
    change({roughness: fit.map.roughness[at((event.clientX - box.x) / box.width, columns)],
            thetaDegrees: Math.min(fit.map.thetaDegrees[rows - 1 - at((event.clientY - box.y) / box.height, rows)], 88)});
  };
  $('map').addEventListener('pointerdown', (event) => fit && point(event));
  $('map').addEventListener('pointermove', (event) => fit && event.buttons && point(event));
  $('map').addEventListener('keydown', (event) => {
    const step = {ArrowLeft: [-0.025, 0], ArrowRight: [0.025, 0], ArrowUp: [0, 2], ArrowDown: [0, -2]}[event.key];
    if (!step) return;
    event.preventDefault();
    change({roughness: Math.min(Math.max(state.roughness + step[0], 0), 1),
            thetaDegrees: Math.min(Math.max(state.thetaDegrees + step[1], 0), 88)});
  });
  $('merl').addEventListener('change', () => takeMerl($('merl').files[0]));
  addEventListener('dragover', (event) => {
    event.preventDefault();
    document.body.classList.add('dropping');
  });
  addEventListener('dragleave', () => document.body.classList.remove('dropping'));
  addEventListener('drop', (event) => {
    event.preventDefault();
    document.body.classList.remove('dropping');
    takeMerl(event.dataTransfer.files[0]);
  });
  $('take-table').addEventListener('submit', takeTable);
  $('take-shader').addEventListener('submit', takeShader);
  $('layout').addEventListener('change', () => {
    const engine = $('layout').value.startsWith('engine:');
    for (const id of ['container', 'precision']) $(id).disabled = engine;
  });
  new ResizeObserver(() => fit && show()).observe($('preview'));
}

async function makePreview() {
  const forceWebGL = new URLSearchParams(location.search).get('graphics') === 'webgl';
  try {
    preview = await Preview.make($('preview'), {forceWebGL, lost, restored});
    document.documentElement.dataset.graphics = preview.graphics;
  } catch (error) {
    withoutPicture(error);
  }
}

function lost() { withoutPicture(new Error('The graphics device was lost; the picture comes back with it, all else works.')); }

async function restored() {
  $('no-preview').hidden = true;
  $('no-preview').textContent = '';
  await makePreview();
  if (fit === null) return;
  await preview?.prepare(fit).catch(withoutPicture);
  showFit();
}

function restore() {
  const choices = {brdfs: [k_own, ...fitter.catalogue.brdfs.map((b) => b.name)], forms: ['table', 'two-lobe'],
                   sizes: ['16', '32', '64'], objectives: ['balanced', 'tv', 'l2', 'l3']};
  const linked = fromLink(location.hash, choices);
  Object.assign(state, linked ?? {});
  trusted = linked?.text === undefined || linked.text === example || state.brdf !== k_own;
}

async function begin() {
  editor = new Editor($('text'), $('lines'), (text) => {
    trusted = true;
    change({text});
    later();
  });
  const made = makePreview(); // while the fitter is fetched
  fitter = await Fitter.load();
  await made;
  const {brdfs, colormaps, version} = fitter.catalogue;
  colours = colormaps;
  cosine = lobePicture([1, 0, 0, 0, 1, 0, 0, 0, 1], colours);
  drawStrip($('map-scale'), colours.magma);
  const add = (value, text) => $('brdf').append(Object.assign(document.createElement('option'), {value, textContent: text}));
  add(k_own, 'your own, in JavaScript');
  for (const {name} of brdfs) add(name, name);
  fillChoices({layout: $('layout'), container: $('container'), language: $('language')}, fitter.catalogue);
  $('version').textContent = `OpenLTC ${version}, MIT licence.${preview ? ` The picture is drawn by ${preview.graphics}.` : ''}`;
  restore();
  editor.value = state.text;
  listen();
  chooseBrdf(state.brdf);
}

begin().catch((error) => {
  say('');
  complain(`The fitter did not start: ${error.message}. The page wants a server of files (python3 -m http.server), and a browser with WebAssembly.`);
});
