// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/markup.h"
#include "openltc/fit/report/figure.h"
#include "openltc/fit/report/report.h"
#include "openltc/fit/report/style.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::fit {

namespace {

struct Row {
  const char* field; // of LobeError
  const char* name;
  const char* meaning;
};
constexpr Row k_rows[] = {
    {"tv", "TV", "share of energy misplaced"},
    {"bound", "bound", "E · TV + |n1 − E|: what a light of radiance 1 errs by at most, F = 1"},
    {"l1", "L1", "over the hemisphere"},
    {"l2", "L2", "relative to ρ/E"},
    {"l3", "L3", "relative to ρ/E"},
    {"peak", "peak", "of the brightest point"},
    {"leak", "leak", "share of D below the surface"},
    {"n1", "n1", "|n1 − E|, of the albedo for F = 1"},
    {"n5", "n5", "the same of its Schlick part"},
};
constexpr const char* k_mapped[] = {"tv", "l2", "peak", "leak"};

const LobeErrorField& field_of(std::string_view name) {
  const auto fields = lobe_error_fields();
  return *std::find_if(fields.begin(), fields.end(),
                       [&](const LobeErrorField& f) { return f.name == name; });
}
const Row& row_of(std::string_view name) {
  return *std::find_if(std::begin(k_rows), std::end(k_rows),
                       [&](const Row& r) { return r.field == name; });
}

const char* horizon_text(Horizon horizon) {
  return horizon == Horizon::clipped ? "horizon clipped: divided by the share above, at least 0.01"
                                     : "horizon leaking: what lies below is lost";
}

// How many times a candidate's figure is the subject's.
std::string ratio_cell(double subject, double other) {
  if (!(subject > 1e-9) || !(other > 1e-9) || !std::isfinite(other / subject)) return "<td>–</td>";
  const double ratio = other / subject;
  const char* style = ratio > 1.02 ? "better" : ratio < 0.98 ? "worse" : "";
  return fmt::format("<td class=\"{}\">× {:.3g}</td>", style, ratio);
}

std::string group_head(const Report& report, int columns) {
  std::string text = "<tr class=\"group\"><th></th>";
  for (std::size_t c = 0; c < report.candidates.size(); ++c)
    text += fmt::format("<th class=\"first\" colspan=\"{}\">{}</th>",
                        c == 0 ? columns : columns + 1, markup_text(report.candidates[c].label));
  return text + "</tr>";
}

std::string column_head(const Report& report, const std::vector<const char*>& names) {
  std::string text = "<tr><th></th>";
  for (std::size_t c = 0; c < report.candidates.size(); ++c) {
    for (std::size_t k = 0; k < names.size(); ++k)
      text += fmt::format("<th{}>{}</th>", k == 0 ? " class=\"first\"" : "", names[k]);
    if (c > 0) text += "<th>vs. first</th>";
  }
  return text + "</tr>";
}

std::string error_table(const Report& report,
                        const std::vector<std::optional<TableError>>& errors) {
  std::string text = "<div class=\"scroll\"><table><thead>" + group_head(report, 4) +
                     column_head(report, {"mean", "median", "p95", "max"}) + "</thead><tbody>";
  for (const Row& row : k_rows) {
    const auto member = field_of(row.field).member;
    text += fmt::format("<tr><th title=\"{}\">{}</th>", markup_text(row.meaning), row.name);
    for (std::size_t c = 0; c < errors.size(); ++c) {
      if (!errors[c]) {
        text += fmt::format("<td class=\"first\" colspan=\"{}\">–</td>", c == 0 ? 4 : 5);
        continue;
      }
      const TableError& e = *errors[c];
      text += fmt::format("<td class=\"first mean\">{}</td><td>{}</td><td>{}</td><td>{}</td>",
                          html_number(e.mean.*member), html_number(e.median.*member),
                          html_number(e.p95.*member), html_number(e.max.*member));
      if (c > 0)
        text += errors[0] ? ratio_cell(errors[0]->mean.*member, e.mean.*member) : "<td>–</td>";
    }
    text += "</tr>";
  }
  return text + "</tbody></table></div>";
}

std::string light_table(const Report& report) {
  struct Line {
    const char* name;
    double LightError::*member;
  };
  constexpr Line lines[] = {{"RMSE", &LightError::rmse},
                            {"mean |error|", &LightError::mean},
                            {"p95", &LightError::p95},
                            {"max", &LightError::max},
                            {"bias (signed mean)", &LightError::bias},
                            {"largest share of its bound", &LightError::of_bound}};
  std::string text =
      "<div class=\"scroll\"><table><thead>" + group_head(report, 1) + "</thead><tbody>";
  for (const Line& l : lines) {
    text += fmt::format("<tr><th>{}</th>", l.name);
    const double subject = report.candidates[0].lights.*l.member;
    for (std::size_t c = 0; c < report.candidates.size(); ++c) {
      const double value = report.candidates[c].lights.*l.member;
      text += fmt::format("<td class=\"first{}\">{}</td>",
                          l.member == &LightError::rmse ? " mean" : "", html_number(value));
      if (c > 0)
        text += l.member == &LightError::of_bound || l.member == &LightError::bias
                    ? "<td></td>"
                    : ratio_cell(subject, value);
    }
    text += "</tr>";
  }
  text += "<tr><th>lights beyond the bound</th>";
  for (std::size_t c = 0; c < report.candidates.size(); ++c)
    text +=
        fmt::format("<td class=\"first\">{} of {}</td>{}", report.candidates[c].lights.violations,
                    report.candidates[c].lights.count, c > 0 ? "<td></td>" : "");
  text += "</tr><tr><th>mean second difference</th>";
  const std::optional<double>& subject = report.candidates[0].second_difference;
  for (std::size_t c = 0; c < report.candidates.size(); ++c) {
    const std::optional<double>& d = report.candidates[c].second_difference;
    text += fmt::format("<td class=\"first\">{}</td>", d ? html_number(*d) : "–");
    if (c > 0) text += d && subject ? ratio_cell(*subject, *d) : "<td>–</td>";
  }
  return text + "</tr></tbody></table></div>";
}

// Where a metric's colours end: the largest 98th percentile of the candidates, so that a few cells
// in a corner do not darken the rest.
double color_top(const RegionReport& region, const LobeErrorField& field) {
  double top = 0;
  for (const ErrorMap& map : region.maps) {
    std::vector<double> values;
    for (const LobeError& e : map.cells)
      if (std::isfinite(e.*field.member)) values.push_back(e.*field.member);
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    top = std::max(top, values[std::size_t(0.98 * double(values.size() - 1))]);
  }
  return top > 1e-6 ? top : 1e-6;
}

std::string maps_of(const Report& report, std::size_t r) {
  const RegionReport& region = report.regions[r];
  std::string text = fmt::format("<div class=\"scroll\"><div class=\"maps\" style=\"grid-template-"
                                 "columns: 92px repeat({}, max-content)\"><div></div>",
                                 std::size(k_mapped));
  for (const char* name : k_mapped)
    text += fmt::format("<div class=\"head\">{}<small>{}</small></div>", row_of(name).name,
                        markup_text(row_of(name).meaning));
  for (std::size_t c = 0; c < report.candidates.size(); ++c) {
    text += "<div class=\"who\">" + markup_text(report.candidates[c].label) + "</div>";
    for (const char* name : k_mapped)
      text += heat_map(region.maps[c], region.region, field_of(name),
                       color_top(region, field_of(name)), r, c,
                       fmt::format("{} of {} over roughness and view angle, {}", row_of(name).name,
                                   report.candidates[c].label, region.name));
  }
  text += "<div></div>";
  for (const char* name : k_mapped)
    text += color_bar(color_top(region, field_of(name)));
  return text + "</div></div>";
}

std::string metadata_of(const Report& report) {
  std::string text = "<div class=\"columns\">";
  for (const CandidateReport& c : report.candidates) {
    text += fmt::format("<section><h3>{}</h3><dl><dt>reading</dt><dd>{}</dd>", markup_text(c.label),
                        horizon_text(c.horizon));
    for (const auto& [name, value] : c.metadata)
      text += fmt::format("<dt>{}</dt><dd>{}</dd>", markup_text(name), markup_text(value));
    text += "</dl></section>";
  }
  return text + "</div>";
}

std::string worst_cell(const Report& report, const WorstCell& cell) {
  const auto three = [](double x) {
    return std::isfinite(x) ? fmt::format("{:.3f}", x) : std::string("–");
  };
  std::string text = fmt::format(
      "<article class=\"cell\"><header><strong>roughness {:.3g}, θ {:.3g}°</strong><span>worst of "
      "{}</span><span>E {}; F = 1: |error| ≤ {} L<sub>max</sub></span></header><div "
      "class=\"lobes\">",
      cell.roughness, cell.theta_degrees, markup_text(report.candidates[cell.of].label),
      html_number(cell.albedo), html_number(cell.errors[cell.of].bound));
  text += "<figure><figcaption><span class=\"key brdf\"></span>ρ/E, the BRDF<small>&nbsp;</small>"
          "</figcaption>" +
          lobe_disc(cell.brdf, cell, "the BRDF’s lobe from above") + "</figure>";
  for (std::size_t c = 0; c < cell.lobes.size(); ++c) {
    text +=
        fmt::format("<figure><figcaption><span class=\"key series{}\"></span>{}<small>TV {} · L2 "
                    "{} · peak {}</small></figcaption>",
                    c % 4, markup_text(report.candidates[c].label), three(cell.errors[c].tv),
                    three(cell.errors[c].l2), three(cell.errors[c].peak));
    text +=
        lobe_disc(cell.lobes[c], cell, report.candidates[c].label + " from above") + "</figure>";
  }
  text += disc_color_bar() + "<figure>" + lobe_cuts(cell) + "</figure>";
  return text + "</div></article>";
}

// The numbers of the maps for the script: four digits, no strings, so nothing to escape.
std::string cell_data(const Report& report) {
  const auto list = [](const auto& values, auto&& get) {
    std::string text = "[";
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double x = get(values[i]);
      text += i > 0 ? "," : "";
      text += std::isfinite(x) ? fmt::format("{:.4g}", x) : std::string("null");
    }
    return text + "]";
  };
  const auto itself = [](double x) { return x; };
  std::string text = "[";
  for (std::size_t r = 0; r < report.regions.size(); ++r) {
    const RegionReport& region = report.regions[r];
    const ErrorMap& first = region.maps.front();
    text += fmt::format("{}{{\"roughness\":{},\"theta\":{},\"albedo\":{},\"candidates\":[",
                        r > 0 ? "," : "", list(first.axes.roughness, itself),
                        list(first.axes.theta_degrees, itself), list(first.albedo, itself));
    for (std::size_t c = 0; c < region.maps.size(); ++c) {
      text += c > 0 ? ",{" : "{";
      const auto fields = lobe_error_fields();
      for (std::size_t k = 0; k < fields.size(); ++k)
        text += fmt::format(
            "{}\"{}\":{}", k > 0 ? "," : "", fields[k].name,
            list(region.maps[c].cells, [&](const LobeError& e) { return e.*fields[k].member; }));
      text += "}";
    }
    text += "]}\n";
  }
  return text + "]";
}

std::string bound_text(const Report& report) {
  const RegionReport& region = report.regions[0];
  return fmt::format(
      "<div class=\"bound\"><p class=\"formula\">|error| ≤ (E · TV + |n1 − E|) · "
      "L<sub>max</sub></p><p>where F = 1, for any light, of any shape and texture, whose radiance "
      "lies between 0 and L<sub>max</sub>: total variation is a guarantee, not only a score. E is "
      "the BRDF’s albedo for F = 1 at that roughness and view angle, n1 what the table holds for "
      "it. For <em>{}</em> over {} the bound is {} L<sub>max</sub> in the mean of the measured "
      "points and {} L<sub>max</sub> at the worst of them; each one’s own value, for its cell’s "
      "midpoint, stands under the pointer in the maps below and in the JSON report. It is as exact "
      "as the quadrature that measures it.</p></div>",
      markup_text(report.candidates[0].label), markup_text(region.name),
      html_number(region.errors[0].mean.bound), html_number(region.errors[0].max.bound));
}

std::string family_text(const LightFamily& f) {
  return fmt::format(
      "{} rectangles from seed {}, all uniform: roughness {}–{}, view angle 0–{}° (along {}), "
      "centre in any direction of the upper hemisphere at distance {}–{}, any orientation, sides "
      "{}–{}; parts below the horizon do not count. Radiance 1 and albedo 1: the figures are "
      "errors of the integral of ρ/E over the light.",
      f.count, f.seed, f.roughness_from, f.roughness_to, f.theta_to_degrees,
      f.angle_axis == table::AngleAxis::theta ? "θ" : "√(1−cos θ)", f.distance_from, f.distance_to,
      f.side_from, f.side_to);
}

} // namespace

std::string to_html(const Report& report) {
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  page += fmt::format("<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
                      markup_text(report.title), k_report_style);
  page += fmt::format("<h1>{}</h1>\n<p class=\"lead\">{}: {}.{}</p>\n", markup_text(report.title),
                      markup_text(report.brdf), markup_text(report.variant),
                      report.source.empty() ? "" : " Source: " + markup_text(report.source) + ".");
  if (!report.command.empty()) page += "<pre>" + markup_text(report.command) + "</pre>\n";
  std::string line;
  if (!report.tool_version.empty()) line += "OpenLTC " + markup_text(report.tool_version) + ". ";
  if (!report.parameter.empty()) line += "Roughness: " + markup_text(report.parameter) + ".";
  page += "<p class=\"note\">" + line + "</p>\n" + metadata_of(report) + bound_text(report);

  page +=
      "<h2>Figures</h2>\n<p>Measured through the look-up that shading uses, on a grid of points "
      "that is not that of a table’s nodes. The factors say how many times the first "
      "candidate’s mean (or single figure) another’s is: green where the first is better by "
      "more than 2 %, orange where it is worse by as much.</p>\n";
  for (const RegionReport& region : report.regions) {
    const MeasureOptions& o = region.region;
    page += fmt::format("<h3>{}, view angle to {}°</h3>\n<p class=\"note\">{} × {} points at the "
                        "midpoints of cells, uniform in roughness and {}.</p>\n",
                        markup_text(region.name), o.theta_to_degrees, o.points, o.points,
                        o.angle_axis == table::AngleAxis::theta ? "θ" : "√(1−cos θ)");
    page += error_table(report, {region.errors.begin(), region.errors.end()});
    if (std::any_of(region.nodes.begin(), region.nodes.end(),
                    [](const auto& e) { return e.has_value(); }))
      page += "<details><summary>The same on those nodes of each table that lie in this "
              "region</summary>" +
              error_table(report, region.nodes) + "</details>\n";
  }
  page += "<h3>Light and smoothness</h3>\n<p class=\"note\">" + family_text(report.lights) +
          " The bound is checked for these lights by themselves and as shading makes them where "
          "F = 1, n1 D against ρ; a light counts as beyond it from what the quadratures may err "
          "by on, " +
          html_number(k_light_tolerance) +
          ". The last row is the mean absolute second difference of M⁻¹ (middle element 1) over "
          "roughness and √(1−cos θ), whatever the packing.</p>\n" +
          light_table(report);

  page += "<h2>Where the errors are</h2>\n<p>One colour scale per column of maps, up to the "
          "largest 98th "
          "percentile of the candidates; brighter is worse. Point at a cell for its figures.</p>\n";
  for (std::size_t r = 0; r < report.regions.size(); ++r)
    page += "<h3>" + markup_text(report.regions[r].name) + "</h3>\n" + maps_of(report, r) + "\n";

  if (!report.worst.empty()) {
    page +=
        "<h2>The worst cells</h2>\n<p>Those of the first region with the largest TV, no two of one "
        "candidate close to each other. Densities of integral 1 seen from above in an equal-area "
        "disc, zoomed to the BRDF’s lobe where it is narrow; the line is the horizon, the cross "
        "the mirror direction, the viewer on the left. Beside them a cut along the plane of "
        "incidence, relative to the BRDF’s peak and cut off at three times it.</p>\n";
    for (const WorstCell& cell : report.worst)
      page += worst_cell(report, cell) + "\n";
  }
  page +=
      "<footer>TV is measured as the integral of max(ρ/E − D, 0), which is ½∫|ρ/E − D| over the "
      "sphere since both integrate to 1. A lobe that a table turns inside out is no "
      "distribution and counts as TV 1, L1 2, L2, L3 and peak 1. Deterministic quadrature and a "
      "fixed family of lights: no byte of this page depends on threads, chance or the "
      "clock.</footer>\n</main>\n<div id=\"tip\"></div>\n";
  page += "<script type=\"application/json\" id=\"cells\">" + cell_data(report) + "</script>\n";
  page += std::string("<script>") + k_report_script + "</script>\n</body>\n</html>\n";
  return page;
}

} // namespace openltc::fit
