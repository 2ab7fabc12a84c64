// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

import {definitions} from './shaders_wgsl.js';

/// The words of WGSL, as glsl.js has them.
export const wgsl = {
  definitions,
  bool: 'bool', int: 'i32', uint: 'u32', real: 'f32', vec2: 'vec2f', vec3: 'vec3f', vec4: 'vec4f', uvec3: 'vec3u', mat3: 'mat3x3f',
  fn: (type, name, parameters, body) =>
      `fn ${name}(${parameters.map(([of, p]) => `${p}: ${of}`).join(', ')})${type && ` -> ${type}`} {\n${body}}\n`,
  variable: (type, name, value) => `  var ${name}: ${type} = ${value};\n`,
  declare: (type, name) => `  var ${name}: ${type};\n`,
  global: (type, name) => `var<private> ${name}: ${type};\n`,
  element: texture => `fn openltc_element(i: i32) -> vec4f { return textureLoad(${texture}, vec2i(i & 255, i >> 8u), 0); }\n`,
  tree: texture => `fn openltc_tree(i: i32) -> vec4f { return textureLoad(${texture}, vec2i(i & 2047, i >> 11u), 0); }\n`,
  pictureParameters: name => [['texture_2d<f32>', name], ['sampler', `${name}_sampler`]],
  pictureArgument: name => `${name}, ${name}_sampler`,
  pictureTexel: (name, uv) => `textureSampleLevel(${name}, ${name}_sampler, ${uv}, 0.0).rgb`,
};
