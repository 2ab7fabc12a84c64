// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// The layouts in which engines read a lobe table, from and to the native one.

#pragma once

#include "openltc/base/result.h"
#include "openltc/table/lobe_table.h"
#include "openltc/table/texture.h"
#include "openltc/target/shade_f64.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace openltc::table {

/// Layouts. Mij is row i, column j of M^-1 from 0; wo = (sin theta, 0, cos theta), x towards it.
/// In all of them but the last x is the perceptual roughness; node i of N lies at (i + 1/2)/N, the
/// half-texel rule; amplitude F0 n1 + (F90 - F0) n5.
enum class Layout {
  /// This project's (lobe_table.h): A B C D | n1 n5 0 0; y = sqrt(1 - cos theta).
  native,
  /// ltc_code since October 2017, three.js, Babylon.js, Bevy, EEVEE:
  /// M00 M20 M02 M22 with M11 = 1 | n1 n5 0 s; y = sqrt(1 - cos theta). s is the form factor of the
  /// clipped sphere (clipped_sphere.h) on axes of its own, x = z/2 + 1/2, y = |F|.
  ltc_code,
  /// Unity HDRP, a slice of _LtcData (LTCAreaLight.hlsl): M00 M20 M11 M02 with M22 = 1, read as
  /// _m00_m02_m11_m20 of the transposed matrix; y = sqrt(1 - cos theta). No amplitudes: they come
  /// from the engine's preintegrated FGD texture.
  unity,
  /// Godot (area_lights_inc.glsl): a b c d | e n1 n5 0 of M = [a 0 d; 0 c 0; b 0 e], here with the
  /// third column of length 1; y = theta / (pi/2), roughness at least .02. theta is a polynomial
  /// that is off by up to .5 degrees; the rows hold the lobes of where the shader reads them.
  godot,
  /// O3DE (Ltc.azsli): x y z w of [1 0 w; 0 z 0; y 0 x], that is M22 M20 M11 M02 with M00 = 1 |
  /// n1 n5 (two channels); y = theta / (pi/2).
  o3de,
  /// This project's with a second lobe: A B C D | n1 n5 w 0 | A B C D of the second, which has the
  /// share w of n1; y = sqrt(1 - cos theta). No engine reads it.
  native_two,
  /// ltc_code read at x = alpha, at least .001, where x should be the roughness: PlayCanvas
  /// (ltc.js, getLTCLightUV) and Ogre-Next (AreaLights_LTC_piece_ps.any). The columns hold the
  /// lobes of where the shader reads them. Of engines alone (engine.h).
  ltc_code_alpha,
};

/// All layouts of one lobe that can be asked for by name, and the names of all in files and on the
/// command line.
std::span<const Layout> all_layouts();
const char* name_of(Layout layout);
const char* name_of(Precision precision);         ///< "float32", "float16"
const char* name_of(AngleAxis axis);              ///< "sqrt(1 - cos theta)", "theta"
const Layout* find_layout(std::string_view name); ///< nullptr when there is none

/// What is fixed for a layout.
struct LayoutFacts {
  AngleAxis angle_axis;
  bool has_amplitudes;       ///< n1 and n5
  int usual_size;            ///< the size compiled into the engines that read it; 0: any
  const char* readers;       ///< who reads it
  const char* normalisation; ///< one line
  std::vector<std::vector<const char*>> channels; ///< of each texture, by name
};
const LayoutFacts& facts_of(Layout layout);
AngleAxis angle_axis_of(Layout layout);

/// Whether it is this project's own packing, of one lobe or two.
inline bool is_native(Layout layout) {
  return layout == Layout::native || layout == Layout::native_two;
}

/// A table as an engine reads it: one to three textures of the same size.
struct PackedTable {
  Layout layout = Layout::native;
  Precision precision = Precision::float32;
  AngleAxis angle_axis = AngleAxis::sqrt_one_minus_cos;
  brdf::LobeWidth width = brdf::LobeWidth::alpha; ///< what the native packing factors out
  std::vector<Texture> textures; ///< their precision is that of the table; no metadata of their own
  TableMetadata metadata;

  int columns() const { return textures.empty() ? 0 : textures[0].width; }
  int rows() const { return textures.empty() ? 0 : textures[0].height; }
};

/// Roughness of a column's nodes, and the width that is factored out there. A single column stands
/// for all roughnesses; it is taken as roughness 1. column_roughness is that at which a layout's
/// shader reads the column, another only for ltc_code_alpha.
double node_roughness(int columns, int column);
double column_roughness(Layout layout, int columns, int column);
double node_width(brdf::LobeWidth width, int columns, int column);

/// The cosine of the view angle at row `row` of `rows` for the matrices of a layout: where its
/// shader reads that row. At the grazing row itself, cos theta = 0, all but the native packing have
/// no finite or no useful value; they hold the row's lobe at .03 of the cosine of the row before,
/// as the fitter does. Mean TV over the last cell by that share, 64 rows, roughness .06-1:
///   share      .01    .03    .10    .35    .70
///   ltc_code   .1807  .1809  .1817  .1867  .1959   (native .1747)
///   o3de       .1813  .1814  .1823  .1892  .2004
/// and at roughness .01-.06, where interpolated matrices miss the lobe altogether, .41-.68 at .03.
double row_cosine(Layout layout, AngleAxis axis, int rows, int row);

/// Packs a table. Where its axes are not the layout's (theta, Godot's polynomial, alpha) it is
/// resampled, otherwise the nodes are exact. In half precision every value is rounded to the
/// nearest half, but that M00 and M02 of ltc_code and unity, whose ratio is the lobe's direction,
/// may be up to 8 halves away; where a determinant would be negative, one element goes up to the
/// next halves. Fails when a value does not fit, naming the texel, and when table and layout have
/// not as many lobes.
Result<PackedTable> pack(const LobeTable& table, Layout layout, Precision precision);

/// The inverse of pack, on the layout's own angle axis: exact at the nodes up to rounding, but for
/// Godot's and those over alpha, which are resampled. Fails
/// on a texel without a lobe (determinant not positive). Without amplitudes n1 is 1 and n5 is 0;
/// those that are divided (divided.h) are multiplied again, and the table is a clipped one.
Result<LobeTable> unpack(const PackedTable& packed);

/// What an engine of that layout reads: its own axes, its own stored values, rounded as they are
/// stored, bilinear. roughness and cos_theta 0..1.
f64::FittedLobe fetch_packed(const PackedTable& packed, double roughness, double cos_theta);

/// Where an engine of that layout reads the table: coordinates 0..1 of column and row, node i of N
/// at i/(N - 1).
Vec2d look_up_position(const PackedTable& packed, double roughness, double cos_theta);

/// The second lobe that is read there; of no weight but in native_two.
f64::SecondLobe fetch_packed_second(const PackedTable& packed, double roughness, double cos_theta);

/// The lobe and amplitudes in the channels of a texel, `second` being empty for a layout of one
/// texture. `width` and `cos_theta` matter to the native layout only.
f64::FittedLobe lobe_of_texel(Layout layout, std::span<const double> first,
                              std::span<const double> second, double width, double cos_theta);

/// The channels of a texture at uv in [0, 1], bilinear between texel centres, clamped at the
/// border.
std::array<double, 4> sample_texture(const Texture& texture, double u, double v);

/// A table whose values are stored in another precision; as pack does it.
Result<PackedTable> with_precision(const PackedTable& packed, Precision precision);

/// Whether the number and channels of the textures are the layout's and all sizes agree.
Status check_textures(const std::string& name, Layout layout, std::span<const Texture> textures);

/// Reads a table through bilinear interpolation on its own angle axis, as fetch_lobe does on the
/// native one.
f64::FittedLobe fetch_native(const LobeTable& table, double roughness, double cos_theta);

/// The second lobe there; of no weight where the table has one only.
f64::SecondLobe fetch_native_second(const LobeTable& table, double roughness, double cos_theta);

/// The table with other nodes, read from its own interpolation. A side of 1 holds one value for all
/// roughnesses; columns 1..512, rows 2..512.
Result<LobeTable> resample(const LobeTable& table, int columns, int rows, AngleAxis axis);

} // namespace openltc::table
