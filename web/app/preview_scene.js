// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The shader of the laboratory's picture, in the words of GLSL or WGSL: a floor and a ball of the fitted BRDF under the
// polygon. The cross on the floor is the point that the figure beside it looks at, from the camera's direction:
// wo = (sin theta, 0, cos theta). Functions of the shader file that `openltc shaders` writes stand before it; the page's
// numbers are `page`, its textures coefficients, amplitudes and, of two lobes, second.

/// vec4 of "polygon data": 31 corners.
export const k_most_data = 40;
/// Of the light, linear, radiance 1 where it is most.
export const lightColor = [1.0, 0.92, 0.8];

/// Numbers of `page`, in this order, after `polygon`: four each.
export const k_numbers = ['eye_roughness', 'right_exposure', 'up_field', 'forward_wide', 'color', 'size'];

export const glslWords = {
  bool: 'bool', int: 'int', real: 'float', vec2: 'vec2', vec3: 'vec3', vec4: 'vec4',
  fn: (type, name, parameters, body) => `${type} ${name}(${parameters.map((p) => p.join(' ')).join(', ')}) {\n${body}}\n`,
  variable: (type, name, value) => `  ${type} ${name} = ${value};\n`,
  choose: (condition, yes, no) => `((${condition}) ? (${yes}) : (${no}))`,
  sampler: '',
};

export const wgslWords = {
  bool: 'bool', int: 'i32', real: 'f32', vec2: 'vec2f', vec3: 'vec3f', vec4: 'vec4f',
  fn: (type, name, parameters, body) => `fn ${name}(${parameters.map(([of, p]) => `${p}: ${of}`).join(', ')}) -> ${type} {\n${body}}\n`,
  variable: (type, name, value) => `  var ${name}: ${type} = ${value};\n`,
  choose: (condition, yes, no) => `select(${no}, ${yes}, ${condition})`,
  sampler: ', table_sampler',
};

/// `two`: whether the BRDF has two lobes. Its `vec4 picture_at(vec2 pixel)` is the colour of a pixel, counted from the
/// lower left corner.
export function sceneText(words, two) {
  const {bool, choose, fn, int, real, sampler, variable, vec2, vec3, vec4} = words;
  const table = `coefficients, amplitudes${two ? ', second' : ''}${sampler}`, ball = `${vec3}(-0.75, 1.15, 0.6)`;
  const surface = fn('ltc_Surface', 'surface_of', [[vec3, 'position'], [vec3, 'normal'], [vec3, 'view']],
      variable(vec3, 'facing', choose('dot(normal, view) < 0.0', 'view', 'normal')) +
      variable(real, 'cosine', 'clamp(dot(facing, view), 0.0, 1.0)') +
      variable(real, 'rough', 'max(page.eye_roughness.w, ltc_k_min_roughness)') +
      // The lobe of some keeps its width as roughness vanishes.
      variable(real, 'width', choose('page.forward_wide.w > 0.5', '1.0', 'ltc_alpha_from_roughness(rough)')) +
      variable('ltc_Surface', 's', `ltc_make_surface(ltc_fetch_lobe_of_width(${table}, rough, width, cosine), position, facing, view,
      ${vec3}(0.0), ${vec3}(1.0), ${vec3}(1.0), rough)`) +
      (two ? `  return ltc_add_second_lobe(s, ltc_fetch_second_lobe_of_width(${table}, rough, width, cosine));\n` : '  return s;\n'));
  // Distance to the polygon along a ray, or -1: the even-odd rule in the plane of its spreads.
  const meet = fn(real, 'meet_polygon', [[vec3, 'start'], [vec3, 'along']],
      variable(vec3, 'n', 'ltc_polygon_normal(0)') + variable(vec3, 'o', 'ltc_polygon_origin(0)') +
      variable(real, 'far', 'dot(o - start, n) / dot(along, n)') + `  if (!(far > 0.0)) { return -1.0; }
` + variable(vec3, 'p', 'start + along * far') + variable(vec3, 'u', 'normalize(ltc_polygon_spread_u(0))') +
      variable(vec3, 'v', 'cross(n, u)') + variable(bool, 'inside', 'false') + variable(int, 'count', 'ltc_polygon_point_count(0)') +
      variable(int, 'i', '1') + `  while (i < count) {
  ${variable(vec3, 'a', 'ltc_polygon_point(0, i - 1) - p')}  ${variable(vec3, 'b', 'ltc_polygon_point(0, i) - p')}` + `
  ${variable(vec2, 's', `${vec2}(dot(a, u), dot(a, v))`)}  ${variable(vec2, 't', `${vec2}(dot(b, u), dot(b, v))`)}` + `
    if ((s.y > 0.0) != (t.y > 0.0)) { if (0.0 < s.x - s.y * (t.x - s.x) / (t.y - s.y)) { inside = !inside; } }
    i += 1;
  }
  return ${choose('inside', 'far', '-1.0')};
`);
  const picture = fn(vec4, 'picture_at', [[vec2, 'pixel']],
      variable(vec3, 'eye', 'page.eye_roughness.xyz') + variable(vec2, 'size', 'page.size.xy') +
      variable(vec2, 'at', '(2.0 * pixel - size) / min(size.y, size.x * 0.75)') +
      variable(vec3, 'along', `normalize(page.forward_wide.xyz + page.up_field.w * (at.x * page.right_exposure.xyz + at.y * page.up_field.xyz))`) +
      variable(real, 'nearest', '1.0e9') + variable(real, 'fade', '1.0') +
      variable(vec3, 'position', 'eye') + variable(vec3, 'normal', `${vec3}(0.0, 0.0, 1.0)`) +
      variable(real, 'to_floor', '-eye.z / along.z') + `  if (to_floor > 0.0) {
    nearest = to_floor;
    position = eye + along * to_floor;
    fade = 1.0 - smoothstep(3.0, 7.5, length(position.xy));
  }
` + variable(vec3, 'ball', ball) + variable(vec3, 'to_ball', 'ball - eye') + variable(real, 'middle', 'dot(to_ball, along)') +
      variable(real, 'inside', 'ball.z * ball.z - dot(to_ball, to_ball) + middle * middle') +
      variable(real, 'to_surface', 'middle - sqrt(max(inside, 0.0))') + `  if (inside > 0.0 && to_surface < nearest) {
    nearest = to_surface;
    position = eye + along * nearest;
    normal = normalize(position - ball);
    fade = 1.0;
  }
` + variable(vec3, 'light', `${vec3}(0.0)`) + variable(real, 'lamp', 'meet_polygon(eye, along)') + `  if (lamp > 0.0 && lamp < nearest) {
    light = page.color.xyz;
  } else if (nearest < 1.0e9 && fade > 0.0) {
    light = fade * page.color.xyz * ltc_shade_polygon(surface_of(position, normal, -along), 0) + 0.004 * fade;
  }
  // The point of the figure.
  if (nearest < 1.0e9 && abs(position.z) < 1.0e-3 && lamp < 0.0) {
  ${variable(vec2, 'd', 'abs(position.xy)')}    if (max(d.x, d.y) < 0.09 && min(d.x, d.y) < 0.008) { light = mix(light, ${vec3}(0.15, 0.65, 1.0), 0.9); }
  }
` + variable(vec3, 'shown', '1.0 - exp(-page.right_exposure.w * light)') +
      `  return ${vec4}(mix(12.92 * shown, 1.055 * pow(shown, ${vec3}(1.0 / 2.4)) - 0.055, step(${vec3}(0.0031308), shown)), 1.0);
`);
  return surface + meet + picture;
}
