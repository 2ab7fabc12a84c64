// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

import {definitions} from './shaders_glsl.js';

/// The words of GLSL.
export const glsl = {
  definitions,
  int: 'int', real: 'float', vec3: 'vec3', vec4: 'vec4', mat3: 'mat3',
  fn: (type, name, parameters, body) => `${type} ${name}(${parameters.map(p => p.join(' ')).join(', ')}) {\n${body}}\n`,
  variable: (type, name, value) => `  ${type} ${name} = ${value};\n`,
  /// openltc_element reads a texture of this name.
  element: texture => `vec4 openltc_element(int i) { return texelFetch(${texture}, ivec2(i & 255, i >> 8), 0); }\n`,
  /// A texture and how to look at it, as parameters and as an argument.
  pictureParameters: name => [['sampler2D', name]],
  pictureArgument: name => name,
};
