// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Flat meshes that emit become lights, as `openltc render` takes them: polygons of their outline, with holes.

import {Color, Matrix4, Quaternion, Vector3} from 'three';
import {PolygonLight, RectLight} from 'openltc-three';

const flatness = 1e-3, nearness = 1e-5; // of the mesh's size
const least = 1; // nits: an emission of glTF's plain factor, which is a colour and no lamp

// Corners in the world, those at one place once, and triangles of them.
function weldedOf(mesh) {
  const {index, attributes: {position}} = mesh.geometry, at = new Vector3(), numbers = new Map(), points = [];
  mesh.geometry.computeBoundingSphere();
  const step = nearness * Math.max(mesh.geometry.boundingSphere.radius, 1e-9);
  const ofVertex = Array.from({length: position.count}, (_, i) => {
    mesh.getVertexPosition(i, at);
    const key = at.toArray().map(x => Math.round(x / step)).join();
    if (!numbers.has(key)) {
      numbers.set(key, points.length);
      points.push(at.clone().applyMatrix4(mesh.matrixWorld));
    }
    return numbers.get(key);
  });
  const corners = Array.from({length: (index ?? position).count}, (_, i) => ofVertex[index ? index.getX(i) : i]);
  return {points, corners};
}

// The normal of a flat mesh, or null.
function planeOf(points, corners) {
  const normal = new Vector3(), u = new Vector3(), v = new Vector3();
  for (let i = 0; i + 2 < corners.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map(k => points[corners[i + k]]);
    u.subVectors(b, a).cross(v.subVectors(c, a));
    if (u.dot(normal) < 0) return null; // folded
    normal.add(u);
  }
  if (!(normal.length() > 0)) return null;
  normal.normalize();
  const heights = corners.map(k => normal.dot(points[k])), size = Math.max(...points.map(p => p.distanceTo(points[0])));
  return Math.max(...heights) - Math.min(...heights) <= flatness * size ? normal : null;
}

// Rings of corners along edges that one triangle has; null where they touch themselves.
function ringsOf(corners) {
  const edges = new Set(), next = new Map();
  for (let i = 0; i < corners.length; i += 3)
    for (let k = 0; k < 3; ++k) edges.add(`${corners[i + k]} ${corners[i + (k + 1) % 3]}`);
  for (const edge of edges) {
    const [a, b] = edge.split(' ').map(Number);
    if (a === b || edges.has(`${b} ${a}`)) continue;
    if (next.has(a)) return null;
    next.set(a, b);
  }
  const rings = [];
  while (next.size) {
    const ring = [];
    for (let a = next.keys().next().value; next.has(a);) {
      ring.push(a);
      const b = next.get(a);
      next.delete(a);
      a = b;
    }
    rings.push(ring);
  }
  return rings;
}

const areaOf = ring => ring.reduce((sum, [x, y], i) => {
  const [u, v] = ring[(i + 1) % ring.length];
  return sum + (x * v - y * u) / 2;
}, 0);

// Without corners on straight lines.
const withoutStraight = ring => ring.filter(([x, y], i) => {
  const [a, b] = ring.at(i - 1), [c, d] = ring[(i + 1) % ring.length];
  const across = (x - a) * (d - y) - (y - b) * (c - x), along = Math.hypot(x - a, y - b) * Math.hypot(c - x, d - y);
  return Math.abs(across) > 1e-6 * along;
});

function isInside([x, y], ring) {
  return ring.filter(([a, b], i) => {
    const [c, d] = ring[(i + 1) % ring.length];
    return (b > y) !== (d > y) && x < a + (y - b) / (d - b) * (c - a);
  }).length % 2 === 1;
}

// Width, height and the angle of x, where a ring is a rectangle.
function rectangleOf(ring) {
  if (ring.length !== 4) return null;
  const sides = ring.map(([x, y], i) => [ring[(i + 1) % 4][0] - x, ring[(i + 1) % 4][1] - y]);
  const [a, b] = sides, lengths = sides.map(side => Math.hypot(...side)), slack = 1e-4 * Math.max(...lengths);
  if (Math.abs(a[0] * b[0] + a[1] * b[1]) > slack * lengths[1] || Math.hypot(a[0] + sides[2][0], a[1] + sides[2][1]) > slack) return null;
  return {width: lengths[0], height: lengths[1], angle: Math.atan2(a[1], a[0]),
          middle: [0, 1].map(k => (ring[0][k] + ring[2][k]) / 2)};
}

// Lights of a flat mesh; they shine along its normal, which is their -z.
function lightsOf(mesh, radiance) {
  const {points, corners} = weldedOf(mesh), normal = points.length < 3 ? null : planeOf(points, corners);
  const numbered = normal && ringsOf(corners);
  if (!numbered?.length) return null;
  const z = normal.clone().negate(), x = new Vector3().subVectors(points[numbered[0][1]], points[numbered[0][0]]).normalize();
  const y = new Vector3().crossVectors(z, x), origin = points[numbered[0][0]];
  const rings = numbered.map(ring => withoutStraight(ring.map(k => {
    const to = new Vector3().subVectors(points[k], origin);
    return [to.dot(x), to.dot(y)];
  }))).filter(ring => ring.length >= 3);
  // Seen from behind, outlines run clockwise and holes the other way.
  const outlines = rings.filter(ring => areaOf(ring) < 0), holes = rings.filter(ring => areaOf(ring) > 0);
  const turn = new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(x, y, z));
  const most = Math.max(radiance.r, radiance.g, radiance.b), color = radiance.clone().multiplyScalar(1 / most);
  const twoSided = mesh.material.side === 2;
  return outlines.map(outline => {
    const own = holes.filter(hole => isInside(hole[0], outline)), rectangle = own.length ? null : rectangleOf(outline);
    const middle = rectangle?.middle ?? [0, 1].map(k => (Math.min(...outline.map(p => p[k])) + Math.max(...outline.map(p => p[k]))) / 2);
    const moved = ring => ring.map(p => [p[0] - middle[0], p[1] - middle[1]]);
    const light = rectangle ? new RectLight(color, most, rectangle.width, rectangle.height, twoSided)
                            : new PolygonLight(color, most, moved(outline), own.map(moved), twoSided);
    light.position.copy(origin).addScaledVector(x, middle[0]).addScaledVector(y, middle[1]);
    light.quaternion.copy(turn);
    if (rectangle) light.rotateZ(rectangle.angle);
    return light;
  });
}

/// Gives `root`, which stands at the origin, lights for what emits in it; the meshes become children of theirs, so that
/// they move with them. Returns {lights, warnings}.
export function takeEmissive(root) {
  const lights = [], warnings = [], meshes = [];
  root.updateMatrixWorld(true);
  root.traverse(object => object.isMesh && !Array.isArray(object.material) && meshes.push(object));
  for (const mesh of meshes) {
    const {material} = mesh;
    if (!material.emissive || !mesh.visible || mesh.userData.openltc_emits_light === false) continue;
    const radiance = new Color().copy(material.emissive).multiplyScalar(material.emissiveIntensity);
    if (!(Math.max(radiance.r, radiance.g, radiance.b) > least)) continue;
    const name = mesh.userData.name || mesh.name || material.name || 'a mesh';
    const made = material.emissiveMap || mesh.isInstancedMesh || mesh.isSkinnedMesh ? null : lightsOf(mesh, radiance);
    if (!made?.length) {
      warnings.push(`"${name}" emits, but is ${material.emissiveMap ? 'textured' : 'not flat'}: it is seen and lights nothing`);
      continue;
    }
    mesh.userData.openltc_emits_light = false; // what is exported has the light itself
    made.forEach((light, k) => {
      light.name = made.length > 1 ? `${name} ${k + 1}` : name;
      root.add(light);
      light.updateMatrixWorld(true);
    });
    made[0].attach(mesh);
    lights.push(...made);
  }
  return {lights, warnings};
}
