// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// What you call: lights. Each function returns the light that a surface reflects of one of radiance 1,
// without shadow; shade_X_parts has its diffuse and its specular part apart.

/// A rectangle or parallelogram: its middle, and from there to the middles of two sides. It emits along
/// half_u x half_v, or to both sides where two_sided is 1.
FN Quad make_quad(Vec3 center, Vec3 half_u, Vec3 half_v, Real two_sided) {
  Quad quad;
  quad.center = center;
  quad.half_u = half_u;
  quad.half_v = half_v;
  quad.two_sided = two_sided;
  return quad;
}

/// A disk, which emits along its unit normal.
FN Ellipse make_disk(Vec3 center, Vec3 normal, Real radius, Real two_sided) {
  Vec3 u = any_perpendicular(normal);
  Ellipse disk;
  disk.center = center;
  disk.half_u = u * radius;
  disk.half_v = cross(normal, u) * radius;
  disk.two_sided = two_sided;
  return disk;
}

/// An ellipse by its perpendicular semi-axes; it emits along half_u x half_v.
FN Ellipse make_ellipse(Vec3 center, Vec3 half_u, Vec3 half_v, Real two_sided) {
  Ellipse ellipse;
  ellipse.center = center;
  ellipse.half_u = half_u;
  ellipse.half_v = half_v;
  ellipse.two_sided = two_sided;
  return ellipse;
}

/// A sphere, which emits outwards.
FN Sphere make_sphere(Vec3 center, Real radius) {
  Sphere sphere;
  sphere.center = center;
  sphere.radius = radius;
  return sphere;
}

/// A tube between two points. caps: 0 for an open one, 1 for a cylinder with flat ends, 2 for a capsule.
FN Tube make_tube(Vec3 from, Vec3 to, Real radius, Real caps) {
  Tube tube;
  tube.from = from;
  tube.to = to;
  tube.radius = radius;
  tube.caps = caps;
  return tube;
}

/// A line between two points, which has no width: instead of radiance 1, an intensity of 1 per metre
/// across it.
FN Line make_line(Vec3 from, Vec3 to) {
  Line line;
  line.from = from;
  line.to = to;
  return line;
}
