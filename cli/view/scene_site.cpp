// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/view/scene_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

namespace openltc::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_scene_prefix = "/scene/";

// By the ending of a name. Those with `of_scene` are what a glTF file may name.
struct FileType {
  std::string_view ending, type;
  bool of_scene;
};
constexpr std::array k_types = {
    FileType{".html", "text/html; charset=utf-8", false},
    FileType{".js", "text/javascript; charset=utf-8", false},
    FileType{".css", "text/css; charset=utf-8", false},
    FileType{".wasm", "application/wasm", false},
    FileType{".txt", "text/plain; charset=utf-8", false},
    FileType{".glb", "model/gltf-binary", true},
    FileType{".gltf", "model/gltf+json", true},
    FileType{".bin", "application/octet-stream", true},
    FileType{".png", "image/png", true},
    FileType{".jpg", "image/jpeg", true},
    FileType{".jpeg", "image/jpeg", true},
    FileType{".webp", "image/webp", true},
    FileType{".ktx2", "image/ktx2", true},
};

const FileType* type_of(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  const auto* found = std::find_if(k_types.begin(), k_types.end(),
                                   [&](const FileType& type) { return type.ending == ending; });
  return found == k_types.end() ? nullptr : found;
}

Answer refusal(int status, std::string text) {
  return {.status = status, .text = std::move(text) + "\n"};
}

// A file of a folder, which is canonical.
Answer file_of(const fs::path& folder, std::string_view name, bool is_scene) {
  std::error_code error;
  const fs::path file = fs::canonical(folder / fs::path(name).relative_path(), error);
  const auto [rest, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  if (!error && rest != folder.end()) return refusal(403, "refused: it is outside of the folder");
  // Not to tell what there is outside: ".." is refused whether it leads somewhere or not.
  for (const fs::path& part : fs::path(name))
    if (part == "..") return refusal(403, "refused: it is outside of the folder");
  if (error || !fs::is_regular_file(file, error)) return refusal(404, "not found");
  const FileType* type = type_of(file);
  if (is_scene && (!type || !type->of_scene))
    return refusal(403, "refused: a glTF file names no such files");
  return {.type = std::string(type ? type->type : "application/octet-stream"), .file = file};
}

} // namespace

Result<SceneSite> SceneSite::make(const fs::path& page, const fs::path& scene) {
  std::error_code error;
  SceneSite site;
  const FileType* type = type_of(scene);
  if (!fs::is_regular_file(scene, error))
    return Error{fmt::format("{}: not found, or no file", scene.string())};
  if (!type || (type->ending != ".glb" && type->ending != ".gltf"))
    return Error{fmt::format("{}: not a .glb or .gltf file", scene.string())};
  site.scene_ = fs::absolute(scene, error);
  site.folder_ = fs::canonical(site.scene_.parent_path(), error);
  if (error) return Error{fmt::format("{}: {}", scene.string(), error.message())};
  site.page_ = fs::canonical(page, error);
  if (error || !fs::is_regular_file(site.page_ / "viewer.html", error))
    return Error{fmt::format("{}: there is no viewer.html", page.string())};
  return site;
}

Answer SceneSite::answer(const Request& request, int port) const {
  if (request.host != fmt::format("127.0.0.1:{}", port) &&
      request.host != fmt::format("localhost:{}", port))
    return refusal(403, "refused: this server answers to 127.0.0.1 and localhost alone");
  if (request.method != "GET" && request.method != "HEAD")
    return refusal(405, "refused: there are files to get, nothing else");
  const std::string name = scene_.filename().string();
  if (request.path == "/")
    return {.status = 302,
            .text = "",
            .location = "/viewer.html?watch&scene=" + percent_encoded(std::string(k_scene_prefix)) +
                        percent_encoded(percent_encoded(name))};
  if (request.path == "/version") {
    std::error_code error;
    const auto time = fs::last_write_time(scene_, error);
    if (error) return refusal(404, "not found");
    const auto size = fs::file_size(scene_, error);
    return {.text = fmt::format("{} {}\n", time.time_since_epoch().count(), error ? 0 : size)};
  }
  if (request.path.compare(0, k_scene_prefix.size(), k_scene_prefix) == 0)
    return file_of(folder_, std::string_view(request.path).substr(k_scene_prefix.size()), true);
  return file_of(page_, request.path, false);
}

} // namespace openltc::cli
