// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/fit_command.h"
#include "openltc/brdf/choose.h"
#include "openltc/table/lobe_check.h"
#include "openltc/table/packed_file.h"
#include "python/src/arrays.h"
#include "python/src/fitted.h"

#include <fmt/format.h>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <variant>

namespace openltc::python {

namespace nb = nanobind;

namespace {

using table::Layout;
using table::PackedTable;

Layout layout_named(const std::string& name) {
  if (const Layout* layout = table::find_layout(name)) return *layout;
  std::string names;
  for (const Layout layout : table::all_layouts())
    names += std::string(names.empty() ? "" : ", ") + name_of(layout);
  throw ToolError(fmt::format("layout {}: there is none of that name; choose {}", name, names));
}

table::LobeForm form_named(const std::string& name) {
  if (name == "table") return table::LobeForm::table;
  if (name == "polynomial") return table::LobeForm::polynomial;
  if (name == "two-lobe") return table::LobeForm::two_lobe;
  if (name == "two-lobe-polynomial") return table::LobeForm::two_lobe_polynomial;
  throw ToolError(
      fmt::format("form {}: choose table, polynomial, two-lobe or two-lobe-polynomial", name));
}

table::Precision precision_named(const std::string& name) {
  for (const table::Precision p : {table::Precision::float32, table::Precision::float16})
    if (name == name_of(p)) return p;
  throw ToolError(fmt::format("precision {}: choose float32 or float16", name));
}

fit::Refine refine_named(const std::string& name) {
  if (name == "auto") return fit::Refine::automatic;
  if (name == "on") return fit::Refine::on;
  if (name == "off") return fit::Refine::off;
  throw ToolError(fmt::format("refine {}: choose auto, on or off", name));
}

const table::Engine* engine_named(const std::optional<std::string>& name) {
  if (!name) return nullptr;
  if (const table::Engine* engine = table::find_engine(*name)) return engine;
  std::string names;
  for (const table::Engine& engine : table::all_engines())
    names += std::string(names.empty() ? "" : ", ") + engine.name;
  throw ToolError(fmt::format("engine {}: there is none of that name; choose {}", *name, names));
}

/// As the tool's options say it, and what the tool makes of them.
fit::FitRequest request_of(std::optional<int> size, std::string objective, const std::string& form,
                           int degree, const std::string& layout, const std::string& precision,
                           const std::string& refine, bool clip_aware,
                           const table::Engine* engine) {
  fit::FitRequest request;
  request.objective = std::move(objective);
  request.form = form_named(form);
  request.degree = degree;
  request.layout = layout_named(layout);
  request.precision = precision_named(precision);
  request.refine = refine_named(refine);
  request.clip_aware = clip_aware;
  request.tool_version = OPENLTC_VERSION;
  if (request.form == table::LobeForm::two_lobe) request.size = fit::k_two_lobe_size;
  if (size) request.size = *size;
  using table::LobePolynomial;
  if (degree < LobePolynomial::k_min_degree || degree > LobePolynomial::k_max_degree)
    throw ToolError(fmt::format("degree {}: choose {} to {}", degree, LobePolynomial::k_min_degree,
                                LobePolynomial::k_max_degree));
  const bool other_layout = request.layout != Layout::native || clip_aware;
  if (request.form != table::LobeForm::table && other_layout)
    throw ToolError("layout and clip_aware are for form table");
  if (engine) {
    if (request.form != table::LobeForm::table || size || other_layout || precision != "float32")
      throw ToolError("form, size, layout and precision are not for engine, which chooses them");
    request.layout = engine->layout;
    request.precision = engine->precision;
    request.size = engine->size;
    if (request.refine == fit::Refine::automatic) request.refine = fit::Refine::on;
  }
  return request;
}

Fitted fit_any(nb::object brdf, const std::string& name, bool narrow, bool has_roughness,
               std::optional<int> size, const std::string& objective, const std::string& form,
               int degree, const std::string& layout, const std::optional<std::string>& engine,
               const std::string& precision, const std::string& refine, bool clip_aware,
               nb::object progress) {
  Fitted fitted;
  fitted.engine = engine_named(engine);
  fitted.request = request_of(size, objective, form, degree, layout, precision, refine, clip_aware,
                              fitted.engine);
  std::string path;
  if (nb::isinstance<nb::str>(brdf)) {
    path = nb::cast<std::string>(brdf);
    fitted.brdf = take(brdf::choose_brdf(path));
    fitted.request.command = cli::fit_command_of(path, fitted.request, fitted.engine);
  } else {
    fitted.function = std::make_shared<Callable>(std::move(brdf));
    fitted.brdf = brdf_of(fitted.function, nullptr, name,
                          narrow ? brdf::LobeWidth::alpha : brdf::LobeWidth::one, has_roughness);
  }
  Job job(std::move(progress));
  const brdf::Brdf own = fitted.brdf_in(job);
  job.run([&] { fitted.lobes = take(fit::fit_lobes(own, fitted.request, job.progress())); });
  return fitted;
}

/// The error of the lobes; with lights and worst cells where `whole`. Another thread may be doing
/// the same: who is first states it, once, and writers read it without the interpreter's lock.
void measure(Fitted& fitted, bool whole, nb::object progress) {
  std::optional<fit::Report>& report = whole ? fitted.report : fitted.errors;
  if (report) return;
  std::vector<fit::Candidate> candidates = {fit::candidate_of(fitted.lobes, fitted.request)};
  fit::ReportOptions options;
  options.title = fmt::format("{}: error of fitted lobes", fitted.brdf.name);
  options.command = fitted.request.command;
  options.tool_version = OPENLTC_VERSION;
  if (!whole) {
    options.worst_cells = 0;
    candidates.front().nodes = {};
  }
  // Of a function of the caller's, one light takes hundreds of calls.
  if (!whole || fitted.function) options.lights.count = 0;
  Job job(std::move(progress));
  const brdf::Brdf own = fitted.stopping_brdf_in(job);
  candidates.front().lobes = [lobes = candidates.front().lobes, &job](double r, double cosine) {
    job.stop_here();
    return lobes(r, cosine);
  };
  std::optional<fit::Report> made;
  job.run([&] { made = take(fit::make_report(own, candidates, options)); });
  if (report) return;
  const bool stated = fitted.errors || fitted.report;
  report = std::move(made);
  if (!stated) fit::state_error(fitted.lobes, report->regions.front().errors.front());
}

nb::list arrays_of(const PackedTable& packed) {
  nb::list arrays;
  for (const table::Texture& t : packed.textures)
    arrays.append(
        array_of(t.values, {std::size_t(t.height), std::size_t(t.width), std::size_t(t.channels)}));
  return arrays;
}

/// As stored: of a table its textures, of a polynomial its terms, and those of the second lobe.
nb::list arrays(const Fitted& fitted) {
  if (const auto* packed = std::get_if<PackedTable>(&fitted.lobes.stored))
    return arrays_of(*packed);
  const auto& polynomial = std::get<table::LobePolynomial>(fitted.lobes.stored);
  nb::list arrays;
  const auto terms = std::size_t(table::polynomial_terms(polynomial.degree));
  arrays.append(array_of(polynomial.coefficients, {terms, 8}));
  if (polynomial.two_lobes()) arrays.append(array_of(polynomial.second, {terms, 4}));
  return arrays;
}

/// What shading reads: texels of 8 floats and of the second lobe 4, or nothing where it is no
/// native table.
nb::object native_nodes(const Fitted& fitted) {
  if (!fitted.lobes.nodes) return nb::none();
  const table::LobeTable& t = *fitted.lobes.nodes;
  const auto rows = std::size_t(t.rows), columns = std::size_t(t.columns);
  nb::list nodes;
  nodes.append(array_of(t.texels, {rows, columns, 8}));
  if (t.two_lobes()) nodes.append(array_of(t.second, {rows, columns, 4}));
  return nodes;
}

const table::LobeTable& nodes_of(const Fitted& fitted) {
  if (fitted.lobes.nodes) return *fitted.lobes.nodes;
  throw ToolError("these lobes are a polynomial; textures are made of form table");
}

/// In another layout, precision and size.
nb::list textures(const Fitted& fitted, const std::optional<std::string>& engine_name,
                  const std::string& layout_name, const std::string& precision_name,
                  std::optional<int> size) {
  Layout layout = layout_named(layout_name);
  table::Precision precision = precision_named(precision_name);
  if (const table::Engine* engine = engine_named(engine_name)) {
    if (const auto* packed = std::get_if<PackedTable>(&fitted.lobes.stored);
        packed && fitted.engine == engine)
      return arrays_of(*packed);
    layout = engine->layout;
    precision = engine->precision;
    size = engine->size;
  }
  const table::LobeTable& nodes = nodes_of(fitted);
  if (!size || *size == nodes.rows) return arrays_of(take(table::pack(nodes, layout, precision)));
  const int columns = nodes.columns == 1 ? 1 : *size;
  return arrays_of(
      take(table::pack(take(table::resample(nodes, columns, *size, table::angle_axis_of(layout))),
                       layout, precision)));
}

std::vector<std::string> save(Fitted& fitted, const std::string& path, nb::object progress) {
  if (!fitted.engine) {
    take(fit::check_extensions(fitted.request, {path}));
    (void)take(fit::check_outputs(fitted.brdf, fitted.request, {path}));
  }
  measure(fitted, false, std::move(progress));
  const Outside others_may_run;
  if (fitted.engine)
    return take(table::write_engine_files(std::get<PackedTable>(fitted.lobes.stored),
                                          *fitted.engine, path));
  return take(fit::write_lobes(fitted.lobes, path));
}

nb::dict metadata(const Fitted& fitted) {
  nb::dict all;
  const table::TableMetadata& m = fitted.lobes.metadata();
  for (const table::MetadataField& field : table::k_metadata_fields) {
    if (field.text)
      all[field.name] = m.*field.text;
    else
      all[field.name] = m.*field.number;
  }
  return all;
}

std::string notes(const Fitted& fitted) {
  std::string text = fitted.lobes.note;
  if (const auto* packed = std::get_if<PackedTable>(&fitted.lobes.stored))
    for (const std::string& line : {fitted.lobes.warning, fit::size_note(*packed)})
      if (!line.empty()) text += (text.empty() ? "" : "\n") + line;
  return text;
}

// A function may refer to what was fitted to it, as a module's do.
int traverse(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  if (!nb::inst_ready(self)) return 0;
  const auto* fitted = nb::inst_ptr<Fitted>(self);
  if (fitted->function) Py_VISIT(fitted->function->function());
  return 0;
}

int clear(PyObject* self) {
  const auto* fitted = nb::inst_ptr<Fitted>(self);
  if (fitted->function) fitted->function->clear();
  return 0;
}

PyType_Slot k_collected[] = {{Py_tp_traverse, reinterpret_cast<void*>(&traverse)},
                             {Py_tp_clear, reinterpret_cast<void*>(&clear)},
                             {0, nullptr}};

} // namespace

void bind_fit(nb::module_& m) {
  nb::class_<Fitted>(m, "Fitted", nb::type_slots(k_collected))
      .def("measure", &measure, nb::arg("whole"), nb::arg("progress").none())
      .def("arrays", &arrays)
      .def("native_nodes", &native_nodes)
      .def("textures", &textures, nb::arg("engine").none(), nb::arg("layout"), nb::arg("precision"),
           nb::arg("size").none())
      .def("save", &save, nb::arg("path"), nb::arg("progress").none())
      .def("metadata", &metadata)
      .def("notes", &notes)
      .def("text", [](const Fitted& f) { return fit::to_text(*(f.report ? f.report : f.errors)); })
      .def("json", [](const Fitted& f) { return fit::to_json(*(f.report ? f.report : f.errors)); })
      .def("html", [](const Fitted& f) { return fit::to_html(*(f.report ? f.report : f.errors)); })
      .def_prop_ro("narrow", [](const Fitted& f) { return f.brdf.width == brdf::LobeWidth::alpha; })
      .def_prop_ro("brdf", [](const Fitted& f) { return f.brdf.name; })
      .def_prop_ro("seconds", [](const Fitted& f) { return f.lobes.seconds; });
  m.def("fit", &fit_any, nb::arg("brdf"), nb::kw_only(), nb::arg("name"), nb::arg("narrow"),
        nb::arg("has_roughness"), nb::arg("size").none(), nb::arg("objective"), nb::arg("form"),
        nb::arg("degree"), nb::arg("layout"), nb::arg("engine").none(), nb::arg("precision"),
        nb::arg("refine"), nb::arg("clip_aware"), nb::arg("progress").none());
  m.def("brdfs", [] {
    nb::list all;
    for (const brdf::Brdf& b : brdf::all_brdfs()) {
      nb::dict one;
      one["name"] = b.name;
      one["variant"] = b.variant;
      one["source"] = b.source;
      one["parameter"] = b.parameter;
      all.append(one);
    }
    return all;
  });
  m.def("engines", [] {
    nb::list all;
    for (const table::Engine& e : table::all_engines()) {
      nb::dict one;
      one["name"] = e.name;
      one["title"] = e.title;
      one["layout"] = name_of(e.layout);
      one["size"] = e.size;
      one["precision"] = name_of(e.precision);
      one["files"] = e.files;
      one["place"] = e.place;
      all.append(one);
    }
    return all;
  });
  m.def("layouts", [] {
    std::vector<std::string> names;
    for (const Layout layout : table::all_layouts())
      names.emplace_back(name_of(layout));
    return names;
  });
}

} // namespace openltc::python
