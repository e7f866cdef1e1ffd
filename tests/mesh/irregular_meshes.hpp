// Meshes for tests: sheets without rows, tubes, spheres, pieces beside each other.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/random.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft {

/// A sheet in the plane xz about the origin: nodes of a grid, those inside moved by up to `jitter` of a cell,
/// each quad cut along a random diagonal. With 0.45 angles go down to a degree.
inline mesh::TriangleMesh jittered_sheet(std::uint32_t nx, std::uint32_t ny, double width, double height,
                                         double jitter = 0.3, std::uint64_t seed = 1) {
  Random random(seed);
  const double dx = width / (nx - 1), dz = height / (ny - 1);
  mesh::TriangleMesh mesh;
  for (std::uint32_t j = 0; j < ny; ++j)
    for (std::uint32_t i = 0; i < nx; ++i) {
      const double a = random.uniform(-jitter, jitter), b = random.uniform(-jitter, jitter);
      const double x = i > 0 && i + 1 < nx ? i + a : i, z = j > 0 && j + 1 < ny ? j + b : j;
      mesh.positions.push_back(Vec3d{x * dx - width / 2, 0, z * dz - height / 2}.to<float>());
    }
  for (std::uint32_t j = 0; j + 1 < ny; ++j)
    for (std::uint32_t i = 0; i + 1 < nx; ++i) {
      const std::uint32_t a = j * nx + i, b = a + 1, c = a + nx, d = c + 1;
      const bool rising = random.below(2) == 0;
      mesh.triangles.push_back({a, rising ? c : d, b});
      mesh.triangles.push_back({rising ? b : a, c, d});
    }
  return mesh;
}

/// A tube about the axis y, open at both ends; each row is turned by half a cell. Its first nodes are the
/// upper rim.
inline mesh::TriangleMesh tube(std::uint32_t around, std::uint32_t along, double radius, double height) {
  mesh::TriangleMesh mesh;
  for (std::uint32_t j = 0; j < along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double angle = 2 * 3.14159265358979 * (i + 0.5 * (j % 2)) / around;
      const double y = height * (0.5 - static_cast<double>(j) / (along - 1));
      mesh.positions.push_back(Vec3d{radius * std::cos(angle), y, radius * std::sin(angle)}.to<float>());
    }
  for (std::uint32_t j = 0; j + 1 < along; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t next = (i + 1) % around, a = j * around + i, b = j * around + next;
      const std::uint32_t c = a + around, d = b + around;
      mesh.triangles.push_back({a, b, j % 2 == 0 ? c : d});
      mesh.triangles.push_back({j % 2 == 0 ? b : a, d, c});
    }
  return mesh;
}

/// The eight faces of an octahedron, cut into n² triangles each, on a sphere.
inline mesh::TriangleMesh sphere_skin(int n, double radius) {
  mesh::TriangleMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto node = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<std::uint32_t>(mesh.positions.size()));
    const Vec3d place{static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])};
    if (is_new) mesh.positions.push_back((place * (radius / length(place))).to<float>());
    return found->second;
  };
  for (int face = 0; face < 8; ++face) {
    const int sx = face & 1 ? -1 : 1, sy = face & 2 ? -1 : 1, sz = face & 4 ? -1 : 1;
    const auto at = [&](int a, int b) { return node({sx * a, sy * b, sz * (n - a - b)}); };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      mesh.triangles.push_back(sx * sy * sz > 0 ? mesh::Triangle{a, b, c} : mesh::Triangle{a, c, b});
    };
    for (int a = 0; a < n; ++a)
      for (int b = 0; a + b < n; ++b) {
        add(at(a, b), at(a + 1, b), at(a, b + 1));
        if (a + b + 1 < n) add(at(a + 1, b), at(a + 1, b + 1), at(a, b + 1));
      }
  }
  return mesh;
}

/// A sphere of n rings of 2 n nodes, and its poles, in each of which 2 n thin triangles meet.
inline mesh::TriangleMesh rings(std::uint32_t n, double radius) {
  const std::uint32_t around = 2 * n, south = 1 + (n - 1) * around;
  mesh::TriangleMesh mesh;
  mesh.positions.push_back(Vec3d{0, radius, 0}.to<float>());
  for (std::uint32_t j = 1; j < n; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double down = 3.14159265358979 * j / n, angle = 3.14159265358979 * i / n;
      const Vec3d x{std::sin(down) * std::cos(angle), std::cos(down), std::sin(down) * std::sin(angle)};
      mesh.positions.push_back((radius * x).to<float>());
    }
  mesh.positions.push_back(Vec3d{0, -radius, 0}.to<float>());
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around;
    mesh.triangles.push_back({0, 1 + next, 1 + i});
    for (std::uint32_t first = 1; first + around < south; first += around) {
      mesh.triangles.push_back({first + i, first + next, first + around + i});
      mesh.triangles.push_back({first + next, first + around + next, first + around + i});
    }
    mesh.triangles.push_back({south, south - around + i, south - around + next});
  }
  return mesh;
}

/// Both in one, with nothing between; the second moved.
inline mesh::TriangleMesh both(mesh::TriangleMesh a, const mesh::TriangleMesh& b, const Vec3f& moved) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  for (const Vec3f& x : b.positions) a.positions.push_back(x + moved);
  for (mesh::Triangle triangle : b.triangles) {
    for (std::uint32_t& vertex : triangle) vertex += first;
    a.triangles.push_back(triangle);
  }
  return a;
}

/// A mesh folded onto itself along x = 0: where it is symmetric, nodes lie on nodes.
inline mesh::TriangleMesh folded(mesh::TriangleMesh mesh) {
  for (Vec3f& x : mesh.positions) x.x = std::abs(x.x);
  return mesh;
}

/// Triangles that have nothing in common, in a row.
inline mesh::TriangleMesh triangles_apart(std::uint32_t count) {
  mesh::TriangleMesh mesh;
  for (std::uint32_t t = 0; t < count; ++t) {
    const float x = 0.3F * static_cast<float>(t);
    for (const Vec3f& corner : {Vec3f{x, 0, 0}, {x + 0.2F, 0, 0}, {x, 0, 0.2F}})
      mesh.positions.push_back(corner);
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

/// The same mesh with its nodes numbered at random.
inline mesh::TriangleMesh shuffled(const mesh::TriangleMesh& mesh, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<std::uint32_t> number(mesh.positions.size());
  for (std::uint32_t n = 0; n < number.size(); ++n) number[n] = n;
  for (std::size_t n = number.size(); n > 1; --n)
    std::swap(number[n - 1], number[random.below(static_cast<std::uint32_t>(n))]);
  mesh::TriangleMesh made = mesh;
  for (std::size_t n = 0; n < number.size(); ++n) made.positions[number[n]] = mesh.positions[n];
  for (mesh::Triangle& triangle : made.triangles)
    for (std::uint32_t& vertex : triangle) vertex = number[vertex];
  return made;
}

}  // namespace weft
