// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Shader text of shadows, in any language with braces: for each pixel the ratio of a light's sampled light with and
// without what stands in its way.
//
// Source: Heitz, Hill, McGuire 2018, "Combining Analytic Direct Illumination and Stochastic Shadows". Points of lights
// and what they give are functions of `openltc shaders --sampling`.

import {heads, originIndex} from './rows.js';
import {isPicture, layerParameters, makeLight, withDefinitions} from './shader_text.js';

/// Whether anything meets a ray from `start` before `far`, by openltc_tree.
export function hiddenFunction({bool, fn, int, real, variable, vec3, vec4}) {
  return fn(bool, 'openltc_is_hidden', [[vec3, 'start'], [vec3, 'direction'], [real, 'far']],
            variable(vec3, 'slope', `${vec3}(1.0) / (direction + ${vec3}(1.0e-20))`) +
            variable(int, 'node', '0') + variable(int, 'nodes', `${int}(openltc_tree(0).x)`) +
            variable(bool, 'hidden', 'false') + `
  while (node < nodes) {
  ${variable(vec4, 'low', 'openltc_tree(1 + 2 * node)')}${variable(vec4, 'high', 'openltc_tree(2 + 2 * node)')}
  ${variable(vec3, 'a', '(low.xyz - start) * slope')}${variable(vec3, 'b', '(high.xyz - start) * slope')}
  ${variable(vec3, 'enter', 'min(a, b)')}${variable(vec3, 'leave', 'max(a, b)')}
  ${variable(real, 'near', 'max(max(enter.x, enter.y), max(enter.z, 0.0))')}
  ${variable(int, 'next', `${int}(low.w)`)}
    if (low.w < 0.0) { next = node + 1; }
    if (near <= min(min(leave.x, leave.y), min(leave.z, far))) {
      next = node + 1;
      if (low.w < 0.0) {
${variable(int, 'k', `${int}(high.w)`)}${variable(int, 'end', `k - 3 * ${int}(low.w)`)}
        while (k < end) {
${variable(vec3, 'p', 'openltc_tree(k).xyz')}${variable(vec3, 'e', 'openltc_tree(k + 1).xyz - p')}
${variable(vec3, 'f', 'openltc_tree(k + 2).xyz - p')}${variable(vec3, 'n', 'cross(e, f)')}
${variable(real, 'slant', '-dot(direction, n)')}
          if (abs(slant) > 1.0e-30) {
${variable(vec3, 'o', 'start - p')}${variable(vec3, 'c', 'cross(o, direction)')}
${variable(real, 'u', 'dot(f, c) / slant')}${variable(real, 'v', '-dot(e, c) / slant')}${variable(real, 't', 'dot(o, n) / slant')}
            if (min(min(u, v), 1.0 - u - v) >= -1.0e-5) { if (t > 0.0) { if (t < far) { hidden = true; } } }
          }
          k += 3;
        }
        if (hidden) { next = nodes; }
      }
    }
    node = next;
  }
  return hidden;
`);
}

// Three numbers from 0 to 1 for a pixel, light and picture: a hash, moved from picture to picture so that the numbers
// fill the cube evenly: by 0.819, 0.671 and 0.549 of 2^32.
function numbersFunction({fn, int, uint, uvec3, variable, vec2, vec3}) {
  const round = `  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v = v ^ (v >> ${uvec3}(16u));
`;
  return fn(vec3, 'openltc_numbers', [[vec2, 'pixel'], [int, 'light'], [uint, 'frame']],
            variable(uvec3, 'v', `${uvec3}(${uint}(pixel.x), ${uint}(pixel.y), ${uint}(light)) * 1664525u + ${uvec3}(1013904223u)`) +
            round + round + `  v = v + frame * ${uvec3}(3518319155u, 2882110345u, 2360945575u);
  return ${vec3}(v >> ${uvec3}(8u)) / 16777216.0;
`);
}

// What a picture shows at a point of its light.
function texelFunction({fn, pictureParameters, pictureTexel, variable, vec2, vec3}) {
  return fn(vec3, 'openltc_texel', [['openltc_Quad', 'lamp'], [vec3, 'point'], ...pictureParameters('picture')],
            variable(vec3, 'to', 'point - lamp.center') +
            variable(vec2, 'uv', `${vec2}(dot(to, lamp.half_u) / dot(lamp.half_u, lamp.half_u),
      dot(to, lamp.half_v) / dot(lamp.half_v, lamp.half_v))`) +
            `  return ${pictureTexel('picture', `0.5 + 0.5 * uv`)};\n`);
}

// Adds a point of a light to the sums. Where the material reflects nothing of the points that were found, all of them
// count alike; the sums of the material itself do without.
function addFunction({fn, real, variable, vec3}, exact, coat) {
  return fn('', 'openltc_add_point', [
    ['openltc_Surface', 'surface'], ...(coat ? [['openltc_Surface', 'coat'], [real, 'coat_share']] : []),
    ['openltc_LightPoint', 'point'], [vec3, 'radiance'], [real, 'by_lobe'], [vec3, 'origin']], `  if (point.hit) {
${variable(real, 'density', 'openltc_point_density(surface, point, by_lobe)')}
${variable(vec3, 'light', 'openltc_eval_point(surface, point, density)')}
${coat ? '    light += coat_share * openltc_eval_point(coat, point, density);\n' : ''}${
    exact ? '' : `    light += ${vec3}(1.0e-4 / max(density, 1.0e-30));\n`}    openltc_all += radiance * light;
    if (!openltc_is_hidden(origin, point.direction, 0.9998 * point.distance - 0.0002)) { openltc_open += radiance * light; }
  }
`);
}

// The rays to all lights of a form that cast shadows.
function raysOf(form, words, pictures, exact, coat) {
  const {int, vec3, pictureArgument} = words, [shape, copies] = form.split(':'), [plain] = shape.split('_');
  const surfaces = coat ? 'coat, coat_share' : '', by_lobe = plain === 'line' ? '0.0' : 'by_lobe';
  const own = plain === 'line' && !exact ? 'rougher' : 'surface', lamp = makeLight(plain);
  const body = picture => `    head = openltc_element(i);
    if (head.w < 0.0) {
      u = openltc_numbers(pixel, i, frame);
      point = openltc_draw_${plain}(${lamp}, start, u.xy);
${plain === 'line' ? '' : `      if (u.z < by_lobe) { point = openltc_meet_${plain}(${lamp}, start, openltc_lobe_direction(surface, u.xy)); }
`}      openltc_add_point(${[own, surfaces, 'point', picture ? `head.rgb * openltc_texel(${makeLight('quad')},
          start + point.direction * point.distance, ${pictureArgument(picture)})` : 'head.rgb', by_lobe, 'origin'].filter(Boolean).join(', ')});
    }
    i += ${int}(abs(head.w));
`;
  const lights = isPicture(shape)
      ? pictures.splice(0, copies).map(name => `  if (i < end) {\n${body(name)}  }\n`).join('') : `  while (i < end) {\n${body('')}  }\n`;
  return `  head = openltc_element(${heads[shape]});
  i = ${int}(head.x);
  end = ${int}(head.y);
${lights}`;
}

/// Types and names of what openltc_trace takes: a layer of the material, a vector across its triangle, pixel and picture,
/// and with a clear coat that.
export const rayParameters = (words, coat) => [
  ...layerParameters(words), [words.vec3, 'across'], [words.vec2, 'pixel'], [words.uint, 'frame'],
  ...(coat ? [[words.vec3, 'coat_normal'], [words.real, 'coat_roughness'], [words.real, 'coat_share']] : [])];

/// Functions for the pass that sums, for the forms of a scene's shapes, in the words of a language. They call
/// `vec4 openltc_element(int i)`, of LightRows, and `vec4 openltc_tree(int i)`, of TreeTexture, which stand before them.
/// `exact`: the sums are those of the material itself, without what quiets a ratio. `coat`: there is a clear coat.
///
/// openltc_trace gives, as columns of a matrix, the light of one point of each light that casts shadows: of all, and of
/// those that nothing hides. Below a roughness of 0.4 half of the rays go where the material's lobe points, none for
/// the coat.
export function rayFunctions(forms, words, pictures, exact, coat) {
  const {fn, global, int, mat3, real, variable, vec3, vec4} = words, left = [...pictures];
  const surface = (normal, albedo, f0, f90, roughness) =>
      `openltc_surface_at(here - openltc_element(${originIndex}).xyz, to_world * ${normal}, to_world * view,
      ${albedo}, ${f0}, ${vec3}(${f90}), ${roughness})`;
  return global(vec3, 'openltc_all') + global(vec3, 'openltc_open') +
      fn(vec4, 'openltc_polygon_data', [[int, 'i']], '  return openltc_element(i);\n') + withDefinitions([
    hiddenFunction(words), numbersFunction(words), left.length ? texelFunction(words) : '', addFunction(words, exact, coat),
    fn(mat3, 'openltc_trace', rayParameters(words, coat), `  openltc_all = ${vec3}(0.0);
  openltc_open = ${vec3}(0.0);
` + variable(vec3, 'here', 'to_world * position + eye') +
       variable(vec3, 'up', 'to_world * normalize(across) * sign(dot(across, view))') +
       variable(vec3, 'origin', 'here + (1.0e-4 + 1.0e-6 * length(here)) * up') +
       variable(vec3, 'start', `origin - openltc_element(${originIndex}).xyz`) +
       variable('openltc_Surface', 'surface', surface('normal', 'albedo', 'f0', 'f90', 'roughness')) +
       (forms.includes('line') && !exact ? variable('openltc_Surface', 'rougher',
                                                   surface('normal', 'albedo', 'f0', 'f90', 'max(roughness, 0.25)')) : '') +
       (coat ? variable('openltc_Surface', 'coat', surface('coat_normal', `${vec3}(0.0)`, `${vec3}(0.04)`, '1.0',
                                                             exact ? 'coat_roughness' : 'max(coat_roughness, 0.25)')) : '') +
       variable(real, 'by_lobe', '0.5 * step(roughness, 0.4)') +
       variable(int, 'i', '0') + variable(int, 'end', '0') + variable(vec4, 'head', `${vec4}(0.0)`) +
       variable(vec3, 'u', `${vec3}(0.0)`) + words.declare('openltc_LightPoint', 'point') +
       forms.map(form => raysOf(form, words, left, exact, coat)).join('') +
       `  return ${mat3}(openltc_all, openltc_open, ${vec3}(0.0));\n`),
  ].join('\n'), words.definitions);
}

/// openltc_ratio_of is the ratio of both sums, for the picture itself. Where a channel was found of no ray, it is that of
/// all channels, and 1 where nothing was. openltc_radiance is that of a light, times openltc_ratio where it casts shadows.
export function ratioFunctions({fn, global, real, variable, vec3, vec4}) {
  const channel = c => `  if (all.${c} > 0.0) { ratio.${c} = open.${c} / all.${c}; }\n`;
  return global(vec3, 'openltc_ratio') +
      fn(vec3, 'openltc_ratio_of', [[vec3, 'all'], [vec3, 'open']],
         variable(real, 'sum', 'all.r + all.g + all.b') +
         variable(vec3, 'ratio', `${vec3}((open.r + open.g + open.b + 1.0e-30) / (sum + 1.0e-30))`) + ['r', 'g', 'b'].map(channel).join('') + '  return ratio;\n') +
      fn(vec3, 'openltc_radiance', [[vec4, 'head']], `  if (head.w < 0.0) { return head.rgb * openltc_ratio; }
  return head.rgb;
`);
}
