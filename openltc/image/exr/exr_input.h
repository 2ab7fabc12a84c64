// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Opening OpenEXR files through the OpenEXR library, version 2.5 or 3. Private to this folder.

#pragma once

#include "openltc/base/regular_file.h"
#include "openltc/base/result.h"

#include <ImfIO.h>
#include <ImfMultiPartInputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace openltc::image {

/// A position in a file; OpenEXR 2 and 3 spell the type differently.
using ExrOffset = decltype(std::declval<Imf::OStream&>().tellp());

/// What the library reads from: a file, or bytes that outlive this.
class ExrStream : public Imf::IStream {
public:
  explicit ExrStream(RegularFile file);
  explicit ExrStream(std::span<const std::uint8_t> bytes);

  std::uint64_t size() const { return file_ ? file_->size() : bytes_.size(); }
  /// Up to to.size() bytes from `offset` on; throws what cannot be read.
  std::size_t read_at(std::uint64_t offset, std::span<std::uint8_t> to);

  bool read(char data[], int count) override;
  ExrOffset tellg() override { return ExrOffset(at_); }
  void seekg(ExrOffset to) override { at_ = std::uint64_t(to); }
  void clear() override {}

private:
  std::optional<RegularFile> file_;
  std::span<const std::uint8_t> bytes_;
  std::vector<std::uint8_t> block_; // of a file, since headers are read byte by byte
  std::uint64_t block_at_ = 0;
  std::uint64_t at_ = 0;
};

/// An open file: its stream must live as long as the library's object.
struct ExrFile {
  std::unique_ptr<ExrStream> stream;
  std::unique_ptr<Imf::MultiPartInputFile> parts;
};

/// Opens a file, or the bytes of one, of any number of parts, after a look at its headers. `name`
/// begins the message.
Result<ExrFile> open_exr(const std::string& path);
Result<ExrFile> open_exr(std::span<const std::uint8_t> bytes, const std::string& name);

/// Runs `function`, which returns a Result<T>. Whatever OpenEXR throws becomes one line.
template <class T, class Function>
Result<T> guarded_exr(const std::string& name, const char* action, Function&& function) {
  try {
    return function();
  } catch (const std::bad_alloc&) {
    return Error{fmt::format("{}: not enough memory for the picture", name)};
  } catch (const std::exception& e) {
    std::string text = e.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return Error{fmt::format("{}: cannot {} OpenEXR: {}", name, action, text)};
  } catch (...) {
    return Error{fmt::format("{}: cannot {} OpenEXR", name, action)};
  }
}

} // namespace openltc::image
