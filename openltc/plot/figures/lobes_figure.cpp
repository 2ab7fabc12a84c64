// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/plot/figures/lobes_figure.h"

#include "openltc/draw/axes.h"
#include "openltc/plot/lobe_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace openltc::plot {

namespace {

constexpr std::size_t k_columns = 4;
constexpr double k_top = 10, k_row_head = 20, k_line = 14.5, k_head_size = 14;
constexpr double k_width = double(k_columns) * k_lobe_panel_width - 4;
constexpr double k_key_height = 150;

double text_lines(const LobeRow& row) {
  const bool noted = std::any_of(row.cells.begin(), row.cells.end(),
                                 [](const LobeCell& cell) { return !cell.note.empty(); });
  return noted ? 4 : 3;
}

double line_height(const LobeRow& row) {
  return k_lobe_panel_height + 10 + text_lines(row) * k_line + 16;
}

std::size_t lines_of(const LobeRow& row) { return (row.cells.size() + k_columns - 1) / k_columns; }

// Where there is room beside the first lobe the key stands there.
bool key_fits_beside(const std::vector<LobeRow>& rows) { return rows.front().cells.size() == 1; }

// "(b) roughness"; without a letter where there is one row.
std::string head_of(const std::vector<LobeRow>& rows, std::size_t row) {
  const std::string& title = rows[row].title;
  return rows.size() > 1 ? fmt::format("({}) {}", char('a' + row), title) : title;
}

Status draw_cell(draw::Figure& figure, Vec2d corner, const LobeCell& cell, bool label_axes) {
  if (Status status = check_matrix(cell.matrix, cell.caption); !status) return status;
  const LobeFacts facts = lobe_facts(lobe_of_matrix(cell.matrix));
  if (!(std::abs(facts.integral - 1) < 5e-7))
    return Error{fmt::format("{}: the density integrates to {:.9f} instead of 1", cell.caption,
                             facts.integral)};
  if (Status status = draw_lobe_panel(figure, corner, cell.matrix, facts, label_axes); !status)
    return status;
  const double x = corner.x + 108;
  double y = corner.y + k_lobe_panel_height + 10;
  const auto print = [&](const std::string& text, bool head) {
    draw_text(
        figure, {x, y}, text,
        {head ? 12.5 : 10.5, draw::Anchor::middle, head ? "ink" : "soft", false, false, 0, true});
    y += k_line;
  };
  print(cell.caption, true);
  if (!cell.note.empty()) print(cell.note, false);
  print(fmt::format("det *M* = {},  peak {} sr⁻¹", number_text(determinant(cell.matrix)),
                    number_text(facts.peak)),
        false);
  print(fmt::format("∫ *D* dω = {:.6f}", facts.integral), false);
  return Success{};
}

const draw::Type k_note = {11, draw::Anchor::start, "soft", false, false, 0, true};

void draw_line_sign(draw::Figure& figure, Vec2d at, const draw::Pen& pen, const std::string& text) {
  draw_line(figure, {at.x, at.y - 4}, {at.x + 24, at.y - 4}, pen);
  draw_text(figure, {at.x + 31, at.y}, text, k_note);
}

Status draw_key(draw::Figure& figure, Vec2d at) {
  const double x = at.x, y = at.y;
  draw_text(
      figure, at,
      "*D*(ω) = *D*_{o}(o / ‖o‖) |det *M*⁻¹| / ‖o‖³,   o = *M*⁻¹ω,   *D*_{o}(ω) = max(0, z) / π",
      {13, draw::Anchor::start, "ink", false, false, 0, true});
  draw_text(
      figure, {x, y + 21},
      "Left: the sphere of directions, coloured by *D*. Right: the lobe, at the distance *D*(ω) "
      "from the origin.",
      k_note);
  draw_text(figure, {x, y + 36}, "Both are relative to the lobe's own peak.", k_note);
  const draw::Axis shares{
      "", 0, 1, false, {{0, "0"}, {0.25, "0.25"}, {0.5, "0.5"}, {0.75, "0.75"}, {1, "1"}}};
  if (Status status =
          draw_color_bar(figure, {x, y + 54}, {230, 9}, image::Colormap::viridis, shares);
      !status)
    return status;
  draw_text(figure, {x + 244, y + 63}, "*D* / peak", k_note);
  const double first = y + 104, second = y + 123;
  draw_line_sign(figure, {x, first}, {k_axis_inks[0], 1.8}, "*M* x");
  draw_line_sign(figure, {x + 74, first}, {k_axis_inks[1], 1.8}, "*M* y");
  draw_line_sign(figure, {x + 148, first}, {k_axis_inks[2], 1.8},
                 "*M* z: the columns of *M*, to one scale; dashed inside the lobe");
  draw_line_sign(figure, {x, second}, {"ink", 1.5}, "mean direction of *D*");
  draw_line_sign(figure, {x + 186, second}, {"soft", 0.9}, "the surface's horizon, z = 0");
  return Success{};
}

} // namespace

Result<draw::Figure> make_lobes_figure(const LobesOptions& options) {
  std::vector<LobeRow> rows = options.rows;
  if (rows.empty())
    for (const StandardRow row :
         {StandardRow::cosine, StandardRow::roughness, StandardRow::anisotropy, StandardRow::skew})
      rows.push_back(standard_row(row));
  std::size_t count = 0;
  for (const LobeRow& row : rows) {
    if (row.cells.empty()) return Error{row.title + ": a row needs a lobe"};
    count += row.cells.size();
  }
  if (rows.size() > k_most_rows)
    return Error{
        fmt::format("{} rows are too many for a figure; {} at most", rows.size(), k_most_rows)};
  if (count > k_most_lobes)
    return Error{
        fmt::format("{} lobes are too many for a figure; {} at most", count, k_most_lobes)};

  const bool beside = key_fits_beside(rows);
  draw::Figure figure;
  figure.title = "Lobes that a matrix M makes of a clamped cosine";
  figure.caption =
      "Linearly transformed cosines for M = [[a, 0, b], [0, c, 0], [d, 0, 1]]; ∫ D dω over the "
      "sphere by quadrature.\n" +
      options.command;
  figure.width = k_width;
  figure.height = k_top + (beside ? 0 : k_key_height);
  for (const LobeRow& row : rows)
    figure.height += k_row_head + double(lines_of(row)) * line_height(row);

  // Notes stand behind the longest title, one below the other.
  double indent = 0;
  for (std::size_t r = 0; r < rows.size(); ++r)
    indent = std::max(indent, 1.1 * draw::text_width(head_of(rows, r), k_head_size) + 14);
  double y = k_top;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const LobeRow& row = rows[r];
    const std::string head = head_of(rows, r);
    draw_text(figure, {0, y + 12}, head, {k_head_size, draw::Anchor::start, "ink", true});
    draw_text(figure, {indent, y + 12}, row.note, {12, draw::Anchor::start, "soft"});
    y += k_row_head;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const Vec2d corner(double(i % k_columns) * k_lobe_panel_width,
                         y + double(i / k_columns) * line_height(row));
      if (Status status = draw_cell(figure, corner, row.cells[i], r == 0 && i == 0); !status)
        return status.error();
    }
    if (r == 0 && beside)
      if (Status status = draw_key(figure, {k_lobe_panel_width + 52, y + 30}); !status)
        return status.error();
    y += double(lines_of(row)) * line_height(row);
  }
  if (!beside)
    if (Status status = draw_key(figure, {0, y + 14}); !status) return status.error();
  return figure;
}

} // namespace openltc::plot
