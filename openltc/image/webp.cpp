// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Reading WebP, lossy and lossless, through libwebp (optional). Container: Google, "WebP Container
// Specification": "RIFF", the size, "WEBP".

#include "openltc/image/codec.h"

#ifdef OPENLTC_HAVE_WEBP
#include <webp/decode.h>
#endif

#include <fmt/format.h>

#include <cstring>

namespace openltc::image::codec {

bool is_webp(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
         std::memcmp(bytes.data() + 8, "WEBP", 4) == 0;
}

#ifdef OPENLTC_HAVE_WEBP

bool has_webp() { return true; }

Result<Samples> decode_webp(std::span<const std::uint8_t> bytes, const std::string& name) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK)
    return Error{fmt::format("{}: a damaged WebP file", name)};
  if (features.has_animation)
    return Error{fmt::format("{}: an animated WebP file; save one of its pictures", name)};
  // The decoder holds planes of its own beside the result.
  if (Status ok = check_readable(name, features.width, features.height, 8); !ok) return ok.error();
  Samples samples;
  samples.width = features.width;
  samples.height = features.height;
  samples.channels = features.has_alpha ? 4 : 3;
  const std::shared_ptr<std::uint8_t> pixels = new_bytes(samples.count());
  if (!pixels) return Error{fmt::format("{}: not enough memory for the picture", name)};
  const auto decode = features.has_alpha ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
  if (!decode(bytes.data(), bytes.size(), pixels.get(), samples.count(),
              samples.width * samples.channels))
    return Error{fmt::format("{}: a damaged WebP file, or one cut short", name)};
  samples.bits8 = pixels;
  return samples;
}

#else

bool has_webp() { return false; }

Result<Samples> decode_webp(std::span<const std::uint8_t>, const std::string& name) {
  return Error{fmt::format("{}: a WebP file, which this build cannot read; install libwebp and "
                           "build again, or save it as PNG",
                           name)};
}

#endif

} // namespace openltc::image::codec
