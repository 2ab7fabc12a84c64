// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

import {definitions} from './shaders_wgsl.js';

/// The words of WGSL, as glsl.js has them.
export const wgsl = {
  definitions,
  int: 'i32', real: 'f32', vec3: 'vec3f', vec4: 'vec4f', mat3: 'mat3x3f',
  fn: (type, name, parameters, body) =>
      `fn ${name}(${parameters.map(([of, p]) => `${p}: ${of}`).join(', ')}) -> ${type} {\n${body}}\n`,
  variable: (type, name, value) => `  var ${name}: ${type} = ${value};\n`,
  element: texture => `fn openltc_element(i: i32) -> vec4f { return textureLoad(${texture}, vec2i(i & 255, i >> 8u), 0); }\n`,
  pictureParameters: name => [['texture_2d<f32>', name], ['sampler', `${name}_sampler`]],
  pictureArgument: name => `${name}, ${name}_sampler`,
};
