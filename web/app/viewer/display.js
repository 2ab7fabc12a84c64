// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// From radiance in textures to what the page shows: exposure and tone mapping as `openltc render` has them, or how far
// two pictures are apart, in colours.

import {Mesh, OrthographicCamera, PlaneGeometry, Scene, ShaderMaterial} from 'three';

/// Tone curves by name, as --tonemap has them.
export const tonemaps = {neutral: 'NeutralToneMapping', aces: 'ACESFilmicToneMapping', none: 'LinearToneMapping'};

/// The factor from nits of an EV100: openltc/image/tonemap.h.
export const exposureOf = ev100 => 1 / (1.2 * 2 ** ev100);
export const ev100Of = exposure => -Math.log2(1.2 * exposure);

/// Colours of the scale of differences, from none to the most.
export const scaleColors = ['#000004', '#3b0f70', '#8c2981', '#de4968', '#fe9f6d', '#fcfdbf'];
const glslColor = hex => `vec3(${[1, 3, 5].map(k => (parseInt(hex.slice(k, k + 2), 16) / 255).toFixed(4)).join(', ')})`;

const vertexShader = 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }';

const head = tone => `
#include <common>
#include <tonemapping_pars_fragment>
uniform highp sampler2D picture, base, rays;
uniform float count;
vec3 displayed(vec3 nits) {
  vec3 c = clamp(${tone}(clamp(nits, 0.0, 1.0e6)), 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
vec3 reference(ivec2 p) { return texelFetch(base, p, 0).rgb + texelFetch(rays, p, 0).rgb / max(count, 1.0); }
`;
const mains = {
  picture: `void main() { gl_FragColor = vec4(displayed(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb), 1.0); }`,
  reference: `void main() { gl_FragColor = vec4(displayed(reference(ivec2(gl_FragCoord.xy))), 1.0); }`,
  // Steps of 255, the mean of three channels, and whether a surface is there.
  difference: `void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  vec3 d = abs(displayed(texelFetch(picture, p, 0).rgb) - displayed(reference(p)));
  gl_FragColor = vec4(255.0 / 3.0 * (d.r + d.g + d.b), texelFetch(rays, p, 0).a, 0.0, 1.0);
}`,
  fewer: `uniform float stepX, stepY;
void main() { gl_FragColor = vec4(texelFetch(picture, ivec2(gl_FragCoord.xy * vec2(stepX, stepY)), 0).rgb, 1.0); }`,
  colors: `uniform float most;
void main() {
  vec3 colors[${scaleColors.length}] = vec3[](${scaleColors.map(glslColor).join(', ')});
  float t = clamp(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).r / most, 0.0, 1.0) * ${scaleColors.length - 1}.0;
  int i = min(int(t), ${scaleColors.length - 2});
  gl_FragColor = vec4(mix(colors[i], colors[i + 1], t - float(i)), 1.0);
}`,
};

/// Draws a rectangle over the whole of a target.
export class Display {
  materials = new Map();
  camera = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
  mesh = new Mesh(new PlaneGeometry(2, 2));
  scene = new Scene().add(this.mesh);

  constructor(renderer) {
    this.renderer = renderer;
    this.mesh.frustumCulled = false;
  }

  /// `task`: a name of mains; `values`: its uniforms. To the renderer's target.
  draw(task, tonemap, exposure, values) {
    const key = `${task} ${tonemap}`;
    if (!this.materials.has(key)) {
      const names = ['picture', 'base', 'rays', 'count', 'most', 'stepX', 'stepY', 'toneMappingExposure'];
      this.materials.set(key, new ShaderMaterial({
        vertexShader, fragmentShader: head(tonemaps[tonemap]) + mains[task], depthTest: false, depthWrite: false, toneMapped: false,
        uniforms: Object.fromEntries(names.map(name => [name, {value: null}]))}));
    }
    this.mesh.material = this.materials.get(key);
    const {uniforms} = this.mesh.material;
    Object.assign(uniforms.toneMappingExposure, {value: exposure});
    for (const name in values) uniforms[name].value = values[name];
    this.renderer.render(this.scene, this.camera);
  }
}
