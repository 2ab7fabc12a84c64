// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// The report's writers: complete, well-formed, self-contained, and safe with any text and number.

#include "openltc/fit/report/report.h"
#include "openltc/image/file.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

using namespace openltc;

namespace {

const std::string k_nasty = "a<b> & \"c\" 'd' </script><script>alert(1)</script> \\ \xff\x01 é";

fit::LobeFunction cosine() {
  return [](double, double) {
    f64::FittedLobe fitted;
    fitted.lobe = f64::cosine_lobe();
    fitted.n1 = 1;
    fitted.n5 = 0.5;
    return fitted;
  };
}

fit::ReportOptions small_options() {
  fit::ReportOptions options;
  for (fit::MeasureOptions& region : options.regions) {
    region.points = 6;
    region.quadrature = {16, 16};
  }
  options.lights.count = 40;
  options.smoothness_points = 8;
  options.command = "openltc fit --against \"" + k_nasty + "\"";
  options.tool_version = "1.2.3";
  return options;
}

std::vector<fit::Candidate> candidates() {
  fit::Candidate own, other, limit;
  own.label = "this table";
  own.lobes = fit::lobes_of(table::builtin_ggx_table());
  own.horizon = fit::Horizon::clipped;
  own.metadata = {{"objective", "balanced"}, {k_nasty, k_nasty}};
  own.nodes = fit::node_axes(table::builtin_ggx_table(), {});
  other.label = k_nasty;
  other.lobes = cosine();
  limit.label = "best single lobe";
  limit.lobes = own.lobes;
  limit.is_limit = true;
  return {own, other, limit};
}

const fit::Report& report() {
  static const fit::Report made =
      *fit::make_report(*brdf::find_brdf("ggx"), candidates(), small_options());
  return made;
}

// Elements of HTML 5 with text inside, well nested; void elements closed or not; quoted attributes.
// Returns what is wrong, or nothing.
std::string fault_of(const std::string& html, std::vector<std::string>& attributes) {
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = html.find('<', at)) != std::string::npos) {
    if (html.compare(at, 2, "<!") == 0) {
      at = html.find('>', at);
      continue;
    }
    const bool closing = html[at + 1] == '/';
    std::size_t i = at + 1 + (closing ? 1 : 0);
    std::string name;
    while (i < html.size() && std::isalnum(static_cast<unsigned char>(html[i])) != 0)
      name += html[i++];
    if (name.empty()) return "a bare < near " + html.substr(at, 40);
    char quote = 0;
    std::string attribute;
    for (; i < html.size() && (quote != 0 || html[i] != '>'); ++i) {
      if (html[i] == '"') quote = quote != 0 ? 0 : '"';
      if (quote != 0 && html[i] == '<') return "a < in an attribute of " + name;
      attribute += html[i];
    }
    if (i >= html.size()) return name + " does not end";
    const bool self_closing = html[i - 1] == '/';
    attributes.push_back(attribute);
    at = i + 1;
    if (closing) {
      if (open.empty() || open.back() != name)
        return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    } else if (!self_closing && name != "meta" && name != "br") {
      open.push_back(name);
      if (name == "script" || name == "style") at = html.find("</" + name, at);
    }
  }
  return open.empty() ? "" : open.back() + " is not closed";
}

std::vector<std::uint8_t> bytes_from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  unsigned word = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) break;
    word = (word << 6) | unsigned(digit);
    if ((bits += 6) >= 8) bytes.push_back(std::uint8_t(word >> (bits -= 8)));
  }
  return bytes;
}

} // namespace

TEST_CASE("the JSON report parses and has every figure") {
  const nlohmann::json json = nlohmann::json::parse(fit::to_json(report()));
  for (const char* key : {"title", "command", "tool_version", "brdf", "bound", "bound_tolerance",
                          "light_family", "candidates", "regions", "worst_cells"})
    CHECK(json.contains(key));
  CHECK(json["tool_version"] == "1.2.3");
  CHECK_FALSE(json.contains("fit_seconds")); // it would differ from run to run
  REQUIRE(json["candidates"].size() == 3);
  CHECK(json["candidates"][0]["horizon"] == "clipped");
  CHECK(json["candidates"][1]["horizon"] == "leaking");
  CHECK(json["candidates"][2]["second_difference"].is_null());
  for (const auto& c : json["candidates"])
    for (const char* key : {"rmse", "mean", "p95", "max", "bias", "bound_violations",
                            "largest_share_of_bound", "mean_light"})
      CHECK(c["lights"][key].is_number());
  REQUIRE(json["regions"].size() == 2);
  for (const auto& region : json["regions"]) {
    CHECK(region["axes"]["roughness"].size() == 6);
    CHECK(region["albedo"].size() == 36);
    REQUIRE(region["candidates"].size() == 3);
    for (const auto& c : region["candidates"])
      for (const char* field : {"tv", "bound", "l1", "l2", "l3", "peak", "leak", "n1", "n5"}) {
        for (const char* statistic : {"mean", "median", "p95", "max"})
          CHECK(c["between_nodes"][statistic][field].is_number());
        CHECK(c["cells"][field].size() == 36);
      }
    // Every cell's bound follows from what stands beside it, to the digits written.
    for (const auto& c : region["candidates"])
      for (std::size_t i = 0; i < 36; ++i)
        CHECK(double(c["cells"]["bound"][i]) ==
              doctest::Approx(double(region["albedo"][i]) * double(c["cells"]["tv"][i]) +
                              double(c["cells"]["n1"][i]))
                  .epsilon(1e-4));
    CHECK(region["candidates"][1]["on_nodes"].is_null());
  }
  CHECK(json["regions"][0]["candidates"][0]["on_nodes"]["mean"]["tv"].is_number());
  CHECK(json["worst_cells"].size() >= 4);
  CHECK(double(json["regions"][0]["candidates"][0]["between_nodes"]["mean"]["tv"]) ==
        doctest::Approx(report().regions[0].errors[0].mean.tv).epsilon(1e-5));
}

TEST_CASE("the page is well-formed, needs nothing but itself and escapes every text") {
  const std::string html = fit::to_html(report());
  std::vector<std::string> attributes;
  CHECK(fault_of(html, attributes) == "");
  CHECK(html.find("http://") == std::string::npos);
  CHECK(html.find("https://") == std::string::npos);
  CHECK(html.find("@import") == std::string::npos);
  CHECK(html.find("url(") == std::string::npos);
  for (const std::string& a : attributes) {
    CHECK(a.find("src=") == std::string::npos);
    const std::size_t href = a.find("href=");
    if (href != std::string::npos) CHECK(a.compare(href, 15, "href=\"data:imag") == 0);
  }
  CHECK(html.find("alert(1)</script>") == std::string::npos);
  CHECK(html.find("&lt;/script&gt;&lt;script&gt;alert(1)") != std::string::npos);
  CHECK(html.find('\xff') == std::string::npos);
  CHECK(html.find('\x01') == std::string::npos);
  CHECK(html.find("é") != std::string::npos);
  // Every metric's map for every candidate and region, and the bound in words.
  std::size_t maps = 0;
  for (std::size_t at = 0; (at = html.find("class=\"map\"", at)) != std::string::npos; ++at)
    ++maps;
  CHECK(maps == 4 * 3 * 2);
  CHECK(html.find("|error| ≤ (E · TV + |n1 − E|) · L") != std::string::npos);
  CHECK(html.find("where F = 1") != std::string::npos);
  CHECK(html.find("Fitted in") == std::string::npos);
}

TEST_CASE("the script's numbers are JSON and agree with the cells") {
  const std::string html = fit::to_html(report());
  const std::string open = "<script type=\"application/json\" id=\"cells\">";
  const std::size_t from = html.find(open) + open.size();
  const auto json = nlohmann::json::parse(html.substr(from, html.find("</script>", from) - from));
  REQUIRE(json.size() == 2);
  CHECK(double(json[0]["candidates"][1]["tv"][7]) ==
        doctest::Approx(report().regions[0].maps[1].cells[7].tv).epsilon(1e-3));
  CHECK(double(json[0]["candidates"][1]["bound"][7]) ==
        doctest::Approx(report().regions[0].maps[1].cells[7].bound).epsilon(1e-3));
}

TEST_CASE("the page's pictures are PNG files that libpng reads, of the right size") {
  const std::string html = fit::to_html(report());
  const std::string open = "data:image/png;base64,";
  int heat_maps = 0, discs = 0;
  for (std::size_t at = 0; (at = html.find(open, at)) != std::string::npos;) {
    at += open.size();
    const auto bytes = bytes_from_base64(html.substr(at, html.find('"', at) - at));
    const auto picture = image::decode(bytes, "picture", true);
    REQUIRE_MESSAGE(picture.ok(), (picture.ok() ? "" : picture.error().message));
    heat_maps += picture->width == 6 && picture->height == 6;
    discs += picture->width == fit::WorstCell::k_side;
  }
  CHECK(heat_maps == 24);
  CHECK(discs == int(report().worst.size()) * 4);
}

TEST_CASE("neither NaN nor infinity gets into an output") {
  fit::Report broken = report();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  broken.regions[0].errors[0].mean.tv = nan;
  broken.regions[0].errors[1].max.l2 = inf;
  broken.regions[0].maps[0].cells[3].tv = nan;
  broken.regions[0].maps[1].cells[4].peak = inf;
  broken.candidates[0].lights.rmse = nan;
  broken.candidates[1].second_difference = -inf;
  broken.worst[0].errors[0].tv = nan;
  broken.worst[0].lobes[0].disc[100] = nan;
  broken.worst[0].lobes[0].cut[5] = inf;
  broken.worst[0].lobes[1].cut[6] = nan;
  const std::string json = fit::to_json(broken);
  CHECK(nlohmann::json::accept(json));
  for (std::string text : {json, fit::to_html(broken), fit::to_text(broken)}) {
    // Base 64 may spell anything.
    for (std::size_t at; (at = text.find("base64,")) != std::string::npos;)
      text.erase(at, text.find('"', at) - at);
    CHECK(text.find("nan") == std::string::npos);
    CHECK(text.find(">inf") == std::string::npos);
    CHECK(text.find("-inf") == std::string::npos);
    CHECK(text.find(" inf") == std::string::npos);
    CHECK(text.find(",inf") == std::string::npos);
  }
}

TEST_CASE("the terminal's table names every candidate and figure") {
  const std::string text = fit::to_text(report());
  for (const char* word : {"this table", "best single lobe", "tv", "bound", "l2", "peak", "leak",
                           "rmse", "second difference", "roughness 0.06–1", "roughness 0.01–0.06"})
    CHECK(text.find(word) != std::string::npos);
}

TEST_CASE("the worst cells are the worst, shown with the true lobe") {
  const fit::Report& r = report();
  REQUIRE(!r.worst.empty());
  CHECK(r.worst[0].errors[0].tv == r.regions[0].errors[0].max.tv);
  for (const fit::WorstCell& cell : r.worst) {
    REQUIRE(cell.lobes.size() == 3);
    CHECK(cell.brdf.disc.size() == fit::WorstCell::k_side * fit::WorstCell::k_side);
    double top = 0;
    for (const double v : cell.brdf.cut)
      top = std::max(top, v);
    // The cut passes through the peak, which lies in the plane of incidence.
    CHECK(top == doctest::Approx(cell.peak).epsilon(0.1));
    // The third candidate's lobes are the first's, which is read as clipped.
    const double ratio = cell.lobes[0].cut[120] / cell.lobes[2].cut[120];
    CHECK(ratio == doctest::Approx(1 / (1 - cell.errors[0].leak)).epsilon(1e-6));
  }
}

TEST_CASE("the same report again, byte for byte; and what cannot be reported on") {
  const auto again = fit::make_report(*brdf::find_brdf("ggx"), candidates(), small_options());
  CHECK(fit::to_json(*again) == fit::to_json(report()));
  CHECK(fit::to_html(*again) == fit::to_html(report()));
  CHECK_FALSE(fit::make_report(*brdf::find_brdf("ggx"), {}, small_options()).ok());
  fit::ReportOptions nowhere = small_options();
  nowhere.regions.clear();
  CHECK_FALSE(fit::make_report(*brdf::find_brdf("ggx"), candidates(), nowhere).ok());
}
