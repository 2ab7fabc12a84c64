// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Bad files end in one line that names the file; failed writing leaves the old file alone.

#include "openltc/image/file.h"
#include "tests/image/make_picture.h"

#include <doctest/doctest.h>
#include <png.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <random>
#include <sys/resource.h>

using namespace openltc;
using namespace openltc::image;
using namespace openltc::image::test;

namespace {

struct SmallFile {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

std::vector<SmallFile> small_files(const TemporaryFolder& folder) {
  const Image picture = random_image(11, 7, 3, 7);
  const std::vector<Layer> layers = {{"", picture}, {"stderr", picture}};
  REQUIRE(write_exr(folder.file("small.exr"), layers).ok());
  REQUIRE(write_hdr(folder.file("small.hdr"), picture).ok());
  REQUIRE(write_png(folder.file("small.png"), picture).ok());
  write_bytes(folder.file("small.jpg"),
              make_jpeg(11, 7, 3, std::vector<std::uint8_t>(11 * 7 * 3, 99)));
  std::vector<SmallFile> files;
  for (const char* name : {"small.exr", "small.hdr", "small.png", "small.jpg"}) {
    REQUIRE(read(folder.file(name)).ok());
    files.push_back({folder.file(name), file_bytes(folder.file(name))});
  }
  return files;
}

// One line, the file's name first.
void check_clear_error(const Result<Image>& result, const std::string& path) {
  REQUIRE(!result.ok());
  const std::string& message = result.error().message;
  CAPTURE(message);
  REQUIRE(message.find(path + ": ") == 0);
  REQUIRE(message.size() > path.size() + 8);
  REQUIRE(message.find('\n') == std::string::npos);
}

void append_big_endian(std::vector<std::uint8_t>& to, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    to.push_back(std::uint8_t(value >> shift));
}

} // namespace

TEST_CASE("a file cut short at any length is refused") {
  const TemporaryFolder folder;
  for (const SmallFile& file : small_files(folder)) {
    CAPTURE(file.name);
    for (std::size_t length = 0; length < file.bytes.size(); ++length) {
      CAPTURE(length);
      write_bytes(file.name, {file.bytes.begin(), file.bytes.begin() + std::ptrdiff_t(length)});
      check_clear_error(read(file.name), file.name);
    }
  }
}

TEST_CASE("garbage and foreign contents are refused") {
  const TemporaryFolder folder;
  std::mt19937 random(8);
  for (const char* extension : {"exr", "hdr", "png", "jpg"}) {
    const std::string path = folder.file(std::string("garbage.") + extension);
    std::vector<std::uint8_t> bytes(4096);
    for (auto& b : bytes)
      b = std::uint8_t(random());
    write_bytes(path, bytes);
    check_clear_error(read(path), path);
    write_bytes(path, std::vector<std::uint8_t>(100, 0));
    check_clear_error(read(path), path);
    std::filesystem::remove(path);
    check_clear_error(read(path), path);
    std::filesystem::create_directory(path);
    check_clear_error(read(path), path);
  }
  const std::string text = folder.file("picture.txt");
  write_bytes(text, {'a'});
  check_clear_error(read(text), text);
}

TEST_CASE("files with damaged bytes are read or refused, never worse") {
  const TemporaryFolder folder;
  std::mt19937 random(9);
  for (const SmallFile& file : small_files(folder)) {
    CAPTURE(file.name);
    for (int round = 0; round < 400; ++round) {
      std::vector<std::uint8_t> bytes = file.bytes;
      for (int k = 0; k < 1 + round % 4; ++k)
        bytes[random() % bytes.size()] = std::uint8_t(random());
      write_bytes(file.name, bytes);
      const Result<Image> result = read(file.name);
      if (result.ok())
        REQUIRE(result->data.size() == result->pixel_count() * std::size_t(result->channels));
      else
        check_clear_error(result, file.name);
    }
  }
}

TEST_CASE("headers that promise absurd sizes are refused before memory is taken") {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> pixels(64, 2);

  for (const char* size : {"-Y 65535 +X 65535", "-Y 2000000000 +X 2000000000", "-Y 0 +X 5",
                           "-Y -5 +X 5", "-Y 99999999999999999999 +X 1", "-Y 60000 +X 2000",
                           "+X 3 -X 3", "+X 65535 -Y 65535", "hello"}) {
    const std::string path = folder.file("huge.hdr");
    const std::string header = std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n") + size + "\n";
    std::vector<std::uint8_t> bytes(header.begin(), header.end());
    bytes.insert(bytes.end(), pixels.begin(), pixels.end());
    write_bytes(path, bytes);
    check_clear_error(read(path), path);
  }

  for (std::uint32_t side : {0u, 60000u, 0x7fffffffu, 0xffffffffu}) {
    const std::string path = folder.file("huge.png");
    std::vector<std::uint8_t> bytes = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    std::vector<std::uint8_t> chunk = {'I', 'H', 'D', 'R'};
    append_big_endian(chunk, side);
    append_big_endian(chunk, side == 60000u ? 2000u : side);
    chunk.insert(chunk.end(), {8, 2, 0, 0, 0});
    append_big_endian(bytes, 13);
    bytes.insert(bytes.end(), chunk.begin(), chunk.end());
    // The checksum of PNG: CRC-32 (ISO/IEC 15948, annex D).
    std::uint32_t crc = 0xffffffffu;
    for (std::uint8_t b : chunk) {
      crc ^= b;
      for (int k = 0; k < 8; ++k)
        crc = crc & 1u ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
    }
    append_big_endian(bytes, ~crc);
    append_big_endian(bytes, 0); // an empty data chunk and the end
    bytes.insert(bytes.end(), {'I', 'D', 'A', 'T', 0x35, 0xaf, 0x06, 0x1e});
    append_big_endian(bytes, 0);
    bytes.insert(bytes.end(), {'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82});
    write_bytes(path, bytes);
    check_clear_error(read(path), path);
  }

  // The windows of an EXR header lie behind their names as four 32-bit numbers.
  const std::string path = folder.file("huge.exr");
  REQUIRE(write_exr(path, std::vector<Layer>{{"", Image(4, 4, 3)}}).ok());
  const std::vector<std::uint8_t> good = file_bytes(path);
  for (std::int32_t corner : {-1, 65000, 0x7ffffffe, 0x7fffffff}) {
    std::vector<std::uint8_t> bytes = good;
    for (const char* key : {"dataWindow", "displayWindow"}) {
      const std::string name(key);
      const auto found = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
      REQUIRE(found != bytes.end());
      // name, 0, "box2i", 0, length (4 bytes), min x, min y, max x, max y
      const auto at = std::size_t(found - bytes.begin()) + name.size() + 1 + 6 + 4 + 8;
      std::memcpy(&bytes[at], &corner, 4);
      std::memcpy(&bytes[at + 4], &corner, 4);
    }
    write_bytes(path, bytes);
    check_clear_error(read(path), path);
  }
}

TEST_CASE("embedded pictures that are neither PNG nor JPEG are refused by name") {
  const std::vector<std::uint8_t> text = {'R', 'I', 'F', 'F', 0, 0, 0, 0, 'W', 'E', 'B', 'P'};
  check_clear_error(decode(text, "model.glb: image 2", true), "model.glb: image 2");
  check_clear_error(decode({}, "model.glb: image 3", true), "model.glb: image 3");
}

TEST_CASE("failed writing names the file and leaves the old one as it was") {
  const TemporaryFolder folder;
  const Image good = random_image(64, 64, 3, 10);
  const auto write = [&](const std::string& path, const Image& image) -> Status {
    if (path.ends_with(".exr")) return write_exr(path, std::vector<Layer>{{"", image}});
    return path.ends_with(".hdr") ? write_hdr(path, image) : write_png(path, image);
  };
  for (const char* name : {"a.exr", "a.hdr", "a.png"}) {
    const std::string path = folder.file(name);
    CAPTURE(path);
    REQUIRE(write(path, good).ok());
    const auto old = file_bytes(path);
    const int files = folder.file_count();

    Image wrong = good;
    wrong.data.pop_back();
    for (const Image& bad : {Image(), Image(3, 3, 2), wrong}) {
      const Status status = write(path, bad);
      REQUIRE(!status.ok());
      CHECK(status.error().message.find(path) == 0);
      CHECK(file_bytes(path) == old);
    }

    // A disk that is full after 4,096 bytes.
    struct rlimit before;
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
    auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit small = {4096, before.rlim_max};
    REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
    const Status status = write(path, random_image(256, 256, 3, 11));
    REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
    std::signal(SIGXFSZ, handler);
    REQUIRE(!status.ok());
    CHECK(status.error().message.find(path) == 0);
    CHECK(file_bytes(path) == old);
    CHECK(folder.file_count() == files);

    const std::string nowhere = folder.file("no/such/folder/" + std::string(name));
    const Status nowhere_status = write(nowhere, good);
    REQUIRE(!nowhere_status.ok());
    CHECK(nowhere_status.error().message.find(nowhere) == 0);
  }
}
