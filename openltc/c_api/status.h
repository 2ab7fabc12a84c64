// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// How the C functions report what went wrong, and keep exceptions in.

#pragma once

#include "openltc/openltc_c.h"

#include <memory>
#include <string_view>

namespace openltc::c_api {

/// Keeps `message` as the calling thread's last error, cut off at its room, and returns `status`.
/// Takes no memory, so that the lack of it can be reported.
openltc_status fail(openltc_status status, std::string_view message) noexcept;

/// The status of the exception that is being handled, which becomes the last error.
openltc_status fail_by_exception() noexcept;

/// Calls body(), which returns a status, and turns an exception into one.
template <class Body> openltc_status guarded(Body&& body) noexcept {
  try {
    return body();
  } catch (...) {
    return fail_by_exception();
  }
}

/// Makes a handle, which fill(handle) completes; `*out` is null if that fails.
template <class Handle, class Fill> openltc_status create(Handle** out, Fill&& fill) noexcept {
  if (!out) return fail(OPENLTC_INVALID_ARGUMENT, "the handle to be made has no place: it is null");
  *out = nullptr;
  return guarded([&]() -> openltc_status {
    auto made = std::make_unique<Handle>();
    const openltc_status status = fill(*made);
    if (status == OPENLTC_OK) *out = made.release();
    return status;
  });
}

} // namespace openltc::c_api
