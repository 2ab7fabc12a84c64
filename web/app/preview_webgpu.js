// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The laboratory's picture by WebGPU.

import {k_most_data, k_numbers, sceneText, wgslWords} from './preview_scene.js';

const k_names = ['coefficients', 'amplitudes', 'second'];
const k_filter = 'float32-filterable'; // the tables are of floats, between whose texels it looks

const head = (two) => `struct Page { polygon: array<vec4f, ${k_most_data}>, ${k_numbers.map((name) => `${name}: vec4f`).join(', ')} }
@group(0) @binding(0) var<uniform> page: Page;
@group(0) @binding(1) var table_sampler: sampler;
${k_names.slice(0, two ? 3 : 2).map((name, i) => `@group(0) @binding(${2 + i}) var ${name}: texture_2d<f32>;\n`).join('')}
fn ltc_polygon_data(i: i32) -> vec4f { return page.polygon[i]; }
@vertex fn corner(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
  return vec4f(select(-1.0, 3.0, i == 1u), select(-1.0, 3.0, i == 2u), 0.0, 1.0);
}
@fragment fn pixel(@builtin(position) at: vec4f) -> @location(0) vec4f {
  return picture_at(vec2f(at.x, page.size.y - at.y));
}
`;

/// A device for the picture, or null where WebGPU is not there, or cannot filter floats.
export async function requestDevice() {
  try {
    const adapter = await navigator.gpu?.requestAdapter();
    return adapter?.features.has(k_filter) ? await adapter.requestDevice({requiredFeatures: [k_filter]}) : null;
  } catch {
    return null;
  }
}

/// Waits until WebGPU is there again.
export async function untilThere(milliseconds) {
  do await new Promise((done) => setTimeout(done, milliseconds));
  while (!await navigator.gpu.requestAdapter().catch(() => null));
}

export class WebGPUPicture {
  static language = 'wgsl';
  #device;
  #context;
  #format = navigator.gpu.getPreferredCanvasFormat();
  #pipelines = new Map(); // by whether there are two lobes
  #textures = [];
  #page;
  #sampler;
  #groups = null; // of the textures that there are
  #pictures = 0;
  #drawn = 0; // of them, those that are there

  /// `lost` is called when the device goes; another picture then wants another device.
  constructor(canvas, device, {lost}) {
    this.#device = device;
    this.#context = canvas.getContext('webgpu');
    this.#context.configure({device, format: this.#format, alphaMode: 'opaque'});
    this.#page = device.createBuffer({size: 16 * (k_most_data + k_numbers.length), usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
    this.#sampler = device.createSampler({magFilter: 'linear', minFilter: 'linear'});
    this.isLost = false;
    device.lost.then(() => {
      this.isLost = true;
      lost();
    });
  }

  setTextures(textures) {
    for (const texture of this.#textures) texture.destroy();
    this.#textures = textures.map(({width, height, channels, values}) => {
      const texture = this.#device.createTexture({size: [width, height], format: channels === 4 ? 'rgba32float' : 'rg32float',
                                                  usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST});
      this.#device.queue.writeTexture({texture}, values, {bytesPerRow: 4 * channels * width}, [width, height]);
      return texture;
    });
    this.#groups = null;
  }

  /// `numbers`: the polygon's, then k_numbers, four each; `shader`: the text of the shader file.
  draw(shader, numbers) {
    const two = this.#textures.length === 3;
    if (!this.#pipelines.has(two)) this.#pipelines.set(two, this.#makePipeline(shader, two));
    const pipeline = this.#pipelines.get(two), {queue} = this.#device;
    this.#groups ??= this.#device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries: [
      {binding: 0, resource: {buffer: this.#page}}, {binding: 1, resource: this.#sampler},
      ...this.#textures.map((texture, i) => ({binding: 2 + i, resource: texture.createView()}))]});
    queue.writeBuffer(this.#page, 0, numbers);
    const encoder = this.#device.createCommandEncoder();
    const pass = encoder.beginRenderPass({colorAttachments: [
      {view: this.#context.getCurrentTexture().createView(), loadOp: 'clear', storeOp: 'store'}]});
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, this.#groups);
    pass.draw(3);
    pass.end();
    queue.submit([encoder.finish()]);
    const mine = ++this.#pictures;
    queue.onSubmittedWorkDone().then(() => this.#drawn = Math.max(this.#drawn, mine), () => {});
  }

  /// Whether the last picture is there, not only asked for.
  get isDrawn() { return this.#pictures > 0 && this.#drawn === this.#pictures; }

  #makePipeline(shader, two) {
    const visible = {visibility: GPUShaderStage.FRAGMENT};
    const layout = this.#device.createBindGroupLayout({entries: [
      {binding: 0, ...visible, buffer: {}}, {binding: 1, ...visible, sampler: {}},
      ...k_names.slice(0, two ? 3 : 2).map((_, i) => ({binding: 2 + i, ...visible, texture: {sampleType: 'float'}}))]});
    const module = this.#device.createShaderModule({code: head(two) + shader + sceneText(wgslWords, two)});
    return this.#device.createRenderPipeline({
      layout: this.#device.createPipelineLayout({bindGroupLayouts: [layout]}), vertex: {module}, fragment: {module, targets: [{format: this.#format}]}});
  }
}
