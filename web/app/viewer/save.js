// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The scene as a file.

import {GLTFExporter} from 'three/addons/exporters/GLTFExporter.js';
import * as textureUtils from 'three/addons/utils/WebGPUTextureUtils.js';
import {GLTFAreaLightsExport} from 'openltc-three';

/// A .glb of `world`, with its lights and a camera first, as an ArrayBuffer.
export async function glbOf(world, camera) {
  const own = camera.clone();
  own.name = 'view';
  const {children} = world;
  world.children = [own, ...children]; // a scene in the file has what is here
  try {
    const exporter = new GLTFExporter().setTextureUtils(textureUtils).register(writer => new GLTFAreaLightsExport(writer));
    return await exporter.parseAsync(world, {binary: true});
  } finally {
    world.children = children;
  }
}
