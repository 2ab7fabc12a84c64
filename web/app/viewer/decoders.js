// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Decoders of compressed meshes and pictures, fetched with the first file that needs one.

import {DRACOLoader} from 'three/addons/loaders/DRACOLoader.js';
import {KTX2Loader} from 'three/addons/loaders/KTX2Loader.js';
import {MeshoptDecoder} from 'three/addons/libs/meshopt_decoder.module.js';

/// What GLTFLoader asks, with the WebAssembly of Draco and Basis from `folder`.
export class Decoders {
  constructor(manager, folder) {
    this.draco = new DRACOLoader(manager).setDecoderPath(`${folder}draco/`);
    this.ktx2 = new KTX2Loader(manager).setTranscoderPath(`${folder}basis/`);
  }

  /// `renderer`: the one that will draw, which says what textures it takes.
  serve(loader, renderer) {
    loader.setDRACOLoader(this.draco).setKTX2Loader(this.ktx2.detectSupport(renderer)).setMeshoptDecoder(MeshoptDecoder);
  }
}
