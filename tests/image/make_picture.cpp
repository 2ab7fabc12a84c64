// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/image/make_picture.h"

#include <png.h>

#include <fstream>
#include <iterator>
#include <random>
#include <unistd.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb_image_write.h>

namespace openltc::image::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  static int counter = 0;
  path_ = fs::temp_directory_path() /
          ("openltc-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ec;
  fs::remove_all(path_, ec);
}

int TemporaryFolder::file_count() const {
  return int(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
}

Image random_image(int width, int height, int channels, std::uint32_t seed, float low, float high) {
  Image image(width, height, channels);
  std::mt19937 random(seed); // its sequence is the same everywhere, unlike the distributions
  for (float& v : image.data)
    v = low + (high - low) * float(random() >> 8) * 0x1p-24f;
  return image;
}

std::vector<std::uint8_t> file_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return std::vector<std::uint8_t>(std::istreambuf_iterator<char>(in), {});
}

void write_bytes(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  fs::remove(path); // writing into an existing file waits for the disk on some file systems
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

std::vector<std::uint8_t> make_png(int width, int height, int color_type, int bit_depth,
                                   std::vector<std::uint8_t> rows, bool interlaced) {
  std::vector<std::uint8_t> out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp p, png_bytep data, png_size_t count) {
    auto* to = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(p));
    to->insert(to->end(), data, data + count);
  };
  png_set_write_fn(png, &out, append, [](png_structp) {});
  png_set_IHDR(png, info, png_uint_32(width), png_uint_32(height), bit_depth, color_type,
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (color_type == PNG_COLOR_TYPE_PALETTE) {
    std::vector<png_color> palette(std::size_t(1) << bit_depth);
    for (std::size_t i = 0; i < palette.size(); ++i)
      palette[i] = {png_byte(3 * i), png_byte(2 * i), png_byte(i)};
    png_set_PLTE(png, info, palette.data(), int(palette.size()));
    const png_byte alpha = 0;
    png_set_tRNS(png, info, &alpha, 1, nullptr);
  }
  png_write_info(png, info);
  std::vector<png_bytep> pointers;
  for (int y = 0; y < height; ++y)
    pointers.push_back(rows.data() + std::size_t(y) * rows.size() / std::size_t(height));
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

std::vector<std::uint8_t> make_jpeg(int width, int height, int channels,
                                    const std::vector<std::uint8_t>& samples) {
  std::vector<std::uint8_t> out;
  const auto append = [](void* to, void* data, int count) {
    auto* bytes = static_cast<std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(to)->insert(
        static_cast<std::vector<std::uint8_t>*>(to)->end(), bytes, bytes + count);
  };
  stbi_write_jpg_to_func(append, &out, width, height, channels, samples.data(), 95);
  return out;
}

} // namespace openltc::image::test
