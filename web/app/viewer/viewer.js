// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The viewer: what the page does with a file, its lights and its picture.

import {Vector3} from 'three';
import {save} from '../downloads.js';
import {ev100Of, exposureOf, scaleColors} from './display.js';
import {kinds, settle} from './light_kinds.js';
import {Panel} from './panel.js';
import {views} from './pictures.js';
import {SceneReader, disposeOf, mostBytes} from './scene_file.js';
import {Stage} from './stage.js';
import {studioLights} from './studio.js';
import {takeEmissive} from './emissive.js';

const $ = id => document.getElementById(id);
const k_preparing = 'Preparing';
const modes = {translate: 'Move', rotate: 'Turn', scale: 'Resize'};
const demo = 'demo.glb', k_look = 1000; // ms between two looks at a scene's file

let stage, reader, panel, name = 'scene', loading = 0, warnings = [], began = performance.now();

// ---- words

// It is read aloud: only what is new.
function say(text) {
  if ($('status').textContent !== text) $('status').textContent = text;
}

function complain(text) {
  $('message').textContent = text;
  $('message').hidden = text === '';
}

function note(more = []) {
  const {view, own, lights} = stage.pictures, notes = [...warnings, ...more];
  if (view === 'theirs' || view === 'error_theirs') {
    if (own.others) notes.push(`three.js has rectangles alone: ${own.others} of ${lights.length} lights are rectangles of the same area`);
    if (own.missing) notes.push(`${own.missing} of ${lights.length} lights have no counterpart in three.js and are left out`);
    if (stage.pictures.castShadows) notes.push('area lights of three.js have no shadows');
  }
  if ($('notes').dataset.text === notes.join()) return;
  $('notes').dataset.text = notes.join();
  $('notes').replaceChildren(...notes.slice(0, 8).map(text => Object.assign(document.createElement('li'), {textContent: text})));
  $('notes').hidden = notes.length === 0;
}

// ---- scenes

async function open(bytes, title, {path = '', keepsPlace = false} = {}) {
  const mine = ++loading;
  complain('');
  say(`Reading ${title}`);
  try {
    const gltf = await reader.read(stage.renderer, bytes, title, path);
    if (mine !== loading) return disposeOf(gltf.scene);
    show(gltf, title, keepsPlace);
  } catch (error) {
    if (mine !== loading) return;
    complain(`${error.message}.`);
    say(stage.content ? `Shown is ${name}` : 'No scene yet');
  }
}

function show(gltf, title, keepsPlace) {
  const place = keepsPlace && stage.content ? stage.place : null, old = stage.clear();
  if (old) disposeOf(old);
  name = title;
  const root = gltf.scene;
  root.updateMatrixWorld(true);
  const bounds = Stage.boundsOf(root), own = [];
  let others = 0;
  root.traverse(object => {
    if (object.isAreaLight) own.push(object);
    else if (object.isLight) ++others;
  });
  stage.setScene(root, gltf.cameras[0] ?? null, bounds);
  if (place) stage.place = place;
  const emissive = takeEmissive(root);
  for (const light of own) settle(light, root);
  warnings = [...gltf.warnings, ...emissive.warnings];
  const lights = [...own, ...emissive.lights], isStudio = lights.length + others === 0;
  if (isStudio) {
    lights.push(...studioLights(bounds, stage.camera.getWorldDirection(new Vector3())));
    warnings.push('it has no lights of its own: these three are a studio rig');
  }
  for (const light of lights) stage.addLight(light);
  choose(null);
  $('list').dataset.scene = name;
  if (place) stage.invalidate();
  else setExposure(isStudio ? ev100Of(1) : undefined);
  say(`${name}: ${lights.length} area light${lights.length === 1 ? '' : 's'}${others ? `, ${others} other${others === 1 ? '' : 's'}` : ''}`);
  note();
}

async function take(file) {
  if (!file) return;
  if (file.size > mostBytes)
    return complain(`${file.name} is too large: ${(file.size / 2 ** 20).toFixed(0)} MB, and this page takes ${mostBytes / 2 ** 20} MB.`);
  await open(await file.arrayBuffer(), file.name);
}

// The last part of an address, as a name.
function nameOf(place) {
  const part = place.split('/').pop();
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
}

// An address on this server, or null.
function ownAddress(place) {
  try {
    const url = new URL(place, location.href);
    return url.origin === location.origin ? url : null;
  } catch {
    return null;
  }
}

async function fetchScene(place, {early, ...more} = {}) {
  const url = ownAddress(place), title = nameOf(place);
  if (!url) {
    say('No scene yet');
    return complain('The scene of a link must lie on the server of this page.');
  }
  try {
    const response = await (early ?? fetch(url));
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
    await open(await response.arrayBuffer(), title, {path: new URL('.', url).href, ...more});
  } catch (error) {
    complain(`${title} cannot be fetched: ${error.message}.`);
    say(stage.content ? `Shown is ${name}` : 'No scene yet');
  }
}

// ---- lights

function choose(light) {
  stage.select(light);
  $('delete').disabled = !light;
  $('modes').hidden = !light;
  panel.show(stage.pictures.lights, light);
}

// A new one hangs over what the camera turns around, and gives a white card there what suits the exposure.
function addLight() {
  const {orbit, scale, pictures} = stage, size = 0.08 * scale, light = kinds[$('kind').value].make(size);
  light.position.copy(orbit.target).add(new Vector3(0, 0.25 * scale, 0));
  if (kinds[light.type].flat) light.rotation.set(-Math.PI / 2, 0, 0);
  const far = 0.25 * scale, white = 0.5 / pictures.exposure;
  light.intensity = light.type === 'LineLight' ? white * Math.PI * far ** 2 : Number((white * Math.PI * far ** 2 / (light.emittingArea() / (light.sides ?? 3))).toPrecision(3));
  light.name = `${kinds[light.type].title.toLowerCase()} ${pictures.lights.length + 1}`;
  stage.addLight(light);
  choose(light);
  changed();
}

function changed() {
  panel.show(stage.pictures.lights, stage.selected);
  note();
  stage.invalidate();
}

function deleteLight() {
  const {lights} = stage.pictures, at = lights.indexOf(stage.selected);
  if (at < 0) return;
  const shown = stage.selected.children.filter(child => !child.isLight);
  for (const child of shown) { // the mesh that showed it glows no more
    child.removeFromParent();
    disposeOf(child);
  }
  stage.removeLight(stage.selected);
  choose(stage.pictures.lights[Math.min(at, stage.pictures.lights.length - 1)] ?? null);
  changed();
}

// ---- the picture

async function setExposure(ev100) {
  const {content} = stage, measured = ev100 === undefined ? await stage.measureExposure() : null;
  if (stage.content !== content) return; // another scene has come
  const value = ev100 ?? (measured ? ev100Of(measured) : ev100Of(1));
  $('exposure').value = value.toFixed(1);
  stage.pictures.exposure = exposureOf(Number($('exposure').value));
  if (measured) stage.showMeasured();
  else stage.invalidate();
}

async function setView(view, castShadows) {
  say(k_preparing);
  try {
    await stage.pictures.prepare(view, castShadows);
  } catch (error) {
    return complain(`A part of the page could not be fetched: ${error.message}.`);
  }
  Object.assign(stage.pictures, {view, castShadows});
  $('legend').hidden = !view.startsWith('error');
  stage.pictures.reset();
  stage.invalidate();
}

const viewNow = () => document.querySelector('#views :checked').value;

function onDrawn() {
  const {pictures} = stage;
  if (document.documentElement.dataset.firstPicture === undefined)
    document.documentElement.dataset.firstPicture = (performance.now() - began).toFixed(0);
  document.documentElement.dataset.drawn = Number(document.documentElement.dataset.drawn ?? 0) + 1;
  $('progress').hidden = !pictures.sendsRays || pictures.isDone;
  $('progress').max = pictures.frames;
  $('progress').value = pictures.frame;
  $('rays').textContent = pictures.sendsRays && pictures.lights.length ? `${pictures.frame} of ${pictures.frames} rays a pixel and light` : '';
  if ($('status').textContent === k_preparing) say(`Shown is ${name}`);
  note();
}

function onMeasured() {
  const {mean, frame} = stage.pictures;
  $('mean').textContent = mean === null ? '–' : `Mean difference ${mean.toFixed(2)} of 255 on surfaces, of which the noise of ${frame} rays a pixel and light is a part`;
  $('mean').dataset.mean = mean ?? '';
}

// ---- taking away

async function saveScene() {
  $('save-glb').disabled = true;
  try {
    const {glbOf} = await import('./save.js');
    const bytes = await glbOf(stage.world, stage.camera);
    const saved = save([{name: `${name.replace(/\.gl(b|tf)$/i, '')}_lights.glb`, bytes}]);
    dispatchEvent(new CustomEvent('taken', {detail: saved}));
  } catch (error) {
    complain(`The scene could not be written: ${error.message}.`);
  }
  $('save-glb').disabled = false;
}

async function savePicture() {
  const blob = await stage.picture();
  const saved = save([{name: `${name.replace(/\.gl(b|tf)$/i, '')}.png`, bytes: await blob.arrayBuffer()}]);
  dispatchEvent(new CustomEvent('taken', {detail: saved}));
}

// ---- start

function radios(parent, group, choices, checked, chosen) {
  for (const [value, text] of Object.entries(choices)) {
    const input = Object.assign(document.createElement('input'), {type: 'radio', name: group, value, checked: value === checked});
    input.addEventListener('change', () => chosen(value));
    const label = document.createElement('label');
    label.append(input, text);
    parent.append(label);
  }
}

function listen() {
  radios($('views'), 'view', views, 'ltc', view => setView(view, $('shadows').checked));
  radios($('modes'), 'mode', modes, 'translate', mode => stage.gizmo.setMode(mode));
  for (const [type, {title}] of Object.entries(kinds)) $('kind').append(Object.assign(document.createElement('option'), {value: type, textContent: title}));
  $('add').onclick = addLight;
  $('delete').onclick = deleteLight;
  $('demo').onclick = () => fetchScene(demo);
  $('file').addEventListener('change', async () => {
    await take($('file').files[0]);
    $('file').value = '';
  });
  $('exposure').addEventListener('input', () => {
    const ev100 = Number($('exposure').value);
    if ($('exposure').value === '' || !(Math.abs(ev100) <= 40)) return;
    stage.pictures.exposure = exposureOf(ev100);
    stage.invalidate();
  });
  $('auto').onclick = () => setExposure();
  $('tonemap').addEventListener('change', () => {
    stage.pictures.tonemap = $('tonemap').value;
    stage.invalidate();
  });
  $('shadows').addEventListener('change', () => setView(viewNow(), $('shadows').checked));
  $('outlines').addEventListener('change', () => {
    stage.showsLights = $('outlines').checked;
    stage.invalidate();
  });
  $('most').addEventListener('change', () => {
    stage.pictures.most = Number($('most').value);
    $('most-text').textContent = $('most').value;
    stage.invalidate();
  });
  $('strip').style.background = `linear-gradient(to right, ${scaleColors.join(', ')})`;
  $('save-glb').onclick = saveScene;
  $('save-png').onclick = savePicture;
  let depth = 0;
  const dropping = on => document.body.classList.toggle('dropping', on);
  addEventListener('dragenter', () => dropping(++depth > 0));
  addEventListener('dragleave', () => dropping(--depth > 0));
  addEventListener('dragover', event => event.preventDefault());
  addEventListener('drop', event => {
    event.preventDefault();
    dropping((depth = 0) > 0);
    take(event.dataTransfer.files[0]);
  });
  stage.addEventListener('chosen', ({detail}) => choose(detail));
  stage.addEventListener('moved', () => panel.write());
  stage.addEventListener('drawn', onDrawn);
  stage.addEventListener('measured', onMeasured);
  stage.addEventListener('broken', ({detail}) => complain(detail));
  stage.addEventListener('lost', () => complain('The graphics device was lost; another one is asked for, all else works.'));
  stage.addEventListener('restored', () => complain(''));
}

// `openltc view` tells a version of the file that changes with it.
async function watch(place) {
  const ended = 'openltc view does not answer; the scene stays as it was read, until it is started again.';
  for (let known = null;;) {
    const version = await fetch('/version').then(response => response.ok ? response.text() : null, () => undefined);
    if (version === undefined) complain(ended);
    else if ($('message').textContent === ended) complain('');
    if (version && known && version !== known) await fetchScene(place, {keepsPlace: true});
    known = version || known;
    await new Promise(done => setTimeout(done, k_look));
  }
}

async function begin() {
  const place = new URLSearchParams(location.search).get('scene'), url = ownAddress(place ?? demo);
  const early = url ? fetch(url) : undefined; // comes while the graphics start
  early?.catch(() => {});
  try {
    stage = await Stage.make($('canvas'), new URLSearchParams(location.search).get('graphics') === 'webgl');
    document.documentElement.dataset.graphics = stage.graphics;
    $('graphics').textContent = `Drawn by ${stage.graphics}.`;
  } catch (error) {
    say('No picture');
    complain(`${error.message} The laboratory works without, but for its picture.`);
    for (const control of document.querySelectorAll('main button, main select, main input')) control.disabled = true;
    return;
  }
  reader = new SceneReader(new URL('decoders/', document.baseURI).href);
  panel = new Panel($('list'), $('fields'), {chosen: choose, changed});
  listen();
  window.viewer = stage; // for consoles and tests
  const watched = place && new URLSearchParams(location.search).has('watch');
  if (watched) $('about').textContent = `${nameOf(place)}, read from this computer; it is shown anew when its file changes.`;
  await fetchScene(place ?? demo, {early});
  if (watched) watch(place);
}

begin();
