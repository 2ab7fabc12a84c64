// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// openltc compare A B: how far picture A is from its reference B.

#include "cli/commands.h"
#include "cli/compare_input.h"
#include "cli/convert/picture.h"
#include "cli/options/pose_options.h"
#include "cli/options/reading_options.h"
#include "cli/output_place.h"
#include "cli/process/message.h"
#include "cli/process/standard_streams.h"
#include "openltc/image/compare/difference.h"
#include "openltc/image/compare/flip_comparison.h"
#include "openltc/image/compare/metrics.h"
#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"
#include "openltc/render/error_by_surface.h"
#include "openltc/render/view/camera_choice.h"
#include "openltc/scene/gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace openltc::cli {

namespace {

using image::Image;

constexpr const char* k_footer =
    R"(B is the reference: relative errors are divided by its values, PSNR uses its peak.
Pictures: .exr and .hdr hold scene-linear radiance; .png and .jpg are decoded from sRGB to linear
light first. Alpha is ignored. A pixel with NaN or infinity in A or B is counted and left out.
Of an .exr it is the picture without a name, or the only one of colour; others by --layer NAME or
FILE:NAME. Luminance with chroma, CIE XYZ and other primaries are compared as Rec.709. What lies
outside the data window is black. Vectors and single channels are compared as numbers, without FLIP.

What the numbers mean
  mean relative   mean of |A-B| / (|B| + eps): "off by so many percent"
  relative MSE    mean of (A-B)^2 / (B^2 + eps^2)
                  eps is 1 % of the mean of |B|, so no number depends on the unit of radiance
  RMSE, MAE       root of the mean square, mean absolute difference, in the picture's unit
  PSNR            10 log10(peak^2 / MSE) in dB, peak = the largest value of B
  FLIP            what an eye sees when flipping between the two: 0 equal, 1 as different as can be
                  (LDR-FLIP for .png and .jpg; HDR-FLIP over all exposures for .exr and .hdr, or
                  LDR-FLIP of the displayed pictures if --exposure is given)

Examples
  openltc compare ltc.exr reference.exr
  openltc compare ltc.exr reference.exr --diff difference.png
  openltc compare ltc.exr reference.exr --scene scene.glb     where the error lies, by surface
  openltc compare a.png b.png --metric flip --diff flip.png --json
  openltc compare blender.exr:ViewLayer.Combined truth.exr

Exit code 0: compared (whatever the difference); 1: a file cannot be read or written, or the sizes
or kinds differ; 2: wrong usage.)";

struct Options {
  std::string a, b, layer, diff, mask, scene, camera;
  std::string metric = "relative";
  std::string exposure;
  float pixels_per_degree = image::FlipOptions{}.pixels_per_degree;
  float scale = 0.0f;
  scene::ReadOptions reading;
  bool json = false;
};

// FLIP's filters reach over a fifth of a degree; the sharpest eye sees 120 pixels in one.
constexpr float k_least_ppd = 1.0f, k_most_ppd = 1000.0f;

std::optional<float> parse_number(const std::string& text) {
  float value = 0.0f;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = result.ec == std::errc() && result.ptr == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string check_positive(const std::string& text) {
  const auto value = parse_number(text);
  return value && *value > 0.0f ? "" : "must be a positive number, not '" + text + "'";
}

std::string check_ppd(const std::string& text) {
  const auto value = parse_number(text);
  if (value && *value >= k_least_ppd && *value <= k_most_ppd) return "";
  return fmt::format("must be a number from {} to {}, not '{}'", k_least_ppd, k_most_ppd, text);
}

std::string check_png(const std::string& text) {
  std::string end = text.size() >= 4 ? text.substr(text.size() - 4) : "";
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return end == ".png" ? "" : "the difference picture must be named .png, not '" + text + "'";
}

/// What the user is told of FLIP.
struct Flip {
  image::FlipComparison result;
  std::string kind; ///< empty where the numbers are no colours, so that there is none
  nlohmann::ordered_json details;
};

/// `hdr`: both hold scene-linear radiance.
Flip compute_flip(const Options& options, bool hdr, const Image& a, const Image& b,
                  const std::vector<std::uint8_t>& mask) {
  image::FlipComparisonOptions flip_options;
  flip_options.flip.pixels_per_degree = options.pixels_per_degree;
  flip_options.scene_linear = hdr;
  flip_options.auto_exposure = options.exposure == "auto";
  flip_options.ev100 = parse_number(options.exposure);
  flip_options.mask = mask;
  Flip flip;
  flip.result = image::compare_flip(a, b, flip_options);
  const image::FlipComparison& f = flip.result;
  flip.details["pixels_per_degree"] = options.pixels_per_degree;
  if (f.is_hdr) {
    flip.kind = fmt::format("HDR-FLIP, {} exposures from {:+.2f} to {:+.2f} stops",
                            f.exposure_count, f.start_exposure, f.stop_exposure);
    flip.details["kind"] = "hdr";
    flip.details["exposures"] = f.exposure_count;
    flip.details["start_exposure_stops"] = f.start_exposure;
    flip.details["stop_exposure_stops"] = f.stop_exposure;
    return flip;
  }
  flip.kind = "LDR-FLIP";
  flip.details["kind"] = "ldr";
  if (f.ev100) {
    flip.kind += fmt::format(" at EV100 {:.2f}, tone map neutral", *f.ev100);
    flip.details["ev100"] = *f.ev100;
    flip.details["tonemap"] = "neutral";
  }
  return flip;
}

Image make_difference_picture(const Options& options, const Image& a, const Image& b,
                              const image::Metrics& metrics, const Flip& flip,
                              const std::vector<std::uint8_t>& mask) {
  image::DifferencePictureOptions picture;
  picture.mask = mask;
  picture.scale_max = options.scale;
  const auto file_name = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  const std::string names =
      fmt::format("{} against {}", file_name(options.a), file_name(options.b));
  const std::string legend = metrics.non_finite_count > 0 ? "; green: NaN or infinity" : "";
  if (options.metric == "flip") {
    if (picture.scale_max <= 0.0f) picture.scale_max = 1.0f;
    picture.title = flip.kind;
    picture.caption = fmt::format("{}: mean {:.4f}{}", names, flip.result.mean, legend);
    return image::difference_picture(flip.result.map, picture);
  }
  if (options.metric == "absolute") {
    picture.title = "absolute difference |A-B|";
    picture.caption = fmt::format("{}: mean {:.4g}{}", names, metrics.mae, legend);
    return image::difference_picture(
        image::difference_map(a, b, image::DifferenceKind::absolute, metrics.eps), picture);
  }
  picture.percent = true;
  picture.is_signed = options.metric == "signed";
  picture.caption = fmt::format("{}: mean {}{:.3g}%{}", names, picture.is_signed ? "size " : "",
                                100.0 * metrics.mean_relative, legend);
  picture.title = fmt::format(
      "{} / (|B| + {:.3g})",
      picture.is_signed ? "signed difference (A-B)" : "relative difference |A-B|", metrics.eps);
  if (picture.is_signed) picture.colormap = image::Colormap::blue_red;
  const auto kind =
      picture.is_signed ? image::DifferenceKind::signed_relative : image::DifferenceKind::relative;
  return image::difference_picture(image::difference_map(a, b, kind, metrics.eps), picture);
}

void print_json(const Options& options, const ComparedPicture& picture_a,
                const ComparedPicture& picture_b, const image::Metrics& m, const Flip& flip,
                const std::vector<render::SurfaceError>& surfaces) {
  const auto place = [](image::PixelPlace p) { return nlohmann::ordered_json::array({p.x, p.y}); };
  nlohmann::ordered_json out;
  out["image"] = picture_a.name;
  out["reference"] = picture_b.name;
  out["width"] = picture_a.picture.image.width;
  out["height"] = picture_a.picture.image.height;
  out["pixels_compared"] = m.pixel_count;
  out["pixels_masked"] = m.masked_count;
  out["pixels_not_finite"] = m.non_finite_count;
  out["pixels_not_finite_in_image"] = m.non_finite_a;
  out["pixels_not_finite_in_reference"] = m.non_finite_b;
  out["mean_image"] = m.mean_a;
  out["mean_reference"] = m.mean_b;
  out["bias"] = m.bias;
  out["mae"] = m.mae;
  out["rmse"] = m.rmse;
  out["psnr_db"] = m.psnr; // null if infinite, that is, if the pictures are equal
  out["psnr_peak"] = m.psnr_peak;
  out["relative_epsilon"] = m.eps;
  out["relative_mse"] = m.relative_mse;
  out["mean_relative_error"] = m.mean_relative;
  out["max_relative_error"] = m.max_relative;
  out["max_relative_error_at"] = place(m.max_relative_at);
  out["max_absolute_difference"] = m.max_abs;
  out["max_absolute_difference_at"] = place(m.max_abs_at);
  out["flip"] = nullptr;
  if (!flip.kind.empty()) {
    out["flip"] = {{"mean", flip.result.mean},
                   {"max", flip.result.max},
                   {"max_at", place(flip.result.max_at)}};
    out["flip"].update(flip.details);
  }
  if (!options.diff.empty()) out["difference_picture"] = options.diff;
  for (const render::SurfaceError& e : surfaces)
    out["by_surface"].push_back({{"surface", e.surface},
                                 {"pixels", e.pixels},
                                 {"mean_relative_error", e.mean_relative},
                                 {"max_relative_error", e.max_relative},
                                 {"max_relative_error_at", {e.max_x, e.max_y}},
                                 {"share", e.share}});
  // A path may hold any bytes; they must not break the output.
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  put("{}\n", out.dump(2, ' ', false, replace));
}

void print_table(const Options& options, const ComparedPicture& picture_a,
                 const ComparedPicture& picture_b, const image::Metrics& m, const Flip& flip,
                 const std::vector<render::SurfaceError>& surfaces) {
  put("image        {}\nreference    {}\n", picture_a.name, picture_b.name);
  put("size         {}x{}, {} pixels compared", picture_a.picture.image.width,
      picture_a.picture.image.height, m.pixel_count);
  if (m.masked_count > 0) put(", {} masked", m.masked_count);
  if (m.non_finite_count > 0)
    put(", {} with NaN or infinity left out (image {}, reference {})", m.non_finite_count,
        m.non_finite_a, m.non_finite_b);
  put("\n\n");
  const auto row = [](const char* name, const std::string& value, const std::string& note) {
    put("{}\n", note.empty() ? fmt::format("{:<16}{:>12}", name, value)
                             : fmt::format("{:<16}{:>12}   {}", name, value, note));
  };
  const auto number = [](double v) { return fmt::format("{:.5g}", v); };
  const auto percent = [](double v) { return fmt::format("{:.4g} %", 100.0 * v); };
  const auto at = [](image::PixelPlace p) { return fmt::format("at pixel ({}, {})", p.x, p.y); };
  row("mean relative", percent(m.mean_relative), fmt::format("|A-B| / (|B| + {:.3g})", m.eps));
  row("max relative", percent(m.max_relative), at(m.max_relative_at));
  row("relative MSE", number(m.relative_mse), "");
  row("RMSE", number(m.rmse), "");
  row("MAE", number(m.mae), "");
  row("bias", number(m.bias), fmt::format("mean of A {:.5g}, of B {:.5g}", m.mean_a, m.mean_b));
  row("max absolute", number(m.max_abs), at(m.max_abs_at));
  row("PSNR", std::isinf(m.psnr) ? "equal" : fmt::format("{:.2f} dB", m.psnr),
      fmt::format("peak {:.5g}", m.psnr_peak));
  if (!flip.kind.empty()) {
    row("FLIP mean", number(flip.result.mean), flip.kind);
    row("FLIP max", number(flip.result.max), at(flip.result.max_at));
  }
  if (!surfaces.empty())
    put("\nwhere the error lies                   pixels      mean   largest              share\n");
  for (const render::SurfaceError& e : surfaces)
    put("{:<38}{:>7} {:>7.2f} % {:>7.1f} % {:>12} {:>5.1f} %\n", e.surface, e.pixels,
        100 * e.mean_relative, 100 * e.max_relative, fmt::format("({}, {})", e.max_x, e.max_y),
        100 * e.share);
  if (!options.diff.empty()) put("\ndifference   {}\n", options.diff);
}

/// The error by surface when --scene is given, else nothing.
Result<std::vector<render::SurfaceError>> surface_errors(const Options& options, const Image& a,
                                                         const Image& b, double eps) {
  if (options.scene.empty()) return std::vector<render::SurfaceError>();
  Result<scene::Scene> scene = scene::load_gltf(options.scene, {}, options.reading);
  if (!scene) return scene.error();
  Result<scene::Camera> camera =
      render::choose_camera(*scene, options.camera, float(a.width) / float(a.height));
  if (!camera) return wrong_camera(options.scene, options.camera, camera.error());
  return render::error_by_surface(*scene, *camera, a, b, eps);
}

Status run(const Options& options) {
  if (!options.diff.empty())
    if (Status ok = check_places({options.diff}); !ok) return ok;
  const Result<ComparedPicture> picture_a = read_compared(options.a, options.layer);
  if (!picture_a) return picture_a.error();
  const Result<ComparedPicture> picture_b = read_compared(options.b, options.layer);
  if (!picture_b) return picture_b.error();
  if (Status ok = check_comparable(*picture_a, *picture_b); !ok) return ok;
  const Image &a = picture_a->picture.image, &b = picture_b->picture.image;
  const bool has_colors = image::is_picture(picture_b->picture.layer.kind);
  if (!has_colors && options.metric == "flip")
    return Error{fmt::format("{}: holds no colours, so FLIP says nothing; choose another --metric",
                             picture_b->name)};

  std::vector<std::uint8_t> mask;
  std::string mask_path;
  if (!options.mask.empty()) {
    const Result<ComparedPicture> picture = read_compared(options.mask, "");
    if (!picture) return picture.error();
    if (Status ok = check_same_size(picture->name, picture->picture.image, picture_b->name, b); !ok)
      return ok;
    mask = image::mask_of(picture->picture.image);
    mask_path = picture->path;
  }
  const bool linear_a = image::is_scene_linear_extension(picture_a->path);
  const bool linear_b = image::is_scene_linear_extension(picture_b->path);
  if (linear_a != linear_b)
    say("warning: one of {} and {} holds scene-linear radiance, the other displayed "
        "colours; the numbers compare them in linear light as they are\n",
        options.a, options.b);

  image::MetricOptions metric_options;
  metric_options.mask = mask;
  const image::Metrics metrics = image::compare(a, b, metric_options);
  if (metrics.pixel_count == 0)
    return Error{fmt::format("{} and {}: no pixel is left to compare ({} masked, {} not finite)",
                             options.a, options.b, metrics.masked_count, metrics.non_finite_count)};
  const Flip flip = has_colors ? compute_flip(options, linear_a && linear_b, a, b, mask) : Flip{};
  Result<std::vector<render::SurfaceError>> surfaces = surface_errors(options, a, b, metrics.eps);
  if (!surfaces) return surfaces.error();
  if (!options.diff.empty()) {
    if (Status ok = check_not_read({options.diff}); !ok) return ok;
    const Image picture = make_difference_picture(options, a, b, metrics, flip, mask);
    if (Status ok = image::write_png(options.diff, picture); !ok) return ok;
  }
  if (options.json)
    print_json(options, *picture_a, *picture_b, metrics, flip, *surfaces);
  else
    print_table(options, *picture_a, *picture_b, metrics, flip, *surfaces);
  return Success{};
}

} // namespace

void add_compare(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("compare", "Measure how far picture A is from its reference B: RMSE, "
                                    "relative errors, PSNR, FLIP, and a difference picture");
  command->footer(k_footer);
  command->add_option("A", options->a, "Picture to judge (.exr .hdr .png .jpg)")->required();
  command->add_option("B", options->b, "The reference, of the same size")->required();
  command->add_option("--layer", options->layer,
                      "The layer of .exr files to compare, of both where the names say none (they "
                      "may: FILE.exr:LAYER); openltc inspect lists them");
  command->add_flag("--json", options->json, "Print JSON instead of a table");
  command
      ->add_option("--diff", options->diff,
                   "Write a difference picture with a colour scale to this .png file")
      ->check(CLI::Validator(check_png, "OUT.png"));
  command
      ->add_option("--metric", options->metric,
                   "What the difference picture shows: relative |A-B|/|B| (default), absolute "
                   "|A-B|, signed (A-B)/|B|, or flip")
      ->check(CLI::IsMember({"relative", "absolute", "signed", "flip"}))
      ->needs("--diff");
  command
      ->add_option("--scale", options->scale,
                   "Upper end of the difference picture's scale, e.g. 0.05 for 5 % (default: a "
                   "round number that 1 % of the pixels exceed; 1 for flip)")
      ->check(CLI::Validator(check_positive, "MAX"))
      ->needs("--diff");
  command->add_option("--scene", options->scene,
                      "The glTF scene that both pictures show: also say where the error lies, by "
                      "metal or dielectric, roughness, and view");
  command
      ->add_option("--camera", options->camera,
                   "The camera they show it from, as for openltc render [the first]")
      ->needs("--scene");
  add_reading_options(*command, options->reading);
  add_pose_options(*command, options->reading.pose);
  for (const char* option : {"--time", "--animation"})
    command->get_option(option)->needs("--scene");
  command->add_option("--mask", options->mask,
                      "Compare only pixels where this picture is not black");
  command
      ->add_option("--exposure", options->exposure,
                   "For .exr and .hdr: FLIP of the pictures as displayed at this EV100 (auto: "
                   "chosen from B) instead of HDR-FLIP")
      ->check(CLI::Validator(check_exposure, "EV100|auto"));
  command
      ->add_option("--pixels-per-degree", options->pixels_per_degree,
                   "For FLIP: how near the viewer sits, 1 to 1000 (default 67: a 0.7 m wide 4K "
                   "screen at 0.7 m)")
      ->check(CLI::Validator(check_ppd, "PPD"));

  command->callback([options, &exit_code] {
    Status status = Success{};
    try {
      status = run(*options);
    } catch (const std::bad_alloc&) {
      status = Error{
          fmt::format("{} and {}: not enough memory to compare them", options->a, options->b)};
    }
    if (status.ok()) return;
    exit_code = fail("compare", status.error());
  });
}

} // namespace openltc::cli
