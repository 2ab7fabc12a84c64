// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shader text that a material gets, for the shapes that a scene has.

import {definitions} from './shaders.js';

// A light of each shape; i is its head.
const element = k => `openltc_element(i + ${k})`;
const halves = `${element(1)}.xyz, ${element(2)}.xyz, ${element(3)}.xyz, ${element(1)}.w`;
const calls = {
  quad: `openltc_shade_quad_parts(surface, openltc_make_quad(${halves}))`,
  polygon: 'openltc_shade_polygon_parts(surface, i + 1)',
  ellipse: `openltc_shade_ellipse_parts(surface, openltc_make_ellipse(${halves}))`,
  sphere: `openltc_shade_sphere_parts(surface, openltc_make_sphere(${element(1)}.xyz, ${element(1)}.w))`,
  tube: `openltc_shade_tube_parts(surface,
        openltc_make_tube(${element(1)}.xyz, ${element(2)}.xyz, ${element(1)}.w, ${element(2)}.w))`,
  line: `openltc_shade_line_parts(surface, openltc_make_line(${element(1)}.xyz, ${element(2)}.xyz))`,
};

// `text` and what it needs of the definitions, those first.
function withDefinitions(text) {
  const needed = new Set(), names = new Set(definitions.map(([name]) => name));
  const visit = part => {
    for (const [name] of part.matchAll(/\bopenltc_\w+/g))
      if (names.has(name) && !needed.has(name)) {
        needed.add(name);
        definitions.filter(([other]) => other === name).forEach(([, own]) => visit(own));
      }
  };
  visit(text);
  return definitions.filter(([name]) => needed.has(name)).map(([, own]) => own).join('\n') + '\n' + text;
}

// Round shapes are written out for so many lights: SwiftShader, which compiles one in a second, takes minutes for
// one in a loop.
const round = ['ellipse', 'sphere', 'tube'], mostCopies = 4;

/// What a shader holds for `count` lights of a shape, beside the number itself: as a word, '' for none.
export function formOf(shape, count) {
  if (count === 0) return '';
  return round.includes(shape) && count <= mostCopies ? `${shape}:${count}` : shape;
}

// The sum over all lights of a form.
function sumOf(form) {
  const [shape, copies] = form.split(':'), end = `openltc_range_${shape}.y`;
  const body = `    head = openltc_element(i);
    sum = openltc_add_light(sum, ${calls[shape]}, head.rgb);
    i += int(head.w);
`;
  const lights = copies ? `  if (i < ${end}) {\n${body}  }\n`.repeat(copies) : `  while (i < ${end}) {\n${body}  }\n`;
  return `  i = openltc_range_${shape}.x;\n${lights}`;
}

/// Declarations and functions, to stand before main(), for forms of shapes.
export function functionsFor(forms) {
  const sums = withDefinitions(`
openltc_ShadedLight openltc_add_light(openltc_ShadedLight sum, openltc_ShadedLight light, vec3 radiance) {
  sum.diffuse += radiance * light.diffuse;
  sum.specular += radiance * light.specular;
  return sum;
}

openltc_ShadedLight openltc_shade_lights(openltc_Surface surface) {
  openltc_ShadedLight sum = openltc_ShadedLight(vec3(0.0), vec3(0.0));
  int i;
  vec4 head;
${forms.map(sumOf).join('')}  return sum;
}

// A layer of the material: position and directions in the axes of three.js's view.
openltc_ShadedLight openltc_shade_layer(vec3 position, vec3 normal, vec3 view, vec3 albedo, vec3 f0, float f90,
                                        float roughness) {
  mat3 to_world = transpose(mat3(viewMatrix));
  return openltc_shade_lights(openltc_surface_at(to_world * position + (cameraPosition - openltc_origin),
      to_world * normal, to_world * view, albedo, f0, vec3(f90), roughness));
}
`);
  return `uniform highp sampler2D openltc_elements;
uniform vec3 openltc_origin;
${forms.map(form => `uniform ivec2 openltc_range_${form.split(':')[0]};\n`).join('')}
vec4 openltc_element(int i) { return texelFetch(openltc_elements, ivec2(i & 255, i >> 8), 0); }
vec4 openltc_polygon_data(int i) { return openltc_element(i); }
${sums}`;
}

/// What follows three.js's own lights in main(). The roughness is the material's own: three.js widens it where
/// normals bend within a pixel, which point lights need.
export const statements = `
{
  openltc_ShadedLight lit = openltc_shade_layer(geometryPosition, geometryNormal, geometryViewDir,
      material.diffuseContribution, material.specularColorBlended, material.specularF90, roughnessFactor);
  reflectedLight.directDiffuse += lit.diffuse;
  reflectedLight.directSpecular += lit.specular;
#ifdef USE_CLEARCOAT
  clearcoatSpecularDirect += openltc_shade_layer(geometryPosition, geometryClearcoatNormal, geometryViewDir,
      vec3(0.0), material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness - geometryRoughness).specular;
#endif
}
`;
