// A search for pairs of features by itself: cloth and colliders where a test puts them, one detection, and
// what it lists, in the numbers of the meshes.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "contact/proximity/near_pairs.hpp"
#include "contact/proximity/pair_search.hpp"
#include "gpu/gpu_fixture.hpp"
#include "gpu/readback.hpp"
#include "mesh/grid.hpp"
#include "state/state.hpp"

namespace weft {

/// Cloth and the colliders that it meets. Lengths in [m].
struct SearchCase {
  mesh::TriangleMesh cloth;
  std::vector<std::array<float, 2>> uv;     // of its vertices; empty: x and z
  std::optional<mesh::Grid> grid;           // what the cloth is; none: a mesh
  std::vector<mesh::TriangleMesh> objects;  // the first colliders
  std::vector<bool> deforming;              // of each object; where the list ends: rigid
  std::vector<scene::Collider> shapes;      // the colliders after them
  std::vector<Vec3f> velocities;            // of its vertices [m/s]; empty: all rest
  std::vector<bool> held;                   // of each vertex: the scene moves it; where the list ends: free
  float substep = 1;                        // [s]
  float collider_travel = 0;                // in a substep
  float thickness = 0, self_thickness = 0;
  float reach = 0;       // slack of a slow vertex
  float most_reach = 0;  // of a fast one; 0: three times that
  std::array<std::uint32_t, 2>
      second_cloth{};  // its first vertex and its first triangle; 0: all are one cloth
  ContactRoom room{60000, 60000, 60000};

  float most() const { return most_reach > 0 ? most_reach : 3 * reach; }
  /// Of slow vertices.
  float radius() const { return thickness + reach; }
  float self_radius() const { return self_thickness + 2 * reach; }
};

struct SearchFound {
  Statistics statistics;
  std::vector<Vec4f> places;  // of each vertex at the search [m]; w: its slack [m]
  std::vector<Vec3f> aheads;  // its way ahead [m]
  std::vector<std::array<std::uint32_t, 2>> candidates;
  std::vector<ListedPair> pairs;
  // In the first substep behind it.
  std::vector<ListedPair> after;
  std::vector<Contact> records;
  std::vector<std::uint32_t> vertex_contacts;
};

/// p' = rotation p + translation, row by row, as the GPU has it.
struct RigidRows {
  std::array<Vec4f, 3> rows;
  Vec3d operator()(const Vec3d& p) const {
    Vec3d moved;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec4f& row = rows[static_cast<std::size_t>(axis)];
      moved[axis] = dot(row.xyz().to<double>(), p) + row.w;
    }
    return moved;
  }
};

class SearchRun {
 public:
  SearchRun(gpu::Device& device, SearchCase setup, std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize)
      : device_(device), setup_(std::move(setup)) {
    auto model = GpuModel::create(device, model_of());
    REQUIRE(model);
    model_ = std::move(*model);
    auto state = State::create(device, model_.host, 1);
    REQUIRE(state);
    state_ = std::move(*state);
    auto pairs = ContactPairs::create(device, model_.host, setup_.room, {});
    REQUIRE(pairs);
    pairs_ = std::move(*pairs);
    create_search(workgroup_size);
    rest_ = setup_.cloth.positions;
    place(setup_.cloth.positions);
    StepBlock step;
    step.time.dt = setup_.substep;
    step.nodes.count = model_.vertex_count();
    step.contact.most_reach = setup_.most();
    step.contact.thickness = setup_.most();  // so that what is at rest has the whole slack
    step.contact.collider_travel = setup_.collider_travel;
    step.contact.detect = Detect::Always;
    state_.steps.write(device, std::span(&step, 1));
    gpu::ComputePass pass(list_, "search");
    search_.record(pass);
    gpu::ComputePass near_pass(near_list_, "near pairs");
    near_.record(near_pass);
  }

  /// Other places of the cloth's vertices: a pipeline takes far longer to make than to run.
  void place(const std::vector<Vec3f>& positions) {
    setup_.cloth.positions = positions;
    std::vector<Vec4f> places;
    for (std::size_t v = 0; v < positions.size(); ++v)
      places.push_back(Vec4f::from(positions[v], v < setup_.held.size() && setup_.held[v] ? 0.0F : 1.0F));
    state_.position[0].write(device_, places);
    for (std::size_t v = 0; v < setup_.velocities.size(); ++v) {  // where the solver has predicted them
      const Vec3d end = positions[v].to<double>() + setup_.substep * setup_.velocities[v].to<double>();
      places[v] = Vec4f::from(end.to<float>(), places[v].w);
    }
    state_.position[1].write(device_, places);
  }
  void move(const std::vector<Vec3f>& positions, const std::vector<Vec3f>& velocities) {
    setup_.velocities = velocities;
    place(positions);
  }
  /// Other places of an object's vertices, as a collider's motion would bring them.
  void place_object(std::size_t object, const std::vector<Vec3f>& positions) {
    setup_.objects[object].positions = positions;
    std::vector<Vec4f> places;
    for (const Vec3f& p : positions) places.push_back(Vec4f::from(p, 0));
    search_.points().write(device_, places, first_point(object));
    search_.points().write(device_, places, search_.colliders().point_count + first_point(object));
  }
  void move_object(std::size_t object, const RigidRows& to) {
    std::vector<Vec3f> moved;
    for (const Vec3f& p : setup_.objects[object].positions) moved.push_back(to(p.to<double>()).to<float>());
    place_object(object, moved);
    search_.points().write(device_, to.rows, 4 * (search_.colliders().point_count + object));
  }

  SearchFound run() {
    gpu::CommandList clear;
    clear.clear(state_.statistics.source());
    clear.clear(search_.candidates().source());
    clear.clear(pairs_.listed.source());
    clear.clear(pairs_.contacts.source());
    REQUIRE(device_.submit(clear));
    REQUIRE(device_.submit(list_));
    SearchFound found;
    found.pairs = read(pairs_.listed);
    REQUIRE(device_.submit(near_list_));
    const std::vector<std::uint32_t> words = read(state_.statistics);
    REQUIRE(words.size() * 4 == sizeof(Statistics));
    std::memcpy(static_cast<void*>(&found.statistics), words.data(), sizeof(Statistics));
    REQUIRE(found.statistics.rolled_back == 0);
    CHECK(found.statistics.detections == 1);
    const std::vector<Vec4f> predicted = read(pairs_.predicted);
    const std::size_t count = model_.vertex_count();
    REQUIRE(predicted.size() == 3 * count);
    for (std::size_t v = 0; v < count; ++v) {
      found.places.push_back(predicted[count + v]);
      found.aheads.push_back(predicted[2 * count + v].xyz());
    }
    found.candidates = read(search_.candidates());
    found.candidates.resize(found.statistics.candidates);
    found.pairs.resize(found.statistics.pairs);
    found.after = read(pairs_.listed);
    found.after.resize(found.statistics.pairs);
    found.records = read(pairs_.contacts);
    found.records.resize(found.statistics.near);
    found.vertex_contacts = read(pairs_.vertex_contacts);
    return found;
  }

  const SearchCase& setup() const { return setup_; }
  /// The cloth's places at rest: those of its making [m].
  const std::vector<Vec3f>& rest() const { return rest_; }
  std::uint32_t cloth_of(std::uint32_t vertex) const {
    return setup_.second_cloth[0] > 0 && vertex >= setup_.second_cloth[0] ? 1 : 0;
  }
  const Model& model() const { return model_.host; }
  const contact::PairSearch& search() const { return search_; }
  std::uint32_t first_point(std::size_t object) const {
    std::size_t first = 0;
    for (std::size_t o = 0; o < object; ++o) first += setup_.objects[o].positions.size();
    return static_cast<std::uint32_t>(first);
  }

 private:
  Model model_of() const {
    Model host;
    const std::size_t vertices = setup_.cloth.positions.size();
    for (const Vec3f& p : setup_.cloth.positions) {
      host.rest_position.push_back(p.to<double>());
      host.uv.push_back({p.x, p.z});
    }
    host.start_position = host.rest_position;
    if (!setup_.uv.empty()) host.uv = setup_.uv;
    host.mass.assign(vertices, 1);
    host.motion.assign(vertices, 0);
    host.triangles = setup_.cloth.triangles;
    Body body;
    body.vertex_count = static_cast<std::uint32_t>(vertices);
    body.triangle_count = static_cast<std::uint32_t>(host.triangles.size());
    body.grid = setup_.grid;
    host.bodies = {body};
    if (const auto [vertex, triangle] = setup_.second_cloth; vertex > 0) {
      host.bodies.push_back(body);
      host.bodies[0].vertex_count = vertex;
      host.bodies[0].triangle_count = triangle;
      host.bodies[1].first_vertex = vertex;
      host.bodies[1].vertex_count -= vertex;
      host.bodies[1].first_triangle = triangle;
      host.bodies[1].triangle_count -= triangle;
    }
    return host;
  }

  void create_search(std::uint32_t workgroup_size) {
    scene::Scene scene;
    scene.cloths.resize(model_.host.bodies.size());
    std::vector<std::size_t> colliders;
    std::vector<mesh::Deformation> deformations(setup_.objects.size());
    for (std::size_t o = 0; o < setup_.objects.size(); ++o) {
      colliders.push_back(o);
      scene.colliders.push_back(scene::ColliderMesh{});
      if (o < setup_.deforming.size() && setup_.deforming[o])
        deformations[o] = {{{1}}, {setup_.objects[o].positions}};
    }
    for (const scene::Collider& shape : setup_.shapes) scene.colliders.push_back(shape);
    contact::SearchSetup search_setup{setup_.thickness, setup_.self_thickness, workgroup_size};
    search_setup.most_slack.assign(model_.vertex_count(), setup_.most());
    auto search = contact::PairSearch::create(device_, model_, state_, pairs_, scene,
                                              {setup_.objects, colliders, deformations}, search_setup);
    REQUIRE_MESSAGE(search, search.error().message);
    search_ = std::move(*search);
    auto near = contact::NearPairs::create(device_, false, workgroup_size);
    REQUIRE(near);
    near_ = std::move(*near);
    REQUIRE(near_.bind(state_, pairs_, search_.points()));
  }

  template <class T>
  std::vector<T> read(const gpu::Buffer<T>& buffer) {
    auto values = gpu::download(device_, buffer);
    REQUIRE(values);
    return *values;
  }

  gpu::Device& device_;
  SearchCase setup_;
  std::vector<Vec3f> rest_;
  GpuModel model_;
  State state_;
  ContactPairs pairs_;
  contact::PairSearch search_;
  contact::NearPairs near_;
  gpu::CommandList list_, near_list_;
};

/// The first triangles of a square grid, 1 m long and wide, flat in xz; cells of 1/8 m or, where that is too
/// few, smaller.
inline SearchCase sheet_of(std::uint32_t triangle_count) {
  std::uint32_t cells = 8;
  while (2 * cells * cells < triangle_count) ++cells;
  const mesh::Grid grid{cells + 1, cells + 1, 1, 1};
  SearchCase made;
  made.cloth.triangles = mesh::grid_triangles(grid);
  made.cloth.triangles.resize(triangle_count);
  for (std::uint32_t j = 0; j <= cells; ++j)
    for (std::uint32_t i = 0; i <= cells; ++i) {
      const mesh::RestPoint at = mesh::rest_point(grid, i, j);
      made.cloth.positions.push_back(Vec3d{at.x, 0, at.y}.to<float>());
    }
  made.self_thickness = 0.0625F / static_cast<float>(cells) * 4;
  made.thickness = 2 * made.self_thickness;
  made.reach = 0.25F * made.self_thickness;
  return made;
}

enum class Shape { Flat, Wavy, Accordion, Crumpled };
constexpr Shape kShapes[] = {Shape::Flat, Shape::Wavy, Shape::Accordion, Shape::Crumpled};

inline std::vector<Vec3f> shaped(const std::vector<Vec3f>& flat, Shape shape, std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<Vec3f> placed;
  for (const Vec3f& at : flat) {
    Vec3d p = at.to<double>();
    if (shape == Shape::Wavy) p.y = 0.1 * std::sin(20 * p.x + 3 * p.z);
    if (shape == Shape::Accordion) {  // four layers, which lean by a twentieth of their length
      const double place = 4 * p.x, along = place - std::floor(place);
      const int layer = static_cast<int>(place);
      p = {0.25 * (layer % 2 == 0 ? along : 1 - along), 0.04 * layer + 0.04 * along, p.z};
    }
    if (shape == Shape::Crumpled)
      p = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
    placed.push_back(p.to<float>());
  }
  return placed;
}

}  // namespace weft
