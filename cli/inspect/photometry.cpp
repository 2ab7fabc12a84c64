// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc inspect of a photometric file: what its luminaire gives, in the words of the trade.

#include "openltc/light/photometry/photometry.h"

#include "cli/inspect/inspect.h"
#include "openltc/light/photometry/photometry_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace openltc::cli {

namespace {

using Json = nlohmann::ordered_json;
using light::IesProfile;
using light::PhotometricSymmetry;
using light::PhotometricType;

const char* letter_of(PhotometricType type) {
  return type == PhotometricType::a ? "A" : type == PhotometricType::b ? "B" : "C";
}

const char* words_of_symmetry(PhotometricSymmetry symmetry) {
  switch (symmetry) {
  case PhotometricSymmetry::axis:
    return "about the axis";
  case PhotometricSymmetry::both:
    return "about the planes C0-C180 and C90-C270";
  case PhotometricSymmetry::plane_c0:
    return "about the plane C0-C180";
  case PhotometricSymmetry::plane_c90:
    return "about the plane C90-C270";
  default:
    return "none";
  }
}

// LM-63-2002, table 1: lengths that are negative are those of something round.
std::string opening_of(const double (&size)[3]) {
  const double w = std::abs(size[0]), l = std::abs(size[1]), h = std::abs(size[2]);
  if (w == 0 && l == 0 && h == 0) return "a point";
  const bool is_round = size[0] < 0 && size[1] < 0;
  std::string text;
  if (is_round && w == l)
    text = size[2] < 0 && h == w ? fmt::format("a sphere, {:.4g} m across", w)
           : h > 0               ? fmt::format("a cylinder, {:.4g} m across", w)
                                 : fmt::format("a disk, {:.4g} m across", w);
  else
    text = fmt::format("{}{:.4g} m long (along C0) and {:.4g} m wide (along C90)",
                       is_round ? "an ellipse, " : "", l, w);
  const bool is_sphere = size[2] < 0 && h == w;
  if (h > 0 && !is_sphere) text += fmt::format(", {:.4g} m high", h);
  return text;
}

struct Range {
  double from = 0, to = 0;
};

// The file's own angles, as unfolded.
void find_ranges(const IesProfile& profile, Range& vertical, Range& horizontal) {
  const auto first = light::node_angles(profile, 0, 0);
  const auto last = light::node_angles(profile, profile.azimuth_degrees.size() - 1,
                                       profile.polar_degrees.size() - 1);
  vertical = {std::min(first.vertical, last.vertical), std::max(first.vertical, last.vertical)};
  horizontal = {std::min(first.horizontal, last.horizontal),
                std::max(first.horizontal, last.horizontal)};
}

// Where what a file states and what its intensities integrate to are different lamps.
std::vector<std::string> contradictions(const IesProfile& profile,
                                        const light::PhotometricSummary& s,
                                        const std::string& path) {
  constexpr double tolerance = 0.05; // of the flux: coarse steps and rounding make a hundredth
  std::vector<std::string> found;
  const double ratio = profile.lamp_lumens > 0 ? s.flux_lumens / profile.lamp_lumens : 0;
  if (ratio > 1 + tolerance)
    found.push_back(fmt::format("{}: the intensities make {:.5g} lm, more than the lamps' {:.5g}",
                                path, s.flux_lumens, profile.lamp_lumens));
  else if (ratio > 0 && profile.output_ratio > 0 &&
           std::abs(ratio - profile.output_ratio) > tolerance)
    found.push_back(fmt::format("{}: {:.1f} % of the lamps' lumens are stated to leave the "
                                "luminaire, the intensities make it {:.1f} %",
                                path, 100 * profile.output_ratio, 100 * ratio));
  if (profile.downward_share >= 0 &&
      std::abs(profile.downward_share - s.downward_share) > tolerance)
    found.push_back(fmt::format("{}: {:.1f} % of the light are stated to go downwards, the "
                                "intensities make it {:.1f} %",
                                path, 100 * profile.downward_share, 100 * s.downward_share));
  return found;
}

std::string angle(double degrees) {
  return degrees >= 360 ? "everywhere" : fmt::format("{:.1f} degrees", degrees);
}

} // namespace

Result<Description> inspect_photometry(const std::string& path) {
  const Result<IesProfile> profile = light::read_photometry(path);
  if (!profile) return profile.error();
  const light::PhotometricSummary s = light::summarise(*profile);
  const std::string letter = letter_of(profile->type);
  const std::string standard = profile->version.empty() ? "LM-63-1986" : profile->version;
  Range vertical, horizontal;
  find_ranges(*profile, vertical, horizontal);
  const std::size_t vertical_count = profile->type == PhotometricType::b
                                         ? profile->azimuth_degrees.size()
                                         : profile->polar_degrees.size();
  const std::size_t horizontal_count = profile->candela.size() / vertical_count;

  Description out;
  std::string& text = out.text;
  text = fmt::format("photometry, {}, type {}, \"{}\"\n", standard, letter, profile->name);
  text += fmt::format("angles     {} vertical from {:g} to {:g}, {} horizontal from {:g} to {:g} "
                      "degrees, unfolded\n",
                      vertical_count, vertical.from, vertical.to, horizontal_count, horizontal.from,
                      horizontal.to);
  text += fmt::format("symmetry   {}\n", words_of_symmetry(s.symmetry));
  text += fmt::format("flux       {:.5g} lm, integrated over the sphere; {:.1f} % downwards{}\n",
                      s.flux_lumens, 100 * s.downward_share,
                      profile->downward_share < 0
                          ? ""
                          : fmt::format(", {:.1f} % as stated", 100 * profile->downward_share));
  if (profile->lamp_lumens > 0) {
    const double ratio = s.flux_lumens / profile->lamp_lumens;
    text += fmt::format("stated     {} lamp{} of {:.5g} lm together, of which {:.1f} % leave the "
                        "luminaire{}\n",
                        profile->lamp_count, profile->lamp_count == 1 ? "" : "s",
                        profile->lamp_lumens, 100 * ratio,
                        profile->output_ratio < 0
                            ? ""
                            : fmt::format(", {:.1f} % as stated", 100 * profile->output_ratio));
  } else {
    text += "stated     no lumens of lamps: absolute photometry\n";
  }
  text += fmt::format(
      "peak       {:.5g} cd at {} {:.4g}, {} {:.4g} degrees{}\n", s.peak_candela,
      profile->type == PhotometricType::c ? "gamma" : "V", s.peak.vertical,
      profile->type == PhotometricType::c ? "C" : "H", s.peak.horizontal,
      profile->type == PhotometricType::c
          ? ""
          : fmt::format(" (gamma {:.4g}, C {:.4g})", s.peak_c.vertical, s.peak_c.horizontal));
  text += fmt::format("beam       to 50 % of the plane's maximum: C0-C180 {}, C90-C270 {}\n",
                      angle(s.beam_degrees[0]), angle(s.beam_degrees[1]));
  text += fmt::format("field      to 10 %: C0-C180 {}, C90-C270 {}\n", angle(s.field_degrees[0]),
                      angle(s.field_degrees[1]));
  text += fmt::format("opening    {}\n", opening_of(profile->size_metres));
  if (profile->input_watts > 0)
    text += fmt::format("power      {:.4g} W, {:.4g} lm/W\n", profile->input_watts,
                        s.flux_lumens / profile->input_watts);
  for (const auto& [key, value] : profile->keywords)
    if (!value.empty()) text += fmt::format("keyword    [{}] {}\n", key, value);
  std::vector<std::string> warnings = profile->warnings;
  for (const std::string& contradiction : contradictions(*profile, s, path))
    warnings.push_back(contradiction);
  for (const std::string& warning : warnings)
    text += fmt::format("warning    {}\n", warning);

  const auto or_null = [](double number) { return number < 0 ? Json() : Json(number); };
  Json& json = out.json;
  json = {{"file", path},
          {"kind", "photometry"},
          {"standard", standard},
          {"type", letter},
          {"name", profile->name},
          {"vertical_degrees",
           {{"count", vertical_count}, {"from", vertical.from}, {"to", vertical.to}}},
          {"horizontal_degrees",
           {{"count", horizontal_count}, {"from", horizontal.from}, {"to", horizontal.to}}},
          {"symmetry", words_of_symmetry(s.symmetry)},
          {"flux_lumens", s.flux_lumens},
          {"downward_share", s.downward_share},
          {"stated_downward_share", or_null(profile->downward_share)},
          {"lamp_count", profile->lamp_count},
          {"lamp_lumens", known_or_null(profile->lamp_lumens)},
          {"stated_output_ratio", or_null(profile->output_ratio)},
          {"peak_candela", s.peak_candela},
          {"peak_vertical_degrees", s.peak.vertical},
          {"peak_horizontal_degrees", s.peak.horizontal},
          {"peak_gamma_degrees", s.peak_c.vertical},
          {"peak_c_degrees", s.peak_c.horizontal},
          {"beam_degrees", Json::array({s.beam_degrees[0], s.beam_degrees[1]})},
          {"field_degrees", Json::array({s.field_degrees[0], s.field_degrees[1]})},
          {"opening_m", Json::array({profile->size_metres[0], profile->size_metres[1],
                                     profile->size_metres[2]})},
          {"input_watts", known_or_null(profile->input_watts)},
          {"keywords", Json::array()},
          {"warnings", warnings}};
  for (const auto& [key, value] : profile->keywords)
    json["keywords"].push_back(Json::array({key, value}));
  return out;
}

} // namespace openltc::cli
