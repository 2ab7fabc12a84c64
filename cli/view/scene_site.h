// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What `openltc view` shows to a browser: the page, one scene with the files beside it, and when
// the scene has changed.

#pragma once

#include "cli/view/request.h"
#include "openltc/base/result.h"

#include <filesystem>
#include <string>

namespace openltc::cli {

/// An answer: a text, or a file.
struct Answer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string text = {};           ///< where there is no file
  std::filesystem::path file = {}; ///< to be sent as it is
  std::string location = {};       ///< of a status 302
};

/// A page and a scene as addresses:
///   /              leads to the page with this scene
///   /version       a text that changes when the scene's file does
///   /scene/NAME    files of the scene's folder that a glTF file may name, by their endings
///   others         files of the page's folder
/// What leaves a folder, by "..", a link or in other ways, is refused.
class SceneSite {
public:
  /// `page` is a folder with viewer.html, `scene` a file. Fails where one is not there.
  static Result<SceneSite> make(const std::filesystem::path& page,
                                const std::filesystem::path& scene);

  /// What is answered to a request that came by `port` of this machine. Requests that name another
  /// host are refused, since a page of theirs would then be a page of ours (DNS rebinding).
  Answer answer(const Request& request, int port) const;

private:
  std::filesystem::path page_, folder_, scene_; // canonical; the scene's as it was given
};

} // namespace openltc::cli
