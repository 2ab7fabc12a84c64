// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A quad light the way engines have it, for comparison: matrix and amplitudes from two textures, a
// frame, and the edges summed by a rational fit of theta / sin theta, once without the matrix and
// once with it (Heitz, Dupuy, Hill, Neubelt 2016). The horizon of cosine space is that of a sphere
// with the same vector irradiance, by a rational fit (Hill and Heitz 2016), or with USUAL_CLIPPED that of the quad, clipped
// in sixteen cases. GLSL 4.50 and GLSL ES 3.00; written from these publications.

// Where the textures of 64 x 64 texels have the lobe of a roughness and a view.
vec2 usual_coordinates(float roughness, float cos_theta) {
  return (vec2(roughness, sqrt(1.0 - clamp(cos_theta, 0.0, 1.0))) * 63.0 + 0.5) / 64.0;
}

struct UsualSurface {
  vec3 position;
  mat3 to_shading;
  mat3 to_cosine; // M^-1 after it
  vec3 albedo;
  vec3 specular;
};

// lobe: the elements 00, 20, 02, 22 of M^-1, the middle one being 1. amplitude: n1, n5.
UsualSurface usual_surface(vec3 position, vec3 normal, vec3 view, vec3 albedo, vec3 f0, vec4 lobe,
                           vec2 amplitude) {
  UsualSurface s;
  s.position = position;
  vec3 t1 = normalize(view - normal * dot(normal, view));
  s.to_shading = transpose(mat3(t1, cross(normal, t1), normal));
  s.to_cosine = mat3(lobe.x, 0.0, lobe.y, 0.0, 1.0, 0.0, lobe.z, 0.0, lobe.w) * s.to_shading;
  s.albedo = albedo * (1.0 - (f0 * amplitude.x + (1.0 - f0) * amplitude.y));
  s.specular = f0 * amplitude.x + (1.0 - f0) * amplitude.y;
  return s;
}

// The edge from a to b, unit vectors: theta / (2 pi) along their normal.
vec3 usual_edge(vec3 a, vec3 b) {
  float x = dot(a, b), y = abs(x);
  float fit = (0.8543985 + (0.4965155 + 0.0145206 * y) * y) / (3.4175940 + (4.1616724 + y) * y);
  float theta_sin = x > 0.0 ? fit : 0.5 * inversesqrt(max(1.0 - x * x, 1e-7)) - fit;
  return cross(a, b) * theta_sin;
}

// The integral of the clamped cosine over the quad.
#ifdef USUAL_CLIPPED
float usual_irradiance(vec3 a, vec3 b, vec3 c, vec3 d) {
  int above = int(a.z > 0.0) + 2 * int(b.z > 0.0) + 4 * int(c.z > 0.0) + 8 * int(d.z > 0.0);
  int n = 0;
  vec3 e = d;
  if (above == 1) {
    n = 3;
    b = a.z * b - b.z * a;
    c = a.z * d - d.z * a;
  } else if (above == 2) {
    n = 3;
    a = b.z * a - a.z * b;
    c = b.z * c - c.z * b;
  } else if (above == 3) {
    n = 4;
    c = b.z * c - c.z * b;
    d = a.z * d - d.z * a;
  } else if (above == 4) {
    n = 3;
    a = c.z * d - d.z * c;
    b = c.z * b - b.z * c;
  } else if (above == 6) {
    n = 4;
    a = b.z * a - a.z * b;
    d = c.z * d - d.z * c;
  } else if (above == 7) {
    n = 5;
    e = a.z * d - d.z * a;
    d = c.z * d - d.z * c;
  } else if (above == 8) {
    n = 3;
    a = d.z * a - a.z * d;
    b = d.z * c - c.z * d;
    c = d;
  } else if (above == 9) {
    n = 4;
    b = a.z * b - b.z * a;
    c = d.z * c - c.z * d;
  } else if (above == 11) {
    n = 5;
    e = d;
    d = d.z * c - c.z * d;
    c = b.z * c - c.z * b;
  } else if (above == 12) {
    n = 4;
    b = c.z * b - b.z * c;
    a = d.z * a - a.z * d;
  } else if (above == 13) {
    n = 5;
    e = d;
    d = c;
    c = c.z * b - b.z * c;
    b = a.z * b - b.z * a;
  } else if (above == 14) {
    n = 5;
    e = d.z * a - a.z * d;
    a = b.z * a - a.z * b;
  } else if (above == 15) {
    n = 4;
  }
  if (n == 0) return 0.0;
  if (n == 3) d = a;
  if (n == 4) e = a;
  a = normalize(a);
  b = normalize(b);
  c = normalize(c);
  d = normalize(d);
  e = normalize(e);
  float sum = usual_edge(a, b).z + usual_edge(b, c).z + usual_edge(c, d).z;
  if (n >= 4) sum += usual_edge(d, e).z;
  if (n == 5) sum += usual_edge(e, a).z;
  return abs(sum);
}
#else
float usual_irradiance(vec3 a, vec3 b, vec3 c, vec3 d) {
  a = normalize(a);
  b = normalize(b);
  c = normalize(c);
  d = normalize(d);
  // Corners run clockwise as seen from the point, whose normal they turn away from.
  vec3 vector = usual_edge(b, a) + usual_edge(c, b) + usual_edge(d, c) + usual_edge(a, d);
  float size = length(vector);
  return max(0.0, (size * size + vector.z) / (size + 1.0));
}
#endif

// The light of a one-sided quad of radiance 1.
vec3 usual_quad(UsualSurface s, vec3 center, vec3 half_u, vec3 half_v) {
  vec3 middle = center - s.position;
  if (dot(middle, cross(half_u, half_v)) >= 0.0) return vec3(0.0);
  vec3 a = middle - half_u - half_v, b = middle + half_u - half_v;
  vec3 c = middle + half_u + half_v, d = middle - half_u + half_v;
  mat3 m = s.to_shading, l = s.to_cosine;
  return s.albedo * usual_irradiance(m * a, m * b, m * c, m * d) +
         s.specular * usual_irradiance(l * a, l * b, l * c, l * d);
}
