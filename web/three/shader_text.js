// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shader text that a material gets, for the shapes that a scene has, in any language with braces.

import {heads, originIndex} from './rows.js';

// A light of each shape; i is its head.
const element = k => `openltc_element(i + ${k})`;
const halves = `${element(1)}.xyz, ${element(2)}.xyz, ${element(3)}.xyz, ${element(1)}.w`;
const lights = {
  quad: `openltc_make_quad(${halves})`,
  polygon: 'i + 1',
  ellipse: `openltc_make_ellipse(${halves})`,
  sphere: `openltc_make_sphere(${element(1)}.xyz, ${element(1)}.w)`,
  tube: `openltc_make_tube(${element(1)}.xyz, ${element(2)}.xyz, ${element(1)}.w, ${element(2)}.w)`,
  line: `openltc_make_line(${element(1)}.xyz, ${element(2)}.xyz)`,
};

/// The light of a shape whose head is i.
export const makeLight = shape => lights[shape];

// What a surface reflects of it. `picture` is what a light with one looks at.
function shadeLight(shape, picture) {
  if (!picture) return `openltc_shade_${shape}_parts(surface, ${lights[shape]})`;
  return `openltc_shade_picture(surface,
        openltc_surface_${shape}_integral(surface, ${lights[shape]}), ${lights.quad}, ${picture})`;
}

/// `text` and what it needs of the definitions, those first.
export function withDefinitions(text, definitions) {
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

/// Each picture is a texture of its own, which no loop can choose: lights with pictures are written out.
export const isPicture = shape => shape.endsWith('_picture');

/// What a shader holds for `count` lights of a shape, beside the number itself: as a word, '' for none.
export function formOf(shape, count) {
  if (count === 0) return '';
  return isPicture(shape) ? `${shape}:${count}` : shape;
}

/// How many pictures a scene's shader has, for its forms.
export function picturesOf(forms) {
  return forms.reduce((sum, form) => sum + (isPicture(form.split(':')[0]) ? Number(form.split(':')[1]) : 0), 0);
}

// The sum over all lights of a form; `pictures` are the names of those that are left.
function sumOf(form, {int, pictureArgument}, pictures, radiance) {
  const [shape, copies] = form.split(':'), [plain] = shape.split('_');
  const body = picture => `    head = openltc_element(i);
    sum = openltc_add_light(sum, ${shadeLight(plain, picture)}, ${radiance});
    i += ${int}(abs(head.w));
`;
  const lights = isPicture(shape)
      ? pictures.splice(0, copies).map(name => `  if (i < end) {\n${body(pictureArgument(name))}  }\n`).join('')
      : `  while (i < end) {\n${body('')}  }\n`;
  return `  head = openltc_element(${heads[shape]});
  i = ${int}(head.x);
  end = ${int}(head.y);
${lights}`;
}

// A light with a picture: its integral, and what each part of the surface's reflection sees of the picture, which
// fills a rectangle.
function pictureFunction({fn, pictureParameters, pictureArgument}) {
  const seen = (lobe, direction) => `openltc_emission_seen_part(rectangle, ${pictureArgument('picture')},
      surface.position, surface.frame, ${lobe}, integral.${direction}, openltc_front_shading(surface), false)`;
  return fn('openltc_ShadedLight', 'openltc_shade_picture',
            [['openltc_Surface', 'surface'], ['openltc_LightIntegral', 'integral'], ['openltc_Quad', 'rectangle'],
             ...pictureParameters('picture')],
            `  return openltc_ShadedLight(openltc_shade_integral(surface, integral).diffuse *
      ${seen('openltc_cosine_lobe()', 'diffuse_direction')},
      openltc_shade_integral(surface, integral).specular *
      ${seen('surface.fitted.lobe', 'specular_direction')});
`);
}

/// Types and names of what says what a layer of the material is. Position, normal and the direction to the eye are in the
/// axes of three.js's view, to_world turns them; `eye` is the camera's place in the world.
export const layerParameters = ({mat3, real, vec3}) => [
  [mat3, 'to_world'], [vec3, 'eye'], [vec3, 'position'], [vec3, 'normal'], [vec3, 'view'], [vec3, 'albedo'], [vec3, 'f0'],
  [real, 'f90'], [real, 'roughness']];

/// Functions for the forms of a scene's shapes, in the words of a language (glsl.js). They call
/// `vec4 openltc_element(int i)`, element i of LightRows, which stands before them, and look at as many `pictures`,
/// names of textures, as picturesOf(forms) says. `radiance` is that of a light, of its head.
///
/// openltc_shade_layer is the light of a layer of the material, of layerParameters.
export function functionsFor(forms, words, pictures, radiance = 'head.rgb') {
  const {int, vec3, vec4, definitions, fn, variable} = words, light = 'openltc_ShadedLight';
  const zero = `${light}(${vec3}(0.0), ${vec3}(0.0))`;
  const left = [...pictures];
  return fn(vec4, 'openltc_polygon_data', [[int, 'i']], '  return openltc_element(i);\n') + withDefinitions([
    pictures.length ? pictureFunction(words) : '',
    fn(light, 'openltc_add_light', [[light, 'sum'], [light, 'light'], [vec3, 'radiance']],
       `  return ${light}(sum.diffuse + radiance * light.diffuse, sum.specular + radiance * light.specular);\n`),
    fn(light, 'openltc_shade_lights', [['openltc_Surface', 'surface']],
       variable(light, 'sum', zero) + variable(int, 'i', '0') + variable(int, 'end', '0') +
       variable(vec4, 'head', `${vec4}(0.0)`) + forms.map(form => sumOf(form, words, left, radiance)).join('') + '  return sum;\n'),
    fn(light, 'openltc_shade_layer', layerParameters(words),
       `  return openltc_shade_lights(openltc_surface_at(
      to_world * position + (eye - openltc_element(${originIndex}).xyz),
      to_world * normal, to_world * view, albedo, f0, ${vec3}(f90), roughness));
`),
  ].join('\n'), definitions);
}
