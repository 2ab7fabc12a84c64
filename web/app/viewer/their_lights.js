// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// three.js's own area lights in place of ours, as far as it has any.

import {DataTexture, HalfFloatType, LinearFilter, Matrix4, RectAreaLight, RectAreaLightNode, RGBAFormat} from 'three';
import {unpack} from './table_bytes.js';

// three.js's tables, as build_viewer.mjs has packed them: text of RectAreaLightTexturesLib is several times as long.
const packed = await (await fetch(new URL('viewer/their_tables.bin', document.baseURI))).arrayBuffer();
const halves = unpack(new Uint8Array(packed), 64);
const tables = [0, 1].map(k => {
  const texture = new DataTexture(halves.subarray(k * halves.length / 2, (k + 1) * halves.length / 2), 64, 64, RGBAFormat, HalfFloatType);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
});
RectAreaLightNode.setLTC({LTC_FLOAT_1: tables[0], LTC_FLOAT_2: tables[1], LTC_HALF_1: tables[0], LTC_HALF_2: tables[1]});

const turned = new Matrix4().makeRotationY(Math.PI);

// Width and height of the rectangle that stands for a flat light: of the same area, and the proportions of its bounds.
function sidesOf(light) {
  if (light.type === 'RectLight') return [light.width, light.height];
  const points = light.outlines().flat(), extent = k => Math.max(...points.map(p => p[k])) - Math.min(...points.map(p => p[k]));
  const [w, h] = [extent(0), extent(1)], shrink = Math.sqrt(light.emittingArea() / light.sides / (w * h));
  return [w * shrink, h * shrink];
}

function rectangle(light, matrix) {
  const made = new RectAreaLight(0xffffff, light.luminance, ...sidesOf(light));
  made.color.copy(light.color);
  made.matrixAutoUpdate = false;
  made.matrix.copy(matrix);
  return made;
}

/// What three.js has for these lights: {made, others, missing}: its lights, how many stand for other flat shapes, and
/// how many there is nothing for.
export function theirLights(lights) {
  const flat = lights.filter(light => light.sides !== undefined);
  return {
    made: flat.flatMap(light => [light.matrixWorld, ...(light.twoSided ? [light.matrixWorld.clone().multiply(turned)] : [])]
        .map(matrix => rectangle(light, matrix))),
    others: flat.filter(light => light.type !== 'RectLight').length,
    missing: lights.length - flat.length,
  };
}
