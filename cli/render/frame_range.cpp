// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/render/frame_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

namespace openltc::cli {

namespace {

constexpr const char* k_how_frames_are_written = "write frames as 1-240, 1-240x10 or 1-24,48";

struct FrameRange {
  int first = 0, last = 0, step = 1;
};

// Digits alone, in range.
bool take_number(std::string_view& text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || text.front() == '-' || number > k_last_frame) return false;
  text.remove_prefix(std::size_t(end - text.data()));
  return true;
}

bool take_character(std::string_view& text, char character) {
  if (text.empty() || text.front() != character) return false;
  text.remove_prefix(1);
  return true;
}

Result<FrameRange> parse_range(std::string_view text) {
  const Error wrong{
      fmt::format("{}; numbers go from 0 to {}", k_how_frames_are_written, k_last_frame)};
  FrameRange range;
  if (text.empty() || !take_number(text, range.first)) return wrong;
  range.last = range.first;
  if (take_character(text, '-')) {
    if (text.empty() || !take_number(text, range.last)) return wrong;
    if (take_character(text, 'x') && (text.empty() || !take_number(text, range.step))) return wrong;
  }
  if (!text.empty()) return wrong;
  if (range.last < range.first)
    return Error{fmt::format("{}-{} has no frame: its last one comes before its first", range.first,
                             range.last)};
  if (range.step < 1) return Error{"every 0th frame is none; write x1 or more"};
  return range;
}

} // namespace

Result<std::vector<int>> parse_frames(const std::string& text) {
  std::set<int> frames;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const Result<FrameRange> range =
        parse_range(std::string_view(text).substr(begin, comma - begin));
    if (!range) return range.error();
    if ((range->last - range->first) / range->step >= k_most_frames)
      return Error{fmt::format("more than {} frames at once", k_most_frames)};
    for (int frame = range->first; frame <= range->last; frame += range->step)
      frames.insert(frame);
    begin = comma + 1;
  }
  if (frames.size() > std::size_t(k_most_frames))
    return Error{fmt::format("more than {} frames at once", k_most_frames)};
  return std::vector<int>(frames.begin(), frames.end());
}

std::string text_of_frames(const std::vector<int>& frames) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t last = i;
    while (last + 1 < frames.size() && frames[last + 1] == frames[last] + 1)
      ++last;
    if (!text.empty()) text += ',';
    text += fmt::format("{}", frames[i]);
    if (last > i) text += fmt::format("-{}", frames[last]);
    i = last + 1;
  }
  return text;
}

std::string path_of_frame(const std::string& pattern, int frame) {
  const std::size_t last = pattern.rfind('#');
  std::size_t first = last;
  while (first > 0 && pattern[first - 1] == '#')
    --first;
  return fmt::format("{}{:0{}}{}", pattern.substr(0, first), frame, last - first + 1,
                     pattern.substr(last + 1));
}

bool has_frame_number(const std::string& pattern) {
  const std::size_t name = pattern.rfind('/') + 1; // 0 without a folder
  return pattern.find('#', name) != std::string::npos;
}

} // namespace openltc::cli
