// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Makes the files of this folder: one scene, plain and with each way to compress that the viewer reads. The encoders
// are other people's; it was run once, for the files that stand here, and writes beside itself.
//
//   mkdir -p out/compressed && cp tests/web/compressed/*.* out/compressed
//   npm ci --prefix out/compressed --ignore-scripts && node out/compressed/make.mjs

import {writeFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {Document, NodeIO} from '@gltf-transform/core';
import {EXTMeshoptCompression, EXTTextureWebP, KHRDracoMeshCompression, KHRMeshQuantization,
        KHRTextureBasisu} from '@gltf-transform/extensions';
import {quantize, reorder} from '@gltf-transform/functions';
import draco3d from 'draco3dgltf';
import {encodeToKTX2} from 'ktx2-encoder';
import {MeshoptDecoder, MeshoptEncoder} from 'meshoptimizer';
import sharp from 'sharp';

const side = 64;

// Soft colours, and a dark frame, so that a picture that is turned or mirrored is another.
function pixels() {
  const data = new Uint8Array(4 * side * side);
  for (let y = 0; y < side; ++y)
    for (let x = 0; x < side; ++x) {
      const [u, v] = [x / side, y / side], dark = Math.min(x, y) < 4 ? 0.3 : 1;
      data.set([220 * (0.25 + 0.75 * u), 220 * (0.25 + 0.75 * v), 220 * (0.6 - 0.3 * u * v), 0].map(c => Math.round(c * dark)), 4 * (y * side + x));
      data[4 * (y * side + x) + 3] = 255;
    }
  return data;
}

// A grid over (u, v), each point with its normal by differences: [positions, normals, texture coordinates, triangles].
function surface(columns, rows, at) {
  const positions = [], normals = [], places = [], corners = [], h = 1e-4;
  const minus = (a, b) => a.map((x, k) => x - b[k]);
  for (let j = 0; j <= rows; ++j)
    for (let i = 0; i <= columns; ++i) {
      const [u, v] = [i / columns, j / rows];
      const a = minus(at(u + h, v), at(u - h, v)), b = minus(at(u, v + h), at(u, v - h));
      const n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]], length = Math.hypot(...n);
      positions.push(...at(u, v));
      normals.push(...n.map(x => x / length));
      places.push(u, v);
      if (i < columns && j < rows) {
        const k = j * (columns + 1) + i, next = k + columns + 1;
        corners.push(k, k + 1, next + 1, k, next + 1, next);
      }
    }
  return [positions, normals, places, corners];
}

// A ring with waves on it, over a floor.
const ring = (u, v) => {
  const [a, b] = [2 * Math.PI * u, -2 * Math.PI * v], r = 0.14 + 0.02 * Math.cos(5 * a), R = 0.4 + r * Math.cos(b);
  return [R * Math.cos(a), 0.3 + 0.12 * Math.cos(a) + r * Math.sin(b), R * Math.sin(a)];
};
const floor = (u, v) => [3 * (u - 0.5), 0, 3 * (0.5 - v)];

function makeScene(image, mimeType) {
  const document = new Document(), buffer = document.createBuffer(), scene = document.createScene();
  const texture = document.createTexture('colours').setImage(image).setMimeType(mimeType);
  const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  for (const [name, [positions, normals, places, corners], roughness] of
       [['ring', surface(24, 12, ring), 0.35], ['floor', surface(2, 2, floor), 0.5]]) {
    const material = document.createMaterial(name).setBaseColorTexture(texture).setMetallicFactor(0).setRoughnessFactor(roughness);
    const primitive = document.createPrimitive().setMaterial(material)
        .setAttribute('POSITION', accessor('VEC3', new Float32Array(positions)))
        .setAttribute('NORMAL', accessor('VEC3', new Float32Array(normals)))
        .setAttribute('TEXCOORD_0', accessor('VEC2', new Float32Array(places)))
        .setIndices(accessor('SCALAR', new Uint16Array(corners)));
    scene.addChild(document.createNode(name).setMesh(document.createMesh(name).addPrimitive(primitive)));
  }
  const half = Math.SQRT1_2;
  scene.addChild(document.createNode('lamp').setTranslation([0, 1.4, 0]).setRotation([-half, 0, 0, half])
      .setExtras({openltc_light: {type: 'rect', width: 0.8, height: 0.5, luminance_nits: 1000}}));
  const camera = document.createCamera().setType('perspective').setYFov(0.6).setAspectRatio(1.5).setZNear(0.1).setZFar(100);
  scene.addChild(document.createNode('camera').setCamera(camera).setTranslation([0, 1.3, 2.4]).setRotation([-0.2474, 0, 0, 0.9689]));
  document.getRoot().setDefaultScene(scene);
  return document;
}

await Promise.all([MeshoptDecoder.ready, MeshoptEncoder.ready]);
const io = new NodeIO()
    .registerExtensions([EXTMeshoptCompression, EXTTextureWebP, KHRDracoMeshCompression, KHRMeshQuantization, KHRTextureBasisu])
    .registerDependencies({'draco3d.encoder': await draco3d.createEncoderModule(), 'draco3d.decoder': await draco3d.createDecoderModule(),
                           'meshopt.encoder': MeshoptEncoder, 'meshopt.decoder': MeshoptDecoder});
const raw = sharp(pixels(), {raw: {width: side, height: side, channels: 4}});
const png = await raw.clone().png({palette: false}).toBuffer();
const ktx2 = isUASTC => encodeToKTX2(png, {
  isUASTC, generateMipmap: true, needSupercompression: isUASTC, qualityLevel: 255, isPerceptual: true, isSetKTX2SRGBTransferFunc: true,
  imageDecoder: async () => ({width: side, height: side, data: pixels()})});
const required = (document, Extension) => document.createExtension(Extension).setRequired(true);

const documents = {
  plain: makeScene(png, 'image/png'),
  draco: makeScene(png, 'image/png'),
  meshopt: makeScene(png, 'image/png'),
  webp: makeScene(await raw.clone().webp({lossless: true}).toBuffer(), 'image/webp'),
  ktx2_uastc: makeScene(await ktx2(true), 'image/ktx2'),
  ktx2_etc1s: makeScene(await ktx2(false), 'image/ktx2'),
};
required(documents.draco, KHRDracoMeshCompression).setEncoderOptions({method: KHRDracoMeshCompression.EncoderMethod.EDGEBREAKER});
await documents.meshopt.transform(reorder({encoder: MeshoptEncoder}), quantize({quantizePosition: 14, quantizeNormal: 10}));
required(documents.meshopt, EXTMeshoptCompression).setEncoderOptions({method: EXTMeshoptCompression.EncoderMethod.QUANTIZE});
required(documents.webp, EXTTextureWebP);
for (const name of ['ktx2_uastc', 'ktx2_etc1s']) required(documents[name], KHRTextureBasisu);
for (const [name, document] of Object.entries(documents)) {
  const bytes = await io.writeBinary(document);
  writeFileSync(fileURLToPath(new URL(`${name}.glb`, import.meta.url)), bytes);
  console.log(`${name}.glb: ${bytes.byteLength} bytes, ${document.getRoot().listExtensionsRequired().map(e => e.extensionName)}`);
}
