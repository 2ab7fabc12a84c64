// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Small vectors over any number type: float, double or SIMD lanes.
//
// They give the C++ side the vector arithmetic that shading languages have built in, so that one
// source serves both. Component-wise operators; no swizzles.

#pragma once

#include <cmath>

namespace openltc {

/// \addtogroup vectors
/// @{

/// Two numbers.
template <class R> struct Vec2T {
  R x{}; ///< the first; 0 if nothing is said
  R y{}; ///< the second
  Vec2T() = default;
  Vec2T(R x_, R y_) : x(x_), y(y_) {} ///< by components
};

/// Three numbers: a position, a direction or a colour.
template <class R> struct Vec3T {
  R x{}; ///< the first, or red; 0 if nothing is said
  R y{}; ///< the second, or green
  R z{}; ///< the third, or blue
  Vec3T() = default;
  explicit Vec3T(R s) : x(s), y(s), z(s) {}        ///< the same three times
  Vec3T(R x_, R y_, R z_) : x(x_), y(y_), z(z_) {} ///< by components
};

/// Four numbers.
template <class R> struct Vec4T {
  R x{}; ///< the first; 0 if nothing is said
  R y{}; ///< the second
  R z{}; ///< the third
  R w{}; ///< the fourth
  Vec4T() = default;
  Vec4T(R x_, R y_, R z_, R w_) : x(x_), y(y_), z(z_), w(w_) {} ///< by components
};

/// Sum.
template <class R> Vec2T<R> operator+(Vec2T<R> a, Vec2T<R> b) { return {a.x + b.x, a.y + b.y}; }
/// Difference.
template <class R> Vec2T<R> operator-(Vec2T<R> a, Vec2T<R> b) { return {a.x - b.x, a.y - b.y}; }
/// Multiple.
template <class R> Vec2T<R> operator*(Vec2T<R> a, R s) { return {a.x * s, a.y * s}; }
/// Multiple.
template <class R> Vec2T<R> operator*(R s, Vec2T<R> a) { return {a.x * s, a.y * s}; }

/// Sum.
template <class R> Vec4T<R> operator+(Vec4T<R> a, Vec4T<R> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
/// Multiple.
template <class R> Vec4T<R> operator*(Vec4T<R> a, R s) {
  return {a.x * s, a.y * s, a.z * s, a.w * s};
}

/// The opposite.
template <class R> Vec3T<R> operator-(Vec3T<R> a) { return {-a.x, -a.y, -a.z}; }
/// Sum.
template <class R> Vec3T<R> operator+(Vec3T<R> a, Vec3T<R> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
/// Difference.
template <class R> Vec3T<R> operator-(Vec3T<R> a, Vec3T<R> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// Product of each component, as colours multiply.
template <class R> Vec3T<R> operator*(Vec3T<R> a, Vec3T<R> b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
/// Multiple.
template <class R> Vec3T<R> operator*(Vec3T<R> a, R s) { return {a.x * s, a.y * s, a.z * s}; }
/// Multiple.
template <class R> Vec3T<R> operator*(R s, Vec3T<R> a) { return {a.x * s, a.y * s, a.z * s}; }
/// Part.
template <class R> Vec3T<R> operator/(Vec3T<R> a, R s) { return {a.x / s, a.y / s, a.z / s}; }
/// Adds b to a.
template <class R> Vec3T<R>& operator+=(Vec3T<R>& a, Vec3T<R> b) { return a = a + b; }
/// Multiplies a by s.
template <class R> Vec3T<R>& operator*=(Vec3T<R>& a, R s) { return a = a * s; }

/// Dot product.
template <class R> R dot(Vec3T<R> a, Vec3T<R> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// Cross product.
template <class R> Vec3T<R> cross(Vec3T<R> a, Vec3T<R> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Vec2f = Vec2T<float>;  ///< single precision
using Vec3f = Vec3T<float>;  ///< single precision: what the API takes and gives
using Vec4f = Vec4T<float>;  ///< single precision
using Vec2d = Vec2T<double>; ///< double precision
using Vec3d = Vec3T<double>; ///< double precision
using Vec4d = Vec4T<double>; ///< double precision

/// In double precision.
inline Vec3d to_double(Vec3f v) { return {double(v.x), double(v.y), double(v.z)}; }
/// Rounded to single precision.
inline Vec3f to_float(Vec3d v) { return {float(v.x), float(v.y), float(v.z)}; }

/// Length.
inline float length(Vec3f a) { return std::sqrt(dot(a, a)); }
/// Length.
inline double length(Vec3d a) { return std::sqrt(dot(a, a)); }
/// a / |a|; not finite where a is 0.
inline Vec3f normalize(Vec3f a) { return a / length(a); }
/// a / |a|; not finite where a is 0.
inline Vec3d normalize(Vec3d a) { return a / length(a); }

/// @}

} // namespace openltc
