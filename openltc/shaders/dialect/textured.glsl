// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A rectangle with a picture.

/// Light that a surface reflects of a rectangle whose radiance is a picture, without shadow. The picture's
/// mean is taken over the light as each part of the surface's reflection sees it. half_u and half_v are at
/// right angles.
FN Vec3 shade_textured_quad(Surface s, Quad quad, Picture picture) {
  LightIntegral integral = surface_quad_integral(s, quad);
  ShadedLight shaded = shade_integral(s, integral);
  Vec3 front = front_shading(s);
  Vec3 diffuse = emission_seen_part(quad, picture, s.position, s.frame, cosine_lobe(),
                                    integral.diffuse_direction, front, s.tilted);
  Vec3 specular = Vec3(Real(0.0), Real(0.0), Real(0.0));
  if (s.two) {
    Real first = integral.specular * s.inv_share;
    Real second = integral.second * s.second_inv_share;
    Real inv = Real(1.0) / max(first + second, Real(k_tiny));
    specular = emission_seen_part(quad, picture, s.position, s.frame, s.fitted.lobe,
                                  integral.first_direction, front, s.tilted) *
                   (first * inv) +
               emission_seen_part(quad, picture, s.position, s.frame, s.second,
                                  integral.second_direction, front, s.tilted) *
                   (second * inv);
  } else {
    specular = emission_seen_part(quad, picture, s.position, s.frame, s.fitted.lobe,
                                  integral.specular_direction, front, s.tilted);
  }
  return shaded.diffuse * diffuse + shaded.specular * specular;
}
