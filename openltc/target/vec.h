// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// Small vectors over any number type: float, double or SIMD lanes.
//
// They give the C++ side the vector arithmetic that shading languages have built in, so that one
// source serves both. Component-wise operators; no swizzles.

#pragma once

#include <cmath>

namespace openltc {

template <class R> struct Vec2T {
  R x{}, y{};
  Vec2T() = default;
  Vec2T(R x_, R y_) : x(x_), y(y_) {}
};

template <class R> struct Vec3T {
  R x{}, y{}, z{};
  Vec3T() = default;
  explicit Vec3T(R s) : x(s), y(s), z(s) {}
  Vec3T(R x_, R y_, R z_) : x(x_), y(y_), z(z_) {}
};

template <class R> struct Vec4T {
  R x{}, y{}, z{}, w{};
  Vec4T() = default;
  Vec4T(R x_, R y_, R z_, R w_) : x(x_), y(y_), z(z_), w(w_) {}
};

template <class R> Vec2T<R> operator+(Vec2T<R> a, Vec2T<R> b) { return {a.x + b.x, a.y + b.y}; }
template <class R> Vec2T<R> operator-(Vec2T<R> a, Vec2T<R> b) { return {a.x - b.x, a.y - b.y}; }
template <class R> Vec2T<R> operator*(Vec2T<R> a, R s) { return {a.x * s, a.y * s}; }
template <class R> Vec2T<R> operator*(R s, Vec2T<R> a) { return {a.x * s, a.y * s}; }

template <class R> Vec4T<R> operator+(Vec4T<R> a, Vec4T<R> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
template <class R> Vec4T<R> operator*(Vec4T<R> a, R s) {
  return {a.x * s, a.y * s, a.z * s, a.w * s};
}

template <class R> Vec3T<R> operator-(Vec3T<R> a) { return {-a.x, -a.y, -a.z}; }
template <class R> Vec3T<R> operator+(Vec3T<R> a, Vec3T<R> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class R> Vec3T<R> operator-(Vec3T<R> a, Vec3T<R> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class R> Vec3T<R> operator*(Vec3T<R> a, Vec3T<R> b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class R> Vec3T<R> operator*(Vec3T<R> a, R s) { return {a.x * s, a.y * s, a.z * s}; }
template <class R> Vec3T<R> operator*(R s, Vec3T<R> a) { return {a.x * s, a.y * s, a.z * s}; }
template <class R> Vec3T<R> operator/(Vec3T<R> a, R s) { return {a.x / s, a.y / s, a.z / s}; }
template <class R> Vec3T<R>& operator+=(Vec3T<R>& a, Vec3T<R> b) { return a = a + b; }
template <class R> Vec3T<R>& operator*=(Vec3T<R>& a, R s) { return a = a * s; }

template <class R> R dot(Vec3T<R> a, Vec3T<R> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class R> Vec3T<R> cross(Vec3T<R> a, Vec3T<R> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Vec2f = Vec2T<float>;
using Vec3f = Vec3T<float>;
using Vec4f = Vec4T<float>;
using Vec2d = Vec2T<double>;
using Vec3d = Vec3T<double>;
using Vec4d = Vec4T<double>;

inline Vec3d to_double(Vec3f v) { return {double(v.x), double(v.y), double(v.z)}; }
inline Vec3f to_float(Vec3d v) { return {float(v.x), float(v.y), float(v.z)}; }

inline float length(Vec3f a) { return std::sqrt(dot(a, a)); }
inline double length(Vec3d a) { return std::sqrt(dot(a, a)); }
inline Vec3f normalize(Vec3f a) { return a / length(a); }
inline Vec3d normalize(Vec3d a) { return a / length(a); }

} // namespace openltc
