// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// openltc view: a scene in the browser.

#include "cli/commands.h"
#include "cli/options/number.h"
#include "cli/process/ending.h"
#include "cli/process/message.h"
#include "cli/process/standard_streams.h"
#include "cli/view/loopback_server.h"
#include "cli/view/scene_site.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <spawn.h>
#include <string>
#include <system_error>
#include <unistd.h>

namespace openltc::cli {

namespace {

namespace fs = std::filesystem;

struct ViewArguments {
  std::string scene, page;
  int port = 0;
  bool no_open = false;
};

// Where the page may be: beside an installed tool, or where `make web` puts it.
Result<fs::path> find_page(const std::string& asked) {
  if (!asked.empty()) return fs::path(asked);
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path places[] = {folder / "../share/openltc/app", folder / "../../../out/web/app"};
  for (const fs::path& place : places)
    if (!folder.empty() && fs::is_regular_file(place / "viewer.html", error)) return place;
  return Error{
      fmt::format("the viewer's page is not there, neither in {} nor in {}; `make web` makes "
                  "it, or say --page FOLDER",
                  places[0].lexically_normal().string(), places[1].lexically_normal().string())};
}

bool has_display() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"})
    if (const char* value = std::getenv(name); value && *value) return true;
  return false;
}

// By the desktop's own choice of a browser. That there is none is no error: the address is printed.
void open_browser(const std::string& address) {
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) return;
  for (const int stream : {0, 1, 2})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  std::string program = "xdg-open", argument = address;
  char* const values[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  posix_spawnp(&child, "xdg-open", &actions, nullptr, values, environ);
  posix_spawn_file_actions_destroy(&actions);
}

int run_view(const ViewArguments& arguments) {
  const Result<fs::path> page = find_page(arguments.page);
  if (!page) return fail("view", page.error());
  const Result<SceneSite> site = SceneSite::make(*page, arguments.scene);
  if (!site) return fail("view", site.error());
  const Result<LoopbackServer> server = LoopbackServer::make(arguments.port);
  if (!server) return fail("view", server.error());
  const std::string address = fmt::format("http://127.0.0.1:{}/", server->port());
  put("{}\n", address);
  std::fflush(stdout); // it is read while this runs
  say("shows {} to browsers of this machine, until Ctrl-C\n", arguments.scene);
  note_written(); // there is nothing to be written when a signal ends it
  if (!arguments.no_open && has_display()) open_browser(address);
  return fail("view", server->serve([&](const Request& request) {
    return site->answer(request, server->port());
  }));
}

constexpr const char* k_view_footer =
    "The page is static and runs in the browser, by WebGL 2. The tool serves it, the scene and "
    "the\n"
    "files of the scene's folder that a glTF file may name, to this machine alone: it listens on\n"
    "127.0.0.1, refuses what lies outside of the folder, and requests for other hosts. The page\n"
    "takes the scene anew when its file changes, and the camera stays.\n"
    "\n"
    "Examples:\n"
    "  openltc view scene.glb               prints the address, and opens it where there is a "
    "display\n"
    "  openltc view scene.glb --no-open --port 8000";

} // namespace

void add_view(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<ViewArguments>();
  CLI::App* command =
      app.add_subcommand("view", "Show a glTF scene in the browser, to look at and set its lights");
  command->footer(k_view_footer);
  command->add_option("scene", arguments->scene, "The scene, .gltf or .glb")
      ->required()
      ->type_name("FILE");
  command->add_option("--port", arguments->port, "Port to listen on; 0 takes a free one")
      ->transform(whole_number(0, 65535))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--no-open", arguments->no_open, "Open no browser");
  command
      ->add_option("--page", arguments->page,
                   "Folder of the viewer's page, of `make web` [beside the tool, or out/web/app]")
      ->type_name("FOLDER");
  command->callback([arguments, &exit_code] { exit_code = run_view(*arguments); });
}

} // namespace openltc::cli
