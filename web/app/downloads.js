// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What can be taken away: tables by layout and container, files of engines, shaders.

import {zip} from './zip.js';

const k_containers = ['.json', '.dds', '.ktx2', '.exr', '.npy', '.h', '.glsl', '.hlsl', '.wgsl', '.js'];

/// The languages of shader files that stand beside the page, as build.mjs makes them.
export const languages = {
  'glsl-es': 'GLSL ES (WebGL 2)', glsl: 'GLSL (Vulkan, desktop)', wgsl: 'WGSL (WebGPU)', hlsl: 'HLSL (Unreal, Unity)',
  metal: 'Metal', gdshader: 'Godot 4',
};

function option(value, text, parent) {
  const made = document.createElement('option');
  made.value = value;
  made.textContent = text;
  parent.append(made);
}

export function fillChoices({layout, container, language}, catalogue) {
  const group = (label) => Object.assign(layout.appendChild(document.createElement('optgroup')), {label});
  const names = group('Layouts');
  for (const {name, readers} of catalogue.layouts) option(`layout:${name}`, name === 'native' ? 'OpenLTC (native)' : `${name}: ${readers}`, names);
  const engines = group('The very files of an engine');
  for (const {name, title} of catalogue.engines) option(`engine:${name}`, title, engines);
  for (const extension of k_containers) option(extension, extension, container);
  for (const name in languages) option(name, languages[name], language);
}

/// What is to be fitted and under which path, of the choices in the form.
export function requestOf(layout, container, precision, fit) {
  const [kind, name] = layout.split(':');
  if (kind === 'engine') return {options: {...fit, form: undefined, size: undefined, engine: name}, path: ''};
  const stem = (fit.brdf.name ?? 'table').replace(/\.binary$/, '').replace(/[^\w-]+/g, '_') || 'table';
  return {options: {...fit, layout: name, precision}, path: stem + container};
}

/// Gives files to the reader: one as it is, more in an archive.
export function save(files, archive) {
  const [name, blob] = files.length === 1 ? [files[0].name, new Blob([files[0].bytes])] : [archive + '.zip', zip(files)];
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  return {name, blob};
}
