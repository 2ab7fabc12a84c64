// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// OpenLTC in C, for C and for every language that binds to it: the lights of openltc/openltc.h over
// arrays of points, and the fitter. C99; link with libopenltc_c. docs/api.md, "From C and other
// languages", tells it in order; docs/examples/shade_quad.c is a whole program.
//
//   openltc_lobes* lobes;
//   openltc_lights* lights;
//   openltc_lobes_create_built_in(OPENLTC_TABLE, &lobes);
//   openltc_lights_create(&lights);
//   openltc_lights_add_rectangle(lights, center, half_u, half_v, 0, radiance);
//   openltc_shade(lobes, lights, &points, 0, reflected);
//
// What holds everywhere:
//
// - World space, metres. Directions lead away from the surface and may have any length that is not
//   0. Colours are linear Rec.709. Radiance in nits gives nits; any other unit comes out as it went
//   in. A vector is 3 floats, x y z or red green blue.
// - A function that can fail returns an openltc_status. If it is not OPENLTC_OK, nothing was
//   created, added or written, but for what the function itself says, and openltc_last_error() has
//   the reason.
// - Any pointer may be null: that is an error, not a crash. Memory behind other pointers is the
//   caller's to get right.
// - A light or a table of numbers that are no light and no table is refused. Points are data: what
//   is not finite there, or has no direction, is black. Results are finite and not negative.
// - Nothing throws, prints or keeps state, but for the last error of each thread. Threads may read
//   the same lobes and lights at once; a handle that is being changed or destroyed belongs to one.

#ifndef OPENLTC_OPENLTC_C_H
#define OPENLTC_OPENLTC_C_H

#include <stddef.h>
#include <stdint.h>

/// \addtogroup c_api
/// @{

/// Before what the shared library exports.
#ifdef __GNUC__
#define OPENLTC_EXPORT __attribute__((visibility("default")))
#else
#define OPENLTC_EXPORT
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// The version of this header, and, by openltc_version(), that of the library that runs: before 1.0
/// they must be the same.
#define OPENLTC_C_VERSION "0.1.0"

/// "major.minor.patch", for as long as the program lives.
OPENLTC_EXPORT const char* openltc_version(void);

/// Whether a function did what it is for. 32 bits in every language.
typedef int32_t openltc_status;
/// Values of openltc_status.
enum {
  OPENLTC_OK = 0,               ///< it did
  OPENLTC_INVALID_ARGUMENT = 1, ///< null, NaN, out of range; a light that is none
  OPENLTC_BUFFER_TOO_SMALL = 2, ///< and the function says how much it takes
  OPENLTC_UNKNOWN_NAME = 3,     ///< of a BRDF or an objective; the error lists those there are
  OPENLTC_FIT_FAILED = 4,       ///< the BRDF is NaN, negative or without energy somewhere, or alike
  OPENLTC_CANCELLED = 5,        ///< a progress callback asked to stop
  OPENLTC_FILE_ERROR = 6,       ///< a file cannot be read, or is not what it should be
  OPENLTC_OUT_OF_MEMORY = 7,    ///< there is not enough memory
  OPENLTC_INTERNAL_ERROR = 8    ///< a fault of the library
};

/// What went wrong with the last call of this thread that failed: one line, UTF-8; "" before any.
/// Calls that succeed leave it alone. Valid until the thread's next call that fails.
OPENLTC_EXPORT const char* openltc_last_error(void);

/// \name Lobes: the fitted BRDF
/// @{

/// Forms of lobes over roughness and view angle.
enum {
  OPENLTC_TABLE = 0,         ///< texels to look up
  OPENLTC_POLYNOMIAL = 1,    ///< terms to evaluate
  OPENLTC_TWO_LOBE_TABLE = 2 ///< texels of two lobes to look up: half the error of one
};

/// Lobes of a BRDF; owns its numbers and never changes.
typedef struct openltc_lobes openltc_lobes;

/// The lobes of GGX that come with the library; `form` is any of the three.
OPENLTC_EXPORT openltc_status openltc_lobes_create_built_in(int32_t form, openltc_lobes** lobes);

/// A table of one's own, which is copied: rows x columns texels of 8 floats, A B C D n1 n5 0 0, a
/// column for each node of roughness, sqrt(alpha) from 0 to 1, fast; a row for each of
/// sqrt(1 - cos theta) from 0 to 1, slow; 2 to 512 of each. A B C D is the lobe's M^-1 in the
/// mirror frame with alpha factored out, as openltc_fit makes it of a BRDF of OPENLTC_WIDTH_ALPHA.
/// Refuses numbers that are not finite and texels without a positive determinant.
OPENLTC_EXPORT openltc_status openltc_lobes_create_table(const float* texels, size_t columns,
                                                         size_t rows, openltc_lobes** lobes);

/// A table of two lobes at every node, which is copied: texels as of openltc_lobes_create_table,
/// but A B C D n1 n5 w 0 with the second lobe's share w of n1, 0..1; and as many of 4 floats, A B C
/// D of the second lobe, packed as the first. Refuses what openltc_lobes_create_table refuses, in
/// either lobe, and other weights.
OPENLTC_EXPORT openltc_status openltc_lobes_create_two_lobe_table(const float* texels,
                                                                  const float* second,
                                                                  size_t columns, size_t rows,
                                                                  openltc_lobes** lobes);

/// A polynomial of one's own, which is copied: (degree + 1)(degree + 2)/2 terms of 8 floats,
/// A B C D n1 s 0 0, as openltc_fit makes them; degree 3 to 6. Refuses numbers that are not finite
/// and lobes without a positive determinant.
OPENLTC_EXPORT openltc_status openltc_lobes_create_polynomial(const float* terms, size_t degree,
                                                              openltc_lobes** lobes);

/// Ends lobes. Null is fine.
OPENLTC_EXPORT void openltc_lobes_destroy(openltc_lobes* lobes);

/// @}

/// \name Lights
///
/// Each openltc_lights_add_... adds a light at the end, or refuses it and says why. Vectors are
/// `const float[3]`; `radiance` is the same in every direction, finite and not negative.
/// Coordinates lie within 4e8 m, radii, semi-axes and lengths between 1e-12 and 1e8 m. `two_sided`
/// is 0 or 1: whether a flat light emits against its normal too.
/// @{

/// A list of lights of any shape, in the order in which they were added.
typedef struct openltc_lights openltc_lights;

/// An empty list, which openltc_lights_destroy ends.
OPENLTC_EXPORT openltc_status openltc_lights_create(openltc_lights** lights);
/// Ends a list and its lights. Null is fine.
OPENLTC_EXPORT void openltc_lights_destroy(openltc_lights* lights);
/// How many lights there are; 0 for null.
OPENLTC_EXPORT size_t openltc_lights_count(const openltc_lights* lights);
/// Leaves no light.
OPENLTC_EXPORT openltc_status openltc_lights_clear(openltc_lights* lights);

/// A rectangle, or parallelogram, around `center`: half_u and half_v lead from there to the middles
/// of two neighbouring sides. Emits along half_u x half_v.
OPENLTC_EXPORT openltc_status openltc_lights_add_rectangle(openltc_lights* lights,
                                                           const float* center, const float* half_u,
                                                           const float* half_v, int32_t two_sided,
                                                           const float* radiance);

/// Any planar outline of 3 vertices or more, convex or concave: `vertices` is vertex_count x 3
/// floats, not closed by repeating the first, counter-clockwise as seen from where it emits to.
/// With `ring_ends`, ring_count numbers that rise to vertex_count, the vertices are several rings,
/// each of which ends before that vertex: outlines counter-clockwise, holes clockwise, in any
/// order. Null and 0: one ring.
OPENLTC_EXPORT openltc_status openltc_lights_add_polygon(openltc_lights* lights,
                                                         const float* vertices, size_t vertex_count,
                                                         const size_t* ring_ends, size_t ring_count,
                                                         int32_t two_sided, const float* radiance);

/// A flat ellipse: half_u and half_v are its semi-axes, perpendicular within 1e-3. Emits along
/// half_u x half_v.
OPENLTC_EXPORT openltc_status openltc_lights_add_ellipse(openltc_lights* lights,
                                                         const float* center, const float* half_u,
                                                         const float* half_v, int32_t two_sided,
                                                         const float* radiance);

/// A disk, which emits along `normal`.
OPENLTC_EXPORT openltc_status openltc_lights_add_disk(openltc_lights* lights, const float* center,
                                                      const float* normal, float radius,
                                                      int32_t two_sided, const float* radiance);

/// A sphere, which emits outwards.
OPENLTC_EXPORT openltc_status openltc_lights_add_sphere(openltc_lights* lights, const float* center,
                                                        float radius, const float* radiance);

/// What closes the ends of a tube.
enum {
  OPENLTC_CAPS_NONE = 0, ///< an open tube: the lateral surface alone
  OPENLTC_CAPS_FLAT = 1, ///< a solid cylinder
  OPENLTC_CAPS_ROUND = 2 ///< a capsule: hemispheres beyond the ends of the axis
};

/// A round tube between the ends of its axis, which emits outwards.
OPENLTC_EXPORT openltc_status openltc_lights_add_tube(openltc_lights* lights, const float* from,
                                                      const float* to, float radius, int32_t caps,
                                                      const float* radiance);

/// A tube without a width: in place of a radiance it has cd/m across its axis, a thin tube's
/// radiance times its diameter.
OPENLTC_EXPORT openltc_status openltc_lights_add_line(openltc_lights* lights, const float* from,
                                                      const float* to,
                                                      const float* intensity_per_metre);

/// A point of `intensity` candela; `range`: metres from which it has faded to nothing, 0 = never.
OPENLTC_EXPORT openltc_status openltc_lights_add_point(openltc_lights* lights,
                                                       const float* position,
                                                       const float* intensity, float range);

/// A spot that shines along `direction` with `intensity` candela: all of it within inner_angle of
/// the axis, none outside of outer_angle; radians, 0 <= inner <= outer <= pi/2.
OPENLTC_EXPORT openltc_status openltc_lights_add_spot(openltc_lights* lights, const float* position,
                                                      const float* direction,
                                                      const float* intensity, float range,
                                                      float inner_angle, float outer_angle);

/// Light from far away that travels along `direction`: `illuminance` lux on a surface that faces
/// it.
OPENLTC_EXPORT openltc_status openltc_lights_add_directional(openltc_lights* lights,
                                                             const float* direction,
                                                             const float* illuminance);

/// @}

/// \name Points
/// @{

/// A material at a point, that of glTF 2.0 with KHR_materials_specular and KHR_materials_ior:
/// 10 floats. Values outside of their range are clamped, NaN counts as 0.
typedef struct openltc_material {
  float base_color[3];     ///< linear Rec.709, 0..1
  float metallic;          ///< 0..1
  float roughness;         ///< perceptual, 0..1; alpha = roughness^2
  float specular;          ///< strength of a dielectric's reflection, 0..1
  float specular_color[3]; ///< and its tint at normal incidence; above 1 is possible
  float ior;               ///< >= 1, or 0, which reflects all
} openltc_material;

/// White, rough, dielectric of index 1.5. All zero, as C leaves it, would be black.
OPENLTC_EXPORT openltc_material openltc_material_default(void);

/// As a stride: one value, which all points have.
#define OPENLTC_SAME ((size_t)-1)

/// A vector for each point: that of point i begins i * stride bytes after `data`. Stride 0 stands
/// for 12, one vector after the other; OPENLTC_SAME for one that all have. So an array of structs
/// serves as well as separate arrays. No alignment is asked for.
typedef struct openltc_vectors {
  const float* data; ///< of the first point
  size_t stride;     ///< bytes from one point to the next; 0 = 12, or OPENLTC_SAME
} openltc_vectors;

/// A number for each point: the same; stride 0 stands for 4.
typedef struct openltc_numbers {
  const float* data; ///< of the first point
  size_t stride;     ///< bytes from one point to the next; 0 = 4, or OPENLTC_SAME
} openltc_numbers;

/// A material for each point: the same; stride 0 stands for 40.
typedef struct openltc_materials {
  const openltc_material* data; ///< of the first point
  size_t stride;                ///< bytes from one point to the next; 0 = 40, or OPENLTC_SAME
} openltc_materials;

/// Points of surfaces, each seen from somewhere. Refers to arrays of the caller.
typedef struct openltc_points {
  size_t count;                ///< points
  openltc_vectors positions;   ///< world space, metres
  openltc_vectors normals;     ///< of shading, on the viewer's side unless there are geometric ones
  openltc_vectors views;       ///< from the point to the eye
  openltc_materials materials; ///< what the surfaces are of
  /// Null, or normals of the triangles, either side: they tell the side that is seen, and hide what
  /// lies behind the triangle.
  openltc_vectors geometric_normals;
  /// Null, or metres by which positions may be wrong, if more than their last digit: of the
  /// positions of a depth buffer, say.
  openltc_numbers position_errors;
} openltc_points;

/// @}

/// \name Light without noise or shadow
/// @{

/// Radiance that each point reflects to its viewer, of all lights together, in closed form and in
/// SIMD lanes: the widest that the machine has.
///
/// radiance: 3 floats a point, one after the other, overwritten. threads: how many may work on it;
/// 0 = as many as there are cores, 1 = the calling one alone. The result does not depend on them,
/// nor on the other points; on the instruction set it does, by a few times 1e-6.
OPENLTC_EXPORT openltc_status openltc_shade(const openltc_lobes* lobes,
                                            const openltc_lights* lights,
                                            const openltc_points* points, int32_t threads,
                                            float* radiance);

/// The same by what reflects it, point by point without lanes; both buffers are 3 floats a point.
/// For shadows multiply each with a ratio of its own.
OPENLTC_EXPORT openltc_status openltc_shade_parts(const openltc_lobes* lobes,
                                                  const openltc_lights* lights,
                                                  const openltc_points* points, int32_t threads,
                                                  float* diffuse, float* specular);

/// @}

/// \name Samples: shadows, and a reference
/// @{

/// A point of a light, drawn or met from a point of a surface.
typedef struct openltc_light_sample {
  float position[3];  ///< on the light
  float direction[3]; ///< to it, unit
  float distance;     ///< metres
  float cos_light;    ///< cosine at the light, 0..1
  float pdf;          ///< per steradian; of a line, per steradian and metre of its width
  float value[3];     ///< BRDF times cosine at the surface, 1/steradian
  int32_t valid;      ///< 0: no light from there reaches the point; the sample counts as 0
} openltc_light_sample;

/// Draws a point of light number `light` for each point, from two random numbers in [0, 1) each:
/// u is 2 floats a point, samples one a point. Refuses lights without an extent: point, spot,
/// directional.
///
/// The mean of value * radiance / pdf over many samples is the reflected radiance without shadow;
/// with the visibility of each, it is the one with shadow. For many samples of one point give it
/// OPENLTC_SAME.
OPENLTC_EXPORT openltc_status openltc_sample_light(const openltc_lobes* lobes,
                                                   const openltc_lights* lights, size_t light,
                                                   const openltc_points* points, int32_t threads,
                                                   const float* u, openltc_light_sample* samples);

/// Where a ray from each point, 3 floats of directions a point, meets light number `light`, with
/// the density by which openltc_sample_light draws it. No ray meets a light without a surface.
OPENLTC_EXPORT openltc_status openltc_intersect_light(const openltc_lobes* lobes,
                                                      const openltc_lights* lights, size_t light,
                                                      const openltc_points* points, int32_t threads,
                                                      const float* directions,
                                                      openltc_light_sample* samples);

/// A direction drawn from the BRDF.
typedef struct openltc_direction_sample {
  float direction[3]; ///< unit, from the surface
  float value[3];     ///< BRDF times cosine, 1/steradian
  float pdf;          ///< per steradian
  int32_t valid;      ///< 0: nothing comes from there; the sample counts as 0
} openltc_direction_sample;

/// Draws a direction from the BRDF of each point: u is 2 floats a point, samples one a point.
OPENLTC_EXPORT openltc_status openltc_sample_surface(const openltc_lobes* lobes,
                                                     const openltc_points* points, int32_t threads,
                                                     const float* u,
                                                     openltc_direction_sample* samples);

/// BRDF times cosine (3 floats a point) and the density of openltc_sample_surface (1 float a point)
/// in one direction for each point (3 floats a point). Of the microfacets themselves, not of the
/// fitted lobe. Either result may be null.
OPENLTC_EXPORT openltc_status openltc_eval_surface(const openltc_lobes* lobes,
                                                   const openltc_points* points, int32_t threads,
                                                   const float* directions, float* values,
                                                   float* pdfs);

/// @}

/// \name The fitter
/// @{

/// Number of BRDFs that are known by name.
OPENLTC_EXPORT size_t openltc_brdf_count(void);
/// Name of one of them, for as long as the program lives; null beyond the last.
OPENLTC_EXPORT const char* openltc_brdf_name(size_t index);

/// A BRDF of the caller's: f in 1/steradian, without the cosine, isotropic, for roughness 0..1. wo
/// (to the viewer) and wi (to the light) are 3 numbers each: unit, away from the surface, z along
/// its normal, both above it. It is called from many threads at once and gives the same for the
/// same; it must not throw or leave by longjmp.
typedef double (*openltc_brdf_function)(const double* wo, const double* wi, double roughness,
                                        void* user);

/// Told of the share of a job that is done, rising from 0 to 1, from any thread, one call at a
/// time. 0 asks the job to stop, anything else to go on. It must not throw or leave by longjmp.
typedef int32_t (*openltc_progress_function)(double share, void* user);

/// What a table factors out of its lobes.
enum {
  OPENLTC_WIDTH_ALPHA = 0, ///< roughness^2: lobes become a mirror; what surfaces are shaded with
  OPENLTC_WIDTH_ONE = 1    ///< nothing: lobes stay wide, as of sheen or diffuse BRDFs
};

/// Whether the nodes of a table are fitted once more, all together.
enum {
  OPENLTC_REFINE_AUTOMATIC = 0, ///< where it pays: up to 32 nodes per axis
  OPENLTC_REFINE_ON = 1,        ///< yes
  OPENLTC_REFINE_OFF = 2        ///< no
};

/// How lobes are fitted. All zero, or a null pointer to it: a table as the built-in one.
typedef struct openltc_fit_options {
  int32_t form;          ///< OPENLTC_TABLE, OPENLTC_POLYNOMIAL or OPENLTC_TWO_LOBE_TABLE
  int32_t refine;        ///< of a table
  size_t size;           ///< nodes per axis of a table, 2 to 512; 0 = 64, of two lobes 32
  size_t degree;         ///< of a polynomial, 3 to 6; 0 = 4
  const char* objective; ///< "balanced", "tv", "l2", "l3" or "TV,L2,L3"; null = "balanced"
  openltc_progress_function progress; ///< null: nobody asks
  void* progress_user;                ///< handed to progress
} openltc_fit_options;

/// What was fitted.
typedef struct openltc_fit_result {
  size_t float_count; ///< written; or, with OPENLTC_BUFFER_TOO_SMALL, needed
  size_t columns;     ///< of a table; a BRDF without roughness has one. Otherwise 0
  size_t rows;        ///< of a table, otherwise 0
  size_t degree;      ///< of a polynomial; otherwise 0
  int32_t width;      ///< OPENLTC_WIDTH_ALPHA or OPENLTC_WIDTH_ONE
  /// Total variation between lobe and BRDF, 0..1, the mean of 40 x 40 points of roughness 0.06 to 1
  /// and view angles to 89.7 degrees: what the files of `openltc fit` state.
  double mean_tv;
  double max_tv; ///< and the largest
} openltc_fit_result;

/// The number of floats that a fit with these options writes at most; 0 where they are out of
/// range.
OPENLTC_EXPORT size_t openltc_fit_capacity(const openltc_fit_options* options);

/// Fits lobes to a BRDF by its name, or to a measured one by the path of a MERL file, which ends in
/// ".binary", and writes them to `numbers`, which has room for `capacity` floats, in the form that
/// openltc_lobes_create_table or openltc_lobes_create_polynomial reads; of two lobes the texels of
/// 8 floats and behind all of them those of 4 that openltc_lobes_create_two_lobe_table calls
/// `second`. Runs on all cores; the result does not depend on them. With null for `result` the
/// error is not measured, which saves a good part of the time. Where it fails `numbers` is as it
/// was, and `result` zero.
OPENLTC_EXPORT openltc_status openltc_fit(const char* brdf, const openltc_fit_options* options,
                                          float* numbers, size_t capacity,
                                          openltc_fit_result* result);

/// The same for a function of the caller's, whose lobes are of OPENLTC_WIDTH_ALPHA or
/// OPENLTC_WIDTH_ONE; `user` is handed to it.
OPENLTC_EXPORT openltc_status openltc_fit_function(openltc_brdf_function function, void* user,
                                                   int32_t width,
                                                   const openltc_fit_options* options,
                                                   float* numbers, size_t capacity,
                                                   openltc_fit_result* result);

/// @}
/// @}

#ifdef __cplusplus
}
#endif

#endif
