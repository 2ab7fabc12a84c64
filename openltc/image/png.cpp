// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// PNG (ISO/IEC 15948) through libpng. Colour-space chunks are ignored: the samples are sRGB, or
// whatever the caller knows them to be, as glTF prescribes.
//
// libpng leaves by longjmp when a file is bad. The functions that call setjmp therefore keep only
// plain values of their own; memory belongs to their callers.

#include "openltc/base/atomic_file.h"
#include "openltc/image/codec.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>

namespace openltc::image {

namespace {

// The last message of libpng; lies outside of the frames that longjmp destroys.
struct Message {
  char text[200] = "damaged file";
};

void on_error(png_structp png, png_const_charp text) {
  auto* message = static_cast<Message*>(png_get_error_ptr(png));
  std::snprintf(message->text, sizeof(message->text), "%s", text);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

struct Source {
  std::span<const std::uint8_t> bytes;
  std::size_t at = 0;
};

void read_bytes(png_structp png, png_bytep to, png_size_t count) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (count > source->bytes.size() - source->at) png_error(png, "the file is cut short");
  std::memcpy(to, source->bytes.data() + source->at, count);
  source->at += count;
}

struct Reader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

struct Header {
  png_uint_32 width = 0, height = 0;
  int bit_depth = 0, channels = 0;
};

// Reads up to the pixels and asks for 8 or 16 bits, without palette.
bool read_header(Reader& reader, Source& source, Header& header) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_set_read_fn(reader.png, &source, read_bytes);
  png_set_user_limits(reader.png, png_uint_32(k_max_side), png_uint_32(k_max_side));
  png_read_info(reader.png, reader.info);
  png_set_expand(reader.png); // palette to RGB, small grey to 8 bits, transparency to alpha
  if constexpr (std::endian::native == std::endian::little) png_set_swap(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  header.width = png_get_image_width(reader.png, reader.info);
  header.height = png_get_image_height(reader.png, reader.info);
  header.bit_depth = png_get_bit_depth(reader.png, reader.info);
  header.channels = png_get_channels(reader.png, reader.info);
  return true;
}

bool read_pixels(Reader& reader, png_bytep* rows) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

struct Writer {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

void append_bytes(png_structp png, png_bytep from, png_size_t count) {
  auto* bytes = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  bytes->insert(bytes->end(), from, from + count);
}

void flush_nothing(png_structp) {}

bool write_image(Writer& writer, std::vector<std::uint8_t>* out, const Image& size,
                 png_bytep* rows) {
  if (setjmp(png_jmpbuf(writer.png))) return false;
  png_set_write_fn(writer.png, out, append_bytes, flush_nothing);
  const int color_type = size.channels == 1   ? PNG_COLOR_TYPE_GRAY
                         : size.channels == 3 ? PNG_COLOR_TYPE_RGB
                                              : PNG_COLOR_TYPE_RGB_ALPHA;
  png_set_IHDR(writer.png, writer.info, png_uint_32(size.width), png_uint_32(size.height), 8,
               color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(writer.png, writer.info);
  png_write_image(writer.png, rows);
  png_write_end(writer.png, nullptr);
  return true;
}

} // namespace

bool codec::is_png(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 8 && png_sig_cmp(bytes.data(), 0, 8) == 0;
}

Result<codec::Samples> codec::decode_png(std::span<const std::uint8_t> bytes,
                                         const std::string& name) {
  if (!is_png(bytes)) return Error{fmt::format("{}: not a PNG file", name)};
  Message message;
  Source source{bytes};
  Header header;
  Reader reader;
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning);
  if (reader.png) reader.info = png_create_info_struct(reader.png);
  if (!reader.png || !reader.info) return Error{fmt::format("{}: libpng does not start", name)};
  if (!read_header(reader, source, header))
    return Error{fmt::format("{}: cannot decode PNG: {}", name, message.text)};
  const std::size_t pixel_bytes = std::size_t(header.channels * header.bit_depth / 8);
  if (Status ok = check_readable(name, header.width, header.height, pixel_bytes); !ok)
    return ok.error();

  // Deflate shrinks by a factor of 1032 at most, and a sample takes at least one bit of the file.
  Samples samples;
  samples.width = int(header.width);
  samples.height = int(header.height);
  samples.channels = header.channels;
  const std::size_t count = samples.count();
  if (count / 32 / 1032 > bytes.size())
    return Error{fmt::format("{}: a header of {}x{} pixels on a file of {} bytes: cut short or "
                             "damaged",
                             name, header.width, header.height, bytes.size())};

  std::uint8_t* data = nullptr;
  std::vector<png_bytep> rows;
  try {
    if (header.bit_depth == 16) {
      samples.bits16.resize(count);
      data = reinterpret_cast<std::uint8_t*>(samples.bits16.data());
    } else {
      const std::shared_ptr<std::uint8_t> bytes_of_picture = new_bytes(count);
      if (!bytes_of_picture) throw std::bad_alloc();
      data = bytes_of_picture.get();
      samples.bits8 = bytes_of_picture;
    }
    rows.resize(header.height);
  } catch (const std::bad_alloc&) {
    return Error{fmt::format("{}: not enough memory for the picture", name)};
  }
  const std::size_t row_bytes =
      std::size_t(header.width) * std::size_t(header.channels) * (header.bit_depth == 16 ? 2 : 1);
  for (std::size_t y = 0; y < rows.size(); ++y)
    rows[y] = data + y * row_bytes;
  if (!read_pixels(reader, rows.data()))
    return Error{fmt::format("{}: cannot decode PNG: {}", name, message.text)};
  return samples;
}

Result<std::vector<std::uint8_t>> encode_png(const Image& display) {
  std::vector<std::uint8_t> bytes(display.data.size());
  std::transform(display.data.begin(), display.data.end(), bytes.begin(), [](float v) {
    return v > 0.0f ? std::uint8_t(std::min(v, 1.0f) * 255.0f + 0.5f) : std::uint8_t(0);
  });
  std::vector<png_bytep> rows(std::size_t(display.height));
  for (std::size_t y = 0; y < rows.size(); ++y)
    rows[y] = bytes.data() + y * std::size_t(display.width) * std::size_t(display.channels);

  std::vector<std::uint8_t> out;
  Message message;
  Writer writer;
  writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning);
  if (writer.png) writer.info = png_create_info_struct(writer.png);
  if (!writer.png || !writer.info) return Error{"libpng does not start"};
  if (!write_image(writer, &out, display, rows.data()))
    return Error{fmt::format("cannot encode PNG: {}", message.text)};
  return out;
}

Status write_png(const std::string& path, const Image& display) {
  if (Status ok = codec::check_writable(path, display); !ok) return ok;
  const Result<std::vector<std::uint8_t>> bytes = encode_png(display);
  if (!bytes) return Error{fmt::format("{}: {}", path, bytes.error().message)};
  return write_atomically(path, [&](const std::string& temporary) -> Status {
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (!file) return Error{fmt::format("{}: cannot write: {}", path, std::strerror(errno))};
    const bool written = std::fwrite(bytes->data(), 1, bytes->size(), file) == bytes->size();
    if (std::fclose(file) != 0 || !written)
      return Error{fmt::format("{}: cannot write: {}", path, std::strerror(errno))};
    return Success{};
  });
}

} // namespace openltc::image
