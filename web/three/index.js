// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The entry for WebGLRenderer.

export * from './lights.js';
export {enableAreaLights} from './scene.js';
