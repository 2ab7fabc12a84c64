// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A hash over cells of space, so that what is near is found without comparing all with all.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace openltc::scene {

struct CellHash {
  std::size_t operator()(const std::array<std::int64_t, 4>& cell) const {
    std::uint64_t h = 14695981039346656037u; // FNV-1a, word-wise
    for (const std::int64_t c : cell)
      h = (h ^ std::uint64_t(c)) * 1099511628211u;
    return std::size_t(h ^ (h >> 31));
  }
};

using Cell = std::array<std::int64_t, 4>;
using Grid = std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash>;

// Calls visit(cell) for `center` and its neighbours in the first `dimensions` directions.
template <class Visit> void for_neighbours(const Cell& center, int dimensions, const Visit& visit) {
  int cells = 1;
  for (int d = 0; d < dimensions; ++d)
    cells *= 3;
  for (int i = 0; i < cells; ++i) {
    Cell cell = center;
    for (int d = 0, rest = i; d < dimensions; ++d, rest /= 3)
      cell[std::size_t(d)] += rest % 3 - 1;
    visit(cell);
  }
}

} // namespace openltc::scene
