// Small vectors: f32 where the GPU's data is meant, f64 for what a user gives.
#pragma once

#include <cmath>
#include <cstdint>

namespace weft {

template <class T>
struct Vec3 {
  T x{}, y{}, z{};

  T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  const T& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
  Vec3& operator-=(const Vec3& b) { return *this = *this - b; }
  Vec3& operator*=(T s) { return *this = *this * s; }
  bool operator==(const Vec3&) const = default;

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const Vec3& a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Vec3 operator*(T s, const Vec3& a) { return a * s; }
  friend Vec3 operator/(const Vec3& a, T s) { return {a.x / s, a.y / s, a.z / s}; }

  /// The same vector in another precision.
  template <class U>
  Vec3<U> to() const {
    return {static_cast<U>(x), static_cast<U>(y), static_cast<U>(z)};
  }
};

template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T length(const Vec3<T>& a) {
  return std::sqrt(dot(a, a));
}
template <class T>
Vec3<T> min(const Vec3<T>& a, const Vec3<T>& b) {
  return {b.x < a.x ? b.x : a.x, b.y < a.y ? b.y : a.y, b.z < a.z ? b.z : a.z};
}
template <class T>
Vec3<T> max(const Vec3<T>& a, const Vec3<T>& b) {
  return {b.x > a.x ? b.x : a.x, b.y > a.y ? b.y : a.y, b.z > a.z ? b.z : a.z};
}

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

/// WGSL's vec4f: 16 bytes, the unit of all state buffers.
struct alignas(16) Vec4f {
  float x{}, y{}, z{}, w{};

  Vec3f xyz() const { return {x, y, z}; }
  static Vec4f from(const Vec3f& v, float w_) { return {v.x, v.y, v.z, w_}; }
  bool operator==(const Vec4f&) const = default;
};
static_assert(sizeof(Vec4f) == 16);

}  // namespace weft
