// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Luminous intensity by direction, as photometric files tell it. light/photometry/photometry.h
// reads them.
//
// The light's own frame is that of shade/punctual.glsl: z the way the luminaire is aimed, where
// both angles of a file are 0, x and y across. Files have one of three systems of angles (ANSI/IES
// LM-63-2002, section 3; CIE 121-1996, planes A, B and C). With V the vertical and H the horizontal
// angle, a direction is
//   C  (sin V cos H,  sin V sin H,       cos V)      luminaires; V from the nadir, 0 to 180 degrees
//   B  (sin V cos H,       -sin H, cos V cos H)      floodlights; planes share the axis y
//   A  (sin V,       -cos V sin H, cos V cos H)      headlamps and signals; planes share the axis x
// H runs counter-clockwise in C and clockwise in A and B, seen from where V grows to. So all three
// agree in the plane H = 0, and a headlamp's V is upwards, towards x, its H to the driver's right.
// LM-63 lets the aim of A be horizontal, where photometric zero is its V = -90; here, as in the
// glTF extension EXT_lights_ies, (0, 0) is the aim of all three.

#pragma once

#include "openltc/base/result.h"
#include "openltc/target/resources.h"
#include "openltc/target/vec.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openltc::light {

/// The system of a file's angles; the numbers are those of LM-63.
enum class PhotometricType { c = 1, b = 2, a = 3 };

/// A direction of a photometric system, in degrees.
struct PhotometricAngles {
  double vertical = 0, horizontal = 0;
};

/// Intensities in the file's own system, whose angles are kept as those of a sphere: the polar one
/// from its poles, and the azimuth around them.
///   C: polar = V, azimuth = H;  B: polar = 90 + H, azimuth = V;  A: polar = 90 - V, azimuth = H.
struct IesProfile {
  std::string name;    ///< [LUMINAIRE], else [LUMCAT], else the file's
  std::string version; ///< first line, "" for files of 1986, which have none; "EULUMDAT"
  PhotometricType type = PhotometricType::c;
  std::vector<std::pair<std::string, std::string>> keywords; ///< without brackets, [MORE] joined

  /// As measured, unfolded by the file's symmetry. Ascending, degrees, within 0 .. 180.
  std::vector<double> polar_degrees;
  /// Ascending degrees over at most a whole circle, both ends of which are there; or one angle when
  /// the light is symmetric about its axis. Outside of both there is no light.
  std::vector<double> azimuth_degrees;
  /// candela[a * polar_degrees.size() + p], multiplied by the file's factors.
  std::vector<double> candela;

  double flux_lumens = 0; ///< integral of the interpolated intensities over all directions
  double max_candela = 0; ///< greater than zero
  /// Lumens of all lamps, as the file states them; 0 when it has absolute photometry.
  double lamp_lumens = 0;
  int lamp_count = 1;
  double output_ratio = -1;          ///< luminaire's lumens to its lamps', as stated; -1 unknown
  double downward_share = -1;        ///< of the lumens, as stated; -1 unknown
  double input_watts = 0;            ///< electric
  double size_metres[3] = {0, 0, 0}; ///< width, length, height; negative values mean round shapes
  std::vector<std::string> warnings; ///< what was put right, one line each that names the file

  /// The intensities over max_candela, for shading: see ProfileView and profile_axes.
  std::vector<float> grid;
  int grid_columns = 0, grid_rows = 0;

  ProfileView view() const { return {grid.data(), grid_columns, grid_rows}; }
};

/// Axes of a profile's own sphere: z to the pole, x at azimuth 0, y at 90 degrees.
struct ProfileAxes {
  Vec3f x, y, z;
};

/// Those axes where the light's own are `x`, `y` and `z` (the aim), orthonormal, in any space.
ProfileAxes profile_axes(PhotometricType type, Vec3f x, Vec3f y, Vec3f z);

/// The light's direction that the angles of a system stand for; a unit vector of its own frame.
Vec3d direction_of(PhotometricType type, PhotometricAngles angles);

/// Angles of a direction of the light's own frame, of any length: V within 0 .. 180 and H within
/// 0 .. 360 for C; both within -180 .. 180, and the polar one within -90 .. 90, for A and B.
PhotometricAngles angles_of(PhotometricType type, Vec3d direction_light);

/// The file's angles of a node of the profile.
PhotometricAngles node_angles(const IesProfile& profile, std::size_t azimuth, std::size_t polar);

/// Intensity in candela towards a direction of the light's own frame, of any length: bilinear in
/// the measured angles of the file's system, 0 outside of their range.
double eval_candela(const IesProfile& profile, Vec3d direction_light);

/// The same by the angles of type C, in radians, whatever the file's type. Any horizontal angle.
double eval_candela(const IesProfile& profile, double vertical_rad, double horizontal_rad);

/// The mean of that over the horizontal angle of type C.
double mean_candela(const IesProfile& profile, double vertical_rad);

/// Reads the text of a file of LM-63-1986, 1991, 1995, 2002 or 2019, TILT=NONE or INCLUDE, of
/// photometric type A, B or C; `name` stands in for its path in messages.
///
/// Type C: vertical angles anywhere within 0 .. 180 degrees; horizontal angles 0 alone, 0 to 90
/// (quadrants alike), 0 to 180 or 90 to 270 (halves alike), or 0 to 360; a full circle may lack its
/// last angle. Types A and B: horizontal angles that begin at 0 are mirrored; polar angles within
/// +-90, the others within +-180 degrees. Intensities are multiplied by the candela multiplier, the
/// ballast factor and, up to 1995, the ballast-lamp photometric factor, in whose place later
/// standards have another field. Tilt factors are read and not applied: they are for luminaires
/// mounted at an angle.
///
/// With a warning: text behind the last value is ignored, and values below 0 by no more than a
/// hundredth of the largest, which is how goniophotometers measure darkness, are 0.
///
/// Refuses, with one line "name:line: what is wrong": no TILT line, TILT in a file of its own,
/// broken, missing and surplus numbers, counts below 1 or above 4096 or of more than 2^20
/// directions, angles that do not ascend or are out of range, values that are further below 0, not
/// finite or above 1e12, and no light at all.
Result<IesProfile> parse_ies(std::string_view text, const std::string& name);

} // namespace openltc::light
