// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What the layers of a picture file are, and which of them is the picture.

#pragma once

#include "openltc/base/result.h"

#include <string>
#include <vector>

namespace openltc::image {

/// How the channels of a layer are read.
enum class LayerKind {
  color,            ///< R G B (A)
  luminance_chroma, ///< Y RY BY (A): OpenEXR's half of the colour resolution, made RGB
  xyz,              ///< X Y Z (A): CIE XYZ, made RGB
  grey,             ///< Y (A)
  vector,           ///< x y z of a position, normal or speed: numbers as they are, no colours
  channel,          ///< one channel of any other name: numbers as they are
  not_flat          ///< deep data and other kinds of parts, which are named but not read
};

/// A kind in words, for people: "colour", "luminance and chroma" ...
const char* name_of(LayerKind kind);

/// Whether a layer of this kind is a picture, in linear Rec.709 once it is read.
bool is_picture(LayerKind kind);

/// A rectangle of pixels; x to the right, y down.
struct Window {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Window&) const = default;
};

/// "640x480 from (0, 0)", or "none".
std::string describe(const Window& window);

struct LayerInfo {
  std::string name; ///< by which it is chosen; "" is the picture of a file of one part
  LayerKind kind = LayerKind::color;
  std::vector<std::string> channels; ///< full names, in the order of Image: colours, then alpha
  int part = 0;                      ///< of the file, from 0
  std::string part_name;             ///< "" where parts have none
  Window display;                    ///< the picture
  Window data;                       ///< where the file has values; 0 elsewhere
  double pixel_aspect = 1;           ///< width of a pixel over its height
  bool other_primaries = false;      ///< its colours are not Rec.709's in the file, but once read
};

/// What of a part counts in sorting its channels into layers.
struct PartChannels {
  std::string name; ///< "" for the only part of a file
  bool flat = true;
  std::vector<std::string> channels;
};

/// Sorts channels into layers by their names, NAME.R NAME.G NAME.B and so on (OpenEXR, "Technical
/// Introduction", channel names), also in small letters and as red, green, blue, alpha. In a file
/// of many parts a layer is PART or PART.NAME. Layers come part by part, the unnamed one first,
/// then by name; every channel is in exactly one, and no two have the same name. Only name, kind,
/// channels, part and part_name are set.
std::vector<LayerInfo> sort_into_layers(const std::vector<PartChannels>& parts);

/// The layer that `wanted` names: its name, or the beginning or end of one name only, up to a dot
/// ("Combined" of "ViewLayer.Combined"), or a single channel's full name. "" is the file's picture:
/// the unnamed one, or the only one of colour, or the only grey one. The error, which begins with
/// `file`, says which there are.
Result<LayerInfo> choose_layer(const std::vector<LayerInfo>& layers, const std::string& wanted,
                               const std::string& file);

} // namespace openltc::image
