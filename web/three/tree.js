// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The triangles that cast shadows, and the tree over them, as one texture of floats that shaders of both renderers
// walk through.
//
// Nodes stand in the order in which they are visited: behind one is what is within it. The first texel has their number
// in x; then two texels each: lower corner of its box and w, upper corner and w. The first w is that of the node to go
// on with where a ray misses the box; in a leaf it is minus its number of triangles, and the second w where they begin.
// Behind the nodes stand triangles, three texels each, their corners.

import {BufferAttribute, BufferGeometry, DataTexture, FloatType, Matrix4, NearestFilter, RGBAFormat, Vector3} from 'three';
import {MeshBVH} from 'three-mesh-bvh';

const columns = 2048, mostRows = 8192; // shaders take an index apart by 2047 and 11; WebGPU's least limit

// Where in the world a mesh is drawn.
function placesOf(mesh) {
  if (!mesh.isInstancedMesh) return [mesh.matrixWorld];
  return Array.from({length: mesh.count}, (_, k) => {
    const place = new Matrix4();
    mesh.getMatrixAt(k, place);
    return place.premultiply(mesh.matrixWorld);
  });
}

// All triangles of meshes, in the world.
function mergedGeometry(meshes) {
  const positions = [], corners = [], vertex = new Vector3();
  for (const mesh of meshes)
    for (const place of placesOf(mesh)) {
      const {index, attributes: {position}} = mesh.geometry, first = positions.length / 3;
      for (let i = 0; i < position.count; ++i)
        positions.push(...mesh.getVertexPosition(i, vertex).applyMatrix4(place));
      for (let i = 0; i < (index ?? position).count; ++i) corners.push(first + (index ? index.getX(i) : i));
    }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setIndex(corners);
  return geometry;
}

export class TreeTexture {
  constructor() { this.reserve(1); }

  reserve(rows) {
    this.texture?.dispose();
    this.data = new Float32Array(4 * columns * rows);
    this.texture = new DataTexture(this.data, columns, rows, RGBAFormat, FloatType);
    this.texture.minFilter = this.texture.magFilter = NearestFilter;
    this.texture.needsUpdate = true;
    this.rows = rows;
  }

  /// Writes the triangles of meshes. The texture is another one where it would not hold them.
  write(meshes) {
    const geometry = mergedGeometry(meshes);
    this.texture.needsUpdate = true;
    this.data[0] = 0;
    if (geometry.index.count === 0) return;
    // Each of its nodes takes 32 bytes: the box, then for an inner node the distance to its second child and an axis, for
    // a leaf where its triangles begin and, below a mark, their number.
    const [root] = new MeshBVH(geometry)._roots, floats = new Float32Array(root), words = new Uint32Array(root);
    const nodes = floats.length / 8, first = 1 + 2 * nodes, rows = Math.ceil((first + geometry.index.count) / columns);
    if (rows > mostRows) return console.warn(`openltc-three: no shadows of ${geometry.index.count / 3} triangles, which no texture holds`);
    if (rows > this.rows) this.reserve(Math.min(2 ** Math.ceil(Math.log2(rows)), mostRows));
    const {data} = this, isLeaf = i => words[8 * i + 7] >>> 16 === 0xffff;
    const put = (texel, from, w) => data.set([...floats.subarray(from, from + 3), w], 4 * texel);
    data[0] = nodes;
    const visit = (i, next) => {
      const leaf = isLeaf(i), begin = words[8 * i + 6];
      put(1 + 2 * i, 8 * i, leaf ? -(words[8 * i + 7] & 0xffff) : next);
      put(2 + 2 * i, 8 * i + 3, leaf ? first + 3 * begin : 0);
      if (leaf) return;
      visit(i + 1, i + begin);
      visit(i + begin, next);
    };
    visit(0, nodes);
    const {index, attributes: {position}} = geometry;
    for (let k = 0; k < index.count; ++k)
      data.set(position.array.subarray(3 * index.getX(k), 3 * index.getX(k) + 3), 4 * (first + k));
  }

  dispose() { this.texture.dispose(); }
}
