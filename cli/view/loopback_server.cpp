// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "cli/view/loopback_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <list>
#include <netinet/in.h>
#include <optional>
#include <poll.h>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <vector>

namespace openltc::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t k_most_head = 16 * 1024, k_most_connections = 64;
constexpr std::chrono::seconds k_patience{30}; // for a head
constexpr time_t k_write_patience = 10;        // seconds, for a reader who takes nothing

// A browser opens some before it knows what it wants.
struct Connection {
  int socket;
  Clock::time_point end;
  std::string head;
};

bool send_all(int socket, std::string_view data) {
  while (!data.empty()) {
    const ssize_t sent = ::send(socket, data.data(), data.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    data.remove_prefix(std::size_t(sent));
  }
  return true;
}

std::string_view phrase_of(int status) {
  switch (status) {
  case 200:
    return "OK";
  case 302:
    return "Found";
  case 400:
    return "Bad Request";
  case 403:
    return "Forbidden";
  case 404:
    return "Not Found";
  case 405:
    return "Method Not Allowed";
  default:
    return "Error";
  }
}

// No other page may read what is here, and no browser guesses what it is or keeps it.
std::string head_of(const Answer& answer, std::size_t size) {
  return fmt::format("HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\n{}{}"
                     "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
                     "Cross-Origin-Resource-Policy: same-origin\r\n"
                     "Referrer-Policy: no-referrer\r\nX-Frame-Options: DENY\r\n"
                     "Connection: close\r\n\r\n",
                     answer.status, phrase_of(answer.status), answer.type, size,
                     answer.location.empty() ? "" : "Location: " + answer.location + "\r\n",
                     answer.status == 405 ? "Allow: GET, HEAD\r\n" : "");
}

void send_answer(int socket, const Answer& answer, bool with_body) {
  std::ifstream file;
  std::size_t size = answer.text.size();
  if (!answer.file.empty()) {
    file.open(answer.file, std::ios::binary | std::ios::ate);
    if (!file) { // it has gone meanwhile, or may not be read
      send_answer(socket, {.status = 404, .text = "not found\n"}, with_body);
      return;
    }
    size = std::size_t(file.tellg());
    file.seekg(0);
  }
  if (!send_all(socket, head_of(answer, size)) || !with_body) return;
  if (answer.file.empty()) {
    send_all(socket, answer.text);
    return;
  }
  std::vector<char> part(1 << 18);
  for (std::size_t left = size; left > 0;) {
    file.read(part.data(), std::streamsize(std::min(left, part.size())));
    const auto count = std::size_t(file.gcount());
    if (count == 0 || !send_all(socket, {part.data(), count})) return;
    left -= count;
  }
}

void accept_one(int listening, std::list<Connection>& connections) {
  const int socket = ::accept4(listening, nullptr, nullptr, SOCK_CLOEXEC);
  if (socket < 0) return;
  const timeval patience{k_write_patience, 0};
  ::setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  connections.push_back({socket, Clock::now() + k_patience, {}});
}

// Reads what is there. Whether the connection is at its end.
bool attend(Connection& connection, const std::function<Answer(const Request&)>& answer) {
  char part[4096];
  const ssize_t count = ::recv(connection.socket, part, sizeof part, MSG_DONTWAIT);
  if (count < 0) return errno != EAGAIN && errno != EINTR;
  if (count == 0) return true;
  connection.head.append(part, std::size_t(count));
  const std::size_t end = connection.head.find("\r\n\r\n");
  if (end == std::string::npos) return connection.head.size() > k_most_head;
  const std::optional<Request> request =
      parse_request(std::string_view(connection.head).substr(0, end));
  if (request)
    send_answer(connection.socket, answer(*request), request->method != "HEAD");
  else
    send_answer(connection.socket, {.status = 400, .text = "this is no request\n"}, true);
  return true;
}

} // namespace

Result<LoopbackServer> LoopbackServer::make(int port) {
  const int made = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (made < 0) return Error{fmt::format("no socket: {}", std::strerror(errno))};
  LoopbackServer server(made, port); // which closes it
  const int yes = 1;
  ::setsockopt(made, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(std::uint16_t(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  if (::bind(made, reinterpret_cast<const sockaddr*>(&address), length) != 0 ||
      ::listen(made, int(k_most_connections)) != 0 ||
      ::getsockname(made, reinterpret_cast<sockaddr*>(&address), &length) != 0)
    return Error{fmt::format("--port {}: {}; 0 takes a free one", port, std::strerror(errno))};
  server.port_ = ntohs(address.sin_port);
  return server;
}

LoopbackServer::LoopbackServer(LoopbackServer&& other) noexcept
    : socket_(other.socket_), port_(other.port_) {
  other.socket_ = -1;
}

LoopbackServer::~LoopbackServer() {
  if (socket_ >= 0) ::close(socket_);
}

Error LoopbackServer::serve(const std::function<Answer(const Request&)>& answer) const {
  std::list<Connection> connections;
  for (;;) {
    std::vector<pollfd> polled{{socket_, POLLIN, 0}};
    for (const Connection& connection : connections)
      polled.push_back({connection.socket, POLLIN, 0});
    if (::poll(polled.data(), polled.size(), 1000) < 0 && errno != EINTR)
      return Error{fmt::format("the server ends: {}", std::strerror(errno))};
    const Clock::time_point now = Clock::now();
    std::size_t k = 1;
    for (auto at = connections.begin(); at != connections.end(); ++k) {
      const bool is_over = polled[k].revents != 0 ? attend(*at, answer) : at->end < now;
      if (is_over) ::close(at->socket);
      at = is_over ? connections.erase(at) : std::next(at);
    }
    if ((polled[0].revents & POLLIN) == 0) continue;
    if (connections.size() == k_most_connections) { // the oldest one gives way
      ::close(connections.front().socket);
      connections.pop_front();
    }
    accept_one(socket_, connections);
  }
}

} // namespace openltc::cli
