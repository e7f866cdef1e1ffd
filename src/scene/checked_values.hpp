// Readers of values that check() has passed and completed.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>

#include "base/json.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

inline const Json& at(const Json& object, const char* key) {
  const Json* value = object.find(key);
  assert(value);
  return *value;
}
inline double number(const Json& object, const char* key) { return at(object, key).number; }
inline std::uint32_t whole(const Json& json) { return static_cast<std::uint32_t>(json.number); }
inline std::string text(const Json& object, const char* key) {
  const Json* value = object.find(key);
  return value ? value->text : "";
}
inline std::optional<double> maybe_number(const Json& object, const char* key) {
  const Json* value = object.find(key);
  return value ? std::optional(value->number) : std::nullopt;
}
inline Vec3d vector(const Json& json) {
  return {json.values[0].number, json.values[1].number, json.values[2].number};
}
inline Vec3d vector(const Json& object, const char* key) { return vector(at(object, key)); }

/// The vector's direction; the largest component is made 1 first, so that no square underflows.
inline Vec3d unit(const Vec3d& v) {
  const double largest = std::max({v.x, -v.x, v.y, -v.y, v.z, -v.z});
  const Vec3d scaled = v / largest;
  return scaled / length(scaled);
}

template <class E, std::size_t N>
E word(const Json& json, const char* const (&names)[N]) {
  const auto found = std::find(std::begin(names), std::end(names), json.text);
  assert(found != std::end(names));
  return static_cast<E>(found - std::begin(names));
}

inline std::array<double, 4> unit_quaternion(const Json& json) {
  double sum = 0;  // of squares
  for (const Json& part : json.values) sum += part.number * part.number;
  std::array<double, 4> q{};
  for (std::size_t k = 0; k < 4; ++k) q[k] = json.values[k].number / std::sqrt(sum);
  return q;
}

inline Transform transform_of(const Json& json) {
  return {number(json, "scale"), unit_quaternion(at(json, "rotate")), vector(json, "translate")};
}

}  // namespace weft::scene
