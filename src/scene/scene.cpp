#include "scene/scene.hpp"

#include <algorithm>

#include "base/json.hpp"
#include "scene/names.hpp"

namespace weft::scene {

Vec3d transformed(const Transform& transform, const Vec3d& point) {
  const Vec3d scaled = point * transform.scale;
  const Vec3d q{transform.rotate[0], transform.rotate[1], transform.rotate[2]};
  const Vec3d turn = 2.0 * cross(q, scaled);  // v' = v + w (2 q x v) + q x (2 q x v)
  return scaled + transform.rotate[3] * turn + cross(q, turn) + transform.translate;
}

namespace {

double hill(double s) { return 16 * s * s * (1 - s) * (1 - s); }

std::vector<Vec3d> grid_points(const GridShape& grid, const Transform& transform, double bump) {
  std::vector<Vec3d> positions;
  positions.reserve(static_cast<std::size_t>(grid.nx) * grid.ny);
  for (std::uint32_t j = 0; j < grid.ny; ++j) {
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const double s = static_cast<double>(i) / (grid.nx - 1), t = static_cast<double>(j) / (grid.ny - 1);
      const double along = grid.width * (s - 0.5), down = grid.height * (t - 0.5);
      const double out = bump == 0 ? 0 : bump * hill(s) * hill(t);
      const Vec3d point = grid.plane == Plane::Xy ? Vec3d{along, -down, out} : Vec3d{along, out, down};
      positions.push_back(transformed(transform, point));
    }
  }
  return positions;
}

}  // namespace

std::vector<Vec3d> grid_positions(const GridShape& grid, const Transform& transform) {
  return grid_points(grid, transform, 0);
}

std::vector<Vec3d> grid_start_positions(const GridShape& grid, const Transform& transform) {
  return grid_points(grid, transform, grid.bump);
}

const std::optional<double>& friction_of(const Collider& collider) {
  return std::visit([](const auto& one) -> const std::optional<double>& { return one.friction; }, collider);
}
const std::optional<ColliderMotion>& motion_of(const Collider& collider) {
  return std::visit([](const auto& one) -> const std::optional<ColliderMotion>& { return one.motion; },
                    collider);
}

Material material_of(const Collider& collider) {
  return std::visit([](const auto& one) { return one.material; }, collider);
}

void set_material(Collider& collider, Material material) {
  std::visit([&](auto& one) { one.material = material; }, collider);
}

const MotionCarried* carried_of(const Collider& collider) {
  const std::optional<ColliderMotion>& motion = motion_of(collider);
  return motion ? std::get_if<MotionCarried>(&*motion) : nullptr;
}
MotionCarried* carried_of(Collider& collider) {
  return std::visit([](auto& one) { return one.motion ? std::get_if<MotionCarried>(&*one.motion) : nullptr; },
                    collider);
}

const Rigid* rigid_of(const Collider& collider) {
  const auto of = [](const auto& one) -> const Rigid* {
    if constexpr (requires { one.rigid; })
      return one.rigid ? &*one.rigid : nullptr;
    else
      return nullptr;
  };
  return std::visit(of, collider);
}
bool has_rigid(const Scene& scene) {
  return std::any_of(scene.colliders.begin(), scene.colliders.end(),
                     [](const Collider& collider) { return rigid_of(collider) != nullptr; });
}

const char* name_of(GridPart part) { return kGridPartNames[static_cast<int>(part)]; }
const char* name_of(Plane plane) { return kPlaneNames[static_cast<int>(plane)]; }
std::string path_of(const Cloth& cloth) {
  return path_of_index(cloth.solid ? "bodies" : "cloths", cloth.entry);
}

const char* name_of(SolverKind kind) { return kSolverKindNames[static_cast<int>(kind)]; }
const char* name_of(Forces forces) { return kForcesNames[static_cast<int>(forces)]; }
const char* name_of(ContactMethod method) { return kContactMethodNames[static_cast<int>(method)]; }
const char* name_of(View view) { return kViewNames[static_cast<int>(view)]; }

}  // namespace weft::scene
