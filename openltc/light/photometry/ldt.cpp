// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources: A. W. Stockmar 1990, "EULUMDAT - ein Leuchtendatenformat fuer den europaeischen
// Beleuchtungsplaner", Licht '90, and its specification as Helios32 and AGi32 print it; absolute
// photometry: Ashdown, Lighting Analysts and DIAL 2009, "Handling of absolute photometry data in
// EULUMDAT files". One item to a line:
//
//    1 company   2 type   3 Isym   4 Mc, count of C-planes   5 their step   6 Ng, count of gamma
//    7 its step   8 report   9 luminaire   10 its number   11 file   12 date and user
//   13 - 15 length, width, height in mm   16 - 21 of the luminous area, four heights
//   22 downward share in %   23 light output ratio in %   24 conversion factor   25 tilt
//   26 sets of lamps, for each: count, type, lumens of all, colour, rendering, watts
//   27 ten direct ratios   28 Mc angles C   29 Ng angles gamma   30 cd per 1000 lm[C][gamma]
//
// All C angles are there; intensities are there for the planes Mc1 to Mc2, counted from 1:
//   Isym 0: 1 to Mc   1: 1   2: 1 to Mc/2 + 1   3: 3 Mc/4 + 1 to 3 Mc/4 + 1 + Mc/2   4: 1 to Mc/4 +
//   1
// where those of 3 run from C270 through C0 to C90. With several sets of lamps, some programs write
// set by set and others item by item; where numbers stand tells which.

#include "openltc/light/photometry/ldt.h"

#include "openltc/light/photometry/ies_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace openltc::light {

namespace {

constexpr int k_max_sets = 100, k_items_per_set = 6;
constexpr double k_metres_per_millimetre = 1e-3;
constexpr double k_tolerance = 0.01; // degrees

// A whole line as a number, with a decimal point or comma.
bool parse_number(std::string_view text, double& value) {
  std::string digits(trimmed(text.substr(0, 64)));
  if (std::count(digits.begin(), digits.end(), ',') == 1 && digits.find('.') == std::string::npos)
    digits[digits.find(',')] = '.';
  const std::size_t sign = digits.size() > 1 && digits[0] == '+' && digits[1] != '-' ? 1 : 0;
  const char* const end = digits.data() + digits.size();
  const auto parsed = std::from_chars(digits.data() + sign, end, value);
  return parsed.ec == std::errc() && parsed.ptr == end && std::isfinite(value);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  text = text.substr(0, text.find('\x1a')); // DOS ends text by Ctrl-Z
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    const bool two = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    text.remove_prefix(end + (two ? 2 : 1));
  }
  return lines;
}

class Reader {
public:
  Reader(std::string_view text, const std::string& name) : lines_(lines_of(text)), name_(name) {}

  Result<IesProfile> read() {
    IesProfile profile;
    // Each step leaves the first error behind and the later ones do nothing.
    read_head(profile);
    read_lamps(profile);
    std::vector<double> planes, gamma, rows;
    read_angles(planes, plane_count_, "C angle", 360);
    read_angles(gamma, gamma_count_, "gamma angle", 180);
    const AngleRows circle = unfold(planes);
    read_intensities(rows, profile);
    if (!good()) return Error{error_};
    take_rows(gamma, circle, rows, profile);
    if (Status ok = finish_profile(profile, name_); !ok) return ok.error();
    return profile;
  }

private:
  std::vector<std::string_view> lines_;
  const std::string& name_;
  std::size_t next_ = 0; // line to read
  std::string error_;
  int symmetry_ = 0;
  std::size_t plane_count_ = 0, gamma_count_ = 0, row_count_ = 0;
  double candela_per_value_ = 1, conversion_ = 1;

  bool good() const { return error_.empty(); }

  void fail(const std::string& what) {
    if (good()) error_ = fmt::format("{}:{}: {}", name_, std::max<std::size_t>(next_, 1), what);
  }

  std::string_view text(const char* what) {
    if (!good()) return {};
    if (next_ >= lines_.size()) {
      fail(fmt::format("the file ends where the {} should stand; it is cut off or no EULUMDAT file",
                       what));
      return {};
    }
    return trimmed(lines_[next_++]);
  }

  double number(const char* what, double least, double most) {
    const std::string_view line = text(what);
    double value = 0;
    if (!good()) return 0;
    if (!parse_number(line, value))
      fail(fmt::format("\"{}\" is not a number; the {} should stand there", printable(line, 24),
                       what));
    else if (value < least || value > most)
      fail(fmt::format("the {} {} is not within {} .. {}", what, value, least, most));
    return good() ? value : 0;
  }

  // What is not needed may be empty, or any text.
  double number_or(const char* what, double otherwise) {
    double value = 0;
    const bool is_number = parse_number(text(what), value) && std::abs(value) <= 1e9;
    return is_number ? value : otherwise;
  }

  int whole_number(const char* what, double least, double most) {
    const double value = number(what, least, most);
    if (value != std::floor(value)) fail(fmt::format("the {} {} is not whole", what, value));
    return int(value);
  }

  void read_head(IesProfile& profile) {
    profile.version = "EULUMDAT";
    const auto keyword = [&](const char* key, const char* what) {
      const std::string value = printable(text(what), 256);
      if (!value.empty()) profile.keywords.emplace_back(key, value);
      return value;
    };
    keyword("MANUFAC", "company");
    number_or("type of the light source", 0);
    symmetry_ = whole_number("symmetry Isym", 0, 4);
    plane_count_ = std::size_t(whole_number("count of C-planes", 1, k_max_angle_count));
    number_or("step of the C-planes", 0);
    gamma_count_ = std::size_t(whole_number("count of gamma angles", 2, k_max_angle_count));
    number_or("step of the gamma angles", 0);
    if (good()) count_rows();
    keyword("TEST", "report's number");
    profile.name = keyword("LUMINAIRE", "luminaire's name");
    keyword("LUMCAT", "luminaire's number");
    text("file's name");
    keyword("ISSUEDATE", "date");
    if (profile.name.empty()) profile.name = std::filesystem::path(name_).stem().string();
    for (const char* what : {"luminaire's length", "luminaire's width", "luminaire's height"})
      number_or(what, 0);
    read_size(profile);
    profile.downward_share = share_or_unknown(number_or("downward share", -1));
    profile.output_ratio = share_or_unknown(number_or("light output ratio", -1));
    conversion_ = number("conversion factor", 0, k_max_photometric_value);
    number_or("tilt", 0);
  }

  static double share_or_unknown(double percent) { return percent > 0 ? percent / 100 : -1; }

  void read_size(IesProfile& profile) {
    const double length = number_or("length of the luminous area", 0) * k_metres_per_millimetre;
    const double width = number_or("width of the luminous area", 0) * k_metres_per_millimetre;
    double height = 0;
    for (int i = 0; i < 4; ++i)
      height = std::max(height, number_or("height of the luminous area", 0));
    const bool is_round = length > 0 && width == 0;
    profile.size_metres[0] = is_round ? -length : length;
    profile.size_metres[1] = is_round ? -length : width;
    profile.size_metres[2] = height * k_metres_per_millimetre;
  }

  void count_rows() {
    const std::size_t planes = plane_count_;
    const std::size_t parts = symmetry_ == 2 ? 2 : symmetry_ >= 3 ? 4 : 1;
    if (planes % parts != 0)
      fail(fmt::format("{} C-planes cannot be halved and quartered as symmetry Isym = {} asks",
                       planes, symmetry_));
    row_count_ = symmetry_ == 0   ? planes
                 : symmetry_ == 1 ? 1
                 : symmetry_ == 4 ? planes / 4 + 1
                                  : planes / 2 + 1;
    const double directions = double(row_count_) * double(gamma_count_);
    if (directions > k_max_directions)
      fail(fmt::format("{} directions are more than {}", directions, k_max_directions));
    if (directions + double(plane_count_ + gamma_count_) > double(lines_.size()))
      fail(fmt::format("the file is too short for {} C-planes of {} gamma angles", row_count_,
                       gamma_count_));
  }

  void read_lamps(IesProfile& profile) {
    const int sets = whole_number("count of sets of lamps", 1, k_max_sets);
    if (!good()) return;
    const std::size_t first = next_, items = std::size_t(sets) * k_items_per_set;
    if (lines_.size() - first < items) {
      fail(fmt::format("the file ends within its {} sets of lamps", sets));
      return;
    }
    // Item i of a set stands at i + 6 set, or at i sets + set.
    const auto line_of = [&](bool by_set, int item, int set) {
      return first + std::size_t(by_set ? item + k_items_per_set * set : item * sets + set);
    };
    const auto is_readable = [&](bool by_set) {
      double value = 0;
      for (int set = 0; set < sets; ++set)
        for (const int item : {0, 2})
          if (!parse_number(lines_[line_of(by_set, item, set)], value)) return false;
      return true;
    };
    const bool by_set = is_readable(true) || !is_readable(false);
    const auto item = [&](int index, int set, const char* what) {
      next_ = line_of(by_set, index, set);
      return number(what, index == 0 ? -1e6 : 0, k_max_photometric_value);
    };
    const double lamps = item(0, 0, "count of lamps");
    const double lumens = item(2, 0, "count of lumens");
    if (good() && !(lumens > 0)) fail("the lamps have 0 lumens, so that there is no light");
    double others = lumens;
    for (int set = 1; set < sets && good(); ++set)
      if (const double l = item(2, set, "count of lumens"); l != lumens) others = l;
    if (good() && others != lumens)
      profile.warnings.push_back(fmt::format(
          "{}: of its {} sets of lamps the first is used, which has {:g} lm", name_, sets, lumens));
    profile.lamp_count = std::clamp(int(std::abs(lamps)), 1, 1000000);
    profile.lamp_lumens = lamps < 0 ? 0 : lumens;
    const std::string lamp = printable(trimmed(lines_[line_of(by_set, 1, 0)]), 256);
    if (!lamp.empty()) profile.keywords.emplace_back("LAMP", lamp);
    double watts = 0;
    const bool has_watts = parse_number(lines_[line_of(by_set, 5, 0)], watts) && watts >= 0;
    profile.input_watts = has_watts ? std::min(watts, k_max_photometric_value) : 0;
    candela_per_value_ = conversion_ * lumens / 1000;
    next_ = first + items;
    for (int i = 0; i < 10; ++i)
      number_or("direct ratio", 0);
  }

  void read_angles(std::vector<double>& angles, std::size_t count, const char* what, double most) {
    for (std::size_t i = 0; i < count && good(); ++i) {
      const double angle = number(what, 0, most);
      if (good() && i > 0 && angle <= angles.back())
        fail(fmt::format("the {} {} follows {}; angles must ascend", what, angle, angles.back()));
      angles.push_back(angle);
    }
  }

  // The whole circle; from C270 on where Isym is 3.
  AngleRows unfold(const std::vector<double>& planes) {
    AngleRows circle;
    if (!good()) return circle;
    const auto expect = [&](std::size_t index, double degrees) {
      if (std::abs(planes[index] - degrees) > k_tolerance)
        fail(fmt::format("plane {} of {} is C{:g}; with symmetry Isym = {} it must be C{:g}",
                         index + 1, plane_count_, planes[index], symmetry_, degrees));
      return degrees;
    };
    const std::size_t half = plane_count_ / 2, quarter = plane_count_ / 4;
    expect(0, 0);
    if (symmetry_ == 1 || plane_count_ == 1) {
      circle.add(0, 0);
      return circle;
    }
    if (symmetry_ == 3) {
      expect(quarter, 90);
      expect(3 * quarter, 270);
      for (std::size_t i = 0; i <= half; ++i) {
        const std::size_t plane = (3 * quarter + i) % plane_count_;
        circle.add(planes[plane] + (plane < 3 * quarter ? 360 : 0), i);
      }
      circle.degrees.front() = 270;
      circle.degrees.back() = 450;
      circle.unfold(); // on to 630, which is 270 again
      return circle;
    }
    for (std::size_t i = 0; i < row_count_; ++i)
      circle.add(planes[i], i);
    circle.degrees.front() = 0;
    if (symmetry_ == 0) {
      double largest_step = 0;
      for (std::size_t i = 1; i < planes.size(); ++i)
        largest_step = std::max(largest_step, planes[i] - planes[i - 1]);
      if (planes.back() >= 360 - k_tolerance)
        circle.degrees.back() = 360;
      else if (360 - planes.back() <= 1.5 * largest_step)
        circle.add(360, 0);
      else
        fail(fmt::format("the C-planes end at C{:g}; without symmetry, Isym = 0, they go around",
                         planes.back()));
      return circle;
    }
    circle.degrees.back() = expect(row_count_ - 1, symmetry_ == 2 ? 180 : 90);
    circle.unfold();
    if (symmetry_ == 4) circle.unfold();
    return circle;
  }

  void read_intensities(std::vector<double>& rows, IesProfile& profile) {
    const std::size_t first = next_, count = row_count_ * gamma_count_;
    for (std::size_t i = 0; i < count && good(); ++i) {
      const double value = number("intensity", -k_max_photometric_value, k_max_photometric_value) *
                           candela_per_value_;
      if (good() && std::abs(value) > k_max_photometric_value)
        fail(fmt::format("{} candela after all factors are more than {}", value,
                         k_max_photometric_value));
      rows.push_back(value);
    }
    if (!good()) return;
    if (const std::size_t wrong = clamp_noise(rows, name_, profile.warnings); wrong < count) {
      next_ = first + wrong + 1;
      return fail("the intensity is too far below 0 for noise of the measurement");
    }
    while (next_ < lines_.size() && trimmed(lines_[next_]).empty())
      ++next_;
    if (next_ >= lines_.size()) return;
    double value = 0;
    const std::string_view rest = trimmed(lines_[next_++]);
    if (parse_number(rest.substr(0, rest.find(' ')), value))
      return fail("numbers are left over after the last intensity; the counts are wrong");
    profile.warnings.push_back(
        fmt::format("{}:{}: the text after the last intensity, \"{}\", is ignored", name_, next_,
                    printable(rest, 60)));
  }
};

} // namespace

Result<IesProfile> parse_ldt(std::string_view text, const std::string& name) {
  return Reader(text, name).read();
}

} // namespace openltc::light
