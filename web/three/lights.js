// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What both entries have.

export {GLTFAreaLights} from './gltf.js';
export {GLTFAreaLightsExport} from './gltf_export.js';
export {AreaLightHelper} from './helper.js';
export {DiskLight, EllipseLight, PolygonLight, RectLight} from './flat_lights.js';
export {LineLight, SphereLight, TubeLight} from './round_lights.js';
