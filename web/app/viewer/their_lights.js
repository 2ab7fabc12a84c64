// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// three.js's own area lights in place of ours, as far as it has any.

import {Matrix4, RectAreaLight} from 'three';
import {RectAreaLightUniformsLib} from 'three/addons/lights/RectAreaLightUniformsLib.js';

RectAreaLightUniformsLib.init();

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
