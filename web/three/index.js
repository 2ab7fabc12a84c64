// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

export {AreaLightHelper} from './helper.js';
export {PolygonLight, RectLight} from './lights.js';
export {enableAreaLights} from './scene.js';
