// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A point of a surface, ready to be shaded, and its BRDF by itself.
//
//   L_o = integral of (k_d c/pi + f_s) L_i cos_i,   f_s = D V F (GGX, height-correlated Smith,
//   Schlick), k_d = 1 - the specular albedo: openltc/shade/surface.glsl.

#pragma once

#include "openltc/api/lobes.h"
#include "openltc/api/material.h"

namespace openltc {

/// \addtogroup surface
/// @{

/// A point of a surface seen from a viewer. Made by make_surface, and of use to shade() and its
/// like. Owns nothing but its numbers; the lobes may go.
struct Surface {
  f32::Surface point{}; ///< as the shading dialect has it (openltc/shade/surface.glsl)
  bool usable = false;  ///< false: what it was made of was no point; nothing is reflected
};

namespace detail {

/// Directions of a point as shading wants them: unit, world space, on the viewer's side.
struct OrientedPoint {
  bool usable = false; ///< false: they are none
  Vec3f normal{0, 0, 1}, view{0, 0, 1}, geometric{0, 0, 1};
};

inline OrientedPoint orient(Vec3f position, Vec3f normal, Vec3f view) {
  const Vec3f none(0.0f);
  const Vec3f n = unit_or(normal, none), wo = unit_or(view, none);
  if (!(is_place(position) && dot(n, n) > 0.5f && dot(wo, wo) > 0.5f)) return {};
  const Vec3f up = towards_viewer(n, wo);
  return {true, up, wo, up};
}

inline OrientedPoint orient(Vec3f position, Vec3f normal, Vec3f view, Vec3f geometric_normal) {
  const Vec3f geometric = unit_or(geometric_normal, Vec3f(0.0f));
  if (!(dot(geometric, geometric) > 0.5f)) return {};
  const bool from_front = dot(geometric, view) >= 0;
  OrientedPoint point = orient(position, from_front ? normal : -normal, view);
  point.geometric = from_front ? geometric : -geometric;
  return point;
}

inline Surface surface_of(Vec3f position, const OrientedPoint& oriented, const Material& material,
                          const Lobes& lobes) {
  Surface surface;
  surface.usable = oriented.usable && has_lobes(lobes);
  if (!surface.usable) return surface;
  const Reflectance r = reflectance_of(material);
  const Vec3f &up = oriented.normal, &wo = oriented.view;
  surface.point = f32::make_surface(find_lobe(lobes, r.roughness, dot(up, wo)), position, up, wo,
                                    r.albedo, r.f0, Vec3f(r.f90), r.roughness);
  if (has_second_lobe(lobes))
    surface.point =
        f32::add_second_lobe(surface.point, find_second_lobe(lobes, r.roughness, dot(up, wo)));
  return surface;
}

} // namespace detail

/// Prepares a point for shading: one look-up of a lobe, which all lights share.
///
/// position: world space, metres, within k_max_coordinate.
/// normal: of shading, world space, on the viewer's side; any length that is not 0.
/// view: from the surface to the eye, world space; any length that is not 0.
/// lobes: built_in_table(), built_in_polynomial() or your own.
///
/// A normal that faces away from the viewer is bent until the view grazes it. Input that is not
/// finite, a direction of no length or lobes of nothing give a surface that is not `usable`, which
/// is black.
inline Surface make_surface(Vec3f position, Vec3f normal, Vec3f view, const Material& material,
                            const Lobes& lobes) {
  return detail::surface_of(position, detail::orient(position, normal, view), material, lobes);
}

/// The same with the normal of the triangle that the point is on: world space, either side, any
/// length that is not 0.
///
/// It tells which side is seen: where it faces away from the viewer, both normals are turned round.
/// What lies behind the triangle's plane is hidden by it, whatever the shading normal says, so that
/// normal maps and interpolated normals let no light through.
inline Surface make_surface(Vec3f position, Vec3f normal, Vec3f view, const Material& material,
                            const Lobes& lobes, Vec3f geometric_normal) {
  const detail::OrientedPoint oriented = detail::orient(position, normal, view, geometric_normal);
  Surface surface = detail::surface_of(position, oriented, material, lobes);
  if (surface.usable) surface.point = f32::set_geometric_normal(surface.point, oriented.geometric);
  return surface;
}

/// Says how far a surface may be from its position, in metres; make_surface takes the rounding of
/// single precision. A point that is no further than that from the plane of a flat light is taken
/// to lie in it and has no light of it; what is no further behind its own triangle is hidden. For
/// positions found from a depth buffer, or large offsets of shadow rays. Smaller values than are
/// set, or none at all, change nothing.
inline void set_position_error(Surface& surface, float metres) {
  const float error2 = metres * metres;
  if (metres > 0.0f && error2 > surface.point.position_error2)
    surface.point.position_error2 = f32::min(error2, k_max_coordinate * k_max_coordinate);
}

/// @}

/// \addtogroup sampling
/// @{

/// Asks that area lights take the ratio of GGX to its lobe in the mean direction of each, which
/// mends the lobe's shape: small lights are exact, errors of others a half and less, for a tenth of
/// the time more (docs/method.md, section 8). Not for lobes that were fitted to another BRDF, which
/// would become GGX.
inline void correct_at_mean(Surface& surface) {
  if (surface.usable) surface.point = f32::correct_at_mean(surface.point);
}

/// Asks that the specular part of area lights be GGX itself instead of a fitted lobe: exact, for
/// any roughness, for polygons, ellipses, spheres, tubes and lines; a polygon takes six to eight
/// times as long (docs/method.md, section 11). Not for lobes that were fitted to another BRDF.
inline void make_exact(Surface& surface) {
  if (surface.usable) surface.point = f32::make_exact(surface.point);
}

/// The same, but large polygons where the view does not graze the surface are left to the lobes
/// with correct_at_mean, which give them nearly as well; small ones are four points of GGX. What
/// `openltc render` takes, with built_in_two_lobe_table().
inline void make_adaptive(Surface& surface) {
  if (surface.usable) surface.point = f32::make_adaptive(surface.point);
}

/// \name The BRDF itself
///
/// Times the cosine at the surface: what a path tracer, or a reference, integrates. `wi` leads from
/// the surface to the light, world space, any length that is not 0.
/// @{

namespace detail {

/// What lies in that unit direction, by the two planes that bound what a surface sees.
inline bool is_above(const f32::Surface& s, Vec3f wi) {
  return dot(s.frame.n, wi) > 0.0f && (!s.tilted || dot(s.geometric, wi) > 0.0f);
}

/// A random number in [0, 1), whatever came in.
inline float unit_random(float u) { return u > 0.0f ? (u < 0.99999994f ? u : 0.99999994f) : 0.0f; }
inline Vec2f unit_random(Vec2f u) { return {unit_random(u.x), unit_random(u.y)}; }

inline bool is_density(float pdf) { return pdf > 0.0f && pdf <= 3.0e38f; }

} // namespace detail

/// BRDF times cosine, 1/steradian; zero behind the surface. Of the microfacets themselves, not of
/// the fitted lobe: shade() differs from its integral by the error of the fit.
inline Vec3f eval_surface(const Surface& surface, Vec3f wi) {
  const Vec3f direction = detail::unit_or(wi, Vec3f(0.0f));
  if (!surface.usable || !detail::is_above(surface.point, direction)) return Vec3f(0.0f);
  const f32::Surface& s = surface.point;
  return detail::finite_light(f32::eval_surface(s, f32::to_shading(s.frame, direction)));
}

/// Density per steradian with which sample_surface draws a direction.
inline float pdf_surface(const Surface& surface, Vec3f wi) {
  const Vec3f direction = detail::unit_or(wi, Vec3f(0.0f));
  if (!surface.usable || !detail::is_above(surface.point, direction)) return 0.0f;
  const f32::Surface& s = surface.point;
  return detail::finite_light(f32::pdf_surface(s, f32::to_shading(s.frame, direction)));
}

/// A direction drawn from the BRDF.
struct DirectionSample {
  bool valid = false;       ///< false: nothing comes from there, and the sample counts as 0
  Vec3f direction{0, 0, 0}; ///< unit, world space, from the surface
  Vec3f value{0, 0, 0};     ///< eval_surface there
  float pdf = 0;            ///< pdf_surface there, per steradian
};

/// Draws a direction from two random numbers in [0, 1): a visible GGX normal or a cosine. The mean
/// of value / pdf times the radiance from there is the reflected radiance.
inline DirectionSample sample_surface(const Surface& surface, Vec2f u) {
  DirectionSample sample;
  if (!surface.usable) return sample;
  const f32::Surface& s = surface.point;
  const Vec3f wi = f32::to_world(s.frame, f32::sample_surface(s, detail::unit_random(u)));
  sample.direction = detail::unit_or(wi, s.frame.n);
  sample.value = eval_surface(surface, sample.direction);
  sample.pdf = pdf_surface(surface, sample.direction);
  sample.valid = detail::is_density(sample.pdf);
  return sample;
}

/// @}
/// @}

} // namespace openltc
