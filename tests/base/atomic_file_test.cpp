// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/atomic_file.h"
#include "openltc/base/temporary_file.h"
#include "tests/base/folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

using namespace openltc;
using openltc::test::Folder;
using openltc::test::put_text;
using openltc::test::text_of;
namespace fs = std::filesystem;

namespace {

Status put(const std::string& path, const std::string& text) {
  put_text(path, text);
  return Success{};
}

Status write(const std::string& path, const std::string& text) {
  return write_atomically(path, [&](const std::string& temporary) { return put(temporary, text); });
}

mode_t mode_of(const std::string& path) {
  struct stat facts = {};
  REQUIRE(::stat(path.c_str(), &facts) == 0);
  return facts.st_mode & 07777;
}

// Every promise holds on file systems of both kinds.
class FileSystem {
public:
  explicit FileSystem(bool plain) { assume_plain_file_system(plain); }
  ~FileSystem() { assume_plain_file_system(false); }
};

bool names(const Status& status, const std::string& part) {
  return !status.ok() && status.error().message.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a_file_appears_when_it_is_complete") {
  const Folder folder;
  const std::string path = folder.file("x.txt");
  const Status status = write_atomically(path, [&](const std::string& temporary) {
    const Status written = put(temporary, "new");
    CHECK_FALSE(fs::exists(path));
    return written;
  });
  CHECK(status.ok());
  CHECK(text_of(path) == "new");
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
  CHECK(text_of(path) == "old");
  CHECK(folder.file_count() == 1);
  CHECK(write_atomically(path, [](const std::string& t) { return put(t, "new"); }).ok());
  CHECK(text_of(path) == "new");
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
  CHECK(text_of(path) == "old");
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
  CHECK(text_of(path) == "new");
}

TEST_CASE("several_files_change_together_or_not_at_all") {
  for (const bool plain : {false, true}) {
    CAPTURE(plain);
    const FileSystem file_system(plain);
    const Folder folder;
    const std::string old = folder.file("old.txt"), fresh = folder.file("fresh.txt");
    put_text(old, "old");
    {
      FileGroup group;
      CHECK(write(old, "new").ok());
      CHECK(write(fresh, "new").ok());
      CHECK(text_of(old) == "old");
      CHECK_FALSE(fs::exists(fresh));
      CHECK(names(write(folder.file("missing/x"), "new"), "missing"));
    } // not committed
    CHECK(text_of(old) == "old");
    CHECK(folder.file_count() == 1);

    FileGroup group;
    CHECK(write(old, "new").ok());
    CHECK(write(fresh, "new").ok());
    CHECK(group.commit().ok());
    CHECK(text_of(old) == "new");
    CHECK(text_of(fresh) == "new");
    CHECK(folder.file_count() == 2);
  }
}

TEST_CASE("a_file_that_cannot_take_its_place_lets_those_before_it_be_as_they_were") {
  for (const bool plain : {false, true}) {
    CAPTURE(plain);
    const FileSystem file_system(plain);
    const Folder folder;
    const std::string old = folder.file("old.txt"), fresh = folder.file("fresh.txt"),
                      last = folder.file("last.txt");
    put_text(old, "old");
    FileGroup group;
    CHECK(write(old, "new").ok());
    CHECK(write(fresh, "new").ok());
    CHECK(write(last, "new").ok());
    fs::create_directories(last + "/not empty"); // meanwhile
    CHECK(names(group.commit(), "last.txt"));
    CHECK(text_of(old) == "old");
    CHECK_FALSE(fs::exists(fresh));
    CHECK(folder.file_count() >= 2); // and parts, until the group goes
  }
}

TEST_CASE("nothing_is_left_when_a_group_goes") {
  for (const bool plain : {false, true}) {
    const FileSystem file_system(plain);
    const Folder folder;
    put_text(folder.file("old.txt"), "old");
    {
      FileGroup group;
      CHECK(write(folder.file("old.txt"), "new").ok());
      CHECK(write(folder.file("last.txt"), "new").ok());
      fs::create_directories(folder.file("last.txt/not empty"));
      CHECK_FALSE(group.commit().ok());
    }
    CHECK(folder.file_count() == 2);
  }
}

TEST_CASE("one_group_inside_another_hands_over") {
  const Folder folder;
  FileGroup outer;
  {
    FileGroup inner;
    CHECK(write(folder.file("a"), "a").ok());
    CHECK(inner.commit().ok());
  }
  {
    FileGroup dropped;
    CHECK(write(folder.file("b"), "b").ok());
  }
  CHECK(folder.file_count() == 0);
  CHECK(outer.commit().ok());
  CHECK(folder.file_count() == 1);
  CHECK(text_of(folder.file("a")) == "a");
}

TEST_CASE("two_outputs_in_one_place_are_noticed_at_the_latest_when_they_are_placed") {
  const Folder folder;
  fs::create_directory_symlink(folder.file("."), folder.file("link"));
  FileGroup group;
  CHECK(write(folder.file("a"), "first").ok());
  CHECK(write(folder.file("link/a"), "second").ok());
  CHECK(names(group.commit(), "written twice"));
  CHECK_FALSE(fs::exists(folder.file("a")));
}

TEST_CASE("links_stay_and_what_they_point_to_is_written") {
  const Folder folder;
  fs::create_directory(folder.file("deep"));
  put_text(folder.file("deep/real"), "old");
  fs::create_symlink("deep/real", folder.file("link"));
  fs::create_symlink("link", folder.file("second"));
  fs::create_symlink("deep/none_yet", folder.file("dangling"));
  fs::create_symlink("loop", folder.file("loop"));
  CHECK(write(folder.file("second"), "new").ok());
  CHECK(write(folder.file("dangling"), "new").ok());
  CHECK(fs::is_symlink(folder.file("second")));
  CHECK(fs::is_symlink(folder.file("link")));
  CHECK(fs::is_symlink(folder.file("dangling")));
  CHECK(text_of(folder.file("deep/real")) == "new");
  CHECK(text_of(folder.file("deep/none_yet")) == "new");
  CHECK(names(write(folder.file("loop"), "new"), "loop"));
}

TEST_CASE("an_existing_file_keeps_its_permissions_and_a_new_one_has_those_of_the_umask") {
  for (const bool plain : {false, true}) {
    const FileSystem file_system(plain);
    const Folder folder;
    const std::string path = folder.file("x");
    for (const mode_t mode : {0600u, 0640u, 0755u, 0666u}) {
      CAPTURE(mode);
      put_text(path, "old");
      REQUIRE(::chmod(path.c_str(), mode) == 0);
      CHECK(write(path, "new").ok());
      CHECK(mode_of(path) == mode);
    }
    const mode_t before = ::umask(027);
    CHECK(write(folder.file("new"), "new").ok());
    ::umask(before);
    CHECK(mode_of(folder.file("new")) == 0640);
  }
}

TEST_CASE("what_is_protected_is_not_written") {
  if (::geteuid() == 0) {
    MESSAGE("skipped: root may write everything");
    return;
  }
  const Folder folder;
  put_text(folder.file("x"), "old");
  REQUIRE(::chmod(folder.file("x").c_str(), 0444) == 0);
  CHECK(names(write(folder.file("x"), "new"), "may not be written"));
  CHECK(text_of(folder.file("x")) == "old");
}

TEST_CASE("a_pipe_gets_the_bytes_and_stays_a_pipe") {
  const Folder folder;
  const std::string pipe = folder.file("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::string got;
  std::thread reader([&] { got = text_of(pipe); });
  const std::string text(200000, 'x'); // more than a pipe holds
  CHECK(write(pipe, text).ok());
  reader.join();
  CHECK(got == text);
  CHECK(fs::is_fifo(pipe));
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a_device_that_is_full_is_an_error_and_no_other_output_changes") {
  const Folder folder;
  put_text(folder.file("old"), "old");
  {
    FileGroup group;
    CHECK(write(folder.file("old"), "new").ok());
    CHECK(write("/dev/full", "new").ok());
    CHECK(names(group.commit(), "/dev/full: cannot write: No space left on device"));
  }
  CHECK(text_of(folder.file("old")) == "old");
  CHECK(folder.file_count() == 1);
}
