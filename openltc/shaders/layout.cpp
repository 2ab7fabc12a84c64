// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/shaders/layout.h"

#include <utility>

namespace openltc::shaders {

namespace {

// A joined piece says so by this text; a broken one has none.
constexpr const char* k_joined = "+";

bool is_joined(const Piece& p) { return !p.parts.empty() && p.text == k_joined; }

std::string flat(const Piece& p) {
  if (p.parts.empty()) return p.text;
  std::string out;
  for (std::size_t i = 0; i < p.parts.size(); ++i)
    out += (i > 0 && !is_joined(p) ? " " : "") + flat(p.parts[i]);
  return out;
}

class Layout {
public:
  Layout(int indent, int width) : width_(std::size_t(width)), column_(std::size_t(indent)) {}

  // `after`: columns that what follows on the line needs.
  void set(const Piece& p, std::size_t after) {
    const std::string line = flat(p);
    if (p.parts.empty() || column_ + line.size() + after <= width_) {
      out_ += line;
      column_ += line.size();
      return;
    }
    const std::size_t start = column_;
    for (std::size_t i = 0; i < p.parts.size(); ++i) {
      const bool last = i + 1 == p.parts.size();
      // Up to the next break: what is joined to this part's end.
      std::size_t follows = last ? after : 0;
      if (is_joined(p)) {
        for (std::size_t k = i + 1; k < p.parts.size(); ++k)
          follows += k == i + 1 ? head(p.parts[k]) : 0;
        set(p.parts[i], follows);
        continue;
      }
      if (i > 0) {
        const std::size_t length = flat(p.parts[i]).size();
        if (column_ + 1 + length + follows <= width_) {
          out_ += ' ';
          ++column_;
        } else {
          out_ += '\n' + std::string(start, ' ');
          column_ = start;
        }
      }
      set(p.parts[i], follows);
    }
  }

  std::string take() { return std::move(out_); }

private:
  // Columns up to the first place where a piece may be broken.
  static std::size_t head(const Piece& p) {
    return p.parts.empty() ? p.text.size() : head(p.parts.front());
  }

  std::size_t width_;
  std::size_t column_;
  std::string out_;
};

} // namespace

Piece piece(std::string text) { return {std::move(text), {}}; }

Piece joined(std::vector<Piece> parts) { return {k_joined, std::move(parts)}; }

Piece broken(std::vector<Piece> parts) { return {"", std::move(parts)}; }

std::string lay_out(const Piece& p, int indent, int width) {
  Layout layout(indent, width);
  layout.set(p, 0);
  return layout.take();
}

} // namespace openltc::shaders
