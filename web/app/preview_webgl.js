// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The laboratory's picture by WebGL 2.

import {glslWords, k_most_data, k_numbers, sceneText} from './preview_scene.js';

const k_names = ['coefficients', 'amplitudes', 'second'];
const k_vertex = `#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0), 0.0, 1.0);
}`;
const k_head = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
struct Page { vec4 ${['polygon[' + k_most_data + ']', ...k_numbers].join(', ')}; };
uniform Page page;
uniform sampler2D ${k_names.join(', ')};
out vec4 color;
vec4 ltc_polygon_data(int i) { return page.polygon[i]; }
`;

export class WebGLPicture {
  static language = 'glsl-es';
  #gl;
  #programs = new Map(); // by whether there are two lobes
  #textures = [];
  #fence = null; // behind the last picture

  /// Fails where there is no WebGL 2. `lost` and `restored` are called when the device goes, and is there again.
  constructor(canvas, {lost, restored}) {
    this.#gl = canvas.getContext('webgl2', {antialias: false, alpha: false});
    if (!this.#gl) throw new Error('Neither WebGPU nor WebGL 2 is there; the picture is left out, all else works');
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault(); // so that it comes back
      lost();
    }, {once: true});
    canvas.addEventListener('webglcontextrestored', restored, {once: true});
  }

  get isLost() { return this.#gl.isContextLost(); }

  setTextures(textures) {
    const gl = this.#gl;
    for (const texture of this.#textures) gl.deleteTexture(texture);
    const filtered = gl.getExtension('OES_texture_float_linear') !== null;
    this.#textures = textures.map(({width, height, channels, values}) => {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      const [inner, format] = channels === 4 ? [filtered ? gl.RGBA32F : gl.RGBA16F, gl.RGBA] : [filtered ? gl.RG32F : gl.RG16F, gl.RG];
      gl.texImage2D(gl.TEXTURE_2D, 0, inner, width, height, 0, format, gl.FLOAT, values);
      for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
      for (const size of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, size, gl.LINEAR);
      return texture;
    });
  }

  /// `numbers`: the polygon's, then k_numbers, four each; `shader`: the text of the shader file.
  draw(shader, numbers, width, height) {
    const gl = this.#gl, two = this.#textures.length === 3;
    if (!this.#programs.has(two)) this.#programs.set(two, this.#link(k_head + shader + sceneText(glslWords, two) +
        'void main() { color = picture_at(gl_FragCoord.xy); }\n'));
    const program = this.#programs.get(two), place = (name) => gl.getUniformLocation(program, name);
    gl.viewport(0, 0, width, height);
    gl.useProgram(program);
    this.#textures.forEach((texture, i) => {
      gl.activeTexture(gl.TEXTURE0 + i);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(place(k_names[i]), i);
    });
    gl.uniform4fv(place('page.polygon'), numbers.subarray(0, 4 * k_most_data));
    k_numbers.forEach((name, i) => gl.uniform4fv(place(`page.${name}`), numbers.subarray(4 * (k_most_data + i), 4 * (k_most_data + i + 1))));
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.deleteSync(this.#fence);
    this.#fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /// Whether the last picture is there, not only asked for.
  get isDrawn() {
    return this.#fence !== null && this.#gl.getSyncParameter(this.#fence, this.#gl.SYNC_STATUS) === this.#gl.SIGNALED;
  }

  #link(text) {
    const gl = this.#gl, program = gl.createProgram();
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
