// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A rectangle lights a floor: shade_quad.cpp in C, all points at once.
//
//   shade_quad_c [FILE.pgm]   prints what reaches the middle of the floor, and writes a picture of
//   it
//
// cc -std=c99 -I ROOT docs/examples/shade_quad.c -L ROOT/build/release/lib -lopenltc_c, ROOT being
// the folder in which openltc/ lies.

#include "openltc/openltc_c.h"

#include <stdio.h>

enum { k_width = 160, k_height = 90, k_count = k_width * k_height + 1 };

static float positions[k_count][3], views[k_count][3], radiance[k_count][3];

// A point of the floor, in the plane y = 0, seen from an eye 1.5 m above it.
static void place(int i, float x, float z) {
  positions[i][0] = x;
  positions[i][1] = 0;
  positions[i][2] = z;
  views[i][0] = 0 - x;
  views[i][1] = 1.5f;
  views[i][2] = 4 - z;
}

// Radiance, in nits, of all points. False if something failed: openltc_last_error() says what.
static int shade(void) {
  // A square metre, a metre above the floor, facing down. A real engine makes lights once.
  const float center[3] = {0, 1, 0}, half_u[3] = {0.5f, 0, 0}, half_v[3] = {0, 0, 0.5f};
  const float lamp_nits[3] = {100, 100, 100}, up[3] = {0, 1, 0};

  openltc_material varnish = openltc_material_default(); // glTF 2.0: of index 1.5 over brown
  varnish.base_color[0] = 0.4f;
  varnish.base_color[1] = 0.2f;
  varnish.base_color[2] = 0.1f;
  varnish.roughness = 0.3f;

  // Arrays with one value for each point, and single values that all points have.
  openltc_points points = {0};
  points.count = k_count;
  points.positions.data = positions[0];
  points.views.data = views[0];
  points.normals.data = up;
  points.normals.stride = OPENLTC_SAME;
  points.materials.data = &varnish;
  points.materials.stride = OPENLTC_SAME;

  openltc_lobes* lobes = NULL;
  openltc_lights* lights = NULL;
  const int done =
      openltc_lobes_create_built_in(OPENLTC_TABLE, &lobes) == OPENLTC_OK &&
      openltc_lights_create(&lights) == OPENLTC_OK &&
      openltc_lights_add_rectangle(lights, center, half_u, half_v, 0, lamp_nits) == OPENLTC_OK &&
      openltc_shade(lobes, lights, &points, 0, radiance[0]) == OPENLTC_OK;
  openltc_lights_destroy(lights);
  openltc_lobes_destroy(lobes);
  return done;
}

int main(int argc, char** argv) {
  for (int i = 0; i + 1 < k_count; ++i)
    place(i, ((float)(i % k_width) - 79.5f) / 40, ((float)(i / k_width) - 44.5f) / 20);
  place(k_count - 1, 0, 0);
  if (!shade()) {
    fprintf(stderr, "shade_quad_c: %s\n", openltc_last_error());
    return 1;
  }
  printf("in the middle: %.3f nits\n", (double)radiance[k_count - 1][1]);
  if (argc < 2) return 0;

  FILE* file = fopen(argv[1], "wb");
  int written = file && fprintf(file, "P5\n%d %d\n255\n", k_width, k_height) > 0;
  for (int i = 0; written && i + 1 < k_count; ++i) {
    const float nits = radiance[i][1];
    written = fputc(nits < 10 ? (int)(25.5f * nits) : 255, file) != EOF;
  }
  if (file) written = fclose(file) == 0 && written;
  if (!written) fprintf(stderr, "shade_quad_c: cannot write %s\n", argv[1]);
  return written ? 0 : 1;
}
