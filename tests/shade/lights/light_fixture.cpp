// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/shade/lights/light_fixture.h"

#include "openltc/table/lobe_table.h"

#include <algorithm>
#include <cmath>

namespace openltc::f64 {
#define FN inline
#define FN_CALL inline
#include "tests/shade/lights/light_batch_body.inc"
#undef FN_CALL
#undef FN
} // namespace openltc::f64

namespace openltc::testing {

namespace {

// Where a light is made: a plane or an axis in space, in double until everything is rounded.
struct Placement {
  Vec3d center; // world space
  double distance, size;
  f64::Frame axes; // any orientation
};

Vec3d mirror_direction(const LightCase& light) {
  const Vec3d n = to_double(light.normal), wo = to_double(light.wo);
  return n * (2 * dot(n, wo)) - wo;
}

Vec3d unit(Vec3d v) { return dot(v, v) > 0 ? normalize(v) : Vec3d(0, 0, 1); }

Placement random_placement(const LightCase& light, Random& random) {
  Placement p;
  p.distance = random.log_uniform(0.1, 10);
  p.size = p.distance * random.log_uniform(0.01, 3);
  const Vec3d n = to_double(light.normal);
  const int kind = random.integer(100);
  Vec3d direction = random.sphere();
  if (kind < 45) {
    const double spread =
        std::max(double(light.roughness) * double(light.roughness), 1e-4) + p.size / p.distance;
    direction = unit(mirror_direction(light) + random.sphere() * (spread * random.uniform()));
  } else if (kind < 85) {
    if (dot(direction, n) < 0) direction = -direction;
  } else {
    const double height = random.uniform(-1, 1) * p.size / p.distance;
    direction = unit(direction - n * dot(direction, n)) + n * height;
  }
  p.center = to_double(light.position) + direction * p.distance;
  p.axes = f64::shading_frame(random.sphere(), random.sphere());
  return p;
}

// The axes such that u x v faces the position.
void face(const LightCase& light, const Placement& p, Vec3d& u, Vec3d& v) {
  u = p.axes.t1;
  v = p.axes.t2;
  if (dot(cross(u, v), to_double(light.position) - p.center) < 0) std::swap(u, v);
}

double signed_area(const Ring& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2d a = ring[i], b = ring[(i + 1) % ring.size()];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return area;
}

// An outline about 2 across: one of the fixture's, of many corners, or random and star-shaped.
std::vector<Ring> random_outline(Random& random) {
  const int kind = random.integer(8);
  if (kind < 5) return shape(kind);
  if (kind == 5) return {star(8 + random.integer(56), 1, random.uniform(0.2, 0.95))};
  Ring ring;
  const int corners = 3 + random.integer(10);
  for (int i = 0; i < corners; ++i) {
    const double phi = 2 * f64::k_pi * (i + random.uniform(0, 0.9)) / corners;
    const double r = random.uniform(0.1, 1);
    ring.push_back(Vec2d(r * std::cos(phi), r * std::sin(phi)));
  }
  // Few corners may all lie on one side of the origin, either way round; lights face their front.
  return {signed_area(ring) < 0 ? reversed(ring) : ring};
}

std::vector<Ring> scaled(std::vector<Ring> rings, double x, double y) {
  for (Ring& ring : rings)
    for (Vec2d& p : ring)
      p = Vec2d(p.x * x, p.y * y);
  return rings;
}

void set_polygon(LightCase& light, const std::vector<Ring>& rings, Vec3d origin, Vec3d u, Vec3d v) {
  light.polygon = std::make_shared<const TestPolygon>(rings, origin, u, v, light.two_sided);
}

double distance_to_segment(Vec3d p, Vec3d a, Vec3d b) {
  const Vec3d ab = b - a;
  const double length2 = dot(ab, ab);
  const double t = length2 > 0 ? std::clamp(dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  return length(p - a - ab * t);
}

// The light's shape; sizes may be scaled by the caller. keep_outside: shrink spheres and tubes that
// hold the position.
void place(LightCase& light, const Placement& p, double ratio, Random& random, bool keep_outside) {
  Vec3d u, v;
  face(light, p, u, v);
  light.two_sided = random.integer(4) == 0;
  const Vec3d position = to_double(light.position);
  switch (light.shape) {
  case LightShape::rectangle:
    set_polygon(light, {rectangle(2 * p.size, 2 * p.size * ratio)}, p.center, u, v);
    break;
  case LightShape::polygon:
    set_polygon(light, scaled(random_outline(random), p.size, p.size * ratio), p.center, u, v);
    break;
  case LightShape::disk:
  case LightShape::ellipse:
    light.a = to_float(p.center);
    light.b = to_float(u * p.size);
    light.c = to_float(v * (p.size * (light.shape == LightShape::disk ? 1 : ratio)));
    break;
  case LightShape::sphere:
    light.a = to_float(p.center);
    light.radius = float(keep_outside ? std::min(p.size, 0.98 * p.distance) : p.size);
    break;
  default: {
    const Vec3d from = p.center - u * p.size, to = p.center + u * p.size;
    const double nearest = distance_to_segment(position, from, to);
    const double radius = p.size * ratio;
    light.a = to_float(from);
    light.b = to_float(to);
    light.radius = float(keep_outside ? std::min(radius, 0.95 * nearest) : radius);
    break;
  }
  }
}

void random_surface(LightCase& light, Random& random) {
  const Vec3d n = random.sphere();
  const double cos_theta = random.uniform();
  const f64::Frame f = f64::shading_frame(n, n);
  const double phi = random.uniform(0, 2 * f64::k_pi),
               sin_theta = std::sqrt(1 - cos_theta * cos_theta);
  light.normal = to_float(n);
  light.wo = to_float(
      f64::to_world(f, Vec3d(sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta)));
  const int kind = random.integer(20);
  light.roughness = kind == 0 ? 0.0f : kind == 1 ? 1.0f : float(random.log_uniform(0.01, 1));
  light.albedo = float(random.uniform());
  light.f0 = float(random.integer(4) == 0 ? 1.0 : random.uniform());
  light.position =
      to_float(Vec3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
}

// Some point of the light: a corner, an end, the centre, a point of an edge or of the surface.
Vec3f point_of(const LightCase& light, Random& random) {
  const float t = float(random.integer(3)) * 0.5f;
  if (light.polygon) {
    const PolygonView& view = light.polygon->view();
    if (random.integer(4) == 0) return f32::polygon_origin(view);
    const int i = random.integer(view.point_count - 1);
    const Vec3f p = f32::polygon_point(view, i), q = f32::polygon_point(view, i + 1);
    return p + (q - p) * t;
  }
  switch (light.shape) {
  case LightShape::disk:
  case LightShape::ellipse:
    return light.a + light.b * t + light.c * float(random.integer(2));
  case LightShape::sphere:
    return light.a + to_float(random.sphere()) * (light.radius * t * 2);
  default:
    return light.a + (light.b - light.a) * t + to_float(random.sphere()) * (light.radius * t);
  }
}

double extreme(Random& random) {
  const double lengths[] = {0, 1e-30, 1e-15, 1e-9, 1e-6, 1e-3, 1, 1e3, 1e6, 1e9};
  return lengths[random.integer(10)];
}

// A view at random, along the normal, or grazing.
void set_view(LightCase& light, double cos_theta, Random& random) {
  const Vec3d n = to_double(light.normal);
  const f64::Frame f = f64::shading_frame(n, n);
  const double phi = random.uniform(0, 2 * f64::k_pi);
  const double sin_theta = std::sqrt(1 - cos_theta * cos_theta);
  light.wo = to_float(
      f64::to_world(f, Vec3d(sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta)));
}

void bend_surface(LightCase& light, Random& random) {
  switch (random.integer(6)) {
  case 0:
    light.wo = light.normal;
    break;
  case 1:
    set_view(light, random.integer(2) == 0 ? 0.0 : random.log_uniform(1e-8, 1e-2), random);
    break;
  case 2:
    light.roughness = float(random.integer(2));
    break;
  case 3:
    light.roughness = float(random.log_uniform(1e-6, 1e-2));
    break;
  case 4: // an axis, so that differences along it are exact
    light.normal = random.integer(2) == 0 ? Vec3f(0, 0, 1) : Vec3f(0, -1, 0);
    set_view(light, random.uniform(), random);
    break;
  default: { // the horizon touches the light
    const Vec3d to_light = to_double(point_of(light, random)) - to_double(light.position);
    const Vec3d side = cross(to_light, random.sphere());
    if (dot(side, side) > 0 && std::isfinite(dot(side, side))) {
      light.normal = to_float(normalize(side));
      set_view(light, random.uniform(), random);
    }
    break;
  }
  }
}

float whole(float x) { return std::abs(x) < 100 ? std::nearbyint(x) : x; }
Vec3f whole(Vec3f v) { return Vec3f(whole(v.x), whole(v.y), whole(v.z)); }

} // namespace

const char* shape_name(LightShape shape) {
  static const char* const names[] = {"rectangle", "polygon",   "disk",    "ellipse", "sphere",
                                      "tube_open", "tube_flat", "capsule", "line"};
  return names[int(shape)];
}
LightShape shape_of_index(int index) { return LightShape(index); }
bool is_polygon(LightShape shape) {
  return shape == LightShape::rectangle || shape == LightShape::polygon;
}

LightCase random_light(LightShape shape, Random& random) {
  LightCase light;
  light.shape = shape;
  random_surface(light, random);
  const Placement p = random_placement(light, random);
  place(light, p, random.log_uniform(0.05, 1), random, true);
  return light;
}

LightCase adversarial_light(LightShape shape, Random& random) {
  LightCase light;
  light.shape = shape;
  random_surface(light, random);
  Placement p = random_placement(light, random);
  double ratio = random.log_uniform(0.05, 1);
  const int bends = 1 + random.integer(3);
  int at_light = -1;
  bool whole_numbers = false;
  for (int i = 0; i < bends; ++i) {
    const Vec3d direction = (p.center - to_double(light.position)) / p.distance;
    switch (random.integer(8)) {
    case 0:
      p.size = extreme(random);
      break;
    case 1:
      p.distance = extreme(random);
      p.center = to_double(light.position) + direction * p.distance;
      if (p.distance == 0) p.distance = 1;
      break;
    case 2:
      ratio = extreme(random);
      break;
    case 3: // edge-on, or the axis through the point
      p.axes = f64::shading_frame(unit(cross(direction, random.sphere())), direction);
      break;
    case 4:
      at_light = random.integer(3);
      break;
    case 5:
      whole_numbers = true;
      break;
    default:
      break;
    }
  }
  if (whole_numbers) {
    p.axes = f64::Frame{Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
    p.center = to_double(whole(to_float(p.center)));
    light.position = whole(light.position);
  }
  // Up to a billion metres: beyond, squares of squares leave single precision.
  ratio = std::min(ratio, 1e9 / std::max(p.size, 1.0));
  place(light, p, ratio, random, false);
  if (at_light >= 0) {
    light.position = point_of(light, random);
    if (at_light == 1)
      light.position = light.position + to_float(random.sphere() * random.log_uniform(1e-9, 1e-2));
    if (at_light == 2 && light.polygon) // flush with it, a little beside
      light.position = light.position + f32::polygon_axis_u(light.polygon->view()) * 1.5f;
  }
  for (int i = random.integer(3); i > 0; --i)
    bend_surface(light, random);
  return light;
}

void set_lane(LightBatch& batch, int i, const LightCase& light) {
  const auto put = [&](Vec3f v, float(&to)[3][k_batch]) {
    to[0][i] = v.x;
    to[1][i] = v.y;
    to[2][i] = v.z;
  };
  batch.shape = light.shape;
  if (light.polygon) batch.polygon = light.polygon->view();
  put(light.position, batch.position);
  put(light.normal, batch.normal);
  put(light.wo, batch.wo);
  put(light.a, batch.a);
  put(light.b, batch.b);
  put(light.c, batch.c);
  batch.roughness[i] = light.roughness;
  batch.albedo[i] = light.albedo;
  batch.f0[i] = light.f0;
  batch.radius[i] = light.radius;
  batch.two_sided[i] = light.two_sided ? 1.0f : 0.0f;
}

CaseView view_of(const LightCase& light) {
  const f32::Frame frame = f32::shading_frame(light.normal, light.wo);
  const f32::FittedLobe fitted =
      f32::fetch_lobe(table::builtin_ggx_table().view(), f32::alpha_from_roughness(light.roughness),
                      dot(light.normal, light.wo));
  const f32::Lobe& l = fitted.lobe;
  return {to_double(light.position),
          {to_double(frame.t1), to_double(frame.t2), to_double(frame.n)},
          f64::make_lobe(double(l.m00), double(l.m02), double(l.m20), double(l.m22))};
}

CaseAnswer evaluate(const LightCase& light, EvaluateLights with) {
  LightBatch batch;
  for (int i = 0; i < k_batch; ++i)
    set_lane(batch, i, light);
  LightAnswers answers;
  with(batch, table::builtin_ggx_table().view(), &answers);
  const auto get = [](const float(&v)[3][k_batch]) { return Vec3f(v[0][0], v[1][0], v[2][0]); };
  return {answers.diffuse[0], answers.specular[0], get(answers.diffuse_direction),
          get(answers.specular_direction), get(answers.shaded)};
}

f64::LightIntegral evaluate_precise(const LightCase& light, const CaseView& view) {
  LightBatch batch;
  set_lane(batch, 0, light);
  return f64::batch_integral(batch, 0, view.position, view.frame, view.lobe);
}

LightCase elsewhere(const LightCase& light, bool adversarial, Random& random) {
  LightCase other = light;
  random_surface(other, random);
  const double distance = length(to_double(light.position) - to_double(point_of(light, random)));
  other.position = to_float(to_double(light.position) + random.sphere() * (0.5 * distance));
  if (!adversarial) return other;
  const int kind = random.integer(4);
  if (kind == 0) other.position = point_of(light, random);
  if (kind == 1)
    other.position =
        point_of(light, random) + to_float(random.sphere() * random.log_uniform(1e-9, 1e-2));
  if (kind == 2) other.position = light.position;
  for (int i = random.integer(3); i > 0; --i)
    bend_surface(other, random);
  return other;
}

std::vector<LightCase> fuzz_lights(LightShape shape, std::uint64_t seed) {
  Random random(seed * std::uint64_t(k_light_shapes) + std::uint64_t(shape));
  const bool adversarial = seed % 2 == 1;
  std::vector<LightCase> lights;
  for (int i = 0; i < k_batch; ++i) {
    if (i > 0 && is_polygon(shape))
      lights.push_back(elsewhere(lights[0], adversarial, random));
    else
      lights.push_back(adversarial ? adversarial_light(shape, random)
                                   : random_light(shape, random));
  }
  return lights;
}

} // namespace openltc::testing
