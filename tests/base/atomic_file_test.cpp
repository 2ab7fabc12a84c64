// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/atomic_file.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

using namespace openltc;
namespace fs = std::filesystem;

namespace {

class Folder {
public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "openltc-base-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  int file_count() const {
    return int(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

private:
  fs::path path_;
};

Status put(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return file ? Status(Success{}) : Status(Error{path + ": cannot write"});
}

std::string get(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool names(const Status& status, const std::string& part) {
  return !status.ok() && status.error().message.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a_file_appears_when_it_is_complete") {
  const Folder folder;
  const std::string path = folder.file("x.txt");
  const Status status = write_atomically(path, [&](const std::string& temporary) {
    CHECK(fs::path(temporary).parent_path() == fs::path(path).parent_path());
    CHECK(fs::path(temporary).extension() == ".txt");
    const Status written = put(temporary, "new");
    CHECK_FALSE(fs::exists(path));
    return written;
  });
  CHECK(status.ok());
  CHECK(get(path) == "new");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("an_older_file_is_replaced_on_success_and_kept_on_failure") {
  const Folder folder;
  const std::string path = folder.file("x.txt");
  REQUIRE(put(path, "old").ok());
  const Status failed = write_atomically(path, [&](const std::string& temporary) -> Status {
    REQUIRE(put(temporary, "half").ok());
    return Error{path + ": the disk is full"};
  });
  CHECK(names(failed, "the disk is full"));
  CHECK(get(path) == "old");
  CHECK(folder.file_count() == 1);
  CHECK(write_atomically(path, [](const std::string& t) { return put(t, "new"); }).ok());
  CHECK(get(path) == "new");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("an_exception_inside_becomes_an_error_that_names_the_file") {
  const Folder folder;
  const std::string path = folder.file("x.txt");
  REQUIRE(put(path, "old").ok());
  const Status failed = write_atomically(path, [](const std::string& temporary) -> Status {
    REQUIRE(put(temporary, "half").ok());
    throw std::runtime_error("no more paper");
  });
  CHECK(names(failed, "x.txt"));
  CHECK(names(failed, "no more paper"));
  const Status other = write_atomically(path, [](const std::string& temporary) -> Status {
    REQUIRE(put(temporary, "half").ok());
    throw 1; // not a std::exception
  });
  CHECK(names(other, "x.txt"));
  CHECK(get(path) == "old");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("success_without_a_file_is_an_error") {
  const Folder folder;
  const std::string path = folder.file("x.txt");
  CHECK(names(write_atomically(path, [](const std::string&) { return Success{}; }), "x.txt"));
  CHECK(folder.file_count() == 0);
}

TEST_CASE("places_where_no_file_can_be_are_errors_before_writing") {
  const Folder folder;
  fs::create_directory(folder.file("folder"));
  REQUIRE(put(folder.file("file"), "").ok());
  for (const std::string& path : {folder.file("missing/x.txt"), folder.file("folder"),
                                  folder.file("file/x.txt"), std::string()}) {
    CAPTURE(path);
    bool called = false;
    const Status status = write_atomically(path, [&](const std::string&) {
      called = true;
      return Success{};
    });
    CHECK(names(status, path));
    CHECK_FALSE(called);
  }
  CHECK(folder.file_count() == 2);
}

TEST_CASE("long_names_of_outputs_are_no_reason_to_fail") {
  // The temporary name is longer than the name, and a name has at most 255 bytes.
  const Folder folder;
  const std::string path = folder.file(std::string(240, 'n') + ".txt");
  CHECK(write_atomically(path, [](const std::string& t) { return put(t, "new"); }).ok());
  CHECK(get(path) == "new");
}

TEST_CASE("temporary_files_can_be_removed_while_they_are_written") {
  const Folder folder;
  const std::string path = folder.file("x.txt");
  REQUIRE(put(path, "old").ok());
  const Status status = write_atomically(path, [&](const std::string& temporary) {
    const Status written = put(temporary, "half");
    CHECK(folder.file_count() == 2);
    remove_temporary_files(); // what the handler of a second Ctrl-C does
    CHECK(folder.file_count() == 1);
    return written;
  });
  CHECK(names(status, "x.txt"));
  CHECK(get(path) == "old");
}
