// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What draws: WebGPU where the browser has it, WebGL 2 otherwise, both by three.js's WebGPURenderer.

import {LinearSRGBColorSpace, WebGPURenderer} from 'three';

const hasWebGPU = async () => Boolean(await navigator.gpu?.requestAdapter().catch(() => null));

// What this page wants of WebGL 2. Throws an Error for the reader.
function checkWebGL() {
  const context = document.createElement('canvas').getContext('webgl2');
  if (!context) throw new Error('This page needs WebGPU or WebGL 2, which this browser does not have or has turned off.');
  if (!context.getExtension('EXT_color_buffer_float'))
    throw new Error('This page needs textures of floats (EXT_color_buffer_float), which this graphics driver does not have.');
  context.getExtension('WEBGL_lose_context')?.loseContext(); // there are few
}

/// A renderer for `canvas` that shows what it is given as it is. `forceWebGL`: not by WebGPU.
export async function makeRenderer(canvas, forceWebGL) {
  const byWebGL = forceWebGL || !await hasWebGPU();
  if (byWebGL) checkWebGL();
  const renderer = new WebGPURenderer({canvas, antialias: false, alpha: false, powerPreference: 'high-performance', forceWebGL: byWebGL});
  renderer.outputColorSpace = LinearSRGBColorSpace;
  await renderer.init();
  return renderer;
}

/// "WebGPU" or "WebGL 2".
export const nameOf = renderer => renderer.backend.isWebGPUBackend ? 'WebGPU' : 'WebGL 2';

/// Waits until what has been asked for is drawn.
export async function finish({backend}) {
  if (backend.isWebGPUBackend) await backend.device.queue.onSubmittedWorkDone();
  else backend.gl.finish();
}

/// The pixels of a target of floats, in any order of rows.
export async function readPixels(renderer, target) {
  const {width, height} = target, pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height);
  if (pixels.length <= 4 * width * height) return pixels;
  const rows = new Float32Array(4 * width * height), stride = 64 * Math.ceil(width / 16); // WebGPU's, of 256 bytes
  for (let y = 0; y < height; ++y) rows.set(pixels.subarray(stride * y, stride * y + 4 * width), 4 * width * y);
  return rows;
}
