// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Fits and their files, as `openltc fit` makes them.

#include "fits.h"

#include "cli/fit_command.h"
#include "openltc/brdf/choose.h"
#include "openltc/brdf/merl.h"
#include "openltc/table/container/description.h"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <memory>
#include <utility>

namespace openltc::wasm {

namespace {

std::map<int, std::unique_ptr<Kept>>& fits() {
  static std::map<int, std::unique_ptr<Kept>> all;
  return all;
}

// "brdf": {"name"}, {"at": address, "size", "name"} of a MERL file or {"function": true, "name",
// "width", "parameter"}.
Result<brdf::Brdf> brdf_of(const Json& description) {
  if (description.contains("function")) return brdf_of_page(description);
  if (description.contains("at")) {
    const auto at = std::uintptr_t(number_of(description, "at", 0));
    const auto size = std::size_t(number_of(description, "size", 0));
    return brdf::parse_merl({reinterpret_cast<const std::uint8_t*>(at), size},
                            text_of(description, "name", "material.binary"));
  }
  const std::string name = text_of(description, "name");
  if (const brdf::Brdf* known = brdf::find_brdf(name)) return *known;
  std::string names;
  for (const brdf::Brdf& entry : brdf::all_brdfs())
    names += (names.empty() ? "" : ", ") + entry.name;
  return Error{fmt::format("brdf \"{}\" is not known; take one of {}, a MERL file's bytes or a "
                           "function",
                           name, names)};
}

Result<Success> read_form(const std::string& name, table::LobeForm& form) {
  static const std::pair<const char*, table::LobeForm> forms[] = {
      {"table", table::LobeForm::table},
      {"polynomial", table::LobeForm::polynomial},
      {"two-lobe", table::LobeForm::two_lobe},
      {"two-lobe-polynomial", table::LobeForm::two_lobe_polynomial}};
  for (const auto& [known, value] : forms)
    if (name == known) {
      form = value;
      return Success{};
    }
  return Error{fmt::format("form \"{}\" is not known; take table, two-lobe, polynomial or "
                           "two-lobe-polynomial",
                           name)};
}

Result<int> whole(const Json& request, const char* name, int otherwise, int least, int most) {
  const double value = number_of(request, name, otherwise);
  if (!(value >= least && value <= most) || value != int(value))
    return Error{
        fmt::format("{} is {}; it is a whole number from {} to {}", name, value, least, most)};
  return int(value);
}

// What is asked for, as the command line's options are read.
Status read_request(const Json& request, Kept& kept) {
  fit::FitRequest& r = kept.request;
  if (Status status = read_form(text_of(request, "form", "table"), r.form); !status) return status;
  const bool two = r.form == table::LobeForm::two_lobe;
  const Result<int> size = whole(request, "size", two ? fit::k_two_lobe_size : 64, 2, 512);
  if (!size) return size.error();
  r.size = *size;
  const Result<int> degree = whole(request, "degree", r.degree, table::LobePolynomial::k_min_degree,
                                   table::LobePolynomial::k_max_degree);
  if (!degree) return degree.error();
  r.degree = *degree;
  r.objective = text_of(request, "objective", r.objective);
  const std::string layout = text_of(request, "layout", "native");
  const std::string precision = text_of(request, "precision", "float32");
  const std::string refine = text_of(request, "refine", "auto");
  const table::Layout* found = table::find_layout(layout);
  if (!found) return Error{fmt::format("layout \"{}\" is not known", layout)};
  r.layout = *found;
  if (r.layout != table::Layout::native && r.form != table::LobeForm::table)
    return Error{
        fmt::format("layout {} is for form table, not for {}", layout, text_of(request, "form"))};
  if (precision != "float32" && precision != "float16")
    return Error{fmt::format("precision \"{}\" is not known; take float32 or float16", precision)};
  if (precision == "float16") r.precision = table::Precision::float16;
  if (refine != "auto" && refine != "on" && refine != "off")
    return Error{fmt::format("refine \"{}\" is not known; take auto, on or off", refine)};
  if (refine != "auto") r.refine = refine == "on" ? fit::Refine::on : fit::Refine::off;
  r.clip_aware = number_of(request, "clipAware", 0) != 0;
  if (const std::string engine = text_of(request, "engine"); !engine.empty()) {
    kept.engine = table::find_engine(engine);
    if (!kept.engine) return Error{fmt::format("engine \"{}\" is not known", engine)};
    r.form = table::LobeForm::table;
    r.layout = kept.engine->layout;
    r.precision = kept.engine->precision;
    r.size = kept.engine->size;
    if (r.refine == fit::Refine::automatic) r.refine = fit::Refine::on;
  }
  r.tool_version = OPENLTC_VERSION;
  return Success{};
}

// The textures as they are stored, and where they lie among the bytes.
void add_textures(const table::PackedTable& packed, Answer& answer) {
  answer.json["columns"] = packed.columns();
  answer.json["rows"] = packed.rows();
  answer.json["textures"] = Json::array();
  for (const table::Texture& texture : packed.textures)
    answer.json["textures"].push_back(
        {{"width", texture.width},
         {"height", texture.height},
         {"channels", texture.channels},
         {"values", answer.add_floats({texture.values.begin(), texture.values.end()})}});
}

Json numbers_of(const fit::LobeError& error) {
  Json object = Json::object();
  for (const fit::LobeErrorField& field : fit::lobe_error_fields())
    object[field.name] = error.*field.member;
  return object;
}

} // namespace

Result<Answer> make_fit(const Json& request) {
  auto kept = std::make_unique<Kept>();
  const Json& description = request.contains("brdf") ? request["brdf"] : Json::object();
  Result<brdf::Brdf> brdf = brdf_of(description);
  if (!brdf) return brdf.error();
  kept->brdf = std::move(*brdf);
  if (Status status = read_request(request, *kept); !status) return status.error();
  if (!description.contains("function"))
    kept->request.command =
        cli::fit_command_of(text_of(description, "name"), kept->request, kept->engine);
  Result<fit::FittedLobes> fitted = fit::fit_lobes(kept->brdf, kept->request, tell_page);
  if (!fitted) return fitted.error();
  kept->fitted = std::move(*fitted);

  // Its error, which the files state.
  fit::MeasureOptions region = fit::ReportOptions::default_regions().front();
  region.horizon = kept->fitted.horizon;
  const fit::MeasuredLobes lobes{"", kept->fitted.lobes(), kept->fitted.horizon};
  const Result<std::vector<fit::ErrorMap>> maps =
      fit::measure_maps(kept->brdf, {&lobes, 1}, fit::midpoint_axes(region), region.quadrature);
  if (!maps) return maps.error();
  const fit::ErrorMap& map = maps->front();
  const fit::TableError error = fit::summarise(map);
  fit::state_error(kept->fitted, error);

  Answer answer;
  Json& json = answer.json;
  json["brdf"] = kept->brdf.name;
  json["width"] = kept->brdf.width == brdf::LobeWidth::alpha ? "alpha" : "one";
  json["layout"] = table::name_of(kept->request.layout);
  json["precision"] = table::name_of(kept->request.precision);
  json["objective"] = kept->request.objective;
  json["command"] = kept->request.command;
  json["note"] = kept->fitted.note;
  json["warning"] = kept->fitted.warning;
  json["seconds"] = kept->fitted.seconds;
  json["mean"] = numbers_of(error.mean);
  json["max"] = numbers_of(error.max);
  if (const auto* packed = std::get_if<table::PackedTable>(&kept->fitted.stored))
    add_textures(*packed, answer);
  std::vector<double> tv;
  for (const fit::LobeError& cell : map.cells)
    tv.push_back(cell.tv);
  json["map"] = {{"roughness", map.axes.roughness},
                 {"thetaDegrees", map.axes.theta_degrees},
                 {"tv", answer.add_floats(tv)},
                 {"albedo", answer.add_floats(map.albedo)}};
  static int last_id = 0;
  json["id"] = ++last_id;
  fits()[last_id] = std::move(kept);
  return answer;
}

Result<Answer> make_files(const Kept& kept, const Json& request) {
  Answer answer;
  answer.json["files"] = Json::array();
  const auto add = [&](const std::string& name, std::vector<std::uint8_t> bytes) {
    answer.json["files"].push_back(name);
    answer.bytes.push_back(std::move(bytes));
  };
  if (kept.engine) {
    const auto& packed = std::get<table::PackedTable>(kept.fitted.stored);
    Result<std::vector<std::pair<std::string, table::Bytes>>> files =
        table::engine_files(packed, *kept.engine);
    if (!files) return files.error();
    for (auto& [name, bytes] : *files)
      add(name, std::move(bytes));
    FileBytes about = file_of_text(table::k_engine_description,
                                   table::description_to_json(table::describe(packed)));
    add(about.path, std::move(about.bytes));
    return answer;
  }
  const std::string path = text_of(request, "path");
  if (Status status = fit::check_extensions(kept.request, {path}); !status) return status.error();
  if (Result<std::vector<std::string>> files = fit::check_outputs(kept.brdf, kept.request, {path});
      !files)
    return files.error();
  Result<std::vector<FileBytes>> files = fit::lobes_bytes(kept.fitted, path);
  if (!files) return files.error();
  for (FileBytes& file : *files)
    add(file.path, std::move(file.bytes));
  return answer;
}

Result<Answer> make_report_text(const Kept& kept, const Json& request) {
  fit::ReportOptions options;
  options.title = fmt::format("{}: error of fitted lobes", kept.brdf.name);
  options.command = kept.request.command;
  options.tool_version = OPENLTC_VERSION;
  options.lights.count = int(number_of(request, "lights", options.lights.count));
  std::vector<fit::Candidate> candidates = {fit::candidate_of(kept.fitted, kept.request)};
  if (number_of(request, "limit", 0) != 0)
    candidates.push_back(fit::limit_of(kept.brdf, kept.fitted));
  const Result<fit::Report> report = fit::make_report(kept.brdf, candidates, options);
  if (!report) return report.error();
  const std::string text = fit::to_json(*report);
  Answer answer;
  answer.bytes.emplace_back(text.begin(), text.end());
  return answer;
}

Result<const Kept*> kept_fit(const Json& request) {
  const auto found = fits().find(int(number_of(request, "id", 0)));
  if (found == fits().end()) return Error{"this fit was freed"};
  return found->second.get();
}

void forget_fit(const Json& request) { fits().erase(int(number_of(request, "id", 0))); }

} // namespace openltc::wasm
