// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc/openltc_c.h from C99: values that are known otherwise, and what is refused.

#include "openltc/openltc_c.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                                                           \
  do {                                                                                             \
    if (!(condition)) {                                                                            \
      ++failures;                                                                                  \
      fprintf(stderr, "%s:%d: %s does not hold; last error: %s\n", __FILE__, __LINE__, #condition, \
              openltc_last_error());                                                               \
    }                                                                                              \
  } while (0)

// Refused, with a reason that has this word in it.
#define CHECK_REFUSED(call, word)                                                                  \
  do {                                                                                             \
    CHECK((call) == OPENLTC_INVALID_ARGUMENT);                                                     \
    CHECK(strstr(openltc_last_error(), word) != NULL);                                             \
  } while (0)

static const float center[3] = {0, 1, 0}, half_u[3] = {0.5f, 0, 0}, half_v[3] = {0, 0, 0.5f};
static const float up[3] = {0, 1, 0}, origin[3] = {0, 0, 0}, nits[3] = {100, 200, 300};

// A white Lambertian point at the origin, looked at from above.
static openltc_material lambertian(void) {
  openltc_material material = openltc_material_default();
  material.specular = 0;
  return material;
}

static openltc_points one_point(const openltc_material* material) {
  openltc_points points = {0};
  points.count = 1;
  points.positions.data = origin;
  points.normals.data = up;
  points.views.data = up;
  points.materials.data = material;
  return points;
}

// The factor from an element to a square metre a metre above it, parallel, is 0.2394 (Howell, "A
// Catalog of Radiation Heat Transfer Configuration Factors"): the share of its radiance that a
// white Lambertian surface shows.
static void a_white_floor_shows_the_factor_of_its_light(void) {
  const double a = 0.5 / sqrt(1.25);
  const double factor = 4 * 2 * a * atan(a) / (2 * 3.14159265358979);
  const openltc_material material = lambertian();
  const openltc_points points = one_point(&material);
  openltc_lobes* lobes = NULL;
  openltc_lights* lights = NULL;
  float radiance[3] = {-1, -1, -1}, diffuse[3], specular[3];
  CHECK(fabs(factor - 0.2394) < 1e-4);
  CHECK(openltc_lobes_create_built_in(OPENLTC_TABLE, &lobes) == OPENLTC_OK);
  CHECK(openltc_lights_create(&lights) == OPENLTC_OK);
  CHECK(openltc_lights_add_rectangle(lights, center, half_u, half_v, 0, nits) == OPENLTC_OK);
  CHECK(openltc_lights_count(lights) == 1);
  CHECK(openltc_shade(lobes, lights, &points, 1, radiance) == OPENLTC_OK);
  CHECK(openltc_shade_parts(lobes, lights, &points, 1, diffuse, specular) == OPENLTC_OK);
  for (int i = 0; i < 3; ++i) {
    CHECK(fabs(radiance[i] / nits[i] - factor) < 1e-5);
    CHECK(fabs(diffuse[i] / nits[i] - factor) < 1e-5);
    CHECK(specular[i] == 0);
  }

  // A point light of 100 cd, a metre above: 100 lux, of which a Lambertian shows 1/pi.
  CHECK(openltc_lights_clear(lights) == OPENLTC_OK);
  CHECK(openltc_lights_count(lights) == 0);
  CHECK(openltc_lights_add_point(lights, center, nits, 0) == OPENLTC_OK);
  CHECK(openltc_shade(lobes, lights, &points, 1, radiance) == OPENLTC_OK);
  CHECK(fabs(radiance[0] * 3.14159265358979 - 100) < 1e-3);

  // No light, no radiance.
  CHECK(openltc_lights_clear(lights) == OPENLTC_OK);
  CHECK(openltc_shade(lobes, lights, &points, 1, radiance) == OPENLTC_OK);
  CHECK(radiance[0] == 0 && radiance[1] == 0 && radiance[2] == 0);
  openltc_lights_destroy(lights);
  openltc_lobes_destroy(lobes);
}

static void what_is_no_point_is_black(void) {
  const openltc_material material = lambertian();
  openltc_points points = one_point(&material);
  openltc_lobes* lobes = NULL;
  openltc_lights* lights = NULL;
  const float bad[4][3] = {{NAN, 0, 0}, {0, INFINITY, 0}, {0, 0, 0}, {0, 1e30f, 0}};
  CHECK(openltc_lobes_create_built_in(OPENLTC_POLYNOMIAL, &lobes) == OPENLTC_OK);
  CHECK(openltc_lights_create(&lights) == OPENLTC_OK);
  CHECK(openltc_lights_add_sphere(lights, center, 0.2f, nits) == OPENLTC_OK);
  for (int i = 0; i < 4; ++i) {
    float radiance[3] = {-1, -1, -1};
    points.normals.data = bad[i];
    CHECK(openltc_shade(lobes, lights, &points, 1, radiance) == OPENLTC_OK);
    CHECK(radiance[0] == 0 && radiance[1] == 0 && radiance[2] == 0);
  }
  openltc_lights_destroy(lights);
  openltc_lobes_destroy(lobes);
}

static void null_is_refused_everywhere(void) {
  const openltc_material material = lambertian();
  const openltc_points points = one_point(&material);
  openltc_points no_points = {0};
  openltc_points broken = points;
  openltc_lobes* lobes = NULL;
  openltc_lights* lights = NULL;
  openltc_light_sample sample;
  openltc_direction_sample direction;
  float radiance[3] = {7, 7, 7};
  const float u[2] = {0.5f, 0.5f};

  openltc_lobes_destroy(NULL);
  openltc_lights_destroy(NULL);
  CHECK(openltc_lights_count(NULL) == 0);
  CHECK_REFUSED(openltc_lobes_create_built_in(OPENLTC_TABLE, NULL), "null");
  CHECK_REFUSED(openltc_lights_create(NULL), "null");
  CHECK_REFUSED(openltc_lights_clear(NULL), "lights");
  CHECK_REFUSED(openltc_lights_add_point(NULL, center, nits, 0), "lights");
  CHECK_REFUSED(openltc_lobes_create_built_in(7, &lobes), "form");
  CHECK(lobes == NULL);
  CHECK_REFUSED(openltc_lobes_create_table(NULL, 4, 4, &lobes), "texels");
  CHECK_REFUSED(openltc_lobes_create_polynomial(NULL, 4, &lobes), "terms");

  CHECK(openltc_lobes_create_built_in(OPENLTC_TABLE, &lobes) == OPENLTC_OK);
  CHECK(openltc_lights_create(&lights) == OPENLTC_OK);
  CHECK_REFUSED(openltc_lights_add_rectangle(lights, NULL, half_u, half_v, 0, nits), "center");
  CHECK_REFUSED(openltc_lights_add_rectangle(lights, center, half_u, half_v, 0, NULL), "radiance");
  CHECK_REFUSED(openltc_lights_add_polygon(lights, NULL, 3, NULL, 0, 0, nits), "vertices");
  CHECK_REFUSED(openltc_lights_add_polygon(lights, center, 1, NULL, 0, 0, nits), "vertex_count");
  CHECK(openltc_lights_count(lights) == 0);
  CHECK(openltc_lights_add_sphere(lights, center, 0.2f, nits) == OPENLTC_OK);

  CHECK_REFUSED(openltc_shade(NULL, lights, &points, 1, radiance), "lobes");
  CHECK_REFUSED(openltc_shade(lobes, NULL, &points, 1, radiance), "lights");
  CHECK_REFUSED(openltc_shade(lobes, lights, NULL, 1, radiance), "points");
  CHECK_REFUSED(openltc_shade(lobes, lights, &points, 1, NULL), "radiance");
  CHECK_REFUSED(openltc_shade(lobes, lights, &points, -1, radiance), "threads");
  CHECK_REFUSED(openltc_shade_parts(lobes, lights, &points, 1, radiance, NULL), "specular");
  broken.views.data = NULL;
  CHECK_REFUSED(openltc_shade(lobes, lights, &broken, 1, radiance), "views is null");
  broken = points;
  broken.positions.stride = 3; // floats, not bytes
  CHECK_REFUSED(openltc_shade(lobes, lights, &broken, 1, radiance), "stride of positions");
  CHECK(radiance[0] == 7 && radiance[1] == 7 && radiance[2] == 7);
  CHECK(openltc_shade(lobes, lights, &no_points, 1, NULL) == OPENLTC_OK);

  CHECK_REFUSED(openltc_sample_light(NULL, lights, 0, &points, 1, u, &sample), "lobes");
  CHECK_REFUSED(openltc_sample_light(lobes, NULL, 0, &points, 1, u, &sample), "lights");
  CHECK_REFUSED(openltc_sample_light(lobes, lights, 1, &points, 1, u, &sample), "no light 1");
  CHECK_REFUSED(openltc_sample_light(lobes, lights, 0, NULL, 1, u, &sample), "points");
  CHECK_REFUSED(openltc_sample_light(lobes, lights, 0, &points, 1, NULL, &sample), "null");
  CHECK_REFUSED(openltc_intersect_light(lobes, lights, 0, &points, 1, up, NULL), "null");
  CHECK_REFUSED(openltc_sample_surface(NULL, &points, 1, u, &direction), "lobes");
  CHECK_REFUSED(openltc_sample_surface(lobes, &points, 1, u, NULL), "null");
  CHECK_REFUSED(openltc_eval_surface(lobes, &points, 1, up, NULL, NULL), "null");
  CHECK(openltc_eval_surface(lobes, &points, 1, up, radiance, NULL) == OPENLTC_OK);
  CHECK(fabs(radiance[0] - 1 / 3.14159265358979) < 1e-6); // Lambert's BRDF

  CHECK_REFUSED(openltc_fit(NULL, NULL, radiance, 3, NULL), "brdf");
  CHECK_REFUSED(openltc_fit_function(NULL, NULL, OPENLTC_WIDTH_ALPHA, NULL, radiance, 3, NULL),
                "function");
  openltc_lights_destroy(lights);
  openltc_lobes_destroy(lobes);
}

int main(void) {
  CHECK(openltc_last_error()[0] == '\0');
  CHECK(strcmp(openltc_version(), OPENLTC_C_VERSION) == 0);
  CHECK(sizeof(openltc_material) == 10 * sizeof(float));
  a_white_floor_shows_the_factor_of_its_light();
  what_is_no_point_is_black();
  CHECK(openltc_last_error()[0] == '\0'); // all of this went well
  null_is_refused_everywhere();
  return failures == 0 ? 0 : 1;
}
