#include "validate/trial.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "method/mass_spring/reference/mass_spring.hpp"
#include "reference/simulation.hpp"
#include "scene/load.hpp"
#include "scene/names.hpp"

namespace weft::validate {

std::string text_of(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  return text.data();
}

Vec3d Moment::momentum() const {
  Vec3d sum;
  for (std::size_t n = 0; n < mass.size(); ++n) sum += mass[n] * velocity[n];
  return sum;
}
Vec3d Moment::angular_momentum(const Vec3d& about) const {
  Vec3d sum;
  for (std::size_t n = 0; n < mass.size(); ++n) sum += mass[n] * cross(position[n] - about, velocity[n]);
  return sum;
}
double Moment::total_mass() const {
  double sum = 0;
  for (const double m : mass) sum += m;
  return sum;
}
Vec3d Moment::center() const {
  Vec3d sum;
  for (std::size_t n = 0; n < mass.size(); ++n) sum += mass[n] * position[n];
  return sum / total_mass();
}
Vec3d Moment::mean_velocity() const { return momentum() / total_mass(); }

Result<Trial> Trial::create(const Rig& rig, const std::string& members, const mesh::TriangleMesh& mesh) {
  WEFT_TRY(scene, scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": ")" +
                                         std::string(scene::name_of(rig.solver)) + "\"}, " + members + "}",
                                     "validate"));
  Assets assets;
  assets.cloths.resize(scene.cloths.size());
  assets.cloths[0] = mesh;
  WEFT_TRY(world, sim::World::create(rig.device, scene, assets));
  return Trial(std::move(world));
}

Result<void> Trial::advance(std::uint32_t frames) {
  for (std::uint32_t frame = 0; frame < frames; ++frame) WEFT_CHECK(world_->advance_frame());
  return world_->finish();
}

Result<Moment> Trial::now() {
  WEFT_TRY(snapshot, world_->snapshot());
  Moment moment;
  for (const Vec4f& p : snapshot.position) {
    moment.position.push_back(p.xyz().to<double>());
    moment.mass.push_back(p.w > 0 ? 1 / static_cast<double>(p.w) : 0);
  }
  for (const Vec4f& v : snapshot.velocity) moment.velocity.push_back(v.xyz().to<double>());
  return moment;
}

Result<void> Trial::change(
    const std::function<void(std::size_t node, Vec3d& place, Vec3d& velocity)>& change) {
  WEFT_TRY(snapshot, world_->snapshot());
  for (std::size_t n = 0; n < snapshot.position.size(); ++n) {
    Vec3d x = snapshot.position[n].xyz().to<double>(), v = snapshot.velocity[n].xyz().to<double>();
    change(n, x, v);
    if (snapshot.position[n].w == 0) continue;  // held
    snapshot.position[n] = Vec4f::from(x.to<float>(), snapshot.position[n].w);
    snapshot.velocity[n] = Vec4f::from(v.to<float>(), 0);
  }
  return world_->restore(snapshot);
}

Result<double> Trial::energy() {
  WEFT_TRY(moment, now());
  reference::MassSpringSystem system;
  system.position = moment.position;
  system.velocity = moment.velocity;
  for (const double mass : moment.mass) system.inverse_mass.push_back(mass > 0 ? 1 / mass : 0);
  system.springs = reference::spring_links(world_->model().host);
  system.fabrics = reference::fabric_cloths(world_->model().host);
  WEFT_TRY(snapshot, world_->snapshot());
  for (reference::FabricCloth& cloth : system.fabrics) cloth.set_creases(snapshot.creases);
  system.solids = reference::solid_bodies(world_->model().host);
  system.acceleration = world_->scene().gravity;
  return reference::energy(system);
}

Result<double> Trial::period(std::uint32_t frames, const std::function<double(const Moment&)>& of) {
  WEFT_TRY(start, now());
  double before = of(start), time = world_->time();
  std::vector<double> crossed;
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    WEFT_CHECK(advance(1));
    WEFT_TRY(moment, now());
    const double here = of(moment), later = world_->time();
    if ((before > 0) != (here > 0)) crossed.push_back(time + (later - time) * before / (before - here));
    if (crossed.size() == 3) return crossed[2] - crossed[0];
    before = here;
    time = later;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::string members_of(const Rig& rig, const Material& material) {
  if (rig.takes_fabric())
    return R"("density": 0.2, "fabric": {"warp": )" + text_of(material.modulus) + R"(, "shear": )" +
           text_of(material.shear > 0 ? material.shear : 0.4 * material.modulus) + R"(, "bending_warp": )" +
           text_of(material.bending) + R"(, "damping": )" + text_of(material.damping) + "}";
  return R"("density": 0.2, "damping": 0.001, "stiffness": {"structural": )" + text_of(material.modulus) +
         R"(, "shear": )" + text_of(material.shear) + R"(, "bend": 0})";
}

std::string grid_of(std::uint32_t nx, std::uint32_t ny, double cell) {
  return R"("grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) + R"(], "size": [)" +
         text_of(cell * (nx - 1)) + ", " + text_of(cell * (ny - 1)) + "]";
}

double slope_of(const std::vector<double>& x, const std::vector<double>& y) {
  const double count = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sx += x[i];
    sy += y[i];
    sxx += x[i] * x[i];
    sxy += x[i] * y[i];
  }
  return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

}  // namespace weft::validate
