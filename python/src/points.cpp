// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "python/src/points.h"

#include "openltc/brdf/choose.h"
#include "openltc/c_api/handles.h"
#include "openltc/openltc_c.h"
#include "openltc/target/shade_f64.h"
#include "python/src/arrays.h"
#include "python/src/fitted.h"
#include "python/src/job.h"

#include <array>
#include <cmath>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace openltc::python {

namespace nb = nanobind;

namespace {

using Vector = std::array<float, 3>;
/// N x 3, or 1 x 3 for all points; any stride from one to the next.
using Vectors = nb::ndarray<const float, nb::shape<-1, 3>, nb::device::cpu>;
using Pairs = nb::ndarray<const float, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using Numbers = nb::ndarray<const float, nb::ndim<1>, nb::device::cpu>;
using Materials = nb::ndarray<const float, nb::shape<-1, 10>, nb::c_contig, nb::device::cpu>;
using Output3 = nb::ndarray<float, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using Doubles3 = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using Doubles = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

void check(openltc_status status) {
  if (status != OPENLTC_OK) throw ToolError(openltc_last_error());
}

struct LightList {
  openltc_lights* lights = nullptr;
  LightList() { check(openltc_lights_create(&lights)); }
  LightList(const LightList&) = delete;
  LightList& operator=(const LightList&) = delete;
  ~LightList() { openltc_lights_destroy(lights); }
};

struct LobeHandle {
  openltc_lobes* lobes = nullptr;
  LobeHandle() = default;
  LobeHandle(LobeHandle&& other) noexcept : lobes(std::exchange(other.lobes, nullptr)) {}
  LobeHandle& operator=(LobeHandle&&) = delete;
  ~LobeHandle() { openltc_lobes_destroy(lobes); }
};

LobeHandle built_in_lobes(int form) {
  LobeHandle made;
  check(openltc_lobes_create_built_in(form, &made.lobes));
  return made;
}

LobeHandle lobes_of_fit(const Fitted& fitted) {
  LobeHandle made;
  if (fitted.brdf.width != brdf::LobeWidth::alpha || !fitted.brdf.has_parameter())
    throw ToolError("surfaces are shaded with lobes that narrow with roughness: narrow=True, "
                    "has_roughness=True");
  if (const auto* p = std::get_if<table::LobePolynomial>(&fitted.lobes.stored)) {
    if (p->two_lobes()) throw ToolError("surfaces are not shaded with form two-lobe-polynomial");
    check(openltc_lobes_create_polynomial(p->coefficients.data(), std::size_t(p->degree),
                                          &made.lobes));
    return made;
  }
  const table::LobeTable& t = *fitted.lobes.nodes;
  if (t.angle_axis != table::AngleAxis::sqrt_one_minus_cos)
    throw ToolError("surfaces are shaded with lobes over sqrt(1 - cos theta): layout native");
  check(t.two_lobes() ? openltc_lobes_create_two_lobe_table(t.texels.data(), t.second.data(),
                                                            std::size_t(t.columns),
                                                            std::size_t(t.rows), &made.lobes)
                      : openltc_lobes_create_table(t.texels.data(), std::size_t(t.columns),
                                                   std::size_t(t.rows), &made.lobes));
  return made;
}

/// Points as the C API has them; the arrays are lent.
struct Points {
  Vectors positions, normals, views;
  Materials materials;
  std::optional<Vectors> geometric_normals;
  std::optional<Numbers> position_errors;

  std::size_t count() const {
    std::size_t most = positions.shape(0);
    for (const Vectors* v : {&normals, &views})
      most = std::max(most, v->shape(0));
    return most;
  }

  template <class Array>
  std::size_t stride(const Array& array, std::size_t floats, const char* name) const {
    if (array.shape(0) == 1) return OPENLTC_SAME;
    if (array.shape(0) != count())
      throw ToolError(std::string(name) + ": as many as there are points are wanted, or one");
    if (array.stride(0) < std::int64_t(floats))
      throw ToolError(std::string(name) + ": its strides are not supported; make a copy");
    return std::size_t(array.stride(0)) * sizeof(float);
  }

  openltc_points as_c() const {
    openltc_points p{};
    p.count = count();
    p.positions = {positions.data(), stride(positions, 3, "positions")};
    p.normals = {normals.data(), stride(normals, 3, "normals")};
    p.views = {views.data(), stride(views, 3, "views")};
    p.materials = {reinterpret_cast<const openltc_material*>(materials.data()),
                   stride(materials, 10, "material")};
    if (geometric_normals)
      p.geometric_normals = {geometric_normals->data(),
                             stride(*geometric_normals, 3, "geometric_normals")};
    if (position_errors)
      p.position_errors = {position_errors->data(), stride(*position_errors, 1, "position_errors")};
    return p;
  }
};

Points points_of(Vectors positions, Vectors normals, Vectors views, Materials materials,
                 std::optional<Vectors> geometric, std::optional<Numbers> errors) {
  return {positions, normals, views, materials, geometric, errors};
}

void shade(const LobeHandle& lobes, const LightList& lights, const Points& points, int threads,
           Output3 radiance) {
  const openltc_points p = points.as_c();
  if (radiance.shape(0) != p.count) throw ToolError("out has another number of points");
  float* out = radiance.data();
  const Outside others_may_run;
  check(openltc_shade(lobes.lobes, lights.lights, &p, threads, out));
}

void shade_parts(const LobeHandle& lobes, const LightList& lights, const Points& points,
                 int threads, Output3 diffuse, Output3 specular) {
  const openltc_points p = points.as_c();
  if (diffuse.shape(0) != p.count || specular.shape(0) != p.count)
    throw ToolError("out has another number of points");
  float *a = diffuse.data(), *b = specular.data();
  const Outside others_may_run;
  check(openltc_shade_parts(lobes.lobes, lights.lights, &p, threads, a, b));
}

nb::tuple eval_surface(const LobeHandle& lobes, const Points& points, Vectors directions) {
  const openltc_points p = points.as_c();
  if (directions.shape(0) != p.count || (p.count > 1 && directions.stride(0) != 3))
    throw ToolError("directions: as many as there are points are wanted");
  std::vector<float> values(3 * p.count), pdfs(p.count);
  const float* w = directions.data();
  {
    const Outside others_may_run;
    check(openltc_eval_surface(lobes.lobes, &p, 0, w, values.data(), pdfs.data()));
  }
  return nb::make_tuple(array_of(std::move(values), {p.count, 3}),
                        array_of(std::move(pdfs), {p.count}));
}

/// N x 8: direction, value, pdf, valid.
nb::object sample_surface(const LobeHandle& lobes, const Points& points, Pairs u) {
  static_assert(sizeof(openltc_direction_sample) == 8 * sizeof(float));
  const openltc_points p = points.as_c();
  if (u.shape(0) != p.count) throw ToolError("u: a pair for each point is wanted");
  std::vector<float> numbers(8 * p.count);
  {
    std::vector<openltc_direction_sample> samples(p.count);
    const Outside others_may_run;
    check(openltc_sample_surface(lobes.lobes, &p, 0, u.data(), samples.data()));
    for (std::size_t i = 0; i < p.count; ++i) {
      const openltc_direction_sample& s = samples[i];
      float* to = numbers.data() + 8 * i;
      for (int k = 0; k < 3; ++k) {
        to[k] = s.direction[k];
        to[3 + k] = s.value[k];
      }
      to[6] = s.pdf;
      to[7] = float(s.valid);
    }
  }
  return nb::cast(array_of(std::move(numbers), {p.count, 8}));
}

/// f cos of a BRDF that the library has: N values for F = 1, and N of the part with (1 - wo.h)^5.
nb::tuple eval_brdf(const std::string& name, Doubles3 wo, Doubles3 wi, Doubles roughness) {
  const brdf::Brdf brdf = take(brdf::choose_brdf(name));
  const std::size_t count = wi.shape(0);
  if (wo.shape(0) != count || roughness.shape(0) != count)
    throw ToolError("wo, wi and roughness differ in length");
  std::vector<double> scale(count), bias(count);
  const double *o = wo.data(), *i = wi.data(), *r = roughness.data();
  {
    const Outside others_may_run;
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3d to_viewer(o[3 * k], o[3 * k + 1], o[3 * k + 2]);
      const Vec3d to_light(i[3 * k], i[3 * k + 1], i[3 * k + 2]);
      if (!(to_viewer.z > 0 && to_light.z > 0 && r[k] >= 0 && r[k] <= 1)) continue;
      const brdf::BrdfValue value = brdf.eval(to_viewer, to_light, r[k]);
      scale[k] = std::isfinite(value.scale) ? value.scale : 0;
      bias[k] = std::isfinite(value.bias) ? value.bias : 0;
    }
  }
  return nb::make_tuple(array_of(std::move(scale), {count}), array_of(std::move(bias), {count}));
}

/// What shading reads at each roughness and cosine: M^-1, n1, n5, of the second lobe M^-1 and its
/// share.
nb::tuple lobes_at(const LobeHandle& lobes, Doubles roughness, Doubles cos_theta) {
  const std::size_t count = roughness.shape(0);
  if (cos_theta.shape(0) != count) throw ToolError("roughness and cos_theta differ in length");
  std::vector<double> first(9 * count), second(9 * count), amplitudes(3 * count);
  const auto put = [](double* to, const f32::Lobe& lobe) {
    const double rows[9] = {lobe.m00, 0, lobe.m02, 0, 1, 0, lobe.m20, 0, lobe.m22};
    std::copy(std::begin(rows), std::end(rows), to);
  };
  const double *roughnesses = roughness.data(), *cosines = cos_theta.data();
  auto others_may_run = std::make_optional<Outside>();
  for (std::size_t k = 0; k < count; ++k) {
    const auto r = float(roughnesses[k]), c = float(cosines[k]);
    if (!(r >= 0 && r <= 1 && c >= 0 && c <= 1))
      throw ToolError("roughness and cos_theta lie within 0 and 1");
    const f32::FittedLobe at = detail::find_lobe(lobes.lobes->view, r, c);
    put(first.data() + 9 * k, at.lobe);
    amplitudes[3 * k] = at.n1;
    amplitudes[3 * k + 1] = at.n5;
    if (detail::has_second_lobe(lobes.lobes->view)) {
      const f32::SecondLobe beside = detail::find_second_lobe(lobes.lobes->view, r, c);
      put(second.data() + 9 * k, beside.lobe);
      amplitudes[3 * k + 2] = beside.weight;
    } else {
      put(second.data() + 9 * k, f32::cosine_lobe());
    }
  }
  others_may_run.reset();
  return nb::make_tuple(array_of(std::move(first), {count, 3, 3}),
                        array_of(std::move(second), {count, 3, 3}),
                        array_of(std::move(amplitudes), {count, 3}));
}

void bind_lights(nb::module_& m) {
  nb::class_<LightList>(m, "LightList")
      .def(nb::init<>())
      .def("__len__", [](const LightList& l) { return openltc_lights_count(l.lights); })
      .def("polygon",
           [](LightList& l, std::vector<Vector> vertices, std::vector<std::size_t> ring_ends,
              bool two_sided, Vector radiance) {
             check(openltc_lights_add_polygon(
                 l.lights, vertices.empty() ? nullptr : vertices[0].data(), vertices.size(),
                 ring_ends.data(), ring_ends.size(), two_sided, radiance.data()));
           })
      .def("ellipse",
           [](LightList& l, Vector center, Vector half_u, Vector half_v, bool two_sided,
              Vector radiance) {
             check(openltc_lights_add_ellipse(l.lights, center.data(), half_u.data(), half_v.data(),
                                              two_sided, radiance.data()));
           })
      .def("rectangle",
           [](LightList& l, Vector center, Vector half_u, Vector half_v, bool two_sided,
              Vector radiance) {
             check(openltc_lights_add_rectangle(l.lights, center.data(), half_u.data(),
                                                half_v.data(), two_sided, radiance.data()));
           })
      .def("disk",
           [](LightList& l, Vector center, Vector normal, float radius, bool two_sided,
              Vector radiance) {
             check(openltc_lights_add_disk(l.lights, center.data(), normal.data(), radius,
                                           two_sided, radiance.data()));
           })
      .def("sphere",
           [](LightList& l, Vector center, float radius, Vector radiance) {
             check(openltc_lights_add_sphere(l.lights, center.data(), radius, radiance.data()));
           })
      .def("tube",
           [](LightList& l, Vector from, Vector to, float radius, int caps, Vector radiance) {
             check(openltc_lights_add_tube(l.lights, from.data(), to.data(), radius, caps,
                                           radiance.data()));
           })
      .def("line",
           [](LightList& l, Vector from, Vector to, Vector intensity_per_metre) {
             check(openltc_lights_add_line(l.lights, from.data(), to.data(),
                                           intensity_per_metre.data()));
           })
      .def("point",
           [](LightList& l, Vector position, Vector intensity, float range) {
             check(openltc_lights_add_point(l.lights, position.data(), intensity.data(), range));
           })
      .def("spot",
           [](LightList& l, Vector position, Vector direction, Vector intensity, float range,
              float inner, float outer) {
             check(openltc_lights_add_spot(l.lights, position.data(), direction.data(),
                                           intensity.data(), range, inner, outer));
           })
      .def("directional", [](LightList& l, Vector direction, Vector illuminance) {
        check(openltc_lights_add_directional(l.lights, direction.data(), illuminance.data()));
      });
}

} // namespace

void bind_points(nb::module_& m) {
  bind_lights(m);
  nb::class_<LobeHandle>(m, "Lobes").def("at", &lobes_at);
  m.def("built_in_lobes", &built_in_lobes);
  m.def("lobes_of_fit", &lobes_of_fit);
  nb::class_<Points>(m, "Points");
  m.def("points", &points_of, nb::arg("positions"), nb::arg("normals"), nb::arg("views"),
        nb::arg("materials"), nb::arg("geometric_normals").none(),
        nb::arg("position_errors").none());
  m.def("shade", &shade, nb::arg("lobes"), nb::arg("lights"), nb::arg("points"), nb::arg("threads"),
        nb::arg("radiance").noconvert());
  m.def("shade_parts", &shade_parts, nb::arg("lobes"), nb::arg("lights"), nb::arg("points"),
        nb::arg("threads"), nb::arg("diffuse").noconvert(), nb::arg("specular").noconvert());
  m.def("eval_surface", &eval_surface);
  m.def("sample_surface", &sample_surface);
  m.def("eval_brdf", &eval_brdf);
}

} // namespace openltc::python
