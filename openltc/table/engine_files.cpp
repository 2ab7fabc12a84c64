// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Sources, each the project's own code that reads the table:
// three.js r187, examples/jsm/lights/RectAreaLightTexturesLib.js
// Babylon.js 9, Lights/LTC/ltcTextureTool.ts
// PlayCanvas 2, src/scene/area-light-luts.js
// Bevy 0.19, crates/bevy_pbr/src/lib.rs
// Blender, source/blender/draw/engines/eevee/eevee_lut.hh
// Unity HDRP, Runtime/Material/LTCAreaLight/Generated/LtcData.BRDF_GGX.cs
// Godot, servers/rendering/storage/ltc
// O3DE, LtcCommon in Gems/Atom/Feature/Common/Code/Source/CoreLights
// Ogre-Next, Samples/Media/Hlms/Pbs/Any/AreaLights_LTC_piece_ps.any

#include "openltc/base/atomic_file.h"
#include "openltc/table/container/container.h"
#include "openltc/table/container/description.h"
#include "openltc/table/engine.h"
#include "openltc/table/half.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace openltc::table {

namespace {

constexpr const char* k_alpha_slip =
    "reads the columns at alpha, not at the roughness; they are fitted for that";

constexpr const char* k_module =
    R"(// LTC tables of GGX by OpenLTC, in place of three.js's own. SPDX-License-Identifier: MIT

import * as THREE from 'three';

const LTC_MAT_1 = [
{}];

const LTC_MAT_2 = [
{}];

function texture( data, type ) {{

	const result = new THREE.DataTexture( data, {}, {}, THREE.RGBAFormat, type, THREE.UVMapping,
		THREE.ClampToEdgeWrapping, THREE.ClampToEdgeWrapping, THREE.LinearFilter, THREE.NearestFilter, 1 );
	result.needsUpdate = true;
	return result;

}}

function halves( values ) {{

	return Uint16Array.from( values, ( x ) => THREE.DataUtils.toHalfFloat( x ) );

}}

class RectAreaLightTexturesLib {{

	static init() {{

		this.LTC_FLOAT_1 = texture( new Float32Array( LTC_MAT_1 ), THREE.FloatType );
		this.LTC_FLOAT_2 = texture( new Float32Array( LTC_MAT_2 ), THREE.FloatType );
		this.LTC_HALF_1 = texture( halves( LTC_MAT_1 ), THREE.HalfFloatType );
		this.LTC_HALF_2 = texture( halves( LTC_MAT_2 ), THREE.HalfFloatType );
		return this;

	}}

}}

export {{ RectAreaLightTexturesLib }};
)";

constexpr const char* k_unity =
    R"(// The LTC table of GGX by OpenLTC, in place of HDRP's own. SPDX-License-Identifier: MIT

namespace UnityEngine.Rendering.HighDefinition
{{
    internal partial class LTCAreaLight
    {{
        // M^-1 divided by M22: elements 00, 20, 11, 02 in half precision; [roughness + {0} * angle].
        internal static ushort[] s_LtcMatrixData_BRDF_GGX = new ushort[{0} * {0} * 4]
        {{
{1}        }};
    }}
}}
)";

// `channels` of a texture as text, a row of the table on each line.
std::string numbers(const Texture& texture, int channels) {
  std::string out;
  for (std::size_t at = 0; at < texture.values.size(); ++at) {
    const std::size_t column = at % std::size_t(texture.channels);
    if (column >= std::size_t(channels)) continue;
    out += fmt::format("{:.6g},", texture.values[at]);
    if ((at + std::size_t(texture.channels) - column) %
                std::size_t(texture.width * texture.channels) ==
            0 &&
        int(column) + 1 == channels)
      out += "\n";
  }
  return out;
}

// The same without the last comma, which JSON does not have.
std::string json_numbers(const Texture& texture) {
  std::string out = numbers(texture, texture.channels);
  out.resize(out.size() - 2);
  return out;
}

std::string halves(const Texture& texture) {
  std::string out;
  for (std::size_t at = 0; at < texture.values.size(); ++at) {
    out += fmt::format("{},", half_from_float(texture.values[at]));
    if ((at + 1) % std::size_t(texture.width * texture.channels) == 0) out += "\n";
  }
  return out;
}

Bytes to_bytes(const std::string& text) { return Bytes(text.begin(), text.end()); }

// Texel after texel, that of the second texture behind that of the first.
Bytes interleaved(const PackedTable& packed) {
  Bytes first, second, out;
  append_values(first, packed.textures[0]);
  append_values(second, packed.textures[1]);
  const std::size_t texel = 4 * bytes_of(packed.precision);
  for (std::size_t at = 0; at < first.size(); at += texel) {
    out.insert(out.end(), first.begin() + std::ptrdiff_t(at),
               first.begin() + std::ptrdiff_t(at + texel));
    out.insert(out.end(), second.begin() + std::ptrdiff_t(at),
               second.begin() + std::ptrdiff_t(at + texel));
  }
  return out;
}

// The bytes of every file, in the order of Engine::files.
std::vector<Bytes> contents(const PackedTable& packed, std::string_view engine) {
  const std::vector<Texture>& t = packed.textures;
  if (engine == "threejs")
    return {to_bytes(fmt::format(k_module, numbers(t[0], 4), numbers(t[1], 4), packed.columns(),
                                 packed.rows()))};
  if (engine == "babylon") return {interleaved(packed)};
  if (engine == "playcanvas")
    return {to_bytes(fmt::format("{{\"LTC_MAT_1\": [\n{}],\n\"LTC_MAT_2\": [\n{}]}}\n",
                                 json_numbers(t[0]), json_numbers(t[1])))};
  if (engine == "bevy") return {encode_ktx2_array(t)};
  if (engine == "eevee")
    return {
        to_bytes(fmt::format("/* LTC tables of GGX by OpenLTC, in place of those of eevee_lut.cc. "
                             "SPDX-License-Identifier: MIT */\n\n"
                             "const float ltc_mat_ggx[{0}][{0}][4] = {{\n{1}}};\n\n"
                             "const float ltc_mag_ggx[{0}][{0}][2] = {{\n{2}}};\n",
                             packed.columns(), numbers(t[0], 4), numbers(t[1], 2)))};
  if (engine == "unity") return {to_bytes(fmt::format(k_unity, packed.columns(), halves(t[0])))};
  return {encode_dds(t[0]), encode_dds(t[1])}; // Godot, O3DE, Ogre-Next
}

} // namespace

std::span<const Engine> all_engines() {
  constexpr Precision f32 = Precision::float32, f16 = Precision::float16;
  static const std::vector<Engine> engines = {
      {"threejs",
       "three.js",
       Layout::ltc_code,
       64,
       f32,
       {"RectAreaLightTexturesLib.js"},
       "three/examples/jsm/lights/ (three/addons/lights), or import it from your own folder",
       ""},
      {"playcanvas",
       "PlayCanvas",
       Layout::ltc_code_alpha,
       64,
       f32,
       {"area-light-luts.json"},
       "an asset of your project, for app.setAreaLightLuts(luts.LTC_MAT_1, luts.LTC_MAT_2)",
       k_alpha_slip},
      {"babylon",
       "Babylon.js",
       Layout::ltc_code,
       64,
       f16,
       {"areaLightsLTC.bin"},
       "core/areaLights/ of your copy of the assets server (Tools.AssetBaseUrl)",
       ""},
      {"bevy", "Bevy", Layout::ltc_code, 64, f16, {"ltc.ktx2"}, "crates/bevy_pbr/src/ltc/", ""},
      {"eevee",
       "EEVEE (Blender)",
       Layout::ltc_code,
       64,
       f32,
       {"eevee_lut_ltc.hh"},
       "source/blender/draw/engines/eevee/, instead of the two arrays in eevee_lut.cc",
       "takes amplitudes from a table of its own, so only the lobes change"},
      {"unity",
       "Unity HDRP",
       Layout::unity,
       64,
       f16,
       {"LtcData.BRDF_GGX.cs"},
       "Runtime/Material/LTCAreaLight/Generated/ of a copy of the HDRP package in Packages/",
       "takes amplitudes from a table of its own, so only the lobes change"},
      {"godot",
       "Godot",
       Layout::godot,
       64,
       f32,
       {"ltc_lut1.dds", "ltc_lut2.dds"},
       "servers/rendering/storage/ltc/; then build the engine",
       "computes angles that are off by up to 0.5 degrees; rows are fitted for where it reads "
       "them"},
      {"o3de",
       "O3DE",
       Layout::o3de,
       32,
       f32,
       {"ltc_mat_lutrgba32f.dds", "ltc_amp_lutrg32f.dds"},
       "Gems/Atom/Feature/Common/Assets/Textures/ltc/",
       ""},
      {"ogre-next",
       "Ogre-Next",
       Layout::ltc_code_alpha,
       64,
       f16,
       {"ltcMatrix0.dds", "ltcMatrix1.dds"},
       "the resource folder from which HlmsPbs::loadLtcMatrix reads (Samples/Media/Common)",
       k_alpha_slip},
  };
  return engines;
}

const Engine* find_engine(std::string_view name) {
  for (const Engine& engine : all_engines())
    if (name == engine.name) return &engine;
  return nullptr;
}

Result<std::vector<std::pair<std::string, Bytes>>> engine_files(const PackedTable& packed,
                                                                const Engine& engine) {
  if (packed.layout != engine.layout || packed.precision != engine.precision)
    return Error{fmt::format("a table of layout {}, {} is not for {}, which reads {}, {}",
                             name_of(packed.layout), name_of(packed.precision), engine.title,
                             name_of(engine.layout), name_of(engine.precision))};
  if (packed.columns() != engine.size || packed.rows() != engine.size)
    return Error{fmt::format("a table of {} x {} nodes is not for {}, which reads {} x {}",
                             packed.columns(), packed.rows(), engine.title, engine.size,
                             engine.size)};
  if (Status status = check_textures(engine.title, packed.layout, packed.textures); !status)
    return status.error();
  std::vector<Bytes> bytes = contents(packed, engine.name);
  std::vector<std::pair<std::string, Bytes>> files;
  for (std::size_t i = 0; i < engine.files.size(); ++i)
    files.emplace_back(engine.files[i], std::move(bytes[i]));
  return files;
}

std::vector<std::string> engine_paths(const Engine& engine, const std::string& folder) {
  std::vector<std::string> paths;
  for (const char* name : engine.files)
    paths.push_back((std::filesystem::path(folder) / name).string());
  paths.push_back((std::filesystem::path(folder) / k_engine_description).string());
  return paths;
}

Result<std::vector<std::string>> write_engine_files(const PackedTable& packed, const Engine& engine,
                                                    const std::string& folder) {
  Result<std::vector<std::pair<std::string, Bytes>>> files = engine_files(packed, engine);
  if (!files) return files.error();
  files->emplace_back(k_engine_description, to_bytes(description_to_json(describe(packed))));
  const std::vector<std::string> paths = engine_paths(engine, folder);
  std::vector<FileBytes> placed;
  for (std::size_t i = 0; i < paths.size(); ++i)
    placed.push_back({paths[i], std::move((*files)[i].second)});
  return write_files(placed);
}

} // namespace openltc::table
