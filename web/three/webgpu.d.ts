// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The entry for WebGPURenderer has the names of that for WebGLRenderer.
export * from './index.js';
