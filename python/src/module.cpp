// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// _openltc: what the package `openltc` is made of. Its functions check little and say less: the
// package around it is what users see.

#include "python/src/busy.h"
#include "python/src/fitted.h"
#include "python/src/points.h"
#include "python/src/scene.h"

#include <nanobind/nanobind.h>

NB_MODULE(_openltc, m) {
  // What a thread that is still there at the end holds is no fault, and not the user's concern.
  nanobind::set_leak_warnings(false);
  m.attr("__version__") = OPENLTC_VERSION;
  nanobind::exception<openltc::python::ToolError> error(m, "Error", PyExc_ValueError);
  error.attr("__doc__") =
      "What the tool would have said: which file, field or argument, and what to do.";
  openltc::python::wait_at_exit();
  openltc::python::bind_fit(m);
  openltc::python::bind_points(m);
  openltc::python::bind_scene_parts(m);
  openltc::python::bind_scene(m);
  openltc::python::bind_pictures(m);
}
