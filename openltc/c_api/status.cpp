// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

#include "openltc/c_api/status.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

namespace openltc::c_api {

namespace {

// An array, not a string: nothing to construct, allocate or destroy when a thread ends, which may
// be after the library was unloaded.
thread_local char last_error[1024] = "";

} // namespace

openltc_status fail(openltc_status status, std::string_view message) noexcept {
  std::size_t length = std::min(message.size(), sizeof(last_error) - 1);
  // Cut between the characters of UTF-8, not within one.
  if (length < message.size())
    while (length > 0 && (static_cast<unsigned char>(message[length]) & 0xc0) == 0x80)
      --length;
  std::memcpy(last_error, message.data(), length);
  last_error[length] = '\0';
  return status;
}

openltc_status fail_by_exception() noexcept {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return fail(OPENLTC_OUT_OF_MEMORY, "out of memory");
  } catch (const std::length_error&) {
    return fail(OPENLTC_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& exception) {
    return fail(OPENLTC_INTERNAL_ERROR, exception.what());
  } catch (...) {
    return fail(OPENLTC_INTERNAL_ERROR, "an exception of unknown type");
  }
}

} // namespace openltc::c_api

const char* openltc_last_error(void) { return openltc::c_api::last_error; }

const char* openltc_version(void) { return OPENLTC_VERSION; }
