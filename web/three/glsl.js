// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

import {definitions} from './shaders_glsl.js';

/// The words of GLSL.
export const glsl = {
  definitions,
  bool: 'bool', int: 'int', uint: 'uint', real: 'float', vec2: 'vec2', vec3: 'vec3', vec4: 'vec4', uvec3: 'uvec3', mat3: 'mat3',
  /// A function; of no type, one that returns nothing.
  fn: (type, name, parameters, body) => `${type || 'void'} ${name}(${parameters.map(p => p.join(' ')).join(', ')}) {\n${body}}\n`,
  variable: (type, name, value) => `  ${type} ${name} = ${value};\n`,
  declare: (type, name) => `  ${type} ${name};\n`,
  /// For an invocation, outside of functions.
  global: (type, name) => `${type} ${name};\n`,
  /// openltc_element and openltc_tree read textures of these names.
  element: texture => `vec4 openltc_element(int i) { return texelFetch(${texture}, ivec2(i & 255, i >> 8), 0); }\n`,
  tree: texture => `vec4 openltc_tree(int i) { return texelFetch(${texture}, ivec2(i & 2047, i >> 11), 0); }\n`,
  /// A texture and how to look at it, as parameters and as an argument.
  pictureParameters: name => [['sampler2D', name]],
  pictureArgument: name => name,
  pictureTexel: (name, uv) => `textureLod(${name}, ${uv}, 0.0).rgb`,
};
