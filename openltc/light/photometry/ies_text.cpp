// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Source: ANSI/IES LM-63 in its versions of 1986, 1991, 1995, 2002 and 2019.
//
//   IESNA:LM-63-2002                first line, absent in 1986
//   [KEYWORD] text                  any number; free text in 1986; [MORE] continues the one before
//   TILT=NONE | INCLUDE | file
//   geometry, count, angles, factors                                   with INCLUDE only
//   lamps, lumens per lamp, multiplier, vertical count, horizontal count, type, units, w, l, h
//   ballast factor, ballast-lamp photometric factor, watts
//   vertical angles, horizontal angles, candela[horizontal][vertical]
//
// From TILT on there are only numbers, parted by blanks, commas and line ends. In 2002 the field
// after the ballast factor is reserved, in 2019 it tells how the file was made: neither multiplies.
// Tools leave words of their own behind the last value; what begins by a number there is something
// else, counts that are wrong.

#include "openltc/light/photometry/ies_text.h"

#include "openltc/light/photometry/ies_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace openltc::light {

namespace {

constexpr std::size_t k_max_keywords = 1024;
constexpr double k_metres_per_foot = 0.3048;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\f' || c == '\v'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

std::string upper(std::string_view s) {
  std::string out(s);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
  return out;
}

class Reader {
public:
  Reader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<IesText> read() {
    IesText file;
    // Each step leaves the first error behind and the later ones do nothing.
    read_head(file);
    const double scale = read_lamp(file);
    switch (file.type) {
    case PhotometricType::a:
      read_angles(file.vertical_degrees, vertical_count_, "vertical", -90, 90);
      read_angles(file.horizontal_degrees, horizontal_count_, "horizontal", -180, 180);
      break;
    case PhotometricType::b:
      read_angles(file.vertical_degrees, vertical_count_, "vertical", -180, 180);
      read_angles(file.horizontal_degrees, horizontal_count_, "horizontal", -90, 90);
      break;
    default:
      read_angles(file.vertical_degrees, vertical_count_, "vertical", 0, 180);
      read_angles(file.horizontal_degrees, horizontal_count_, "horizontal", 0, 360);
    }
    read_candela(file, scale);
    if (good() && !at_end()) read_rest(file);
    if (!good()) return Error{error_};
    return file;
  }

private:
  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::string error_;
  std::size_t vertical_count_ = 0, horizontal_count_ = 0;

  bool good() const { return error_.empty(); }

  void fail(const std::string& what) {
    if (good()) error_ = fmt::format("{}:{}: {}", name_, line_, what);
  }

  // The rest of the line; what ends it, \n, \r or \r\n, is consumed.
  std::string_view take_line() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_line_end(text_[at_]))
      ++at_;
    const std::string_view line = text_.substr(begin, at_ - begin);
    skip_line_end();
    return line;
  }

  void skip_line_end() {
    if (at_ >= text_.size()) return;
    const bool two = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
    at_ += two ? 2 : 1;
    ++line_;
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (is_line_end(text_[at_]))
        skip_line_end();
      else if (is_blank(text_[at_]))
        ++at_;
      else
        break;
    }
  }

  // DOS ends text by Ctrl-Z; some tools pad with zeros.
  bool at_end() {
    skip_blanks();
    return at_ >= text_.size() || text_[at_] == '\x1a' || text_[at_] == '\0';
  }

  void read_candela(IesText& file, double scale) {
    const std::size_t count = vertical_count_ * horizontal_count_;
    std::vector<std::size_t> line_of;
    file.candela.reserve(count);
    line_of.reserve(count);
    for (std::size_t i = 0; i < count && good(); ++i) {
      const double value =
          number("candela value", -k_max_photometric_value, k_max_photometric_value) * scale;
      if (good() && std::abs(value) > k_max_photometric_value)
        fail(fmt::format("{} candela after all factors are more than {}", value,
                         k_max_photometric_value));
      file.candela.push_back(value);
      line_of.push_back(line_);
    }
    if (!good()) return;
    const std::size_t wrong = clamp_noise(file.candela, name_, file.warnings);
    if (wrong >= file.candela.size()) return;
    line_ = line_of[wrong];
    fail(fmt::format("the candela value {} is too far below 0 for noise of the measurement",
                     file.candela[wrong]));
  }

  // Behind the last value.
  void read_rest(IesText& file) {
    double value = 0;
    if (parse(next_token(), value))
      return fail("numbers are left over after the last candela value; the counts are wrong");
    const std::size_t line = line_;
    file.warnings.push_back(
        fmt::format("{}:{}: the text after the last candela value, \"{}\", is ignored", name_, line,
                    printable(trimmed(take_line()), 60)));
  }

  std::string_view next_token() const {
    std::size_t end = at_;
    while (end < text_.size() && !is_blank(text_[end]) && !is_line_end(text_[end]))
      ++end;
    return text_.substr(at_, end - at_);
  }

  static bool parse(std::string_view token, double& value) {
    const std::size_t sign = token.size() > 1 && token[0] == '+' && token[1] != '-' ? 1 : 0;
    const auto parsed = std::from_chars(token.data() + sign, token.data() + token.size(), value);
    return parsed.ec == std::errc() && parsed.ptr == token.data() + token.size() &&
           std::isfinite(value);
  }

  double number(const char* what, double least, double most) {
    if (!good()) return 0;
    if (at_end()) {
      fail(fmt::format("the file ends where a {} should stand", what));
      return 0;
    }
    const std::string_view token = next_token();
    double value = 0;
    if (!parse(token, value)) {
      fail(fmt::format("\"{}\" is not a number; a {} should stand there", printable(token, 24),
                       what));
      return 0;
    }
    if (value < least || value > most) {
      fail(fmt::format("the {} {} is not within {} .. {}", what, value, least, most));
      return 0;
    }
    at_ += token.size();
    return value;
  }

  int whole_number(const char* what, double least, double most) {
    const double value = number(what, least, most);
    if (value != std::floor(value)) fail(fmt::format("the {} {} is not whole", what, value));
    return int(value);
  }

  void read_head(IesText& file) {
    if (text_.substr(0, 3) == "\xef\xbb\xbf") at_ = 3;
    while (at_ < text_.size() && good()) {
      const std::size_t begin_line = line_;
      const std::string_view line = trimmed(take_line());
      const std::string_view after_tilt =
          upper(line.substr(0, 4)) == "TILT" ? trimmed(line.substr(4)) : std::string_view();
      if (!after_tilt.empty() && after_tilt.front() == '=') {
        const std::string tilt = upper(trimmed(after_tilt.substr(1)));
        if (tilt == "INCLUDE") return read_tilt();
        if (tilt == "NONE") return;
        line_ = begin_line;
        return fail(fmt::format("TILT={}: tilt factors in a file of their own are not read; use "
                                "TILT=NONE or INCLUDE",
                                printable(tilt, 40)));
      }
      if (begin_line == 1 && upper(line.substr(0, 3)) == "IES") {
        file.version = printable(line, 40);
      } else if (!line.empty() && line.front() == '[') {
        read_keyword(line, file);
      } else if (!line.empty() && file.label.empty()) {
        file.label = printable(line, 256);
      }
    }
    fail("no line begins with TILT=; this is no LM-63 file or it is cut off");
  }

  void read_keyword(std::string_view line, IesText& file) {
    const std::size_t close = line.find(']');
    if (close == std::string_view::npos) return; // a label that happens to begin with a bracket
    const std::string key = upper(printable(line.substr(1, close - 1), 64));
    const std::string text = printable(trimmed(line.substr(close + 1)), 1024);
    if (key == "MORE" && !file.keywords.empty()) {
      std::string& last = file.keywords.back().second;
      if (!last.empty()) last += ' ';
      last += text;
      return;
    }
    if (file.keywords.size() >= k_max_keywords)
      return fail(fmt::format("more than {} keywords", k_max_keywords));
    file.keywords.emplace_back(key, text);
  }

  void read_tilt() {
    whole_number("lamp to luminaire geometry", 1, 3);
    const int pairs = whole_number("count of tilt angles", 1, k_max_angle_count);
    for (int i = 0; i < pairs && good(); ++i)
      number("tilt angle", -360, 360);
    for (int i = 0; i < pairs && good(); ++i)
      number("tilt factor", 0, k_max_photometric_value);
  }

  // Returns what all candela values are to be multiplied by.
  double read_lamp(IesText& file) {
    const int lamps = whole_number("count of lamps", 0, 1e6);
    const double lumens = number("count of lumens per lamp", -1, k_max_photometric_value);
    if (lumens < 0 && lumens != -1)
      fail(fmt::format("{} lumens per lamp; only -1, for absolute photometry, may be negative",
                       lumens));
    const double multiplier = number("candela multiplier", 0, k_max_photometric_value);
    vertical_count_ = std::size_t(whole_number("count of vertical angles", 1, k_max_angle_count));
    horizontal_count_ =
        std::size_t(whole_number("count of horizontal angles", 1, k_max_angle_count));
    const double directions = double(vertical_count_) * double(horizontal_count_);
    if (directions > k_max_directions)
      fail(fmt::format("{} directions are more than {}", directions, k_max_directions));
    const int type = whole_number("photometric type", 1, 3);
    if (good()) file.type = PhotometricType(type);
    const int units = whole_number("type of units", 1, 2);
    for (double& size : file.size_metres)
      size = number("size of the luminaire", -1e6, 1e6) * (units == 1 ? k_metres_per_foot : 1);
    const double ballast = number("ballast factor", 0, k_max_photometric_value);
    const double ballast_lamp = number("ballast-lamp photometric factor", -k_max_photometric_value,
                                       k_max_photometric_value);
    file.input_watts = number("count of input watts", 0, k_max_photometric_value);
    file.lamp_lumens = lumens > 0 ? lumens * lamps : 0;
    file.lamp_count = lamps;
    // Before memory is taken: each number needs a character and a blank.
    const double room = double(text_.size() - at_) / 2 + 1;
    if (good() && directions + double(vertical_count_ + horizontal_count_) > room)
      fail(fmt::format("the file is too short for {} vertical times {} horizontal angles",
                       vertical_count_, horizontal_count_));
    if (!good()) {
      vertical_count_ = horizontal_count_ = 0;
      return 0;
    }
    if (is_later_than_1995(file.version)) return multiplier * ballast;
    if (ballast_lamp < 0)
      fail(fmt::format("the ballast-lamp photometric factor {} is negative", ballast_lamp));
    return multiplier * ballast * ballast_lamp;
  }

  // The version ends in its year: IESNA91, IESNA:LM-63-1995, IES:LM-63-2019.
  static bool is_later_than_1995(const std::string& version) {
    std::size_t digits = 0;
    while (digits < 4 && digits < version.size() && version[version.size() - 1 - digits] >= '0' &&
           version[version.size() - 1 - digits] <= '9')
      ++digits;
    return digits == 4 && version.compare(version.size() - 4, 4, "1995") > 0;
  }

  void read_angles(std::vector<double>& angles, std::size_t count, const char* kind, double least,
                   double most) {
    const std::string what = fmt::format("{} angle", kind);
    for (std::size_t i = 0; i < count && good(); ++i) {
      const double angle = number(what.c_str(), least, most);
      if (good() && i > 0 && angle <= angles.back())
        fail(fmt::format("the {} {} follows {}; angles must ascend", what, angle, angles.back()));
      angles.push_back(angle);
    }
  }
};

} // namespace

Result<IesText> parse_ies_text(std::string_view text, const std::string& name) {
  return Reader(text, name).read();
}

} // namespace openltc::light
