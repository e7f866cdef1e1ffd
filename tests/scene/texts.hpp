// Scene texts that tests build on.
#pragma once

#include <string>

namespace weft::scene {

/// A scene with one more key at the top: R"("drag": 1)".
inline std::string scene_with(const std::string& members) {
  return R"({"format": "weft-scene/1", "cloths": [{"grid": [4, 3], "size": [3, 2], "density": 0.2}], )" +
         members + "}";
}

/// A scene with one collider, which proximity contact meets.
inline std::string proximity_with(const std::string& collider) {
  return scene_with(R"("contact": {"method": "proximity"}, "colliders": [)" + collider + "]");
}

/// A scene of one cloth that has these keys.
inline std::string cloth_of(const std::string& members) {
  return R"({"format": "weft-scene/1", "cloths": [{)" + members + "}]}";
}

/// A scene of one good grid cloth with further keys.
inline std::string cloth_with(const std::string& members) {
  return cloth_of(R"("grid": [4, 3], "size": [3, 2], "density": 0.2, )" + members);
}

/// A scene with one motion of all corners.
inline std::string motion_with(const std::string& members) {
  return cloth_with(R"("motions": [{"nodes": "corners", )" + members + "}]");
}

/// A scene of one body with these keys, and a density and material.
inline std::string body_with(const std::string& members, const std::string& material = R"({"young": 1000})") {
  return R"({"format": "weft-scene/1", "bodies": [{)" + members + R"(, "density": 1000, "material": )" +
         material + "}]}";
}

inline std::string minimal_scene() { return cloth_of(R"("grid": [4, 3], "size": [3, 2], "density": 0.2)"); }

}  // namespace weft::scene
