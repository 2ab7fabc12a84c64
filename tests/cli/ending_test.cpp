// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// However the tool ends, there are the old outputs or the new ones, and nothing else.

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <sys/resource.h>

using namespace openltc::test;
namespace fs = std::filesystem;

namespace {

constexpr const char* k_old = "an older file";

RunOptions limited_to(rlim_t file_bytes) {
  RunOptions options;
  options.prepare = [file_bytes] {
    const rlimit limit = {file_bytes, file_bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
  };
  return options;
}

std::vector<std::string> small_render(const std::vector<std::string>& outputs) {
  std::vector<std::string> arguments = {"render", demo_scene(), "--quiet", "--size",
                                        "160x90", "--samples",  "1"};
  for (const std::string& output : outputs) {
    arguments.push_back("-o");
    arguments.push_back(output);
  }
  return arguments;
}

} // namespace

TEST_CASE("a_signal_ends_a_long_render_soon_and_leaves_older_files_as_they_were") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("x.exr");
  // Many tiles, and few tiles that would each take minutes.
  for (const char* size : {"1280x720", "16x16"})
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
      CAPTURE(size);
      CAPTURE(signal);
      write_text(exr, k_old);
      RunOptions options;
      options.interrupt_after_s = 0.7;
      options.limit_s = 20;
      options.signal = signal;
      options.prepare = [] {
        const rlimit no_core = {0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
      };
      const Run run = run_tool({"render", demo_scene(), "--quiet", "--size", size, "--integrator",
                                "reference", "--samples", "1000000", "-o", exr},
                               options);
      // The parent sees the signal: a shell's loop over many scenes ends as well.
      CHECK(run.ended_by == signal);
      CHECK(line_count(run.err) == 1);
      CHECK(contains(run.err, "nothing was written"));
      CHECK(holds(exr, k_old));
      CHECK(folder.file_count() == 1);
    }
}

TEST_CASE("every_command_ends_by_ctrl_c_with_old_outputs_or_new_ones") {
  const TemporaryFolder folder;
  const std::string table = folder.file("table.json"), a = folder.file("a.exr"),
                    b = folder.file("b.exr");
  REQUIRE(run_tool({"fit", "--size", "64", "--refine", "off", "--quiet", "-o", table}).exit_code ==
          0);
  REQUIRE(run_tool({"render", demo_scene(), "--quiet", "--size", "640x360", "--samples", "1",
                    "--shadow-samples", "0", "-o", a, "-o", b})
              .exit_code == 0);
  struct Case {
    std::vector<std::string> arguments;
    std::vector<std::string> outputs;
  };
  const std::string out = folder.file("out");
  const std::vector<Case> cases = {
      {{"fit", "--size", "48", "-o", out + ".json", "-o", out + ".dds"},
       {out + ".json", out + "_1.dds", out + "_2.dds", out + ".dds.json"}},
      {{"convert", table, out + ".h"}, {out + ".h"}},
      {{"compare", a, b, "--diff", out + ".png"}, {out + ".png"}},
      {{"plot", "point", "-o", out + ".png", "-o", out + ".svg"}, {out + ".png", out + ".svg"}}};
  for (const Case& c : cases)
    for (const double after_s : {0.01, 0.1, 0.3, 0.6, 1.0}) {
      CAPTURE(c.arguments[0]);
      CAPTURE(after_s);
      for (const std::string& output : c.outputs)
        write_text(output, k_old);
      const int files = folder.file_count();
      const Run run = run_tool(c.arguments, {"", after_s, 60});
      CHECK((run.exit_code == 0 || run.ended_by == SIGINT));
      CHECK(folder.file_count() == files);
      const bool first_is_old = holds(c.outputs[0], k_old);
      for (const std::string& output : c.outputs)
        CHECK(holds(output, k_old) == first_is_old);
      if (run.exit_code == 0) CHECK_FALSE(first_is_old);
      for (const std::string& output : c.outputs)
        fs::remove(output);
    }
}

TEST_CASE("a_limit_of_file_size_is_an_error_and_outputs_change_together") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("x.exr"), png = folder.file("x.png"),
                    hdr = folder.file("x.hdr");
  write_text(png, k_old);
  write_text(exr, k_old);
  // The PNG of these outputs fits; EXR and HDR do not.
  const Run run = run_tool(small_render({png, exr, hdr}), limited_to(30000));
  CHECK(fails_naming(run, "x.exr: cannot write"));
  CHECK(holds(png, k_old));
  CHECK(holds(exr, k_old));
  CHECK(folder.file_count() == 2);

  const std::string table = folder.file("t");
  CHECK(run_tool({"fit", "--quiet", "--size", "16", "-o", table + ".json", "-o", table + ".h", "-o",
                  table + ".dds"},
                 limited_to(2000))
            .exit_code == 1);
  CHECK(run_tool({"plot", "point", "-o", folder.file("l.svg")}, limited_to(2000)).exit_code == 1);
  CHECK(run_tool({"convert", demo_scene(), folder.file("c.glb")}, limited_to(2000)).exit_code == 1);
  CHECK(folder.file_count() == 2);
}

TEST_CASE("little_memory_is_an_error_and_leaves_nothing") {
#if defined(__SANITIZE_ADDRESS__)
  MESSAGE("skipped: the address sanitizer needs all addresses");
#else
  const TemporaryFolder folder;
  write_text(folder.file("x.exr"), k_old);
  RunOptions options;
  options.prepare = [] {
    const rlimit limit = {rlim_t(700) << 20, rlim_t(700) << 20};
    setrlimit(RLIMIT_AS, &limit);
  };
  const Run run = run_tool({"render", demo_scene(), "--quiet", "--size", "8192x8192", "--samples",
                            "1", "-o", folder.file("x.exr")},
                           options);
  CHECK(run.exit_code != 0);
  CHECK(run.ended_by != SIGKILL); // it did not hang
  CHECK(holds(folder.file("x.exr"), k_old));
  CHECK(folder.file_count() == 1);
#endif
}

TEST_CASE("a_figure_ends_in_any_memory") {
#if defined(__SANITIZE_ADDRESS__)
  MESSAGE("skipped: the address sanitizer needs all addresses");
#else
  const TemporaryFolder folder;
  const std::string png = folder.file("x.png");
  for (int megabytes = 300; megabytes <= 750; megabytes += 50) {
    CAPTURE(megabytes);
    RunOptions options;
    options.limit_s = 30;
    options.prepare = [megabytes] {
      const rlimit limit = {rlim_t(megabytes) << 20, rlim_t(megabytes) << 20};
      setrlimit(RLIMIT_AS, &limit);
    };
    const Run run = run_tool({"plot", "point", "--scale", "8", "--quiet", "-o", png}, options);
    CHECK((run.exit_code == 0 || run.exit_code == 1 || run.exit_code == 127)); // 127: the loader
    CHECK(folder.file_count() == (run.exit_code == 0 ? 1 : 0));
    fs::remove(png);
  }
#endif
}

TEST_CASE("sigkill_leaves_no_part_of_a_new_file") {
  const TemporaryFolder folder;
  const std::string exr = folder.file("x.exr");
  for (int i = 0; i < 10; ++i) {
    RunOptions options;
    options.interrupt_after_s = 0.1 + 0.06 * i;
    options.signal = SIGKILL;
    const Run run = run_tool(small_render({exr}), options);
    CAPTURE(options.interrupt_after_s);
    CHECK((run.exit_code == 0 || run.ended_by == SIGKILL));
    if (folder.file_count() == 0) continue;
    CHECK(folder.file_count() == 1);
    CHECK(run_tool({"inspect", exr}).exit_code == 0); // whole
    fs::remove(exr);
  }
}
