// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "tests/cli/tool.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace openltc::test {

namespace {

void redirect(int target, const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || dup2(file, target) < 0) _exit(126);
}

bool ended_as(const Run& run, int exit_code, const std::string& part) {
  const bool good = run.exit_code == exit_code && line_count(run.err) == 1 && run.out.empty() &&
                    contains(run.err, part);
  if (!good)
    MESSAGE("expected exit code " << exit_code << " and one line with '" << part << "', got "
                                  << run.exit_code << ", signal " << run.ended_by << ", stderr:\n"
                                  << run.err << "stdout:\n"
                                  << run.out);
  return good;
}

} // namespace

Run run_tool(const std::vector<std::string>& arguments, const RunOptions& options) {
  const TemporaryFolder folder;
  const std::string out = folder.file("stdout"), err = folder.file("stderr");
  std::vector<std::string> words = {OPENLTC_TOOL};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);

  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  // Until it is the tool, the child has the handlers of doctest: a signal waits.
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before);
  const pid_t child = fork();
  if (child == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGABRT, SIGSEGV, SIGPIPE})
      std::signal(signal, SIG_DFL);
    if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(126);
    redirect(1, out);
    redirect(2, err);
    if (options.prepare) options.prepare();
    sigprocmask(SIG_SETMASK, &before, nullptr);
    execv(argv[0], argv.data());
    _exit(127);
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  Run run;
  int status = 0;
  struct rusage usage = {};
  bool interrupted = false, killed = false;
  while (wait4(child, &status, WNOHANG, &usage) == 0) {
    if (options.interrupt_after_s > 0 && !interrupted && elapsed() > options.interrupt_after_s) {
      interrupted = true;
      kill(child, options.signal);
    }
    if (!killed && elapsed() > options.limit_s) {
      killed = true;
      kill(child, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  run.seconds = elapsed();
  run.peak_bytes = std::uint64_t(usage.ru_maxrss) * 1024;
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) run.ended_by = WTERMSIG(status);
  run.out = text_of(out);
  run.err = text_of(err);
  return run;
}

int line_count(const std::string& text) { return int(std::count(text.begin(), text.end(), '\n')); }

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool fails_naming(const Run& run, const std::string& part) { return ended_as(run, 1, part); }

bool refuses_usage(const Run& run, const std::string& part) { return ended_as(run, 2, part); }

std::vector<std::uint8_t> bytes_of(const std::string& path) {
  return image::test::file_bytes(path);
}

std::string text_of(const std::string& path) {
  const auto bytes = bytes_of(path);
  return std::string(bytes.begin(), bytes.end());
}

void write_text(const std::string& path, const std::string& text) {
  image::test::write_bytes(path, std::vector<std::uint8_t>(text.begin(), text.end()));
}

void write_scene(const std::string& path, const GltfBuilder& scene) {
  write_text(path, scene.to_text());
}

GltfBuilder lit_floor(double nits) {
  GltfBuilder scene;
  // The square of square_primitive, laid flat: its +z looks up (floor) or down (lamp).
  const double s = std::sqrt(0.5);
  scene.add("materials", {{"name", "white"}});
  scene.add("materials",
            {{"name", "lamp"},
             {"emissiveFactor", {1, 1, 1}},
             {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", nits}}}}}});
  scene.use("KHR_materials_emissive_strength");
  json floor = scene.square_primitive(), lamp = floor;
  floor["material"] = 0;
  lamp["material"] = 1;
  scene.add_mesh_node(floor, {{"name", "floor"},
                              {"rotation", {-s, 0, 0, s}},
                              {"scale", {4, 4, 1}},
                              {"translation", {-2, 0, 2}}});
  scene.add_mesh_node(
      lamp, {{"name", "lamp"}, {"rotation", {s, 0, 0, s}}, {"translation", {-0.5, 1, -0.5}}});
  return scene;
}

void add_camera(GltfBuilder& scene, const std::string& name, double height) {
  const int camera = scene.add(
      "cameras",
      {{"name", name}, {"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
  const int node =
      scene.add("nodes", {{"name", name}, {"camera", camera}, {"translation", {0, height, 4}}});
  scene.root["scenes"][0]["nodes"].push_back(node);
}

bool holds(const std::string& path, const std::string& text) { return text_of(path) == text; }

void redirect_to(int target, const std::string& path, int flags) {
  const int file = open(path.c_str(), flags);
  if (file < 0 || dup2(file, target) < 0) _exit(126);
}

std::string demo_scene() { return OPENLTC_SOURCE_DIR "/scenes/demo.glb"; }

} // namespace openltc::test
