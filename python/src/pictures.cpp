// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/image/compare/flip_comparison.h"
#include "openltc/image/compare/metrics.h"
#include "openltc/image/display.h"
#include "openltc/image/file.h"
#include "openltc/plot/figures/error_figure.h"
#include "openltc/plot/figures/fit_figure.h"
#include "python/src/arrays.h"
#include "python/src/fitted.h"
#include "python/src/job.h"
#include "python/src/scene.h"

#include <algorithm>
#include <cmath>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace openltc::python {

namespace nb = nanobind;

namespace {

using PictureArray = nb::ndarray<const float, nb::ndim<3>, nb::c_contig, nb::device::cpu>;

image::Image picture_of(const PictureArray& array) {
  const auto is_side = [](std::size_t n) { return n > 0 && n <= std::size_t(image::k_max_side); };
  if (!is_side(array.shape(0)) || !is_side(array.shape(1)) || array.shape(2) == 0 ||
      array.shape(2) > 4)
    throw ToolError("a picture has 1 to 65,535 pixels a side and 1 to 4 channels");
  image::Image picture(int(array.shape(1)), int(array.shape(0)), int(array.shape(2)));
  std::copy_n(array.data(), picture.data.size(), picture.data.begin());
  return picture;
}

nb::tuple compare(PictureArray test, PictureArray reference, bool scene_linear,
                  std::optional<float> ev100, bool with_flip) {
  image::Image a, b;
  {
    const Outside others_may_run;
    a = picture_of(test);
    b = picture_of(reference);
  }
  if (a.width != b.width || a.height != b.height || a.channels != b.channels)
    throw ToolError("the pictures differ in size or channels");
  image::Metrics m;
  image::FlipComparison flip;
  Job job{nb::none()};
  job.run([&] {
    m = image::compare(a, b);
    if (!with_flip) return;
    image::FlipComparisonOptions options;
    options.scene_linear = scene_linear;
    options.ev100 = ev100;
    flip = image::compare_flip(a, b, options);
  });
  nb::dict all;
  all["mean_a"] = m.mean_a;
  all["mean_b"] = m.mean_b;
  all["bias"] = m.bias;
  all["mae"] = m.mae;
  all["mse"] = m.mse;
  all["rmse"] = m.rmse;
  all["relative_mse"] = m.relative_mse;
  all["mean_relative"] = m.mean_relative;
  all["psnr"] = m.psnr;
  all["max_abs"] = m.max_abs;
  all["max_abs_at"] = nb::make_tuple(m.max_abs_at.x, m.max_abs_at.y);
  all["max_relative"] = m.max_relative;
  all["max_relative_at"] = nb::make_tuple(m.max_relative_at.x, m.max_relative_at.y);
  all["pixel_count"] = m.pixel_count;
  all["non_finite_count"] = m.non_finite_count;
  if (!with_flip) return nb::make_tuple(all, nb::none());
  all["flip"] = flip.mean;
  all["flip_max"] = flip.max;
  return nb::make_tuple(all, array_of_picture(std::move(flip.map)));
}

void write(const std::string& path, PictureArray radiance, std::optional<PictureArray> error,
           std::optional<float> ev100, bool half) {
  const Outside others_may_run;
  const image::Image picture = picture_of(radiance);
  std::optional<image::Image> standard_error;
  if (error) standard_error = picture_of(*error);
  image::DisplayOptions display;
  display.ev100 = ev100;
  const float exposure = take(image::resolve_exposure(picture, display));
  take(image::write_picture(
      path, picture, standard_error ? &*standard_error : nullptr, exposure, display.tonemap,
      half ? image::ExrPrecision::half_float : image::ExrPrecision::full_float));
}

nb::object read(const std::string& path, const std::string& layer) {
  image::Image picture;
  {
    const Outside others_may_run;
    picture = take(image::read_layer(path, layer));
  }
  return array_of_picture(std::move(picture));
}

fit::MeasuredLobes measured(const Fitted& fitted) {
  return {fitted.brdf.name, fitted.lobes.lobes(), fitted.lobes.horizon};
}

std::string error_figure(Fitted& fitted, std::vector<std::string> norms) {
  plot::ErrorFigureOptions options;
  options.lobes = {measured(fitted)};
  if (!norms.empty()) options.norms = std::move(norms);
  options.command = fitted.request.command;
  Job job{nb::none()};
  options.brdf = fitted.stopping_brdf_in(job);
  std::string svg;
  job.run([&] { svg = to_svg(take(plot::make_error_figure(options)), draw::Theme::automatic); });
  return svg;
}

std::string fit_figure(Fitted& fitted, std::vector<double> theta_degrees,
                       std::vector<double> roughness) {
  plot::FitFigureOptions options;
  options.lobes = measured(fitted);
  if (!theta_degrees.empty()) options.theta_degrees = std::move(theta_degrees);
  if (!roughness.empty()) options.roughness = std::move(roughness);
  options.command = fitted.request.command;
  Job job{nb::none()};
  options.brdf = fitted.stopping_brdf_in(job);
  std::string svg;
  job.run([&] { svg = to_svg(take(plot::make_fit_figure(options)), draw::Theme::automatic); });
  return svg;
}

} // namespace

void bind_pictures(nb::module_& m) {
  m.def("compare", &compare, nb::arg("test"), nb::arg("reference"), nb::arg("scene_linear"),
        nb::arg("ev100").none(), nb::arg("with_flip"));
  m.def("write_picture", &write, nb::arg("path"), nb::arg("radiance"),
        nb::arg("standard_error").none(), nb::arg("ev100").none(), nb::arg("half"));
  m.def("read_picture", &read, nb::arg("path"), nb::arg("layer"));
  m.def("error_figure", &error_figure);
  m.def("fit_figure", &fit_figure);
}

} // namespace openltc::python
