#include "player/own_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "mesh/lumped.hpp"
#include "mesh/merge.hpp"
#include "mesh/read_mesh.hpp"

namespace weft::window {
namespace {

using Ordered = nlohmann::ordered_json;

constexpr std::size_t kMostClothNodes = 200000, kMostObstacleTriangles = 1000000;
constexpr int kGrid = 64;         // nodes a side of the sheet
constexpr double kDensity = 0.3;  // [kg/m²]
// [N/m] for a mesh of 1 m; scaled with the length, so that a mesh of any size sags by the same fraction.
constexpr double kStructural = 375, kShear = 50, kBend = 1.7;
// Of a spring, as a part of sqrt(stiffness * mass): the same at any resolution.
constexpr double kDamping = 0.09;

/// To six digits, as a person would write it.
double number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.5e", value);
  return std::strtod(text, nullptr);
}
Ordered point(double x, double y, double z) { return {number(x), number(y), number(z)}; }

Vec3d sides(const mesh::Bounds& box) {
  return {static_cast<double>(box.high.x) - box.low.x, static_cast<double>(box.high.y) - box.low.y,
          static_cast<double>(box.high.z) - box.low.z};
}

/// Centred over the origin, its longest side as `scale` makes it, its lowest point at `floor`.
Ordered placed(const mesh::Bounds& box, double scale, double floor) {
  const auto middle = [&](double low, double high) { return -scale * 0.5 * (low + high); };
  return {{"scale", number(scale)},
          {"translate",
           point(middle(box.low.x, box.high.x), floor - scale * box.low.y, middle(box.low.z, box.high.z))}};
}

Ordered stiffness_of(double length) {
  return {{"structural", number(kStructural * length)},
          {"shear", number(kShear * length)},
          {"bend", number(kBend * length)}};
}
double damping_of(double length, double node_mass) {
  return number(kDamping * std::sqrt(kStructural * length * node_mass));
}

Ordered common(const std::string& title, double thickness) {
  return {{"format", "weft-scene/1"},
          {"title", title.substr(0, 200)},
          {"drag", 0.5},
          {"time", {{"substeps", "auto"}, {"frames", 150}}},
          {"contact", {{"method", "proximity"}, {"thickness", number(thickness)}}}};
}
Ordered floor_plane() {
  return {{"kind", "plane"}, {"point", Ordered::array({0, 0, 0})}, {"normal", Ordered::array({0, 1, 0})}};
}

Ordered over_obstacle(const OwnMesh& own, double length) {
  const double scale = length / own.longest_side();
  const double height = scale * sides(own.box).y;
  const double width = 1.7 * length;
  Ordered scene = common("Draped over " + own.name, 0.003 * width);
  scene["cloths"] =
      Ordered::array({{{"name", "sheet"},
                       {"grid", Ordered::array({kGrid, kGrid})},
                       {"size", Ordered::array({number(width), number(width)})},
                       {"plane", "xz"},
                       {"transform", {{"translate", point(0, height + 0.08 * length, 0)}}},
                       {"density", kDensity},
                       {"stiffness", stiffness_of(length)},
                       {"friction", 0.4},
                       {"damping", damping_of(length, kDensity * width * width / (kGrid * kGrid))}}});
  scene["colliders"] = Ordered::array(
      {{{"kind", "mesh"}, {"mesh", kOwnMesh}, {"transform", placed(own.box, scale, 0)}}, floor_plane()});
  scene["camera"] = {{"eye", point(1.35 * length, height + 0.45 * length, 2.1 * length)},
                     {"target", point(0, 0.42 * height, 0)},
                     {"fov_degrees", 38}};
  return scene;
}

/// All nodes weigh the same, so that small triangles need no smaller step.
Ordered as_cloth(const OwnMesh& own, double length) {
  const double scale = length / own.longest_side();
  const double area = own.area * scale * scale;
  const double node_mass = kDensity * area / static_cast<double>(own.mesh.positions.size());
  const double edge =
      1.5 * std::sqrt(area / static_cast<double>(own.mesh.triangles.size()));  // of an even triangle
  const double radius = 0.25 * length;
  const double floor = 2 * radius + 0.08 * length;  // of the mesh, above the ball
  const double top = floor + scale * sides(own.box).y;
  const double away = 1.9 * top;  // a fifth more than what its field of view holds
  Ordered scene = common(own.name + " as cloth", std::min(0.005 * length, 0.3 * edge));
  scene["cloths"] = Ordered::array({{{"name", "mesh"},
                                     {"mesh", kOwnMesh},
                                     {"transform", placed(own.box, scale, floor)},
                                     {"node_mass", number(node_mass)},
                                     {"stiffness", stiffness_of(length)},
                                     {"friction", 0.4},
                                     {"damping", damping_of(length, node_mass)}}});
  scene["colliders"] = Ordered::array(
      {{{"kind", "sphere"}, {"center", point(0, radius, 0)}, {"radius", number(radius)}}, floor_plane()});
  scene["camera"] = {{"eye", point(0.44 * away, 0.5 * top + 0.25 * away, 0.86 * away)},
                     {"target", point(0, 0.5 * top, 0)},
                     {"fov_degrees", 38}};
  return scene;
}

}  // namespace

double OwnMesh::longest_side() const {
  const Vec3d side = sides(box);
  return std::max({side.x, side.y, side.z});
}

bool OwnMesh::may_be(Role role) const {
  return role == Role::Obstacle ? mesh.triangles.size() <= kMostObstacleTriangles
                                : mesh.positions.size() <= kMostClothNodes;
}

Result<OwnMesh> read_own_mesh(const std::string& path) {
  OwnMesh own;
  own.name = std::filesystem::path(path).filename().string();
  WEFT_SET(own.mesh, mesh::read_mesh(path));
  const std::size_t before = own.mesh.triangles.size();
  own.dropped = mesh::drop_degenerate_triangles(own.mesh);
  if (own.mesh.triangles.empty())
    return input_error("%s: none of the %zu triangles of the mesh has an area.", own.name.c_str(), before);
  mesh::drop_unused_vertices(own.mesh);
  if (!own.may_be(Role::Cloth) && !own.may_be(Role::Obstacle))
    return make_error(ErrorKind::Limit, "%s: %zu triangles are more than the limit of %zu.", own.name.c_str(),
                      own.mesh.triangles.size(), kMostObstacleTriangles);
  own.box = mesh::bounds(own.mesh);
  for (const double part : mesh::vertex_areas(own.mesh)) own.area += part;
  return own;
}

std::string scene_of_mesh(const OwnMesh& mesh, Role role, double length) {
  return (role == Role::Obstacle ? over_obstacle(mesh, length) : as_cloth(mesh, length))
      .dump(-1, ' ', false, Ordered::error_handler_t::replace);  // a file may have any bytes as its name
}

}  // namespace weft::window
