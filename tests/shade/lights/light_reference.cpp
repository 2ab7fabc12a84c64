// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources: Lambert 1760 (the edge sum); Baum, Rushmeier, Winget 1989, equation 9, whose limit for a
// curved boundary is the contour integral used here; outlines of spheres and tubes from where the
// line of sight is tangent, (x - c) . x = 0 with the point at the origin.

#include "tests/shade/lights/light_reference.h"

#include "tests/shade/quadrature_1d.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace openltc::testing {

namespace {

// center + u t, or center + u cos t + v sin t; relative to the shading point, world space or, once
// transformed, shading space.
struct Piece {
  bool straight;
  Vec3d center, u, v;
  double from, to;

  Vec3d at(double t) const {
    return straight ? center + u * t : center + u * std::cos(t) + v * std::sin(t);
  }
  Vec3d derivative(double t) const { return straight ? u : v * std::cos(t) - u * std::sin(t); }
};

Piece segment(Vec3d a, Vec3d b) { return {true, a, b - a, Vec3d(0.0), 0, 1}; }
Piece arc(Vec3d center, Vec3d u, Vec3d v, double from, double to) {
  return {false, center, u, v, from, to};
}

// A closed boundary, and which of +y and -y of the shading frame it may hold: 1 or -1.
struct Outline {
  std::vector<Piece> pieces;
  double apex = 1;
};

// Both horizons; below either is outside.
struct Wedge {
  f64::Lobe lobe;
  bool surface;

  double surface_height(Vec3d x) const { return surface ? x.z : 1.0; }
  double cosine_height(Vec3d x) const { return lobe.m20 * x.x + lobe.m22 * x.z; }
  bool inside(Vec3d x) const { return surface_height(x) > 0 && cosine_height(x) > 0; }
};

// Where dot(normal, piece) = offset.
void add_roots(const Piece& p, Vec3d normal, double offset, std::vector<double>& roots) {
  const double a = dot(normal, p.center) - offset, b = dot(normal, p.u), c = dot(normal, p.v);
  if (p.straight) {
    if (b != 0) roots.push_back(-a / b);
    return;
  }
  const double r = std::hypot(b, c);
  if (!(std::abs(a) < r)) return;
  const double middle = std::atan2(c, b), half = std::acos(-a / r);
  for (const double t : {middle - half, middle + half})
    for (int turn = -2; turn <= 2; ++turn)
      roots.push_back(t + turn * 2 * f64::k_pi);
}

// The ends and the roots between them, ascending.
std::vector<double> breaks_of(const Piece& p, std::vector<double> roots) {
  std::vector<double> breaks = {p.from, p.to};
  for (const double t : roots)
    if (t > p.from && t < p.to) breaks.push_back(t);
  std::sort(breaks.begin(), breaks.end());
  return breaks;
}

std::vector<double> horizon_breaks(const Piece& p, const Wedge& wedge) {
  std::vector<double> roots;
  if (wedge.surface) add_roots(p, Vec3d(0, 0, 1), 0, roots);
  add_roots(p, Vec3d(wedge.lobe.m20, 0, wedge.lobe.m22), 0, roots);
  return breaks_of(p, std::move(roots));
}

// Angle times unit axis of the arc a to b.
Vec3d angle_term(Vec3d a, Vec3d b) {
  const Vec3d c = cross(a, b);
  const double sin_part = length(c);
  return sin_part > 0 ? c * (std::atan2(sin_part, dot(a, b)) / sin_part) : Vec3d(0.0);
}

// Integral of o x do / |o|^2 over part of an arc. Where the lobe is narrow the integrand is a peak
// at the smallest angle to the cosine's pole; intervals shrink towards it by halves.
Vec3d arc_term(const Piece& p, const f64::Lobe& lobe, double from, double to) {
  const auto f = [&](double t) {
    const Vec3d o = f64::to_cosine(lobe, p.at(t)), d = f64::to_cosine(lobe, p.derivative(t));
    return cross(o, d) / dot(o, o);
  };
  const auto away = [&](double t) {
    const Vec3d o = f64::to_cosine(lobe, p.at(t));
    return (o.x * o.x + o.y * o.y) / dot(o, o);
  };
  constexpr int samples = 24;
  std::array<double, samples + 1> height{};
  for (int i = 0; i <= samples; ++i)
    height[std::size_t(i)] = away(from + (to - from) * i / samples);
  std::vector<double> breaks = {from, to};
  for (int i = 0; i <= samples; ++i) {
    const auto k = std::size_t(i);
    if ((i > 0 && height[k - 1] < height[k]) || (i < samples && height[k + 1] < height[k]))
      continue;
    double low = from + (to - from) * std::max(i - 1, 0) / samples;
    double high = from + (to - from) * std::min(i + 1, samples) / samples;
    for (int step = 0; step < 45; ++step) { // golden section
      const double a = high - (high - low) * 0.6180339887498949, b = low + (high - a);
      (away(a) < away(b) ? high : low) = away(a) < away(b) ? b : a;
    }
    const double peak = 0.5 * (low + high);
    breaks.push_back(peak);
    for (double step = (to - from) / 4; step > (to - from) * 1e-5; step *= 0.25)
      for (const double t : {peak - step, peak + step})
        if (t > from && t < to) breaks.push_back(t);
  }
  std::sort(breaks.begin(), breaks.end());
  Vec3d sum(0.0);
  for (std::size_t i = 1; i < breaks.size(); ++i)
    if (breaks[i] > breaks[i - 1]) sum += integrate_adaptive(f, breaks[i - 1], breaks[i], 1e-12);
  return sum;
}

Vec3d outline_integral(const Outline& outline, const f64::Lobe& lobe, bool surface_horizon) {
  const Wedge wedge{lobe, surface_horizon};
  struct Interval {
    const Piece* piece;
    double from, to;
    bool inside;
  };
  std::vector<Interval> intervals;
  for (const Piece& p : outline.pieces) {
    const std::vector<double> breaks = horizon_breaks(p, wedge);
    for (std::size_t i = 1; i < breaks.size(); ++i)
      if (breaks[i] > breaks[i - 1])
        intervals.push_back(
            {&p, breaks[i - 1], breaks[i], wedge.inside(p.at(0.5 * (breaks[i - 1] + breaks[i])))});
  }
  Vec3d sum(0.0);
  const Vec3d apex(0, outline.apex, 0);
  const std::size_t count = intervals.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Interval& k = intervals[i];
    if (!k.inside) continue;
    const Vec3d a = f64::to_cosine(lobe, k.piece->at(k.from));
    const Vec3d b = f64::to_cosine(lobe, k.piece->at(k.to));
    sum += k.piece->straight ? angle_term(a, b) : arc_term(*k.piece, lobe, k.from, k.to);
    if (!intervals[(i + count - 1) % count].inside) sum = sum - angle_term(a, apex);
    if (!intervals[(i + 1) % count].inside) sum += angle_term(b, apex);
  }
  return sum / (2 * f64::k_pi);
}

// ---- what is seen of each shape, relative to the shading point, world space ----

double apex_of_plane(Vec3d normal, Vec3d point, Vec3d y) {
  return dot(normal, y) * dot(normal, point) < 0 ? -1 : 1;
}

void add_polygon(const LightCase& light, Vec3d position, Vec3d y, std::vector<Outline>& outlines) {
  const PolygonView& view = light.polygon->view();
  const Vec3d normal = f64::polygon_normal(view), origin = f64::polygon_origin(view) - position;
  if (dot(normal, origin) >= 0 && !light.two_sided) return;
  // Rings one by one: their closing arcs are sums, too.
  for (int i = 1; i < view.point_count; ++i) {
    if (f64::polygon_starts_ring(view, i - 1))
      outlines.push_back({{}, apex_of_plane(normal, origin, y)});
    if (f64::polygon_starts_ring(view, i)) continue;
    outlines.back().pieces.push_back(segment(f64::polygon_point(view, i - 1) - position,
                                             f64::polygon_point(view, i) - position));
  }
}

void add_ellipse(Vec3d center, Vec3d u, Vec3d v, bool two_sided, Vec3d y,
                 std::vector<Outline>& outlines) {
  const Vec3d normal = cross(u, v);
  if (dot(normal, center) >= 0 && !two_sided) return;
  outlines.push_back(
      {{arc(center, u, v, 0, f64::k_pi), arc(center, u, v, f64::k_pi, 2 * f64::k_pi)},
       apex_of_plane(normal, center, y)});
}

// The circle in which a sphere is touched, and the basis of it with `toward` in its first axis.
Piece tangent_circle(Vec3d center, double radius, Vec3d toward) {
  const double distance2 = dot(center, center), distance = std::sqrt(distance2);
  const Vec3d direction = center / distance;
  const Vec3d u = normalize(toward - direction * dot(toward, direction));
  const double k = std::max(1 - radius * radius / distance2, 0.0), r = radius * std::sqrt(k);
  return arc(center * k, u * r, cross(direction, u) * r, 0, 2 * f64::k_pi);
}

bool sphere_holds(Vec3d center, double radius, Vec3d direction) {
  const double along = dot(center, direction);
  return along > 0 && dot(center, center) - along * along < radius * radius;
}

void add_sphere(Vec3d center, double radius, Vec3d y, std::vector<Outline>& outlines) {
  if (length(center) <= radius || radius <= 0) return;
  const Vec3d side = std::abs(center.x) < std::abs(center.y) ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Piece circle = tangent_circle(center, radius, side);
  outlines.push_back({{circle}, sphere_holds(center, radius, y) ? 1.0 : -1.0});
}

struct TubeShape {
  Vec3d from, to, axis; // axis unit
  double length, radius;
  double rho;                    // distance of the point from the axis
  Vec3d radial;                  // unit, from the axis towards the point
  Vec3d side;                    // axis x radial
  double beyond_from, beyond_to; // how far the point lies beyond either end

  // Seen from outside the infinite tube: the angles between the lines of tangency.
  double half_angle() const { return std::acos(radius / rho); }
  Vec3d around(double phi) const {
    return radial * (radius * std::cos(phi)) + side * (radius * std::sin(phi));
  }
  // Whether a ray leaves through the lateral surface or one of the spheres.
  bool lateral_holds(Vec3d d) const {
    const Vec3d d_across = d - axis * dot(d, axis);
    const Vec3d o_across = radial * rho;
    const double a = dot(d_across, d_across), b = dot(o_across, d_across),
                 c = rho * rho - radius * radius;
    if (a == 0 || b * b - a * c <= 0) return false;
    const double t = (-b - std::sqrt(b * b - a * c)) / a;
    const double along = dot(d * t - from, axis);
    return t > 0 && along >= 0 && along <= length;
  }
};

TubeShape tube_shape(Vec3d from, Vec3d to, double radius) {
  TubeShape s;
  s.from = from;
  s.to = to;
  s.radius = radius;
  s.length = length(to - from);
  s.axis = (to - from) / s.length;
  s.beyond_from = dot(from, s.axis);
  s.beyond_to = -dot(to, s.axis);
  const Vec3d across = s.axis * dot(from, s.axis) - from;
  s.rho = length(across);
  const Vec3d other = std::abs(s.axis.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  s.radial = s.rho > 0 ? across / s.rho : normalize(cross(s.axis, other));
  s.side = cross(s.axis, s.radial);
  return s;
}

void add_lateral(const TubeShape& s, Vec3d y, std::vector<Outline>& outlines) {
  if (s.rho <= s.radius) return;
  const double beta = s.half_angle();
  const Vec3d u = s.radial * s.radius, v = s.side * s.radius;
  outlines.push_back(
      {{segment(s.from + s.around(-beta), s.to + s.around(-beta)), arc(s.to, u, v, -beta, beta),
        segment(s.to + s.around(beta), s.from + s.around(beta)),
        arc(s.from, u, v * -1.0, -beta, beta)},
       s.lateral_holds(y) ? 1.0 : -1.0});
}

// Half of the circle where the sphere at an end is touched: the part beyond the end. From the side
// -s.side to +s.side at sign 1, back at sign -1.
Piece cap_arc(const TubeShape& s, Vec3d center, Vec3d outward, double height, double sign) {
  Piece p = tangent_circle(center, s.radius, outward);
  p.v = s.side * (length(p.u) * sign);
  const double distance = length(center);
  const double r = length(p.u);
  const double half =
      std::acos(std::clamp(-height * s.radius * s.radius / (distance * r * s.rho), -1.0, 1.0));
  p.from = -half;
  p.to = half;
  return p;
}

void add_capsule(const TubeShape& s, Vec3d y, std::vector<Outline>& outlines) {
  if (s.rho <= s.radius) { // before an end: its sphere hides the rest
    if (s.beyond_from > 0) add_sphere(s.from, s.radius, y, outlines);
    if (s.beyond_to > 0) add_sphere(s.to, s.radius, y, outlines);
    return;
  }
  const double beta = s.half_angle();
  const bool holds =
      s.lateral_holds(y) || sphere_holds(s.from, s.radius, y) || sphere_holds(s.to, s.radius, y);
  outlines.push_back({{segment(s.from + s.around(-beta), s.to + s.around(-beta)),
                       cap_arc(s, s.to, s.axis, s.beyond_to, 1),
                       segment(s.to + s.around(beta), s.from + s.around(beta)),
                       cap_arc(s, s.from, -s.axis, s.beyond_from, -1)},
                      holds ? 1.0 : -1.0});
}

std::vector<Outline> outlines_of(const LightCase& light, const CaseView& view) {
  const Vec3d a = to_double(light.a) - view.position, b = to_double(light.b), y = view.frame.t2;
  const double radius = double(light.radius);
  std::vector<Outline> outlines;
  if (is_polygon(light.shape)) add_polygon(light, view.position, y, outlines);
  if (light.shape == LightShape::disk || light.shape == LightShape::ellipse)
    add_ellipse(a, b, to_double(light.c), light.two_sided, y, outlines);
  if (light.shape == LightShape::sphere) add_sphere(a, radius, y, outlines);
  if (light.shape == LightShape::tube_open || light.shape == LightShape::tube_flat ||
      light.shape == LightShape::capsule) {
    const TubeShape s = tube_shape(a, b - view.position, radius);
    if (light.shape == LightShape::capsule)
      add_capsule(s, y, outlines);
    else
      add_lateral(s, y, outlines);
    if (light.shape == LightShape::tube_flat) {
      const Vec3d u = s.radial * radius, v = s.side * radius;
      add_ellipse(s.from, v, u, false, y, outlines); // facing away from the axis
      add_ellipse(s.to, u, v, false, y, outlines);
    }
  }
  return outlines;
}

Piece to_shading(const f64::Frame& frame, Piece p) {
  p.center = f64::to_shading(frame, p.center);
  p.u = f64::to_shading(frame, p.u);
  p.v = f64::to_shading(frame, p.v);
  return p;
}

// Integral of D sin b / r^2 along the line, b the angle between the line and w, r = h / sin b the
// distance, h that of the line; sin b dl = r dphi, phi the angle at the point. Let psi be the same
// angle in cosine space. There o = |M^-1 w| u, and k = |M^-1 w x M^-1 w'| / |w x w'| is the same
// for all w, w' of the line's plane, so dpsi = k dphi / |M^-1 w|^2 and
//   D dphi / r = u_z det / (pi |M^-1 w|^3) dphi / r = u_z det |M u| sin b / (pi k h) dpsi,
// det |M u| sin b being the length of (adj M^-1 u) x (the line's direction).
Vec3d line_integral(const LightCase& light, const CaseView& view, const f64::Lobe& lobe,
                    bool surface_horizon) {
  const Piece p = to_shading(
      view.frame, segment(to_double(light.a) - view.position, to_double(light.b) - view.position));
  const Vec3d plane = cross(p.at(0), p.at(1));
  const double h = length(plane) / length(p.u);
  if (!(h > 0)) return Vec3d(0.0);
  const Wedge wedge{lobe, surface_horizon};
  const std::vector<double> breaks = horizon_breaks(p, wedge);
  Vec3d sum(0.0);
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    if (breaks[i - 1] == breaks[i] || !wedge.inside(p.at(0.5 * (breaks[i - 1] + breaks[i]))))
      continue;
    const Vec3d a = f64::to_cosine(lobe, p.at(breaks[i - 1]));
    const Vec3d b = f64::to_cosine(lobe, p.at(breaks[i]));
    const Vec3d e1 = normalize(a), e2 = normalize(b - e1 * dot(b, e1));
    const double angle = std::atan2(length(cross(a, b)), dot(a, b));
    if (!(angle > 0)) continue;
    const double k =
        length(cross(f64::to_cosine(lobe, p.at(0)), f64::to_cosine(lobe, p.at(1)))) / length(plane);
    const auto f = [&](double psi) {
      const Vec3d o = e1 * std::cos(psi) + e2 * std::sin(psi);
      const Vec3d m = f64::from_cosine(lobe, o);
      return o * (length(cross(m, p.u)) / (length(p.u) * f64::k_pi * k * h));
    };
    for (int part = 0; part < 8; ++part)
      sum += integrate_adaptive(f, angle * part / 8, angle * (part + 1) / 8, 1e-12);
  }
  return sum;
}

} // namespace

Vec3d contour_integral(const LightCase& light, const CaseView& view, const f64::Lobe& lobe,
                       bool surface_horizon) {
  if (light.shape == LightShape::line) return line_integral(light, view, lobe, surface_horizon);
  Vec3d sum(0.0);
  Vec3d rings(0.0);
  for (Outline& outline : outlines_of(light, view)) {
    for (Piece& p : outline.pieces)
      p = to_shading(view.frame, p);
    const Vec3d part = outline_integral(outline, lobe, surface_horizon);
    // Outlines run either way about what they bound; holes run against their polygon.
    if (is_polygon(light.shape))
      rings += part;
    else
      sum += part.z < 0 ? -part : part;
  }
  return sum + (rings.z < 0 ? -rings : rings);
}

} // namespace openltc::testing
