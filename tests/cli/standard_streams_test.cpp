// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Standard streams that are closed, full, or that nobody reads.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

using namespace openltc::test;

namespace {

RunOptions with(const std::function<void()>& prepare) {
  RunOptions options;
  options.prepare = prepare;
  return options;
}

RunOptions onto(int target, const std::string& path, int flags = O_WRONLY) {
  return with([=] { redirect_to(target, path, flags); });
}

// Standard stream `target` is a pipe that nobody reads.
RunOptions unread(int target) {
  return with([target] {
    int ends[2];
    if (pipe(ends) != 0 || dup2(ends[1], target) < 0) _exit(126);
    close(ends[0]);
    close(ends[1]);
  });
}

std::vector<std::string> render_to(const std::string& path, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments = {"render",    demo_scene(), "--size", "48x27",
                                        "--samples", "1",          "-o",     path};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

bool is_png(const std::string& path) {
  const auto bytes = bytes_of(path);
  return bytes.size() > 100 && bytes[0] == 0x89 && bytes[1] == 'P' && bytes.back() == 0x82;
}

} // namespace

TEST_CASE("standard_output_that_is_lost_is_a_failure_of_every_command") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("a.exr"), table = folder.file("t.json");
  REQUIRE(run_tool(render_to(exr)).exit_code == 0);
  REQUIRE(run_tool({"fit", "--size", "8", "--quiet", "-o", table}).exit_code == 0);
  const std::vector<std::vector<std::string>> commands = {
      {"--help"},
      {"--version"},
      {"render", "--help"},
      {"fit", "--help"},
      {"compare", "--help"},
      {"inspect", "--help"},
      {"convert", "--help"},
      {"plot", "--help"},
      {"plot", "lobes", "--help"},
      {"fit", "--list"},
      {"fit", "--size", "8", "--quiet"},
      {"compare", exr, exr},
      {"compare", exr, exr, "--json"},
      {"inspect", demo_scene()},
      {"inspect", demo_scene(), "--json"},
      {"inspect", exr},
      {"inspect", table},
      render_to(folder.file("b.png"), {"--quiet", "--json"})};
  for (const auto& command : commands) {
    CAPTURE(command[0]);
    CAPTURE(command.back());
    const Run full = run_tool(command, onto(1, "/dev/full"));
    CHECK(full.exit_code == 1);
    CHECK(line_count(full.err) == 1);
    CHECK(contains(full.err, "standard output"));
    const Run closed = run_tool(command, with([] { close(1); }));
    CHECK(closed.exit_code == 1);
    CHECK(contains(closed.err, "standard output"));
    // As other tools do, and as `openltc inspect x | head -1` needs.
    const Run pipe = run_tool(command, unread(1));
    CHECK(pipe.ended_by == SIGPIPE);
    CHECK(pipe.err.empty());
  }
  CHECK(is_png(folder.file("b.png"))); // what could be written was
}

TEST_CASE("outputs_are_written_though_the_report_is_lost") {
  const TemporaryFolder folder;
  const std::string table = folder.file("t.json");
  CHECK(run_tool({"fit", "--size", "8", "--quiet", "-o", table}, unread(1)).ended_by == SIGPIPE);
  CHECK(run_tool({"inspect", table}).exit_code == 0);
}

TEST_CASE("standard_error_that_is_lost_is_no_reason_to_fail") {
  const TemporaryFolder folder;
  const std::string png = folder.file("a.png");
  for (const RunOptions& lost :
       {onto(2, "/dev/full"), unread(2), with([] { close(2); }), onto(2, "/dev/null", O_RDONLY)}) {
    CHECK(run_tool(render_to(png), lost).exit_code == 0);
    CHECK(is_png(png));
    std::filesystem::remove(png);
    CHECK(run_tool({"plot", "point", "-o", folder.file("l.svg")}, lost).exit_code == 0);
    CHECK(run_tool({"fit", "--size", "8", "-o", folder.file("t.json")}, lost).exit_code == 0);
    CHECK(run_tool({"convert", folder.file("t.json"), folder.file("t.h")}, lost).exit_code == 0);
    CHECK(run_tool({"render", "--no-such"}, lost).exit_code == 2);
    CHECK(run_tool({"render", folder.file("missing.glb")}, lost).exit_code == 1);
  }
}

TEST_CASE("closed_streams_do_not_make_messages_go_into_pictures") {
  const TemporaryFolder folder;
  const std::string png = folder.file("a.png"), plain = folder.file("plain.png"),
                    svg = folder.file("l.svg"), plain_svg = folder.file("plain.svg");
  REQUIRE(run_tool(render_to(plain)).exit_code == 0);
  REQUIRE(run_tool({"plot", "point", "-o", plain_svg}).exit_code == 0);
  for (int closed = 1; closed < 8; ++closed) { // every set of the three
    CAPTURE(closed);
    const RunOptions options = with([closed] {
      for (int stream = 0; stream < 3; ++stream)
        if ((closed >> stream & 1) != 0) close(stream);
    });
    CHECK(run_tool(render_to(png), options).exit_code == 0);
    CHECK(bytes_of(png) == bytes_of(plain));
    CHECK(run_tool({"plot", "point", "-o", svg}, options).exit_code == 0);
    CHECK(bytes_of(svg) == bytes_of(plain_svg));
  }
}

TEST_CASE("a_file_that_takes_standard_output_is_no_output_as_well") {
  const TemporaryFolder folder;
  const std::string table = folder.file("t.json");
  for (const int stream : {1, 2}) {
    write_text(table, "");
    const Run run = run_tool({"fit", "--size", "8", "--quiet", "-o", folder.file("./t.json")},
                             onto(stream, table, O_WRONLY | O_TRUNC));
    CHECK(run.exit_code == 1);
    const auto bytes = bytes_of(table);
    CHECK(contains(stream == 1 ? run.err : std::string(bytes.begin(), bytes.end()),
                   "goes there as well"));
  }
}
