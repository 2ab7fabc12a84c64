// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Throwing and catching. The packaged libc++abi is made without it; the compiler
// (-fwasm-exceptions) leaves to the library which of a function's handlers takes an exception, and
// who owns it.
//
// Source: Itanium C++ ABI, "Exception Handling", Level II; the tables are those of LLVM's
// "Exception Handling in LLVM", with one entry for each landing pad of a function.

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <typeinfo>

// What is thrown is an address, for WebAssembly itself.
__asm__(".tagtype __cpp_exception i32\n.globl __cpp_exception\n__cpp_exception:\n");

// What the compiler's code writes before it asks, and reads afterwards.
extern "C" {
struct LandingPad {
  std::uintptr_t index;
  const std::uint8_t* table; // of the function
  std::uintptr_t selector;   // which of its types takes the exception, 0 = none
};
LandingPad __wasm_lpad_context = {};
}

namespace {

// In front of each object that is thrown; what is thrown is the address of it.
struct alignas(std::max_align_t) Thrown {
  const std::type_info* type;
  void* (*destroy)(void*); // which gives back its argument, as all destructors do here
  Thrown* below;           // the one that was being handled before
  int handlers;
  bool rethrown;
  void* object() { return this + 1; }
};

Thrown* handled = nullptr;

std::uintptr_t read_unsigned(const std::uint8_t*& at) {
  std::uintptr_t value = 0;
  unsigned shift = 0;
  do
    value |= std::uintptr_t(*at & 0x7F) << shift, shift += 7;
  while (*at++ & 0x80);
  return value;
}

std::intptr_t read_signed(const std::uint8_t*& at) {
  std::uintptr_t value = 0;
  unsigned shift = 0;
  do
    value |= std::uintptr_t(*at & 0x7F) << shift, shift += 7;
  while (*at++ & 0x80);
  if ((at[-1] & 0x40) && shift < 8 * sizeof value) value |= ~std::uintptr_t(0) << shift;
  return std::intptr_t(value);
}

// Whether a handler of that class takes objects of the other: the same, or its one public base, at
// the same address, as all classes that are thrown here derive. A class with such a base has its
// type_info behind the name.
bool takes(const std::type_info* handler, const std::type_info* type) {
  static const void* const with_base = [] {
    const void* table;
    std::memcpy(&table, static_cast<const void*>(&typeid(std::bad_array_new_length)), sizeof table);
    return table;
  }();
  for (;;) {
    if (*handler == *type) return true;
    const void* words[3];
    std::memcpy(words, static_cast<const void*>(type), sizeof(void*));
    if (words[0] != with_base) return false;
    std::memcpy(words, static_cast<const void*>(type), sizeof words);
    type = static_cast<const std::type_info*>(words[2]);
  }
}

// The handler of a function's landing pad for what was thrown; 0 where it has none.
std::uintptr_t find_handler(const std::uint8_t* table, std::uintptr_t index,
                            const std::type_info* type) {
  constexpr std::uint8_t omitted = 0xFF;
  if (*table++ != omitted) std::abort(); // no base of its own
  if (*table++ == omitted) return 0;     // no types
  const std::uintptr_t to_types = read_unsigned(table);
  const std::uint8_t* const types = table + to_types;
  ++table; // the encoding of what follows, which is always this
  const std::uintptr_t size = read_unsigned(table);
  const std::uint8_t* const actions = table + size;
  std::uintptr_t action = 0;
  for (std::uintptr_t i = 0; i <= index && table < actions; ++i) {
    read_unsigned(table); // its landing pad
    action = read_unsigned(table);
  }
  if (action == 0) return 0; // cleanup alone
  for (const std::uint8_t* at = actions + action - 1;;) {
    const std::intptr_t filter = read_signed(at);
    if (filter > 0) {
      const std::type_info* handler;
      std::memcpy(&handler, types - std::uintptr_t(filter) * sizeof handler, sizeof handler);
      if (!handler || takes(handler, type)) return std::uintptr_t(filter);
    }
    const std::uint8_t* const next = at;
    const std::intptr_t step = read_signed(at);
    if (step == 0) return 0;
    at = next + step;
  }
}

[[noreturn]] void raise(Thrown* thrown) { __builtin_wasm_throw(0, thrown); }

} // namespace

extern "C" {

void* __cxa_allocate_exception(std::size_t size) noexcept {
  auto* thrown = static_cast<Thrown*>(std::calloc(1, sizeof(Thrown) + size));
  if (!thrown) std::abort();
  return thrown->object();
}

void __cxa_free_exception(void* object) noexcept { std::free(static_cast<Thrown*>(object) - 1); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Thrown* const thrown = static_cast<Thrown*>(object) - 1;
  thrown->type = type;
  thrown->destroy = destroy;
  raise(thrown);
}

void* __cxa_get_exception_ptr(void* exception) noexcept {
  return static_cast<Thrown*>(exception)->object();
}

void* __cxa_begin_catch(void* exception) noexcept {
  auto* const thrown = static_cast<Thrown*>(exception);
  thrown->rethrown = false;
  if (thrown->handlers++ == 0) {
    thrown->below = handled;
    handled = thrown;
  }
  return thrown->object();
}

void __cxa_end_catch() {
  Thrown* const thrown = handled;
  if (--thrown->handlers > 0) return;
  handled = thrown->below;
  if (thrown->rethrown) return;
  if (thrown->destroy) thrown->destroy(thrown->object());
  std::free(thrown);
}

[[noreturn]] void __cxa_rethrow() {
  handled->rethrown = true;
  raise(handled);
}

// Where nothing may be thrown.
[[noreturn]] void __clang_call_terminate(void*) { std::terminate(); }

int __gxx_wasm_personality_v0(...) { return 0; } // named by the compiler, not called

int _Unwind_CallPersonality(void* exception) {
  LandingPad& pad = __wasm_lpad_context;
  pad.selector = find_handler(pad.table, pad.index, static_cast<Thrown*>(exception)->type);
  return 0;
}

} // extern "C"
