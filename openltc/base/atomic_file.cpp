// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/base/atomic_file.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <unistd.h>

namespace openltc {

namespace {

// Paths being written now. Fixed storage, so that a signal handler may read it.
constexpr std::size_t k_max_path = 4096;
constexpr std::size_t k_slots = 16;
struct Slot {
  std::atomic<int> state{0}; // 0 free, 1 being filled, 2 in use
  char path[k_max_path];
};
std::array<Slot, k_slots> g_slots;
std::atomic<unsigned> g_counter{0};

class Registration {
public:
  explicit Registration(const std::string& path) {
    if (path.size() + 1 > k_max_path) return;
    for (Slot& slot : g_slots) {
      int expected = 0;
      if (!slot.state.compare_exchange_strong(expected, 1)) continue;
      std::memcpy(slot.path, path.c_str(), path.size() + 1);
      slot.state.store(2);
      slot_ = &slot;
      return;
    }
  }
  ~Registration() {
    if (slot_) slot_->state.store(0);
  }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;

private:
  Slot* slot_ = nullptr;
};

} // namespace

void remove_temporary_files() noexcept {
  for (Slot& slot : g_slots)
    if (slot.state.load() == 2) ::unlink(slot.path);
}

Status write_atomically(const std::string& path,
                        const std::function<Status(const std::string& temporary)>& write) {
  namespace fs = std::filesystem;
  const fs::path target(path);
  if (path.empty()) return Error{"the output path is empty"};
  std::error_code ec;
  if (fs::is_directory(target, ec)) return Error{fmt::format("{}: is a directory", path)};
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ec))
    return Error{fmt::format("{}: the folder {} does not exist", path, folder.string())};

  // A name may have 255 bytes; a long one must not make the temporary one too long.
  const fs::path temporary =
      folder / fmt::format(".{}.{}-{}.part{}", target.stem().string().substr(0, 100), ::getpid(),
                           g_counter.fetch_add(1), target.extension().string());
  const Registration registration(temporary.string());
  Status status = Success{};
  try {
    status = write(temporary.string());
  } catch (const std::exception& e) {
    status = Error{fmt::format("{}: {}", path, e.what())};
  } catch (...) {
    status = Error{fmt::format("{}: cannot write", path)};
  }
  if (status.ok() && std::rename(temporary.c_str(), path.c_str()) != 0)
    status = Error{fmt::format("{}: cannot write: {}", path, std::strerror(errno))};
  if (!status.ok()) fs::remove(temporary, ec);
  return status;
}

} // namespace openltc
