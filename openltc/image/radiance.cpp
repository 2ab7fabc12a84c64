// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Radiance pictures (.hdr): Greg Ward, "Real Pixels", Graphics Gems II, 1991, and the file format
// page of the Radiance reference manual.
//
// A pixel is four bytes, three mantissas and one exponent: colour = mantissa * 2^(exponent - 136).
// A scan line stores its four components one after the other, each run-length encoded.

#include "openltc/base/atomic_file.h"
#include "openltc/image/codec.h"
#include "openltc/image/radiance_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace openltc::image {

namespace {

constexpr double k_largest = double(std::numeric_limits<float>::max());

using Rgbe = std::array<std::uint8_t, 4>;

// Widths that the run-length encoding of whole components can hold.
constexpr int k_min_rle_width = 8;
constexpr int k_max_rle_width = 32767;

// The largest value of the format: mantissa 255 with exponent 255, 255 * 2^119 = 1.7e38.
const float k_max_value = std::ldexp(255.0f, 255 - 136);

Rgbe encode(const float* rgb) {
  float v[3];
  for (int c = 0; c < 3; ++c)
    v[c] = rgb[c] > 0.0f ? std::min(rgb[c], k_max_value) : 0.0f;
  const float largest = std::max({v[0], v[1], v[2]});
  int exponent = 0;
  (void)std::frexp(largest, &exponent); // largest = m * 2^exponent, m in [1/2, 1)
  // Rounding a mantissa of 255.5 and more up takes the next exponent.
  if (std::ldexp(largest, 8 - exponent) >= 255.5f) ++exponent;
  if (largest == 0.0f || exponent + 128 < 1) return {0, 0, 0, 0};
  Rgbe out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = std::uint8_t(std::ldexp(v[c], 8 - exponent) + 0.5f);
  out[3] = std::uint8_t(exponent + 128);
  return out;
}

// One component of a line: runs of 4 to 127 equal bytes as (128 + length, byte), the rest as
// (length, bytes...) with length up to 128.
void encode_runs(const std::vector<std::uint8_t>& line, std::vector<std::uint8_t>& out) {
  const std::size_t n = line.size();
  const auto run_at = [&](std::size_t i) {
    std::size_t end = i + 1;
    while (end < n && end - i < 127 && line[end] == line[i])
      ++end;
    return end - i;
  };
  for (std::size_t i = 0; i < n;) {
    const std::size_t run = run_at(i);
    if (run >= 4) {
      out.push_back(std::uint8_t(128 + run));
      out.push_back(line[i]);
      i += run;
      continue;
    }
    std::size_t end = i;
    while (end < n && end - i < 128) {
      const std::size_t next = run_at(end);
      if (next >= 4) break;
      end = std::min(end + next, i + 128);
    }
    out.push_back(std::uint8_t(end - i));
    out.insert(out.end(), line.begin() + std::ptrdiff_t(i), line.begin() + std::ptrdiff_t(end));
    i = end;
  }
}

// Reads the file from front to back; every function returns an empty optional at its end.
class Cursor {
public:
  explicit Cursor(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::size_t left() const { return bytes_.size() - at_; }
  std::optional<std::string_view> line() {
    const auto begin = bytes_.begin() + std::ptrdiff_t(at_);
    const auto end = std::find(begin, bytes_.end(), std::uint8_t('\n'));
    if (end == bytes_.end()) return std::nullopt;
    const std::string_view text(reinterpret_cast<const char*>(bytes_.data()) + at_,
                                std::size_t(end - begin));
    at_ += text.size() + 1;
    return text;
  }
  std::optional<std::span<const std::uint8_t>> take(std::size_t count) {
    if (count > left()) return std::nullopt;
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }
  std::optional<Rgbe> peek_pixel() const {
    if (left() < 4) return std::nullopt;
    return Rgbe{bytes_[at_], bytes_[at_ + 1], bytes_[at_ + 2], bytes_[at_ + 3]};
  }

private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

bool read_components(Cursor& in, std::vector<Rgbe>& line) {
  (void)in.take(4); // 2, 2, width
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t x = 0; x < line.size();) {
      const auto head = in.take(1);
      if (!head) return false;
      const std::size_t code = (*head)[0];
      const std::size_t length = code > 128 ? code - 128 : code;
      if (length == 0 || length > line.size() - x) return false;
      const auto values = in.take(code > 128 ? 1 : length);
      if (!values) return false;
      for (std::size_t i = 0; i < length; ++i)
        line[x++][c] = (*values)[code > 128 ? 0 : i];
    }
  }
  return true;
}

// The older form: plain pixels, and (1, 1, 1, n) repeats the pixel before it n times, n shifted by
// 8 bits more for each repetition that follows the last at once.
bool read_plain(Cursor& in, std::vector<Rgbe>& line) {
  int shift = 0;
  for (std::size_t x = 0; x < line.size();) {
    const auto pixel = in.peek_pixel();
    if (!pixel) return false;
    (void)in.take(4);
    if ((*pixel)[0] == 1 && (*pixel)[1] == 1 && (*pixel)[2] == 1) {
      const std::size_t count = shift < 32 ? std::size_t((*pixel)[3]) << shift : 0;
      if (x == 0 || count > line.size() - x) return false;
      std::fill_n(line.begin() + std::ptrdiff_t(x), count, line[x - 1]);
      x += count;
      shift += 8;
    } else {
      line[x++] = *pixel;
      shift = 0;
    }
  }
  return true;
}

bool read_line(Cursor& in, std::vector<Rgbe>& line) {
  const auto first = in.peek_pixel();
  if (!first) return false;
  const bool has_components = (*first)[0] == 2 && (*first)[1] == 2 && (*first)[2] < 128 &&
                              int(line.size()) >= k_min_rle_width &&
                              int(line.size()) <= k_max_rle_width;
  if (!has_components) return read_plain(in, line);
  if ((std::size_t((*first)[2]) << 8 | (*first)[3]) != line.size()) return false;
  return read_components(in, line);
}

Result<RadianceHeader> read_header(Cursor& in, const std::string& name) {
  const auto cut_short = [&] {
    return Error{fmt::format("{}: the Radiance header is cut short", name)};
  };
  const auto magic = in.line();
  if (!magic || !magic->starts_with("#?"))
    return Error{fmt::format("{}: not a Radiance file (it does not begin with #?RADIANCE)", name)};
  RadianceHeader header;
  while (true) {
    const auto line = in.line();
    if (!line) return cut_short();
    // An indented line is a copy of another picture's header, which does not count.
    const std::string_view text = line->ends_with('\r') ? line->substr(0, line->size() - 1) : *line;
    if (text.empty()) break;
    if (Status ok = read_radiance_variable(text, name, header); !ok) return ok.error();
  }
  const auto resolution = in.line();
  if (!resolution) return cut_short();
  if (!parse_radiance_resolution(*resolution, header))
    return Error{
        fmt::format("{}: cannot read the resolution '{}'; expected '-Y HEIGHT +X WIDTH' or "
                    "another order of the two",
                    name, resolution->substr(0, resolution->find('\r')).substr(0, 60))};
  for (double& factor : header.color_correction) {
    factor *= header.exposure;
    if (!(factor > 1e-37 && factor < 1e37))
      return Error{fmt::format(
          "{}: the EXPOSURE and COLORCORR lines multiply to {:.3g}, out of range", name, factor)};
  }
  return header;
}

} // namespace

Result<Image> codec::decode_radiance(std::span<const std::uint8_t> bytes, const std::string& name) {
  Cursor in(bytes);
  Result<RadianceHeader> header = read_header(in, name);
  if (!header) return header.error();
  if (Status ok = check_size(name, header->width, header->height); !ok) return ok.error();

  const int lines = header->columns ? header->width : header->height;
  const int length = header->columns ? header->height : header->width;
  // Run-length encoding shrinks a line to 2 bytes per 127 pixels and component at the least.
  const std::size_t least = std::size_t(lines) * std::max<std::size_t>(4, std::size_t(length) / 64);
  if (least > in.left() && length >= k_min_rle_width)
    return Error{fmt::format("{}: {} bytes cannot hold {}x{} pixels: cut short or damaged", name,
                             bytes.size(), header->width, header->height)};

  if (Status ok = check_readable(name, header->width, header->height, 3 * sizeof(float)); !ok)
    return ok.error();
  Image image(header->width, header->height, 3);
  std::vector<Rgbe> line(static_cast<std::size_t>(length));
  for (int j = 0; j < lines; ++j) {
    if (!read_line(in, line))
      return Error{fmt::format("{}: line {} of {} is cut short or damaged", name, j + 1, lines)};
    for (int i = 0; i < length; ++i) {
      const int x = header->columns ? j : i, y = header->columns ? i : j;
      const Rgbe& pixel = line[std::size_t(i)];
      float* out = image.pixel(header->from_right ? header->width - 1 - x : x,
                               header->from_bottom ? header->height - 1 - y : y);
      if (pixel[3] == 0) continue; // black, whatever the mantissas
      const double unit = std::ldexp(1.0, int(pixel[3]) - 136);
      for (std::size_t c = 0; c < 3; ++c)
        out[c] = float(std::min(double(pixel[c]) * unit / header->color_correction[c], k_largest));
    }
  }
  if (header->is_xyz)
    multiply_colors(rec709_from_xyz(), image);
  else if (header->primaries)
    multiply_colors(*rec709_from_rgb(*header->primaries), image);
  return image;
}

Status write_hdr(const std::string& path, const Image& image) {
  if (Status ok = codec::check_writable(path, image); !ok) return ok;
  return write_atomically(path, [&](const std::string& temporary) -> Status {
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (!file) return Error{fmt::format("{}: cannot write: {}", path, std::strerror(errno))};
    fmt::print(file, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height,
               image.width);

    const bool runs = image.width >= k_min_rle_width && image.width <= k_max_rle_width;
    std::array<std::vector<std::uint8_t>, 4> components;
    for (auto& component : components)
      component.resize(std::size_t(image.width));
    std::vector<std::uint8_t> bytes;
    bool ok = std::ferror(file) == 0;
    for (int y = 0; y < image.height && ok; ++y) {
      bytes.clear();
      if (runs) bytes = {2, 2, std::uint8_t(image.width >> 8), std::uint8_t(image.width & 255)};
      for (int x = 0; x < image.width; ++x) {
        const Vec3f rgb = image.rgb(x, y);
        const float values[3] = {rgb.x, rgb.y, rgb.z};
        const Rgbe pixel = encode(values);
        if (!runs) bytes.insert(bytes.end(), pixel.begin(), pixel.end());
        for (std::size_t c = 0; c < 4; ++c)
          components[c][std::size_t(x)] = pixel[c];
      }
      if (runs) {
        for (const auto& component : components)
          encode_runs(component, bytes);
      }
      ok = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    }
    const int write_errno = errno;
    const bool closed = std::fclose(file) == 0;
    if (!ok || !closed)
      return Error{
          fmt::format("{}: cannot write: {}", path, std::strerror(ok ? errno : write_errno))};
    return Success{};
  });
}

} // namespace openltc::image
