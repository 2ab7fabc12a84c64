// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Inks are CSS classes: s-NAME strokes, f-NAME fills. The series' colours are those of Okabe and
// Ito 2008, "Color Universal Design", lightened for the dark page. Pictures are data URIs (RFC
// 2397) in base 64 (RFC 4648).

#include "openltc/plot/sketch.h"

#include "openltc/image/palette.h"
#include "openltc/image/png_bytes.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

namespace openltc::plot {

namespace {

struct InkColors {
  Ink ink;
  const char* name;
  const char* light;
  const char* dark;
};

constexpr InkColors k_inks[] = {
    {Ink::ink, "ink", "#1b1c1e", "#e6e6e2"},      {Ink::soft, "soft", "#5c6066", "#9ba1a8"},
    {Ink::rule, "rule", "#dcdcd6", "#33373c"},    {Ink::paper, "paper", "#ffffff", "#15171a"},
    {Ink::blue, "blue", "#0068a8", "#5bb4ea"},    {Ink::orange, "orange", "#cf5200", "#f09a4f"},
    {Ink::green, "green", "#008a63", "#35c796"},  {Ink::pink, "pink", "#a8558a", "#d796bf"},
    {Ink::black, "black", "#000000", "#000000"},  {Ink::white, "white", "#ffffff", "#ffffff"},
    {Ink::signal, "signal", "#ff7a45", "#ff7a45"}};

const char* name_of(Ink ink) {
  for (const InkColors& colors : k_inks)
    if (colors.ink == ink) return colors.name;
  return "none";
}

std::string path_data(std::span<const Vec2d> points, bool closed) {
  std::string data;
  for (std::size_t i = 0; i < points.size(); ++i)
    data += fmt::format("{}{:.1f} {:.1f}",
                        i == 0   ? "M"
                        : i == 1 ? "L"
                                 : " ",
                        points[i].x + 0.0, points[i].y + 0.0);
  return data + (closed ? "Z" : "");
}

std::string pen_attributes(const Pen& pen) {
  std::string text =
      fmt::format("class=\"s-{}\" stroke-width=\"{:.3g}\"", name_of(pen.color), pen.width);
  if (pen.dash[0] != 0) text += fmt::format(" stroke-dasharray=\"{}\"", pen.dash);
  if (pen.opacity < 1) text += fmt::format(" stroke-opacity=\"{:.3g}\"", pen.opacity);
  return text;
}

std::string escaped(char c) {
  switch (c) {
  case '&':
    return "&amp;";
  case '<':
    return "&lt;";
  case '>':
    return "&gt;";
  default:
    return std::string(1, c);
  }
}

// _{...} and *...* as tspans. The base line comes back with the tspan that follows.
std::string marked_up(std::string_view text, double size) {
  std::string result;
  bool slanted = false;
  const std::string drop = fmt::format("{:.2g}", 0.25 * size);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '*') {
      result += slanted ? "</tspan>" : "<tspan font-style=\"italic\">";
      slanted = !slanted;
    } else if (text.substr(i, 2) == "_{") {
      const std::size_t end = text.find('}', i);
      const std::string_view lowered = text.substr(i + 2, end - i - 2);
      result += fmt::format("<tspan dy=\"{}\" font-size=\"{:.3g}\">{}</tspan>", drop, 0.72 * size,
                            marked_up(lowered, 0.72 * size));
      i = end;
      // What follows, one character at least, on the base line again.
      if (i + 1 < text.size() && text[i + 1] != '*') {
        std::size_t next = i + 2;
        while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xc0u) == 0x80u)
          ++next;
        std::string character;
        for (std::size_t k = i + 1; k < next; ++k)
          character += escaped(text[k]);
        result += fmt::format("<tspan dy=\"-{}\">{}</tspan>", drop, character);
        i = next - 1;
      }
    } else {
      result += escaped(text[i]);
    }
  }
  return result;
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view k_digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t word = (std::uint32_t(bytes[i]) << 16) |
                               (left > 1 ? std::uint32_t(bytes[i + 1]) << 8 : 0u) |
                               (left > 2 ? std::uint32_t(bytes[i + 2]) : 0u);
    text += k_digits[(word >> 18) & 63];
    text += k_digits[(word >> 12) & 63];
    text += left > 1 ? k_digits[(word >> 6) & 63] : '=';
    text += left > 2 ? k_digits[word & 63] : '=';
  }
  return text;
}

std::string rules(bool dark) {
  std::string css;
  for (const InkColors& ink : k_inks)
    css += fmt::format(".s-{0}{{stroke:{1}}}.f-{0}{{fill:{1}}}", ink.name,
                       dark ? ink.dark : ink.light);
  return css;
}

} // namespace

void draw_path(Sketch& sketch, std::span<const Vec2d> points, const Pen& pen, bool closed) {
  sketch.body +=
      fmt::format("<path {} d=\"{}\"/>\n", pen_attributes(pen), path_data(points, closed));
}

void draw_shape(Sketch& sketch, std::span<const Vec2d> outline, const Fill& fill) {
  if (fill.hatched) {
    sketch.body += fmt::format("<path fill=\"url(#hatch)\" d=\"{}\"/>\n", path_data(outline, true));
    return;
  }
  sketch.body += fmt::format("<path class=\"f-{}\" fill-opacity=\"{:.3g}\" d=\"{}\"/>\n",
                             name_of(fill.color), fill.opacity, path_data(outline, true));
}

void draw_dots(Sketch& sketch, std::span<const Vec2d> places, const Pen& pen) {
  if (places.empty()) return;
  // Lines without length, under round caps.
  std::string data;
  for (const Vec2d& at : places)
    data += fmt::format("M{:.1f} {:.1f}h0", at.x, at.y);
  sketch.body += fmt::format("<path {} d=\"{}\"/>\n", pen_attributes(pen), data);
}

void draw_text(Sketch& sketch, double x, double y, std::string_view text, const TextStyle& style) {
  constexpr const char* k_anchors[] = {"start", "middle", "end"};
  sketch.body += fmt::format(
      "<text class=\"f-{}\" x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.4g}\" text-anchor=\"{}\"{}{} "
      "xml:space=\"preserve\">{}</text>\n",
      name_of(style.color), x, y, style.size, k_anchors[int(style.anchor)],
      style.bold ? " font-weight=\"600\"" : "",
      style.monospaced ? " font-family=\"ui-monospace, DejaVu Sans Mono, monospace\"" : "",
      marked_up(text, style.size));
}

Status draw_picture(Sketch& sketch, Vec2d corner, Vec2d size, const image::Image& display,
                    bool few_colors) {
  const Result<std::vector<std::uint8_t>> bytes =
      few_colors ? image::png_bytes(image::reduce_colors(display)) : image::png_bytes(display);
  if (!bytes) return bytes.error();
  sketch.body += fmt::format("<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
                             "preserveAspectRatio=\"none\" href=\"data:image/png;base64,{}\"/>\n",
                             corner.x, corner.y, size.x, size.y, base64(*bytes));
  return Success{};
}

std::string to_svg(const Sketch& sketch, Theme theme) {
  std::string css = rules(theme == Theme::dark);
  if (theme == Theme::automatic)
    css += fmt::format("@media (prefers-color-scheme:dark){{{}}}", rules(true));
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" font-family=\"system-ui, Segoe UI, Helvetica, DejaVu Sans, sans-serif\" "
      "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<style>{2}</style>\n",
      sketch.width, sketch.height, css);
  if (sketch.body.find("url(#hatch)") != std::string::npos)
    svg += "<pattern id=\"hatch\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
           "patternTransform=\"rotate(45)\"><path class=\"s-soft\" stroke-width=\"1.5\" "
           "stroke-opacity=\".8\" d=\"M0 3h6\"/></pattern>\n";
  if (theme != Theme::automatic)
    svg += "<rect class=\"f-paper\" width=\"100%\" height=\"100%\"/>\n";
  return svg + sketch.body + "</svg>\n";
}

} // namespace openltc::plot
