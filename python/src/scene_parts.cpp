// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Fields by other names than the library's where a unit was missing in them.

#include "openltc/light/light.h"
#include "python/src/scene.h"
#include "python/src/vectors.h"

#include <fmt/format.h>

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace openltc::python {

namespace nb = nanobind;

namespace {

// Sets a field. In place of nanobind's words on arguments of functions: which field, and what it
// takes.
int set_field(PyObject* self, PyObject* name, PyObject* value) {
  const int code = PyObject_GenericSetAttr(self, name, value);
  if (code == 0 || value == nullptr || PyErr_ExceptionMatches(PyExc_TypeError) == 0) return code;
  PyErr_Clear();
  try {
    const nb::handle object(self), field(name), given(value);
    const nb::object now = nb::getattr(object, field);
    PyErr_SetString(PyExc_TypeError,
                    fmt::format("{}={:.80}: a {} is wanted, as {:.80} is", nb::str(field).c_str(),
                                nb::repr(given).c_str(), nb::type_name(now.type()).c_str(),
                                nb::repr(now).c_str())
                        .c_str());
  } catch (nb::python_error& error) { // of a __repr__
    error.restore();
  }
  return code;
}

const PyType_Slot k_fields[] = {{Py_tp_setattro, reinterpret_cast<void*>(set_field)}, {0, nullptr}};

void bind_area_lights(nb::module_& m) {
  using namespace light;
  nb::class_<Emitter>(m, "Emitter", nb::type_slots(k_fields),
                      "What lights with an extent have: radiance in nits along the normal, times "
                      "cos(t)^cosine_power at the angle t.")
      .def_rw("name", &Emitter::name)
      .def_rw("radiance_nits", &Emitter::radiance)
      .def_rw("cosine_power", &Emitter::cosine_power)
      .def_rw("two_sided", &Emitter::two_sided)
      .def_prop_ro("has_texture", [](const Emitter& e) { return e.texture >= 0; });
  nb::class_<PolygonLight, Emitter>(m, "PolygonLight",
                                    "A planar outline, or several: ring_ends are one past the last "
                                    "vertex of each; holes run clockwise.")
      .def(nb::init<>())
      .def_rw("vertices", &PolygonLight::vertices)
      .def_rw("ring_ends", &PolygonLight::ring_end)
      .def_rw("normal", &PolygonLight::normal);
  nb::class_<EllipseLight, Emitter>(
      m, "EllipseLight", "A flat ellipse or disk of a scene; emits along half_u x half_v.")
      .def(nb::init<>())
      .def_rw("center", &EllipseLight::center)
      .def_rw("half_u", &EllipseLight::half_u)
      .def_rw("half_v", &EllipseLight::half_v);
  nb::class_<SphereLight, Emitter>(m, "SphereLight", "A sphere of a scene.")
      .def(nb::init<>())
      .def_rw("center", &SphereLight::center)
      .def_rw("radius_metres", &SphereLight::radius);
  nb::class_<TubeLight, Emitter>(m, "TubeLight",
                                 "A round tube of a scene; caps: 0 none, 1 flat, 2 round.")
      .def(nb::init<>())
      .def_rw("start", &TubeLight::from)
      .def_rw("end", &TubeLight::to)
      .def_rw("radius_metres", &TubeLight::radius)
      .def_prop_rw(
          "caps", [](const TubeLight& t) { return int(t.caps); },
          [](TubeLight& t, int caps) {
            if (caps < 0 || caps > 2) throw nb::value_error("caps: 0 none, 1 flat, 2 round");
            t.caps = TubeCaps(caps);
          });
  nb::class_<LineLight, Emitter>(m, "LineLight",
                                 "A tube without a width of a scene, in candela per metre.")
      .def(nb::init<>())
      .def_rw("start", &LineLight::from)
      .def_rw("end", &LineLight::to)
      .def_rw("intensity_candela_per_metre", &LineLight::intensity_per_metre);
}

void bind_punctual(nb::module_& m) {
  using light::PunctualLight;
  nb::class_<PunctualLight>(m, "PunctualLight", nb::type_slots(k_fields),
                            "A point, spot or directional light of a scene, in candela or lux.")
      .def(nb::init<>())
      .def_rw("name", &PunctualLight::name)
      .def_prop_rw(
          "type",
          [](const PunctualLight& p) {
            constexpr const char* k_names[] = {"point", "spot", "directional"};
            return k_names[int(p.type)];
          },
          [](PunctualLight& p, const std::string& name) {
            if (name == "point")
              p.type = light::PunctualType::point;
            else if (name == "spot")
              p.type = light::PunctualType::spot;
            else if (name == "directional")
              p.type = light::PunctualType::directional;
            else
              throw nb::value_error("type: choose point, spot or directional");
          })
      .def_rw("position", &PunctualLight::position)
      .def_rw("direction", &PunctualLight::direction)
      .def_rw("intensity_candela_or_lux", &PunctualLight::intensity)
      .def_rw("range_metres", &PunctualLight::range)
      .def_rw("cos_inner", &PunctualLight::cos_inner)
      .def_rw("cos_outer", &PunctualLight::cos_outer)
      .def_prop_ro("has_profile", [](const PunctualLight& p) { return p.profile != nullptr; });
}

} // namespace

void bind_scene_parts(nb::module_& m) {
  bind_area_lights(m);
  bind_punctual(m);
  using scene::Camera, scene::Material;
  nb::class_<Camera>(m, "Camera", nb::type_slots(k_fields),
                     "Looks along `forward`; right, up, forward are orthonormal, world space; "
                     "fov_y_rad is the full vertical angle.")
      .def(nb::init<>())
      .def_rw("name", &Camera::name)
      .def_prop_rw(
          "orthographic",
          [](const Camera& c) { return c.projection != scene::Projection::perspective; },
          [](Camera& c, bool flat) {
            c.projection = flat ? scene::Projection::orthographic : scene::Projection::perspective;
          })
      .def_rw("position", &Camera::position)
      .def_rw("right", &Camera::right)
      .def_rw("up", &Camera::up)
      .def_rw("forward", &Camera::forward)
      .def_rw("fov_y_rad", &Camera::fov_y_rad)
      .def_rw("height_metres", &Camera::height)
      .def_rw("aspect", &Camera::aspect)
      .def_rw("near_metres", &Camera::near)
      .def_rw("far_metres", &Camera::far);
  nb::class_<Material>(
      m, "SceneMaterial", nb::type_slots(k_fields),
      "A material of a scene: glTF metallic-roughness; textures of the file multiply these.")
      .def_rw("name", &Material::name)
      .def_rw("base_color", &Material::base_color)
      .def_rw("metallic", &Material::metallic)
      .def_rw("roughness", &Material::roughness)
      .def_rw("normal_scale", &Material::normal_scale)
      .def_rw("emission_nits", &Material::emission)
      .def_rw("specular", &Material::specular)
      .def_rw("specular_color", &Material::specular_color)
      .def_rw("ior", &Material::ior)
      .def_rw("alpha_cutoff", &Material::alpha_cutoff)
      .def_rw("double_sided", &Material::double_sided)
      .def_rw("unlit", &Material::unlit);
}

} // namespace openltc::python
