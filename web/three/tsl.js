// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What we use of three.js's shading language: before r186 three/tsl does not have all of it.

import {TSL} from 'three/webgpu';

export const {cameraPosition, cameraViewMatrix, clearcoatNormalView, diffuseContribution, float, glslFn, ivec2, mat3,
  materialClearcoat, materialClearcoatRoughness, materialRoughness, mrt, normalView, positionView,
  positionViewDirection, property, renderGroup, screenCoordinate, specularColorBlended, specularF90, texture,
  textureLoad, transpose, uniform, vec3, vec4, wgslFn} = TSL;
