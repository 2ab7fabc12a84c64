// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// A BRDF that is a function of the caller's over arrays.

#pragma once

#include "openltc/brdf/brdf.h"
#include "python/src/job.h"

#include <memory>
#include <nanobind/nanobind.h>
#include <string>

namespace openltc::python {

/// A function of Python that fitting calls. Owned by those who hold the BRDF, on any thread.
class Callable {
public:
  explicit Callable(nanobind::object function);
  ~Callable();

  /// f of wo and each wi, by the thread that runs `job`. Throws std::runtime_error when the job is
  /// being stopped.
  void call(Job& job, Vec3d wo, std::span<const Vec3d> wi, double roughness,
            std::span<double> values) const;

  /// For Python's collector of cycles: the function, and to let it go.
  PyObject* function() const { return function_; }
  void clear();

private:
  PyObject* function_; ///< null once it has been let go
};

/// A BRDF of it, which can be called while `job` runs; without one it only says what it is.
brdf::Brdf brdf_of(const std::shared_ptr<Callable>& callable, Job* job, std::string name,
                   brdf::LobeWidth width, bool has_roughness);

} // namespace openltc::python
