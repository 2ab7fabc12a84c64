// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Shadows for WebGPURenderer have the names of those for WebGLRenderer.
export * from './shadows.js';
