// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The limits are those of the extension's specification (Khronos glTF repository,
// EXT_meshopt_compression, 2020).

#include "openltc/scene/gltf/file/meshopt.h"

#include "openltc/scene/gltf/file/failure.h"
#include "openltc/scene/gltf/file/memory.h"

#ifdef OPENLTC_HAVE_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <fmt/format.h>

namespace openltc::scene::gltf {

#ifdef OPENLTC_HAVE_MESHOPTIMIZER

namespace {

// No codec makes more than 1024 bytes of one (256 vertices of which four bytes do not change);
// what claims more is not a stream, and is not worth an allocation.
constexpr std::size_t k_max_ratio = 1024;

void check(const MeshoptStream& stream, const std::string& field) {
  if (stream.mode == "ATTRIBUTES") {
    if (stream.stride == 0 || stream.stride % 4 != 0 || stream.stride > 256)
      fail(field + ".byteStride", "must be a multiple of 4 from 4 to 256");
  } else {
    if (stream.stride != 2 && stream.stride != 4) fail(field + ".byteStride", "must be 2 or 4");
    if (stream.filter != "NONE") fail(field + ".filter", "is only allowed for ATTRIBUTES");
    if (stream.mode == "TRIANGLES" && stream.count % 3 != 0)
      fail(field + ".count", "must be a multiple of 3");
  }
  const bool stride_fits_filter =
      stream.filter == "NONE" ||
      (stream.filter == "OCTAHEDRAL" && (stream.stride == 4 || stream.stride == 8)) ||
      (stream.filter == "QUATERNION" && stream.stride == 8) || stream.filter == "EXPONENTIAL";
  if (!stride_fits_filter)
    fail(field + ".byteStride", fmt::format("does not fit the filter {}", stream.filter));
  const std::uint64_t size = saturating_product(stream.count, stream.stride);
  if (stream.count == 0 || size / k_max_ratio > stream.bytes.size())
    fail(field + ".count",
         fmt::format("{} elements of {} bytes cannot come from {} compressed bytes; the file is "
                     "damaged",
                     stream.count, stream.stride, stream.bytes.size()));
}

} // namespace

bool has_meshopt_decoder() { return true; }

std::vector<std::uint8_t> decode_meshopt(const MeshoptStream& stream, const std::string& field,
                                         MemoryShare& memory) {
  check(stream, field);
  take_memory(memory, saturating_product(stream.count, stream.stride), field);
  std::vector<std::uint8_t> decoded(stream.count * stream.stride);
  const auto* bytes = stream.bytes.data();
  const std::size_t size = stream.bytes.size();
  int error = 0;
  if (stream.mode == "ATTRIBUTES")
    error = meshopt_decodeVertexBuffer(decoded.data(), stream.count, stream.stride, bytes, size);
  else if (stream.mode == "TRIANGLES")
    error = meshopt_decodeIndexBuffer(decoded.data(), stream.count, stream.stride, bytes, size);
  else
    error = meshopt_decodeIndexSequence(decoded.data(), stream.count, stream.stride, bytes, size);
  if (error != 0) fail(field, "the compressed data is damaged; export the file again");

  if (stream.filter == "OCTAHEDRAL")
    meshopt_decodeFilterOct(decoded.data(), stream.count, stream.stride);
  else if (stream.filter == "QUATERNION")
    meshopt_decodeFilterQuat(decoded.data(), stream.count, stream.stride);
  else if (stream.filter == "EXPONENTIAL")
    meshopt_decodeFilterExp(decoded.data(), stream.count, stream.stride);
  return decoded;
}

#else

bool has_meshopt_decoder() { return false; }

std::vector<std::uint8_t> decode_meshopt(const MeshoptStream&, const std::string& field,
                                         MemoryShare&) {
  fail(field, "this build has no meshoptimizer; install it and build again, or export the file "
              "without EXT_meshopt_compression");
}

#endif

} // namespace openltc::scene::gltf
