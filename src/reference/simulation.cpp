#include "reference/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/state_hash.hpp"
#include "contact/reference/pushes/analytic.hpp"
#include "contact/reference/pushes/response.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/rules/max_push.hpp"
#include "model/attachments.hpp"
#include "model/grab_speed.hpp"
#include "model/limited_edges.hpp"
#include "scene/motion.hpp"

namespace weft::reference {
namespace {

std::vector<BendLink> bending_of(const Model& model) {
  std::vector<BendLink> links;
  const ElementTable& triples = model.elements(ElementKind::Triple);
  for (std::size_t t = 0; t < triples.size(); ++t) {
    const auto nodes = triples.nodes_of(t);
    links.push_back({nodes[0], nodes[1], nodes[2], static_cast<double>(triples.material[t])});
  }
  return links;
}

void set_state(MassSpringSystem& system, std::span<const Vec4f> position, std::span<const Vec4f> velocity,
               std::span<const Vec4f> creases) {
  system.position.clear();
  system.velocity.clear();
  for (const Vec4f& p : position) system.position.push_back(p.xyz().to<double>());
  for (const Vec4f& v : velocity) system.velocity.push_back(v.xyz().to<double>());
  for (FabricCloth& cloth : system.fabrics) cloth.set_creases(creases);
}

}  // namespace

std::vector<SpringLink> spring_links(const Model& model) {
  std::vector<SpringLink> links;
  const Springs springs = model.springs();
  const std::vector<float> longest = longest_lengths(limited_edges(model), springs);
  for (std::size_t k = 0; k < springs.size(); ++k) {
    const Spring s = springs[k];
    links.push_back({s.node_a, s.node_b, static_cast<double>(s.rest_length), static_cast<double>(s.stiffness),
                     static_cast<double>(s.damping), static_cast<double>(longest[k])});
  }
  return links;
}

MassSpringSystem elements_of(const Model& model) {
  MassSpringSystem system;
  for (std::size_t node = 0; node < model.vertex_count(); ++node)
    system.inverse_mass.push_back(model.inverse_mass(node));
  system.springs = spring_links(model);
  system.bending = bending_of(model);
  system.fabrics = fabric_cloths(model);
  system.solids = solid_bodies(model);
  system.gases = enclosed_gases(model);
  return system;
}

EnergySums energies_at(MassSpringSystem& system, std::span<const Vec4f> position,
                       std::span<const Vec4f> velocity, std::span<const Vec4f> creases,
                       const Vec3d& acceleration) {
  set_state(system, position, velocity, creases);
  system.acceleration = acceleration;
  return energies(system);
}

std::vector<Vec3d> forces_at(MassSpringSystem& system, std::span<const Vec4f> position,
                             std::span<const Vec4f> velocity, std::span<const Vec4f> creases,
                             std::span<const double> mass, const Vec3d& acceleration) {
  set_state(system, position, velocity, creases);
  std::vector<Vec3d> forces = spring_forces(system);
  const std::vector<Vec3d> gas = gas_forces(system, system.position);
  for (std::size_t node = 0; node < forces.size(); ++node)
    forces[node] += gas[node] + mass[node] * acceleration;
  return forces;
}

Result<Simulation> Simulation::create(const scene::Scene& scene, const Assets& assets) {
  WEFT_TRY(model, build_model(scene, assets));
  Simulation made(scene, std::move(model));
  WEFT_TRY(plan, sim::FramePlan::create(scene, *made.model_, assets));
  made.plan_ = std::move(plan);
  scene::Solver settings = scene.solver;
  settings.kind = made.plan_.method().kind;
  made.stepper_ = make_stepper(settings, *made.model_, made.step());
  MassSpringSystem& system = made.system_;
  system = elements_of(*made.model_);
  system.acceleration = scene.gravity + scene.external_force;
  system.drag = scene.drag;
  system.wind = scene::wind_field(scene.wind);
  system.air = scene.air;
  if (scene.air) system.triangles = air_triangles(*made.model_);
  system.grab_speed = grab_speed(*made.model_);
  // No more than the whole distance in a substep: the follower would swing about its target.
  system.grab_rate = std::min(kGrabRate, 1 / made.step());
  const scene::ContactMethod method = scene.contact.method;
  if (method == scene::ContactMethod::Paper || method == scene::ContactMethod::Bvh)
    WEFT_CHECK(made.add_colliders(assets));
  if (method == scene::ContactMethod::Proximity)
    made.proximity_.emplace(scene, *made.model_, assets.objects, assets.deformations, made.step(),
                            solved_contact(scene, made.plan_.method()));
  made.reset();
  return made;
}

Result<void> Simulation::add_colliders(const Assets& assets) {
  const std::vector<mesh::TriangleMesh>& objects = assets.objects;
  for (std::size_t o = 0; o < objects.size(); ++o) {
    if (std::holds_alternative<scene::ColliderConvex>(scene_.colliders[assets.object_colliders[o]])) {
      convex_.emplace_back(objects[o]);
      continue;
    }
    const auto first = static_cast<std::uint32_t>(object_.positions.size());
    object_.positions.insert(object_.positions.end(), objects[o].positions.begin(),
                             objects[o].positions.end());
    for (std::size_t t = 0; t < objects[o].triangles.size(); ++t) {
      const TrianglePoints points = points_of(objects[o], static_cast<std::uint32_t>(t));
      const double area = length(cross(points.b - points.a, points.c - points.a));
      if (!(area > 0) || !std::isfinite(area))
        return input_error("Triangle %zu of collider mesh %zu has no area, or one that is not finite.", t, o);
      mesh::Triangle triangle = objects[o].triangles[t];
      for (std::uint32_t& vertex : triangle) vertex += first;
      object_.triangles.push_back(triangle);
    }
  }
  if (!object_.triangles.empty()) object_triangles_.emplace(object_);
  for (const scene::Collider& collider : scene_.colliders) {
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) spheres_.push_back(*sphere);
    if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider)) planes_.push_back(*plane);
  }
  push_limits_ = {scene_.contact.thickness, max_push(*model_, scene_.contact.thickness)};
  return {};
}

Result<void> Simulation::advance_frame() {
  const std::vector<Vec3d> position = system_.position, velocity = system_.velocity;
  std::vector<std::vector<hinge::Crease>> creases;
  for (const FabricCloth& cloth : system_.fabrics) creases.push_back(cloth.creases);
  const std::uint64_t contacts = contacts_;
  const std::vector<RigidState> rigid = proximity_ ? proximity_->rigid().states() : std::vector<RigidState>{};
  const sim::FramePlan::Frame frame = plan_.frame(frame_);
  for (std::uint32_t s = 0; s < frame.substeps; ++s) substep(s, frame);
  if (!finite()) {
    system_.position = position;
    system_.velocity = velocity;
    for (std::size_t c = 0; c < creases.size(); ++c) system_.fabrics[c].creases = creases[c];
    contacts_ = contacts;
    if (proximity_) proximity_->rigid().states() = rigid;
    return make_error(ErrorKind::Diverged,
                      "In frame %u the state is not finite; it stays as it was before that frame.", frame_);
  }
  ++frame_;
  return {};
}

void Simulation::reset() {
  system_.position = model_->start_position;
  system_.velocity.assign(model_->vertex_count(), {});
  for (FabricCloth& cloth : system_.fabrics) cloth.creases.assign(cloth.creases.size(), {});
  frame_ = 0;
  contacts_ = 0;
  if (proximity_) proximity_->forget();
  stepper_->forget();
}

void Simulation::substep(std::uint32_t number, const sim::FramePlan::Frame& frame) {
  const std::uint32_t count = frame.substeps;
  const double dt = scene_.time.frame / count;
  const double before = static_cast<double>(frame_) * count + number;  // substeps, were all frames cut alike
  const std::vector<Vec3d> previous = system_.position, velocity_before = system_.velocity;
  if (proximity_ && number == 0) proximity_->begin_frame(scene_.time.frame, dt);
  system_.time = before * dt;  // of the wind
  // As sim::FrameSteps counts time, to the bit: it decides which substep is the first of a grab.
  set_grabs(time() + number * dt + dt);
  std::function<Pressed(std::span<const Vec3d>)> pressed;
  if (solved_contact(scene_, plan_.method()).obstacles && finite())
    pressed = [&](std::span<const Vec3d> velocity) -> Pressed {
      std::vector<Press> presses = proximity_->presses(previous, velocity, before * dt, dt);
      return {proximity_->pressed_pairs(), std::move(presses)};
    };
  const double ratio = number == 0 ? frame.step_ratio : 1;
  stepper_->advance(
      {system_, places_at((before + 1) * dt, previous), dt, ratio, pressed, scene_.contact.restitution});
  const std::vector<Vec3d> position = system_.position, velocity = system_.velocity;
  if (!proximity_) {
    answer_contacts(previous);
  } else if (finite()) {
    contacts_ += proximity_->answer({previous, velocity_before, system_.inverse_mass, system_.position,
                                     system_.velocity, stepper_->held(), stepper_->pair_forces()},
                                    before * dt, dt);
    const std::vector<bool>& beside_cloth = proximity_->beside_cloth();
    for (std::size_t node = 0; node < beside_cloth.size(); ++node)
      if (beside_cloth[node]) stepper_->forget_hold(node);
  }
  if (proximity_ && proximity_->met()) {
    stepper_->begin_anew();
    return;
  }
  for (std::size_t node = 0; node < position.size(); ++node)
    if (system_.position[node] != position[node] || system_.velocity[node] != velocity[node])
      stepper_->forget(node);
}

std::vector<Vec3d> Simulation::places_at(double time, const std::vector<Vec3d>& previous) const {
  std::vector<scene::RigidTransform> transforms;
  for (const scene::Motion& motion : model_->motions) transforms.push_back(scene::motion_at(motion, time));
  std::vector<Vec3d> places = previous;
  for (std::size_t node = 0; node < previous.size(); ++node)
    if (model_->motion[node] > 1)
      places[node] = transforms[model_->motion[node] - 2](model_->rest_position[node]);
  return places;
}

void Simulation::set_grabs(double time) {
  system_.grabs.clear();
  for (const NodeGrab& one : model_->grabs)
    if (scene::active_at(one.grab, time)) system_.grabs[one.node] = scene::target_at(one.grab, time);
}

void Simulation::answer_contacts(const std::vector<Vec3d>& previous) {
  if (!object_triangles_ && convex_.empty() && spheres_.empty() && planes_.empty()) return;
  std::vector<NodePush> pushes(previous.size());
  if (object_triangles_) {
    const std::vector<TrianglePair> pairs = object_triangles_->pairs(model_->triangles, system_.position);
    contacts_ += pairs.size();
    pushes = pushes_of(pairs, model_->triangles, previous, system_.inverse_mass, object_, push_limits_);
  }
  contacts_ += add_convex_pushes(pushes, convex_, model_->triangles, previous, system_.position,
                                 system_.inverse_mass, push_limits_);
  if (!spheres_.empty() || !planes_.empty()) {
    const std::vector<NodePush> more =
        analytic_pushes(previous, system_.position, system_.inverse_mass, spheres_, planes_, push_limits_);
    for (std::size_t node = 0; node < more.size(); ++node) {
      pushes[node].sum += more[node].sum;
      pushes[node].count += more[node].count;
      contacts_ += more[node].count;
    }
  }
  respond(pushes, previous, system_.position, system_.velocity);
}

bool Simulation::finite() const {
  for (const auto* values : {&system_.position, &system_.velocity})
    for (const Vec3d& v : *values)
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return false;
  return true;
}

std::string Simulation::hash() const {
  return state_hash(std::as_bytes(std::span(system_.position)), std::as_bytes(std::span(system_.velocity)));
}

}  // namespace weft::reference
