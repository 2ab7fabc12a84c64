// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What openltc inspect says about a file, one function per kind of file.

#pragma once

#include "openltc/base/result.h"
#include "openltc/fit/measure/error.h"
#include "openltc/scene/emissive/emissive.h"
#include "openltc/scene/read_options.h"
#include "openltc/table/lobe_table.h"

#include <nlohmann/json.hpp>
#include <string>

namespace openltc::cli {

/// The same facts twice: for people, lines that end in a newline, and for programs.
struct Description {
  std::string text;
  nlohmann::ordered_json json;
};

/// Mean and maximum TV that a file states, for people; 0 stands for not known.
std::string stated_errors(const table::TableMetadata& metadata);
/// Adds how far lobes are from the BRDF of this name; nothing where there is no such BRDF.
void add_measured_errors(const std::string& brdf_name, const fit::LobeFunction& lobes,
                         fit::Horizon horizon, Description& out);
/// A number that is 0 when it is not known: then null.
nlohmann::ordered_json known_or_null(double number);

/// A lobe table, .json .dds .ktx2 .npy: metadata, errors, ranges; for a bare texture what it most
/// probably is.
Result<Description> inspect_table(const std::string& path);
/// A lobe polynomial, .json: metadata, errors, and the proof of its determinant made anew.
Result<Description> inspect_polynomial(const std::string& path);
/// An .exr: a table when its attributes say so or NAME_1.exr and NAME_2.exr of one small size lie
/// side by side, a picture otherwise.
Result<Description> inspect_exr(const std::string& path);
/// A picture, .exr .hdr .png .jpg: size, parts and layers, range of each channel, exposure. Of one
/// layer only if it is named.
Result<Description> inspect_picture(const std::string& path, const std::string& layer = "");
/// A photometric file, .ies .ldt: flux, peak, angles, symmetry, opening, what it states.
Result<Description> inspect_photometry(const std::string& path);
/// A glTF scene, .gltf .glb: geometry, cameras, lights in photometric units, animations, warnings.
Result<Description> inspect_scene(const std::string& path, const scene::EmissiveOptions& emissive,
                                  const scene::ReadOptions& reading);

} // namespace openltc::cli
