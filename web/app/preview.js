// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A floor and a sphere of the fitted BRDF under the polygon, by WebGL 2 and the shader file that `openltc
// shaders` writes. The cross on the floor is the point that the figure beside it looks at, from the camera's
// direction: wo = (sin theta, 0, cos theta).

import {cornersOf, dataOf} from './polygon_light.js';

const k_most_data = 40; // vec4 of "polygon data": 31 corners
const k_distance = 4.2, k_target = [-0.45, 0.22, 0.42], k_field = 0.4;
/// Of the light, linear, radiance 1 where it is most.
export const lightColor = [1.0, 0.92, 0.8];

const k_steepest = 2, k_flattest = 84; // degrees at which the camera stays

const k_vertex = `#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0), 0.0, 1.0);
}`;

const k_head = `#version 300 es
precision highp float;
precision highp int;
uniform vec4 u_polygon[${k_most_data}];
vec4 ltc_polygon_data(int i) { return u_polygon[i]; }
`;

const k_main = `
uniform sampler2D u_coefficients, u_amplitudes, u_second;
uniform vec3 u_eye, u_right, u_up, u_forward;
uniform vec2 u_size;
uniform float u_field, u_roughness, u_exposure;
uniform bool u_wide; // the lobe keeps its width as roughness vanishes
uniform vec3 u_color;
out vec4 color;

#ifdef TWO_LOBES
#define TABLE u_coefficients, u_amplitudes, u_second
#else
#define TABLE u_coefficients, u_amplitudes
#endif

const vec3 k_ball = vec3(-0.75, 1.15, 0.6);

ltc_Surface surface_of(vec3 position, vec3 normal, vec3 view) {
  vec3 facing = dot(normal, view) < 0.0 ? view : normal;
  float cosine = clamp(dot(facing, view), 0.0, 1.0);
  float rough = max(u_roughness, ltc_k_min_roughness);
  float width = u_wide ? 1.0 : ltc_alpha_from_roughness(rough);
  ltc_FittedLobe fitted = ltc_fetch_lobe_of_width(TABLE, rough, width, cosine);
  ltc_Surface s = ltc_make_surface(fitted, position, facing, view, vec3(0.0), vec3(1.0), vec3(1.0), rough);
#ifdef TWO_LOBES
  return ltc_add_second_lobe(s, ltc_fetch_second_lobe_of_width(TABLE, rough, width, cosine));
#else
  return s;
#endif
}

// Distance to the polygon along a ray, or -1: the even-odd rule in the plane of its spreads.
float meet_polygon(vec3 from, vec3 along) {
  vec3 n = ltc_polygon_normal(0), o = ltc_polygon_origin(0);
  float distance = dot(o - from, n) / dot(along, n);
  if (!(distance > 0.0)) return -1.0;
  vec3 p = from + along * distance, u = normalize(ltc_polygon_spread_u(0)), v = cross(n, u);
  bool inside = false;
  for (int i = 1; i < ltc_polygon_point_count(0); ++i) {
    vec3 a = ltc_polygon_point(0, i - 1) - p, b = ltc_polygon_point(0, i) - p;
    vec2 s = vec2(dot(a, u), dot(a, v)), t = vec2(dot(b, u), dot(b, v));
    if ((s.y > 0.0) != (t.y > 0.0) && 0.0 < s.x - s.y * (t.x - s.x) / (t.y - s.y)) inside = !inside;
  }
  return inside ? distance : -1.0;
}

void main() {
  vec2 at = (2.0 * gl_FragCoord.xy - u_size) / min(u_size.y, u_size.x * 0.75);
  vec3 along = normalize(u_forward + u_field * (at.x * u_right + at.y * u_up));
  float nearest = 1e9;
  vec3 position, normal;
  float fade = 1.0;
  float to_floor = -u_eye.z / along.z;
  if (to_floor > 0.0) {
    nearest = to_floor;
    position = u_eye + along * to_floor;
    normal = vec3(0.0, 0.0, 1.0);
    fade = 1.0 - smoothstep(3.0, 7.5, length(position.xy));
  }
  vec3 to_ball = k_ball - u_eye;
  float middle = dot(to_ball, along), inside = k_ball.z * k_ball.z - dot(to_ball, to_ball) + middle * middle;
  if (inside > 0.0 && middle - sqrt(inside) < nearest) {
    nearest = middle - sqrt(inside);
    position = u_eye + along * nearest;
    normal = normalize(position - k_ball);
    fade = 1.0;
  }
  vec3 light = vec3(0.0);
  float lamp = meet_polygon(u_eye, along);
  if (lamp > 0.0 && lamp < nearest) light = u_color;
  else if (nearest < 1e9 && fade > 0.0)
    light = fade * u_color * ltc_shade_polygon(surface_of(position, normal, -along), 0) + 0.004 * fade;
  // The point of the figure.
  if (nearest < 1e9 && abs(position.z) < 1e-3 && lamp < 0.0) {
    vec2 d = abs(position.xy);
    if (max(d.x, d.y) < 0.09 && min(d.x, d.y) < 0.008) light = mix(light, vec3(0.15, 0.65, 1.0), 0.9);
  }
  vec3 shown = 1.0 - exp(-u_exposure * light);
  color = vec4(mix(12.92 * shown, 1.055 * pow(shown, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, shown)), 1.0);
}
`;

const sub = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));

/// The camera that looks at the origin's surroundings from a view angle.
export function cameraAt(thetaDegrees) {
  const theta = Math.min(Math.max(thetaDegrees, k_steepest), k_flattest) * Math.PI / 180;
  const eye = [k_distance * Math.sin(theta), 0, k_distance * Math.cos(theta)];
  const forward = unit(sub(k_target, eye)), right = unit(cross(forward, [0, 0, 1])), up = cross(right, forward);
  return {eye, forward, right, up};
}

const hasTwo = (fit) => fit.textures.length === 3;

// Pixels from the middle for a slope of 1.
const scaleOf = (width, height) => Math.min(height, width * 0.75) / (2 * k_field);

/// The ray of a place in a picture of that size: [origin, direction].
export function rayIn(x, y, thetaDegrees, width, height) {
  const {eye, forward, right, up} = cameraAt(thetaDegrees), scale = scaleOf(width, height);
  const a = (x - width / 2) / scale, b = (height / 2 - y) / scale;
  return [eye, unit(forward.map((f, i) => f + a * right[i] + b * up[i]))];
}

/// Where a point is seen in a picture of that size; null behind the camera.
export function placeIn(point, thetaDegrees, width, height) {
  const {eye, forward, right, up} = cameraAt(thetaDegrees), scale = scaleOf(width, height);
  const to = sub(point, eye), dot = (v) => to.reduce((s, x, i) => s + x * v[i], 0);
  const depth = dot(forward);
  return depth < 0.1 ? null : [width / 2 + dot(right) / depth * scale, height / 2 - dot(up) / depth * scale];
}

export class Preview {
  #canvas;
  #gl;
  #programs = new Map(); // by whether there are two lobes
  #textures = [];
  #fit = null;
  #shaders = new Map(); // their texts
  #fence = null; // behind the last picture

  /// Fails where there is no WebGL 2.
  constructor(canvas) {
    this.#canvas = canvas;
    this.#gl = canvas.getContext('webgl2', {antialias: false, alpha: false});
    if (!this.#gl) throw new Error('WebGL 2 is not there; the picture is left out, all else works');
  }

  /// Fetches the shader file that reads a fit.
  async prepare(fit) {
    const two = hasTwo(fit), name = `shaders/glsl-es-${two ? 'two-lobe' : 'table'}`;
    if (this.#shaders.has(two)) return;
    const response = await fetch(new URL(name, import.meta.url));
    if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`);
    this.#shaders.set(two, await response.text());
  }

  /// Takes the textures of a fit that it is prepared for.
  setFit(fit) {
    const gl = this.#gl;
    for (const texture of this.#textures) gl.deleteTexture(texture);
    const filtered = gl.getExtension('OES_texture_float_linear') !== null;
    this.#textures = fit.textures.map(({width, height, channels, values}) => {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      const [inner, format] = channels === 4 ? [filtered ? gl.RGBA32F : gl.RGBA16F, gl.RGBA] : [filtered ? gl.RG32F : gl.RG16F, gl.RG];
      gl.texImage2D(gl.TEXTURE_2D, 0, inner, width, height, 0, format, gl.FLOAT, values);
      for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
      for (const size of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, size, gl.LINEAR);
      return texture;
    });
    this.#fit = fit;
  }

  /// `density`: pixels of the picture to one of the page; 2 for smooth edges.
  draw({light, roughness, thetaDegrees, exposure}, density) {
    if (this.#fit === null || this.#gl.isContextLost()) return;
    const gl = this.#gl, canvas = this.#canvas;
    const width = Math.round(canvas.clientWidth * density), height = Math.round(canvas.clientHeight * density);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const two = hasTwo(this.#fit);
    if (!this.#programs.has(two)) this.#programs.set(two, this.#link(two));
    const program = this.#programs.get(two);
    gl.viewport(0, 0, width, height);
    gl.useProgram(program);
    const place = (name) => gl.getUniformLocation(program, name);
    this.#textures.forEach((texture, i) => {
      gl.activeTexture(gl.TEXTURE0 + i);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(place(['u_coefficients', 'u_amplitudes', 'u_second'][i]), i);
    });
    const data = new Float32Array(4 * k_most_data);
    data.set(dataOf(light).subarray(0, data.length));
    gl.uniform4fv(place('u_polygon'), data);
    const camera = cameraAt(thetaDegrees);
    for (const name of ['eye', 'forward', 'right', 'up']) gl.uniform3fv(place('u_' + name), camera[name]);
    gl.uniform2f(place('u_size'), width, height);
    gl.uniform1f(place('u_field'), k_field);
    gl.uniform1f(place('u_roughness'), roughness);
    gl.uniform1f(place('u_exposure'), exposure);
    gl.uniform1i(place('u_wide'), this.#fit.width === 'one' ? 1 : 0);
    gl.uniform3fv(place('u_color'), lightColor);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.deleteSync(this.#fence);
    this.#fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /// Whether the last picture is there, not only asked for.
  get isDrawn() {
    return this.#fence !== null && this.#gl.getSyncParameter(this.#fence, this.#gl.SYNC_STATUS) === this.#gl.SIGNALED;
  }

  /// As rayIn, of this canvas.
  rayAt(x, y, thetaDegrees) {
    return rayIn(x, y, thetaDegrees, this.#canvas.clientWidth, this.#canvas.clientHeight);
  }

  /// Corners as they are seen.
  corners(light, thetaDegrees) {
    return cornersOf(light).map((p) => placeIn(p, thetaDegrees, this.#canvas.clientWidth, this.#canvas.clientHeight));
  }

  #link(two) {
    const gl = this.#gl, program = gl.createProgram();
    const text = k_head + (two ? '#define TWO_LOBES\n' : '') + this.#shaders.get(two) + k_main;
    for (const [type, source] of [[gl.VERTEX_SHADER, k_vertex], [gl.FRAGMENT_SHADER, text]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error('the shader is refused: ' + gl.getAttachedShaders(program).map((s) => gl.getShaderInfoLog(s)).join(' '));
    return program;
  }
}
