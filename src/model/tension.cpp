#include "model/tension.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/mass_moments.hpp"
#include "model/cloth_size.hpp"
#include "model/fabric.hpp"

namespace weft {
namespace {

/// A triangle that is pressed to less than this part of its area bears no tension that could be told.
constexpr double kFlat = 1e-9;

/// F = R U, P = F S: the Biot stress is the symmetric part of U S = U⁻¹ (Fᵀ P), in the plane R.
Mat3 biot_stress(const membrane::Law& law, const membrane::Axes& f) {
  const membrane::Axes p = membrane::stress(law, f);
  const double a = dot(f.warp, f.warp), b = dot(f.warp, f.weft), c = dot(f.weft, f.weft);
  const double area = std::sqrt(std::max(a * c - b * b, 0.0));  // by that at rest
  if (!(area > kFlat)) return {};
  const double scale = std::sqrt(a + c + 2 * area);
  // U = (C + area) / scale, and its determinant is the area.
  const double i11 = (c + area) / (scale * area), i12 = -b / (scale * area),
               i22 = (a + area) / (scale * area);
  const Vec3d r1 = i11 * f.warp + i12 * f.weft, r2 = i12 * f.warp + i22 * f.weft;
  const double g11 = dot(f.warp, p.warp), g12 = dot(f.warp, p.weft), g21 = dot(f.weft, p.warp),
               g22 = dot(f.weft, p.weft);
  const double b11 = i11 * g11 + i12 * g21, b22 = i12 * g12 + i22 * g22;
  const double b12 = (i11 * g12 + i12 * g22 + i12 * g11 + i22 * g21) / 2;
  return b11 * Mat3::outer(r1, r1) + b12 * (Mat3::outer(r1, r2) + Mat3::outer(r2, r1)) +
         b22 * Mat3::outer(r2, r2);
}

double stiffness_of(const scene::Stiffness& stiffness, mesh::SpringKind kind) {
  if (kind == mesh::SpringKind::Structural) return stiffness.structural;
  return kind == mesh::SpringKind::Shear ? stiffness.shear : stiffness.bend;
}

/// Of each triangle of springs, times its area [N·m]: half of each edge's and of what crosses it, and all at a rim.
std::vector<Mat3> spring_tensions(const Model& model, const Body& body, std::span<const Vec3d> position) {
  mesh::TriangleMesh mesh = cloth_mesh(model, body);
  const std::vector<mesh::Triangle> torn = mesh.triangles;
  if (!body.whole.empty()) mesh.triangles = body.whole;
  std::vector<Mat3> sums(torn.size());
  for (const mesh::MeshSpring& spring : mesh::torn_springs(mesh, body.weights, torn)) {
    const Vec3d span =
        position[body.first_vertex + spring.node_b] - position[body.first_vertex + spring.node_a];
    const double now = length(span);
    if (!(now > 0)) continue;
    const double force =
        spring.weight * stiffness_of(body.stiffness, spring.kind) * (now - spring.rest_length);
    const Mat3 half = force * spring.rest_length / (2 * now * now) * Mat3::outer(span, span);
    for (const std::uint32_t triangle : spring.triangles) sums[triangle] += half;
  }
  return sums;
}

/// The same of fabric.
std::vector<Mat3> fabric_tensions(const Model& model, const Body& body, std::span<const Vec3d> position) {
  const FabricSheet sheet = fabric_sheet(model, body);
  const RestSheet at_rest = sheet.rest();
  const membrane::Law law = membrane_law(*body.fabric);
  std::vector<Mat3> sums;
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
    const auto place = [&](std::size_t k) { return position[body.first_vertex + sheet.triangles[t][k]]; };
    const membrane::Rest rest = membrane::Rest::of(at_rest.places(t));
    sums.push_back(rest.area * biot_stress(law, membrane::deformation(rest, {place(0), place(1), place(2)})));
  }
  return sums;
}

}  // namespace

std::vector<Mat3> tensions(const Model& model, const Body& body, std::span<const Vec3d> position) {
  const std::vector<Mat3> of_triangles =
      body.fabric ? fabric_tensions(model, body, position) : spring_tensions(model, body, position);
  std::vector<Mat3> sums(body.vertex_count);
  std::vector<double> areas(body.vertex_count);
  for (std::size_t k = 0; k < of_triangles.size(); ++k) {
    const mesh::Triangle& triangle = model.triangles[body.first_triangle + k];
    const double area = area_of(model, triangle);
    for (const std::uint32_t vertex : triangle) {
      areas[vertex - body.first_vertex] += area;
      sums[vertex - body.first_vertex] += of_triangles[k];
    }
  }
  for (std::size_t node = 0; node < sums.size(); ++node)
    if (areas[node] > 0) sums[node] = 1 / areas[node] * sums[node];
  return sums;
}

Principal largest_principal(const Mat3& symmetric) {
  const auto [values, axes] = mesh::principal_axes(symmetric);
  int best = 0;
  for (int k = 1; k < 3; ++k)
    if (values[k] > values[best]) best = k;
  return {values[best], {axes.x[best], axes.y[best], axes.z[best]}};
}

}  // namespace weft
