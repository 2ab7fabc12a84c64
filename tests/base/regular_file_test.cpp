// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/address_space.h"
#include "openltc/base/regular_file.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

using namespace openltc;
namespace fs = std::filesystem;

namespace {

class Folder {
public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "openltc-file-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
  fs::path path_;
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The one line about a path that is refused by every function.
std::string refusal(const std::string& path, std::uint64_t max_bytes = k_any_size) {
  const auto opened = open_regular_file(path, max_bytes);
  const auto bytes = read_regular_file(path, max_bytes);
  const auto text = read_regular_text(path, max_bytes);
  REQUIRE_FALSE(opened.ok());
  REQUIRE_FALSE(bytes.ok());
  REQUIRE_FALSE(text.ok());
  CHECK(bytes.error().message == opened.error().message);
  CHECK(text.error().message == opened.error().message);
  CHECK(opened.error().message.rfind(path + ": ", 0) == 0);
  CHECK(opened.error().message.find('\n') == std::string::npos);
  return opened.error().message;
}

} // namespace

TEST_CASE("a regular file is read whole, through links too") {
  const Folder folder;
  const std::string text("some\0bytes\xff\n", 12);
  std::ofstream(folder.file("a"), std::ios::binary) << text;
  fs::create_symlink("a", folder.file("b"));
  for (const char* name : {"a", "b"}) {
    const std::string path = folder.file(name);
    CHECK(*read_regular_text(path) == text);
    CHECK(*read_regular_text(path, text.size()) == text);
    const std::vector<std::uint8_t> bytes = *read_regular_file(path);
    CHECK(std::string(bytes.begin(), bytes.end()) == text);
    const RegularFile file = std::move(*open_regular_file(path));
    CHECK(file.size() == text.size());
    std::uint8_t part[5] = {};
    CHECK(*file.read_at(5, part) == 5);
    CHECK(std::string(part, part + 5) == "bytes");
    CHECK(*file.read_at(text.size() - 2, part) == 2);
    CHECK(*file.read_at(1000, part) == 0);
  }
  std::ofstream(folder.file("empty"), std::ios::binary);
  CHECK(read_regular_text(folder.file("empty"), 0)->empty());
}

TEST_CASE("what may wait or never end is refused at once") {
  const Folder folder;
  REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0); // nobody writes: fopen would wait
  CHECK(has(refusal(folder.file("pipe")), "is a pipe"));
  CHECK(has(refusal(folder.file(".")), "is a directory"));
  CHECK(has(refusal("/dev/zero"), "is a device")); // never ends
  CHECK(has(refusal("/dev/null"), "is a device"));
  fs::create_symlink("pipe", folder.file("link"));
  CHECK(has(refusal(folder.file("link")), "is a pipe"));

  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = folder.file("socket");
  REQUIRE(path.size() < sizeof(address.sun_path));
  path.copy(address.sun_path, path.size());
  REQUIRE(::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0);
  CHECK(has(refusal(path), "is a socket"));
  ::close(descriptor);
}

TEST_CASE("what is not there or too large is refused") {
  const Folder folder;
  CHECK(has(refusal(folder.file("absent")), "cannot open: No such file"));
  CHECK(has(refusal(""), "cannot open"));
  fs::create_symlink("loop", folder.file("loop"));
  CHECK(has(refusal(folder.file("loop")), "cannot open"));
  std::ofstream(folder.file("a")) << "12345";
  CHECK(has(refusal(folder.file("a"), 4), "5 bytes, more than the 4"));
  // A size without contents.
  std::ofstream(folder.file("sparse")) << "";
  REQUIRE(::truncate(folder.file("sparse").c_str(), off_t(9) << 30) == 0);
  CHECK(has(refusal(folder.file("sparse"), 1u << 30), "9663676416 bytes"));

  const std::string zero = folder.file("a") + std::string("\0b", 2);
  CHECK_FALSE(open_regular_file(zero).ok());
  CHECK(has(open_regular_file(zero).error().message, "zero byte"));
}

TEST_CASE("a file whose size is unknown is read to its end, but not beyond the limit") {
  if (!fs::exists("/proc/self/status")) {
    MESSAGE("skipped: no /proc");
    return;
  }
  CHECK(has(*read_regular_text("/proc/self/status"), "Pid:"));
  const auto cut = read_regular_text("/proc/self/status", 10);
  REQUIRE_FALSE(cut.ok());
  CHECK(has(cut.error().message, "more than the 10 bytes"));
}

TEST_CASE("address space is there or not, and given back") {
  CHECK(has_address_space(0));
  for (int i = 0; i < 1000; ++i) // not kept
    REQUIRE(has_address_space(std::uint64_t(1) << 24));
  CHECK_FALSE(has_address_space(std::uint64_t(1) << 62));
  CHECK_FALSE(has_address_space(k_any_size));
}
