// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The closed form on the scenes where it is worst (tools/make_hard_scenes.py), against the
// reference; a row for each scene, form and table. docs/verification.md says what is measured.

#include "bench/hard_measure.h"
#include "bench/hard_reference.h"
#include "openltc/image/compare/difference.h"
#include "openltc/image/file.h"
#include "openltc/image/tonemap.h"
#include "openltc/render/renderer.h"
#include "openltc/scene/gltf.h"
#include "openltc/table/shading_lobes.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

using namespace openltc;
namespace fs = std::filesystem;

namespace {

struct Options {
  std::vector<std::string> scenes;
  std::vector<std::string> tables = {"built-in", "two-lobe"};
  std::vector<std::string> forms = {"lobe", "ratio", "adaptive", "exact"};
  std::string size = "192x108";
  std::string folder = OPENLTC_SOURCE_DIR "/scenes/hard";
  std::string cache = OPENLTC_BUILD_DIR "/hard_references";
  std::string pictures;
  std::int64_t limit = 1 << 14;
  bool fresh = false, json = false;
  int width = 0, height = 0; ///< from size
};

constexpr int k_first_samples = 512;
constexpr double k_noise = 0.1; ///< of the error, at most

[[noreturn]] void end(const std::string& message) {
  fmt::print(stderr, "bench_hard: {}\n", message);
  std::exit(1);
}

template <typename T> T got(Result<T> result) {
  if (!result) end(result.error().message);
  return std::move(*result);
}

void check(const Status& status) {
  if (!status) end(status.error().message);
}

/// A way to make a picture without noise: what a row of the table is about.
struct Form {
  std::string name;  ///< "one lobe"
  std::string table; ///< "built-in", or the file's name without its ending
  std::function<Result<render::Picture>(const scene::Scene&, render::RenderOptions)> render;
};

struct NamedForm {
  const char* option; ///< of --form
  const char* name;   ///< after what lobes there are, where lobes matter
  render::SpecularForm form;
};
const NamedForm k_forms[] = {{"lobe", "", render::SpecularForm::lobe},
                             {"ratio", ", ratio", render::SpecularForm::ratio},
                             {"adaptive", " or GGX", render::SpecularForm::adaptive},
                             {"exact", "GGX itself", render::SpecularForm::exact}};

/// The lobes of the table (or polynomial) of a file, in every form that was asked for.
void add_forms(const std::string& table, const std::vector<std::string>& wanted,
               std::vector<Form>& forms) {
  auto lobes = std::make_shared<table::ShadingLobes>(
      table == "two-lobe" ? table::builtin_ggx_two_lobe_table() : table::builtin_ggx_table());
  std::string label = table == "two-lobe" ? "built-in" : table;
  if (label != "built-in") {
    std::vector<std::string> notes;
    *lobes = got(table::read_shading_lobes(table, notes));
    for (const std::string& note : notes)
      fmt::print(stderr, "bench_hard: {}\n", note);
    label = fs::path(table).stem().string();
  }
  const auto* held = std::get_if<table::LobeTable>(lobes.get());
  const std::string what = held && held->two_lobes() ? "two lobes" : "one lobe";
  for (const NamedForm& named : k_forms) {
    if (std::find(wanted.begin(), wanted.end(), named.option) == wanted.end()) continue;
    const bool exact = named.form == render::SpecularForm::exact;
    if (exact && table != "built-in") continue; // no lobe has a part in it
    forms.push_back(
        {exact ? named.name : what + named.name, label,
         [lobes, form = named.form](const scene::Scene& scene, render::RenderOptions options) {
           options.specular_form = form;
           const render::LobeSource source =
               std::visit([](const auto& l) { return render::LobeSource(l); }, *lobes);
           return render::render(scene, scene.cameras.at(0), source, options);
         }});
  }
}

struct Row {
  std::string scene;
  const Form* form = nullptr;
  bench::HardErrors errors;
  std::int64_t reference_samples = 0;
  bool limit_met = false;
  double seconds = 0;           ///< of the picture, the fastest of three
  double reference_seconds = 0; ///< that this run spent on the reference
};

std::string percent(std::optional<double> value, int digits) {
  return value ? fmt::format("{:.{}f} %", 100 * *value, digits) : "–";
}

// Where the reference is black the error is in nits, the picture's mean.
void print_head() {
  fmt::print("| scene | form | table | error, of the light | relative, median | p95 | FLIP | "
             "energy | noise/error | samples | seconds |\n"
             "|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print_row(const Row& row) {
  const bench::HardErrors& e = row.errors;
  fmt::print("| {} | {} | {} | {} | {} | {} | {:.3f} | {} | {}{} | {} | {:.4f} |\n", row.scene,
             row.form->name, row.form->table,
             e.of_light ? percent(e.of_light, 2) : fmt::format("{:.2g} nits", e.mean_nits),
             percent(e.median_relative, 1), percent(e.p95_relative, 0), e.flip,
             e.energy ? fmt::format("{:+.1f} %", 100 * *e.energy) : "–",
             e.noise_over_error ? fmt::format("{:.3f}", *e.noise_over_error) : "–",
             row.limit_met ? " (limit of samples)" : "", row.reference_samples, row.seconds);
  std::fflush(stdout);
}

/// Forms and tables beside each other; rows are those of a scene after those of another, in the
/// order of `forms`.
void print_side_by_side(const std::vector<Form>& forms, const std::vector<Row>& rows) {
  fmt::print("\nError of the light / p95 of relative / FLIP\n| scene |");
  for (const Form& form : forms)
    fmt::print(" {}, {} |", form.name, form.table);
  fmt::print("\n|---|");
  for (std::size_t i = 0; i < forms.size(); ++i)
    fmt::print("---|");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bench::HardErrors& e = rows[i].errors;
    if (i % forms.size() == 0) fmt::print("\n| {} |", rows[i].scene);
    fmt::print(" {} / {} / {:.3f} |",
               e.of_light ? percent(e.of_light, 1) : fmt::format("{:.2g} nits", e.mean_nits),
               percent(e.p95_relative, 0), e.flip);
  }
  fmt::print("\n");
}

/// Of each form and table: the worst scene beside the best.
void print_summary(const std::vector<Form>& forms, const std::vector<Row>& rows) {
  fmt::print("\nError in % of the light, over the scenes with light\n");
  for (const Form& form : forms) {
    const Row *worst = nullptr, *best = nullptr;
    double sum = 0;
    int count = 0;
    for (const Row& row : rows) {
      if (row.form != &form || !row.errors.of_light) continue;
      if (!worst || *row.errors.of_light > *worst->errors.of_light) worst = &row;
      if (!best || *row.errors.of_light < *best->errors.of_light) best = &row;
      sum += *row.errors.of_light;
      ++count;
    }
    if (count == 0) continue;
    fmt::print("  {}, {}: worst {} ({}), best {} ({}), mean {}\n", form.name, form.table,
               percent(worst->errors.of_light, 2), worst->scene, percent(best->errors.of_light, 2),
               best->scene, percent(sum / count, 2));
  }
}

void print_json(const Options& options, const std::vector<Row>& rows) {
  const auto number = [](std::optional<double> v) {
    return v && std::isfinite(*v) ? nlohmann::ordered_json(*v) : nlohmann::ordered_json(nullptr);
  };
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const Row& row : rows)
    out.push_back({{"scene", row.scene},
                   {"form", row.form->name},
                   {"table", row.form->table},
                   {"width", options.width},
                   {"height", options.height},
                   {"error_of_light", number(row.errors.of_light)},
                   {"median_relative", number(row.errors.median_relative)},
                   {"p95_relative", number(row.errors.p95_relative)},
                   {"flip", row.errors.flip},
                   {"energy", number(row.errors.energy)},
                   {"mean_nits", row.errors.mean_nits},
                   {"noise_over_error", number(row.errors.noise_over_error)},
                   {"limit_met", row.limit_met},
                   {"reference_samples", row.reference_samples},
                   {"seconds", row.seconds},
                   {"reference_seconds", row.reference_seconds}});
  fmt::print("{}\n", out.dump(2));
}

std::string file_word(const std::string& text) {
  std::string word;
  for (const char c : text)
    word += std::isalnum(static_cast<unsigned char>(c)) || c == '-' ? c : '_';
  return word;
}

void write_both(const std::string& stem, const image::Image& radiance, float exposure) {
  const image::LayerView layer[] = {{"", &radiance}};
  check(image::write_exr_views(stem + ".exr", layer));
  check(image::write_png(stem + ".png",
                         image::to_display(radiance, exposure, image::Tonemap::neutral)));
}

/// The picture, the reference and their difference; both pictures at the reference's exposure.
void write_pictures(const Options& options, const std::string& scene, const Form& form,
                    const image::Image& picture, const image::Image& reference) {
  const bool black =
      std::all_of(reference.data.begin(), reference.data.end(), [](float v) { return v == 0.0f; });
  const float exposure = image::auto_exposure(black ? picture : reference);
  fs::create_directories(options.pictures);
  const std::string stem = options.pictures + "/" + scene;
  const std::string name = stem + "_" + file_word(form.name + " " + form.table);
  write_both(stem + "_reference", reference, exposure);
  write_both(name, picture, exposure);

  image::Image difference = picture;
  double mean = 0;
  for (std::size_t i = 0; i < difference.data.size(); ++i) {
    difference.data[i] -= reference.data[i];
    mean += double(reference.data[i]) / double(difference.data.size());
  }
  const image::LayerView layer[] = {{"", &difference}};
  check(image::write_exr_views(name + "_difference.exr", layer));
  image::DifferencePictureOptions drawn;
  drawn.is_signed = drawn.percent = true;
  drawn.colormap = image::Colormap::blue_red;
  drawn.scale_max = 1;
  drawn.title = "(A-B) / (B + 1 % of its mean)";
  drawn.caption = scene + ", " + form.name + ", " + form.table;
  const double eps = std::max(bench::k_lit * mean, 1e-12);
  check(image::write_png(
      name + "_difference.png",
      image::difference_picture(
          image::difference_map(picture, reference, image::DifferenceKind::signed_relative, eps),
          drawn)));
}

/// Renders the reference with more samples until its noise is a tenth of the picture's error.
/// Returns whether that came to the limit first.
bool refine(const Options& options, bench::HardReferenceStore& store,
            bench::HardReference& reference, const scene::Scene& scene, const fs::path& file,
            const image::Image& picture) {
  double seconds = reference.seconds;
  for (;;) {
    const std::optional<double> ratio = bench::noise_over_error(picture, reference);
    if (!ratio || *ratio <= k_noise) return false;
    if (2 * reference.samples > options.limit) return true;
    // Powers of two, which stratify best; noise falls faster than their root, mostly.
    std::int64_t samples = 2 * reference.samples;
    for (double left = *ratio / k_noise / 1.5; left > 1 && 2 * samples <= options.limit; left /= 2)
      samples *= 2;
    reference = got(store.render(scene, file, options.width, options.height, samples));
    reference.seconds = seconds += reference.seconds;
  }
}

void measure(const Options& options, const fs::path& file, const std::vector<Form>& forms,
             bench::HardReferenceStore& store, std::vector<Row>& rows) {
  const scene::Scene scene = got(scene::load_gltf(file.string()));
  bench::HardReference reference =
      got(store.load(scene, file, options.width, options.height, k_first_samples));
  render::RenderOptions ltc;
  ltc.width = options.width;
  ltc.height = options.height;
  ltc.samples = 1;
  ltc.shadow_samples = 0;
  ltc.filter = render::PixelFilter::none;

  struct Made {
    render::Picture picture;
    bool limit_met;
    double seconds;
  };
  std::vector<Made> made;
  for (const Form& form : forms) {
    Made m{got(form.render(scene, ltc)), false, 0};
    m.seconds = m.picture.render_seconds;
    for (int i = 1; i < 3; ++i)
      m.seconds = std::min(m.seconds, got(form.render(scene, ltc)).render_seconds);
    m.limit_met = refine(options, store, reference, scene, file, m.picture.radiance);
    made.push_back(std::move(m));
  }
  // All forms against the same, last reference.
  for (std::size_t i = 0; i < forms.size(); ++i) {
    const image::Image& picture = made[i].picture.radiance;
    rows.push_back({file.stem().string(), &forms[i], bench::hard_errors(picture, reference),
                    reference.samples, made[i].limit_met, made[i].seconds, reference.seconds});
    if (!options.json) print_row(rows.back());
    if (!options.pictures.empty())
      write_pictures(options, file.stem().string(), forms[i], picture, reference.radiance);
  }
}

std::vector<fs::path> scene_files(const Options& options) {
  std::vector<fs::path> files;
  if (!options.scenes.empty()) {
    for (const std::string& name : options.scenes)
      files.push_back(fs::path(options.folder) / (name + ".glb"));
    return files;
  }
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(options.folder, error))
    if (entry.path().extension() == ".glb") files.push_back(entry.path());
  if (files.empty()) end(options.folder + ": no .glb there");
  std::sort(files.begin(), files.end());
  return files;
}

/// The arguments without those that tools/bench.sh passes on for Google's benchmark library.
std::vector<std::string> own_arguments(int argc, char** argv) {
  std::vector<std::string> arguments;
  for (int i = argc - 1; i > 0; --i) // CLI11 wants them from behind
    if (!std::string_view(argv[i]).starts_with("--benchmark_")) arguments.push_back(argv[i]);
  return arguments;
}

} // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("The closed form on the scenes where it is worst, against the reference",
               "bench_hard");
  app.add_option("--scene", options.scenes, "A scene's name, may be repeated [all]")
      ->allow_extra_args(false);
  app.add_option("--table", options.tables,
                 "Lobes: a file of openltc fit, or those built in, one (built-in) or two "
                 "(two-lobe); may be "
                 "repeated [built-in and two-lobe]")
      ->allow_extra_args(false);
  app.add_option("--form", options.forms,
                 "Form of the closed form: lobe, ratio, adaptive or exact; may be repeated [all]")
      ->check(CLI::IsMember({"lobe", "ratio", "adaptive", "exact"}))
      ->allow_extra_args(false);
  app.add_option("--size", options.size, "WIDTHxHEIGHT in pixels [192x108]");
  app.add_option("--folder", options.folder, "Where the scenes lie [scenes/hard]");
  app.add_option("--cache", options.cache,
                 "Where references are kept [hard_references of the build]");
  app.add_option("--limit", options.limit, "Most samples of the reference per pixel [16384]")
      ->check(CLI::Range(k_first_samples, 1 << 20));
  app.add_option("--pictures", options.pictures,
                 "A folder for the pictures, references and differences, .png and .exr");
  app.add_flag("--fresh", options.fresh, "Render the references anew");
  app.add_flag("--json", options.json, "Print JSON instead of a table");
  try {
    app.parse(own_arguments(argc, argv));
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  char rest = 0;
  if (std::sscanf(options.size.c_str(), "%dx%d%c", &options.width, &options.height, &rest) != 2 ||
      options.width < 1 || options.height < 1)
    end("--size " + options.size + ": write WIDTHxHEIGHT, e.g. 192x108");

  std::vector<Form> forms;
  for (const std::string& table : options.tables)
    add_forms(table, options.forms, forms);
  bench::HardReferenceStore store(options.cache, options.fresh);
  std::vector<Row> rows;
  if (!options.json) print_head();
  for (const fs::path& file : scene_files(options))
    measure(options, file, forms, store, rows);
  if (options.json) {
    print_json(options, rows);
    return 0;
  }
  if (forms.size() > 1) print_side_by_side(forms, rows);
  print_summary(forms, rows);
}
