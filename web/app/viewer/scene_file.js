// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A glTF file becomes a scene, or one sentence that says why not.

import {LoadingManager} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {GLTFAreaLights} from 'openltc-three';

/// Bytes of a file; what three.js makes of one takes several times as many.
export const mostBytes = 256 * 2 ** 20;
const mostVertices = 2e7;

// What GLTFLoader and our plugin read, of which a file may say that it cannot be shown without.
const readExtensions = new Set([
  'EXT_lights_area', 'EXT_lights_ies', 'EXT_materials_bump', 'EXT_mesh_gpu_instancing', 'EXT_meshopt_compression',
  'EXT_texture_avif', 'EXT_texture_webp', 'KHR_draco_mesh_compression', 'KHR_lights_punctual', 'KHR_materials_anisotropy',
  'KHR_materials_clearcoat', 'KHR_materials_dispersion', 'KHR_materials_emissive_strength', 'KHR_materials_ior',
  'KHR_materials_iridescence', 'KHR_materials_sheen', 'KHR_materials_specular', 'KHR_materials_transmission',
  'KHR_materials_unlit', 'KHR_materials_volume', 'KHR_mesh_quantization', 'KHR_meshopt_compression',
  'KHR_texture_basisu', 'KHR_texture_transform']);
const decodedExtensions = ['EXT_meshopt_compression', 'KHR_draco_mesh_compression', 'KHR_meshopt_compression', 'KHR_texture_basisu'];
const size = bytes => `${(bytes / 2 ** 20).toFixed(0)} MB`;

/// The document of a .glb or .gltf file of `bytes`, an ArrayBuffer. Throws an Error whose message is for the reader.
export function documentOf(bytes, name) {
  if (bytes.byteLength > mostBytes)
    throw new Error(`${name} is too large: ${size(bytes.byteLength)}, and this page takes ${size(mostBytes)}`);
  const view = new DataView(bytes), text = (begin, end) => new TextDecoder().decode(new Uint8Array(bytes, begin, end));
  const binary = bytes.byteLength >= 12 && view.getUint32(0, true) === 0x46546c67; // "glTF"
  if (!binary && text(0, Math.min(bytes.byteLength, 64)).trimStart()[0] !== '{')
    throw new Error(`${name} is no glTF file: a .glb begins with "glTF", a .gltf with "{"`);
  if (binary) {
    const [version, length] = [4, 8].map(at => view.getUint32(at, true));
    if (version !== 2) throw new Error(`${name} is glTF of version ${version}; this page reads version 2`);
    if (length > bytes.byteLength || bytes.byteLength < 20 || 20 + view.getUint32(12, true) > bytes.byteLength)
      throw new Error(`${name} is cut off: ${bytes.byteLength} bytes are there of ${length}`);
  }
  try {
    const json = JSON.parse(binary ? text(20, view.getUint32(12, true)) : text(0, bytes.byteLength));
    if (json.asset?.version?.startsWith('2') !== true) throw new Error('asset.version is not 2.0');
    return json;
  } catch (error) {
    throw new Error(`${name} is no glTF file: ${error.message}`);
  }
}

/// Throws where a file cannot be shown as it is meant.
export function checkDocument(json, name) {
  const missing = (json.extensionsRequired ?? []).filter(extension => !readExtensions.has(extension));
  if (missing.length) throw new Error(`${name} needs ${missing.join(', ')}, which this page cannot read`);
  const positions = (json.meshes ?? []).flatMap(mesh => (mesh.primitives ?? []).map(p => p.attributes?.POSITION));
  const vertices = [...new Set(positions)].reduce((sum, k) => sum + (json.accessors?.[k]?.count ?? 0), 0);
  if (vertices > mostVertices) throw new Error(`${name} is too large: ${vertices} vertices, and this page takes ${mostVertices}`);
}

/// Reads files; decoders are fetched when a file needs them, from `folder`.
export class SceneReader {
  constructor(folder) {
    this.folder = folder;
    this.manager = new LoadingManager();
  }

  /// The file as GLTFLoader gives it, for `renderer`, and `warnings`: what of it is not shown. `path` is where other
  /// files are.
  async read(renderer, bytes, name, path = '') {
    const json = documentOf(bytes, name), warnings = [];
    checkDocument(json, name);
    const uris = [...(json.buffers ?? []), ...(json.images ?? [])].map(({uri}) => uri).filter(uri => uri && !uri.startsWith('data:'));
    if (uris.length && !path)
      throw new Error(`${name} names other files (${uris[0]}${uris.length > 1 ? ', …' : ''}), which a page cannot open; pack them into a .glb`);
    this.manager.onError = url => warnings.push(`${url.startsWith('blob:') ? 'a picture' : url.split('/').pop()} cannot be read`);
    const loader = new GLTFLoader(this.manager).register(parser => new GLTFAreaLights(parser));
    const {warn} = console; // by which the plugin says what it leaves out
    console.warn = (...words) => {
      if (String(words[0]).startsWith('openltc-three: ')) warnings.push(String(words[0]).slice(15));
      else warn.apply(console, words);
    };
    try {
      if (decodedExtensions.some(extension => json.extensionsUsed?.includes(extension))) {
        const {Decoders} = await import('./decoders.js');
        this.decoders ??= new Decoders(this.manager, this.folder);
        this.decoders.serve(loader, renderer);
      }
      const gltf = await loader.parseAsync(bytes, path);
      if (!gltf.scene) throw new Error('it has no scene');
      return {...gltf, warnings: [...new Set(warnings)]};
    } catch (error) {
      throw new Error(`${name} cannot be read: ${error.message}`);
    } finally {
      console.warn = warn;
    }
  }
}

/// Frees what a scene holds of the graphics processor.
export function disposeOf(root) {
  const materials = new Set(), textures = new Set();
  root.traverse(object => {
    object.geometry?.dispose();
    object.skeleton?.dispose();
    if (object.isInstancedMesh) object.dispose();
    [object.material].flat().forEach(material => material && materials.add(material));
    if (object.texture?.isTexture) textures.add(object.texture);
  });
  for (const material of materials) {
    for (const value of Object.values(material)) if (value?.isTexture) textures.add(value);
    material.dispose();
  }
  for (const texture of textures) {
    texture.dispose();
    texture.source?.data?.close?.(); // an ImageBitmap
  }
}
