// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The entry for WebGPURenderer.

export * from './lights.js';
export {enableAreaLights} from './scene_webgpu.js';
