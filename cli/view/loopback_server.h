// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// A server for the browsers of this machine, of one thread.

#pragma once

#include "cli/view/scene_site.h"
#include "openltc/base/result.h"

#include <functional>

namespace openltc::cli {

/// Listens on the loopback interface alone, 127.0.0.1, so that no other machine reaches it.
class LoopbackServer {
public:
  /// `port` 0 takes a free one. Fails where the port is taken.
  static Result<LoopbackServer> make(int port);
  LoopbackServer(LoopbackServer&& other) noexcept;
  LoopbackServer& operator=(LoopbackServer&&) = delete;
  ~LoopbackServer();

  int port() const { return port_; }

  /// Answers requests, one after the other, until the process ends; returns where it cannot go on.
  /// A request whose head has more than 16 KiB, or does not come in half a minute, has no answer.
  Error serve(const std::function<Answer(const Request&)>& answer) const;

private:
  LoopbackServer(int socket, int port) : socket_(socket), port_(port) {}
  int socket_, port_;
};

} // namespace openltc::cli
