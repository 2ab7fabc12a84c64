// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/draw/figure.h"

#include "openltc/base/markup.h"
#include "openltc/draw/marked_text.h"
#include "openltc/image/file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace openltc::draw {

namespace {

constexpr double k_margin = 18;
constexpr double k_title_size = 16, k_caption_size = 11.5;

struct Role {
  const char* name;
  const char* light;
  const char* dark;
};

// Series: blue, vermilion, green and purple near those of Okabe and Ito 2008, "Color Universal
// Design", darkened or lightened until they stand out from the paper; curves differ in their dashes
// as well.
constexpr std::array<Role, 8> k_roles = {{{"paper", "#ffffff", "#15171a"},
                                          {"ink", "#1b1c1e", "#e6e6e2"},
                                          {"soft", "#5c6066", "#9ba1a8"},
                                          {"rule", "#dcdcd6", "#33373c"},
                                          {"series0", "#0068a8", "#5bb4ea"},
                                          {"series1", "#cf5200", "#f09a4f"},
                                          {"series2", "#008a63", "#35c796"},
                                          {"series3", "#a8558a", "#d796bf"}}};

// "stroke" or "fill" of a colour: a class for a role, an attribute otherwise.
struct Paint {
  std::string classes, attributes;
  void add(const char* property, const std::string& color) {
    for (const Role& role : k_roles)
      if (color == role.name) {
        classes += fmt::format("{}{}-{}", classes.empty() ? "" : " ", property[0], role.name);
        return;
      }
    attributes += fmt::format(" {}=\"{}\"", property, color);
  }
  std::string text() const {
    return (classes.empty() ? "" : fmt::format(" class=\"{}\"", classes)) + attributes;
  }
};

// Two decimals at most, none that are not needed.
std::string number(double x) {
  std::string text = fmt::format("{:.2f}", x);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string style_of(const Pen& pen) {
  Paint paint;
  paint.add("fill", pen.fill);
  paint.add("stroke", pen.color);
  std::string text = paint.text();
  if (pen.color != "none" && pen.width != 1)
    text += fmt::format(" stroke-width=\"{}\"", number(pen.width));
  if (!pen.dash.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", pen.dash);
  if (pen.opacity != 1) text += fmt::format(" opacity=\"{}\"", number(pen.opacity));
  if (pen.fill_opacity != 1) text += fmt::format(" fill-opacity=\"{}\"", number(pen.fill_opacity));
  return text;
}

std::string style_sheet(Theme theme) {
  const auto rules = [](bool dark) {
    std::string text;
    for (const Role& role : k_roles) {
      const char* color = dark ? role.dark : role.light;
      text += fmt::format(".s-{0}{{stroke:{1}}}.f-{0}{{fill:{1}}}", role.name, color);
    }
    return text;
  };
  std::string text = "<style>" + rules(theme == Theme::dark);
  if (theme == Theme::automatic) text += "@media(prefers-color-scheme:dark){" + rules(true) + "}";
  return text + "</style>\n";
}

void draw_png(Figure& figure, Vec2d corner, Vec2d size, const std::vector<std::uint8_t>& png,
              bool smooth) {
  figure.body += fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
                             "preserveAspectRatio=\"none\"{} href=\"data:image/png;base64,{}\"/>\n",
                             number(corner.x), number(corner.y), number(size.x), number(size.y),
                             smooth ? "" : " style=\"image-rendering:pixelated\"", base64(png));
}

// Words of a text, and lines of about `width` made of them.
std::vector<std::string> lines_of(const std::string& text, double width, double size) {
  std::vector<std::string> lines;
  std::string line;
  std::size_t at = 0;
  while (at < text.size()) {
    const bool forced = text[at] == '\n';
    std::size_t end = text.find_first_of(" \n", at + (forced ? 1 : 0));
    if (end == std::string::npos) end = text.size();
    const std::string word = forced ? text.substr(at + 1, end - at - 1) : text.substr(at, end - at);
    if (forced || (!line.empty() && text_width(line + " " + word, size) > width)) {
      lines.push_back(line);
      line = word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
    at = end < text.size() && text[end] == ' ' ? end + 1 : end;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

} // namespace

void draw_path(Figure& figure, std::span<const Vec2d> points, const Pen& pen, bool closed) {
  if (points.empty()) return;
  std::string d;
  for (std::size_t i = 0; i < points.size(); ++i)
    d += fmt::format("{}{} {}", i > 0 ? "L" : "M", number(points[i].x), number(points[i].y));
  figure.body += fmt::format("<path d=\"{}{}\"{} stroke-linejoin=\"round\" "
                             "stroke-linecap=\"round\"/>\n",
                             d, closed ? "Z" : "", style_of(pen));
}

void draw_line(Figure& figure, Vec2d from, Vec2d to, const Pen& pen) {
  figure.body += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>\n", number(from.x),
                             number(from.y), number(to.x), number(to.y), style_of(pen));
}

void draw_rectangle(Figure& figure, Vec2d corner, Vec2d size, const Pen& pen) {
  figure.body +=
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n", number(corner.x),
                  number(corner.y), number(size.x), number(size.y), style_of(pen));
}

void draw_circle(Figure& figure, Vec2d center, double radius, const Pen& pen) {
  figure.body += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", number(center.x),
                             number(center.y), number(radius), style_of(pen));
}

void draw_text(Figure& figure, Vec2d place, const std::string& text, const Type& type) {
  Paint paint;
  paint.add("fill", type.color);
  std::string style = paint.text() + fmt::format(" font-size=\"{}\"", number(type.size));
  if (type.anchor != Anchor::start)
    style += fmt::format(" text-anchor=\"{}\"", type.anchor == Anchor::end ? "end" : "middle");
  if (type.bold) style += " font-weight=\"600\"";
  if (type.italic) style += " font-style=\"italic\"";
  if (type.turn_degrees != 0)
    style += fmt::format(" transform=\"rotate({} {} {})\"", number(type.turn_degrees),
                         number(place.x), number(place.y));
  if (type.marked) style += " xml:space=\"preserve\"";
  figure.body +=
      fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>\n", number(place.x), number(place.y), style,
                  type.marked ? marked_text(text, type.size) : markup_text(text));
}

double draw_paragraph(Figure& figure, Vec2d place, double width, const std::string& text,
                      const Type& type) {
  constexpr double k_bold = 1.12; // wider than text_width says
  double y = place.y;
  for (const std::string& line : lines_of(text, width / (type.bold ? k_bold : 1), type.size)) {
    draw_text(figure, Vec2d(place.x, y), line, type);
    y += 1.4 * type.size;
  }
  return y - place.y;
}

double text_width(const std::string& text, double size) {
  double ems = 0;
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    // Bytes of one character; wide ones are those of three bytes from U+2E80 on.
    const std::size_t bytes = c < 0x80 ? 1 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : 4;
    const std::string_view narrow = "iljtfr.,:;'|![]() ", broad = "mwMW%@";
    ems += bytes == 3 && c >= 0xe3                          ? 1.0
           : narrow.find(char(c)) != std::string_view::npos ? 0.35
           : broad.find(char(c)) != std::string_view::npos  ? 0.9
                                                            : 0.62;
    i += bytes;
  }
  return ems * size;
}

Status draw_picture(Figure& figure, Vec2d corner, Vec2d size, const image::Image& display,
                    bool smooth) {
  const Result<std::vector<std::uint8_t>> png = image::encode_png(display);
  if (!png) return png.error();
  draw_png(figure, corner, size, *png, smooth);
  return Success{};
}

Status draw_picture(Figure& figure, Vec2d corner, Vec2d size, const PaletteImage& display) {
  const Result<std::vector<std::uint8_t>> png = encode_png(display);
  if (!png) return png.error();
  draw_png(figure, corner, size, *png, true);
  return Success{};
}

void draw_dots(Figure& figure, std::span<const Vec2d> places, const Pen& pen) {
  if (places.empty()) return;
  // One path of lines without length, under round caps.
  std::string d;
  for (const Vec2d& at : places)
    d += fmt::format("M{:.1f} {:.1f}h0", at.x, at.y);
  figure.body += fmt::format("<path d=\"{}\"{} stroke-linecap=\"round\"/>\n", d, style_of(pen));
}

void begin_clip(Figure& figure, Vec2d corner, Vec2d size) {
  const int id = figure.clips++;
  figure.body +=
      fmt::format("<clipPath id=\"clip{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" "
                  "height=\"{4}\"/></clipPath><g clip-path=\"url(#clip{0})\">\n",
                  id, number(corner.x), number(corner.y), number(size.x), number(size.y));
}

void end_clip(Figure& figure) { figure.body += "</g>\n"; }

std::string to_svg(const Figure& figure, Theme theme) {
  const double width = figure.width + 2 * k_margin;
  Figure frame;
  double top = k_margin;
  if (!figure.title.empty()) {
    const Type title{k_title_size, Anchor::start, "ink", true, false, 0};
    top += draw_paragraph(frame, Vec2d(k_margin, top + k_title_size), figure.width, figure.title,
                          title) +
           6;
  }
  double bottom = top + figure.height;
  if (!figure.caption.empty()) {
    const Type caption{k_caption_size, Anchor::start, "soft", false, false, 0};
    bottom += 10 + draw_paragraph(frame, Vec2d(k_margin, bottom + 10 + k_caption_size),
                                  figure.width, figure.caption, caption);
  }
  const double height = std::ceil(bottom + k_margin); // the last row of pixels is covered
  std::string svg =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                  "viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\" "
                  "font-family=\"'DejaVu Sans','Segoe UI','Helvetica Neue',Arial,sans-serif\">\n",
                  number(width), number(height), markup_text(figure.title));
  svg += style_sheet(theme);
  svg += "<rect class=\"f-paper\" width=\"100%\" height=\"100%\"/>\n";
  svg += frame.body;
  svg += fmt::format("<g transform=\"translate({} {})\">\n", number(k_margin), number(top));
  return svg + figure.body + "</g>\n</svg>\n";
}

} // namespace openltc::draw
