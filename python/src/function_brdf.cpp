// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "python/src/function_brdf.h"

#include "python/src/arrays.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace openltc::python {

namespace nb = nanobind;

namespace {

// As an array of the caller's to keep, N x 3.
nb::object array_of_directions(std::span<const Vec3d> directions) {
  static_assert(sizeof(Vec3d) == 3 * sizeof(double));
  const auto* numbers = reinterpret_cast<const double*>(directions.data());
  return nb::cast(array_of(std::vector<double>(numbers, numbers + 3 * directions.size()),
                           {directions.size(), 3}));
}

} // namespace

Callable::Callable(nb::object function) : function_(function.release().ptr()) {}

Callable::~Callable() {
  if (!function_) return;
  const nb::gil_scoped_acquire interpreter;
  Py_DECREF(function_);
}

void Callable::clear() { Py_CLEAR(function_); }

void Callable::call(Job& job, Vec3d wo, std::span<const Vec3d> wi, double roughness,
                    std::span<double> values) const {
  const bool done = function_ && job.call([&] {
    using Values = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
    const nb::object result = nb::handle(function_)(
        array_of_directions(std::vector<Vec3d>(wi.size(), wo)), array_of_directions(wi), roughness);
    const auto numbers = nb::cast<Values>(result);
    if (numbers.size() != values.size())
      throw std::length_error("the BRDF gave another number of values than of directions");
    std::copy_n(numbers.data(), values.size(), values.begin());
  });
  if (!done) throw std::runtime_error("the job was stopped"); // also where there is no function
}

brdf::Brdf brdf_of(const std::shared_ptr<Callable>& callable, Job* job, std::string name,
                   brdf::LobeWidth width, bool has_roughness) {
  brdf::Brdf brdf = brdf::brdf_from_batch(
      std::move(name),
      [callable, job](Vec3d wo, std::span<const Vec3d> wi, double roughness,
                      std::span<double> values) {
        if (!job) throw std::logic_error("there is no job to call the BRDF");
        callable->call(*job, wo, wi, roughness, values);
      },
      width);
  if (!has_roughness) brdf.parameter.clear();
  return brdf;
}

} // namespace openltc::python
