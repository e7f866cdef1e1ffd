// Balls that enclose a gas, for tests of docs/pressure.md: their meshes and scenes.
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "mesh/primitives.hpp"

namespace weft {

inline constexpr double kBallRadius = 0.3, kBallDensity = 0.2;  // [m], [kg/m²]

/// A geodesic sphere around a point.
inline mesh::TriangleMesh ball(int cells, const Vec3d& center = {}) {
  return mesh::transformed(mesh::make_geodesic_sphere(cells), kBallRadius, {0, 0, 0, 1}, center);
}

inline std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

/// An isotropic fabric of this Young's modulus [N/m] that is not damped, with Poisson's ratio 0.3.
inline std::string isotropic(double young) {
  return R"("fabric": {"warp": )" + number(young) + R"(, "shear": )" + number(young / 2.6) +
         R"(, "poisson": 0.3, "bending_warp": 0, "damping": 0})";
}
/// Springs that resist nothing.
inline const std::string kDust = R"("damping": 0, "stiffness": {"structural": 0, "shear": 0, "bend": 0})";

/// The members of a scene with one ball, without weight.
inline std::string ball_scene(const std::string& solver, const std::string& material,
                              const std::string& pressure, const std::string& world = "") {
  return R"("solver": )" + solver + R"(, "gravity": [0, 0, 0], )" + world +
         R"("cloths": [{"mesh": "ball.ply", "density": 0.2, )" + material + R"(, "pressure": )" + pressure +
         "}]";
}

}  // namespace weft
