// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc.Fitted: lobes that were fitted, with their BRDF, so that their error can be measured when
// somebody asks for it.

#pragma once

#include "openltc/fit/fit_job.h"
#include "openltc/table/engine.h"
#include "python/src/function_brdf.h"

#include <memory>
#include <nanobind/nanobind.h>
#include <optional>
#include <string>

namespace openltc::python {

/// What a fit makes.
struct Fitted {
  brdf::Brdf brdf; ///< not to be called where `function` is there
  fit::FitRequest request;
  const table::Engine* engine = nullptr; ///< whose files it is for, or nullptr
  std::shared_ptr<Callable> function;    ///< the BRDF, or nullptr where it is the library's
  fit::FittedLobes lobes;
  std::optional<fit::Report> errors; ///< without lights and worst cells
  std::optional<fit::Report> report; ///< with all

  /// The BRDF as a job may call it. Each job has its own: several may be going on at once.
  brdf::Brdf brdf_in(Job& job) const {
    return function ? brdf_of(function, &job, brdf.name, brdf.width, brdf.has_parameter()) : brdf;
  }
  /// The same for work that does not ask the job whether to go on: the BRDF does.
  brdf::Brdf stopping_brdf_in(Job& job) const {
    brdf::Brdf own = brdf_in(job);
    if (!function)
      own.eval = [eval = brdf.eval, &job](Vec3d wo, Vec3d wi, double roughness) {
        job.stop_here();
        return eval(wo, wi, roughness);
      };
    return own;
  }
};

/// Adds the class and openltc.fit's lower half.
void bind_fit(nanobind::module_& m);

} // namespace openltc::python
