// The structs and numbers that C++ and WGSL both write down. A struct of a uniform or storage binding that is
// missing here fails tests/web/layouts.test.ts.
#include "layouts.hpp"

#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string>

#include "contact/object_tree.hpp"
#include "contact/proximity/pair_search.hpp"
#include "contact/proximity/rigid_bodies.hpp"
#include "contact/proximity/round_kernel.hpp"
#include "contact/proximity/tree_refit.hpp"
#include "contact/pushes/colliders_analytic.hpp"
#include "contact/pushes/colliders_convex.hpp"
#include "contact/pushes/object_triangles.hpp"
#include "contact/pushes/pairs_paper.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/rules/rigid_body.hpp"
#include "element/spring/neighbours.hpp"
#include "element/spring/packed_springs.hpp"
#include "element/spring/spring_blocks.hpp"
#include "element/spring/spring_grid.hpp"
#include "gpu/kernel.hpp"
#include "mesh/sheet_rim.hpp"
#include "method/creases.hpp"
#include "method/enclosed_gas.hpp"
#include "method/fabric_buffers.hpp"
#include "method/mass_spring/advance_mesh.hpp"
#include "method/multigrid/cycle.hpp"
#include "method/multigrid/grid_level_params.hpp"
#include "method/multigrid/mesh_lists.hpp"
#include "method/node_range.hpp"
#include "method/projection/color.hpp"
#include "method/projective_dynamics/solver_projective_dynamics.hpp"
#include "method/solid_buffers.hpp"
#include "method/vbd/solver_vbd.hpp"
#include "model/cords.hpp"
#include "model/limited_edges.hpp"
#include "model/model.hpp"
#include "overlay/overlay.hpp"
#include "render/fabric.hpp"
#include "render/fine_cloth.hpp"
#include "render/floor.hpp"
#include "render/frame_params.hpp"
#include "render/light.hpp"
#include "scene/grab.hpp"
#include "scene/scene.hpp"
#include "state/contact_pairs.hpp"
#include "state/statistics.hpp"
#include "state/step_block.hpp"
#include "state/surface.hpp"

namespace weft {
namespace {

/// WGSL's name of what a member is made of.
template <class T>
struct Scalar : Scalar<typename T::value_type> {};  // std::array
template <>
struct Scalar<float> {
  static constexpr const char* kName = "f32";
};
template <>
struct Scalar<Vec4f> : Scalar<float> {};
template <>
struct Scalar<std::uint32_t> {
  static constexpr const char* kName = "u32";
};
template <>
struct Scalar<Detect> : Scalar<std::uint32_t> {};

#define PART(part, name)                       \
  template <>                                  \
  struct Scalar<StepBlock::part> {             \
    static constexpr const char* kName = name; \
  };
PART(Time, "StepTime")
PART(Nodes, "StepNodes")
PART(Contact, "StepContact")
PART(Air, "StepAir")
PART(Hands, "StepHands")
PART(Method, "StepMethod")
#undef PART
template <>
struct Scalar<MembraneLawBlock> {
  static constexpr const char* kName = "MembraneLaw";
};

template <>
struct Scalar<SolidLawBlock> {
  static constexpr const char* kName = "SolidLaw";
};

template <class T>
Json member(const char* name, std::size_t offset) {
  return {{"name", name}, {"offset", offset}, {"size", sizeof(T)}, {"scalar", Scalar<T>::kName}};
}

/// `rounded_to` [bytes]: the C++ struct is padded to a multiple of it, which WGSL does not know of.
Json row(const char* name, const char* file, std::size_t size, std::size_t rounded_to,
         std::initializer_list<Json> members) {
  return {{"name", name},
          {"file", file},
          {"size", size},
          {"rounded_to", rounded_to},
          {"members", Json::array_t(members)}};
}

constexpr std::size_t kExact = 1;     // the same size in both
constexpr std::size_t kUniform = 16;  // a uniform block of its own

#define M(name) member<decltype(T::name)>(#name, offsetof(T, name))

Json step_block() {
  using T = StepBlock;
  return row("StepBlock", "state/step.wgsl", sizeof(T), kExact,
             {M(time), M(nodes), M(contact), M(air), M(hands), M(method)});
}
Json step_time() {
  using T = StepBlock::Time;
  return row("StepTime", "state/step.wgsl", sizeof(T), alignof(T), {M(dt), M(step_ratio)});
}
Json step_nodes() {
  using T = StepBlock::Nodes;
  return row("StepNodes", "state/step.wgsl", sizeof(T), alignof(T), {M(count), M(first_motion)});
}
Json step_contact() {
  using T = StepBlock::Contact;
  return row("StepContact", "state/step.wgsl", sizeof(T), alignof(T),
             {M(thickness), M(self_thickness), M(push_scale), M(max_push), M(most_reach), M(restitution),
              M(collider_travel), M(detect), M(point_count), M(first_place), M(most_delay)});
}
Json step_air() {
  using T = StepBlock::Air;
  return row("StepAir", "state/step.wgsl", sizeof(T), alignof(T),
             {M(acceleration), M(wind), M(wind_wave_a), M(wind_wave_b), M(gust_a), M(gust_b), M(drag),
              M(pressure), M(lift), M(friction)});
}
Json step_hands() {
  using T = StepBlock::Hands;
  return row("StepHands", "state/step.wgsl", sizeof(T), alignof(T),
             {M(first), M(count), M(still), M(first_still), M(first_moving), M(rate), M(speed)});
}
Json step_method() {
  using T = StepBlock::Method;
  return row("StepMethod", "state/step.wgsl", sizeof(T), alignof(T),
             {M(spring_count), M(force_scale), M(force_limit)});
}
Json spring() {
  using T = PackedSpring;
  return row("Spring", "element/spring/packed_spring.wgsl", sizeof(T), kExact,
             {M(node_a), M(node_b_and_kind), M(rest_length)});
}
Json spring_kind() {
  using T = SpringKind;
  return row("SpringKind", "element/spring/packed_spring.wgsl", sizeof(T), kExact,
             {M(stiffness), M(damping)});
}
Json spring_block() {
  using T = SpringBlock;
  return row("SpringBlock", "method/mass_spring/spring_block_forces.wgsl", sizeof(T), kExact,
             {M(first_node), M(node_count), M(first_spring), M(spring_count)});
}
Json block_spring() {
  using T = BlockSpring;
  return row("BlockSpring", "method/mass_spring/spring_block_forces.wgsl", sizeof(T), kExact,
             {M(nodes_and_kind), M(rest_length)});
}
Json neighbour() {
  using T = Neighbour;
  return row("Neighbour", "element/spring/neighbour.wgsl", sizeof(T), kExact,
             {M(node_and_kind), M(rest_length)});
}
Json mesh_params() {
  using T = MeshParams;
  return row("MeshParams", "method/mass_spring/advance_mesh.wgsl", sizeof(T), kUniform,
             {M(first), M(count), M(kinds)});
}
Json membrane_law() {
  using T = MembraneLawBlock;
  return row("MembraneLaw", "element/membrane/law.wgsl", sizeof(T), kUniform,
             {M(stiffness), M(delay), M(energy)});
}
Json enclosed_gas() {
  using T = Gas;
  return row("Gas", "method/gas.wgsl", sizeof(T), kExact,
             {M(first_vertex), M(first_chunk), M(chunk_count), M(rest_volume), M(rest_pressure),
              M(rest_gauge), M(volume), M(gauge)});
}
Json gas_chunk() {
  using T = GasChunk;
  return row("GasChunk", "method/gas.wgsl", sizeof(T), kExact, {M(gas), M(first), M(count)});
}
Json fabric_params() {
  using T = FabricParams;
  return row("FabricParams", "method/fabric_params.wgsl", sizeof(T), kUniform,
             {M(first), M(count), M(triangles), M(hinges), M(law)});
}
Json yield_law() {
  using T = YieldLawBlock;
  return row("YieldLaw", "element/hinge/yield.wgsl", sizeof(T), kUniform,
             {M(curvature), M(hardening), M(first), M(padding)});
}
Json node_range() {
  using T = NodeRange;
  return row("NodeRange", "method/mass_spring/advance_gathered.wgsl", sizeof(T), kExact,
             {M(first), M(count)});
}
Json solid_law() {
  using T = SolidLawBlock;
  return row("SolidLaw", "element/tet/law.wgsl", sizeof(T), kUniform,
             {M(mu), M(lambda), M(delay), M(energy)});
}
Json solid_params() {
  using T = SolidParams;
  return row("SolidParams", "method/solid_params.wgsl", sizeof(T), kUniform,
             {M(first), M(count), M(tets), M(first_tet), M(law)});
}
Json spring_grid_row() {
  using T = SpringGrid;
  return row("SpringGrid", "element/spring/spring_grid.wgsl", sizeof(T), kUniform,
             {M(first_vertex), M(nx), M(ny), M(uniform_weights), M(stiffness), M(damping), M(rest_length),
              M(bending), M(longest)});
}
Json level_of_grid() {
  using T = GridLevelParams;
  return row("GridLevelParams", "method/multigrid/grid_level.wgsl", sizeof(T), kExact,
             {M(nx), M(ny), M(first_vector), M(first_operator), M(bending_i), M(bending_j), M(last_bend_i),
              M(last_bend_j), M(rim), M(vectors), M(operators), M(padding)});
}
Json cloth_nodes() {
  using T = ClothNodes;
  return row("ClothNodes", "method/multigrid/cloth.wgsl", sizeof(T), kUniform,
             {M(first_vertex), M(count), M(residual), M(may_retry), M(vectors), M(iterations), M(first_part),
              M(padding)});
}
Json bottom_sweeps() {
  using T = BottomSweeps;
  return row("BottomSweeps", "method/multigrid/tail.wgsl", sizeof(T), kExact, {M(count), M(middle), M(half)});
}
Json level_of_mesh() {
  using T = MeshLevelParams;
  return row("MeshLevelParams", "method/multigrid/mesh_level.wgsl", sizeof(T), kExact,
             {M(node_count), M(block_count), M(first_vector), M(first_row), M(first_source), M(first_product),
              M(first_taps), M(padding)});
}
Json share() {
  using T = Share;
  return row("Share", "method/multigrid/mesh_level.wgsl", sizeof(T), kExact, {M(index), M(weight)});
}
Json elements_of_color() {
  using T = ElementsOfColor;
  return row("ElementsOfColor", "method/projection/color.wgsl", sizeof(T), kUniform, {M(first), M(count)});
}
Json nodes_of_color() {
  using T = NodesOfColor;
  return row("NodesOfColor", "method/vbd/descend.wgsl", sizeof(T), kUniform,
             {M(first), M(count), M(first_node), M(kinds)});
}
Json gathered_color() {
  using T = GatheredColor;
  return row("GatheredColor", "method/vbd/gathered_color.wgsl", sizeof(T), kUniform,
             {M(first), M(count), M(first_node), M(rows)});
}
Json relaxed_nodes() {
  using T = RelaxedNodes;
  return row("RelaxedNodes", "method/projective_dynamics/relaxed_nodes.wgsl", sizeof(T), kUniform,
             {M(first_node), M(count), M(stiffness_rate), M(damping_rate), M(radius)});
}
Json spring_kinds() {
  using T = SpringKindsBlock;
  return row("SpringKinds", "element/spring/neighbour.wgsl", sizeof(T), kUniform, {M(kinds)});
}
Json turned_tet() {
  using T = TurnedTet;
  return row("TurnedTet", "method/projective_dynamics/turned_tet.wgsl", sizeof(T), kExact,
             {M(first), M(second), M(third)});
}
Json fabric_pair() {
  using T = FabricPair;
  return row("FabricPair", "method/projective_dynamics/fabric_pair.wgsl", sizeof(T), kExact,
             {M(other), M(pull), M(damping), M(bending)});
}
Json iteration() {
  using T = Iteration;
  return row("Iteration", "method/projective_dynamics/relax.wgsl", sizeof(T), kUniform, {M(weight)});
}
Json surface_params() {
  using T = SurfaceParams;
  return row("SurfaceParams", "state/surface.wgsl", sizeof(T), kUniform,
             {M(first_vertex), M(vertex_count), M(row)});
}
Json fine_grid() {
  using T = render::FineGridParams;
  return row("FineGrid", "render/fine_grid.wgsl", sizeof(T), kUniform,
             {M(first_node), M(first_vertex), M(nx), M(ny), M(level)});
}
Json object_triangle() {
  using T = contact::ObjectTriangle;
  return row("ObjectTriangle", "contact/pushes/contact_pair.wgsl", sizeof(T), kExact, {M(a), M(b), M(c)});
}
Json tree_node() {
  using T = contact::TreeNode;
  using Axis = decltype(T::low)::value_type;
  constexpr std::size_t low = offsetof(T, low), high = offsetof(T, high);
  return row("TreeNode", "contact/pushes/bvh.wgsl", sizeof(T), kExact,
             {member<Axis>("low_x", low), member<Axis>("low_y", low + sizeof(Axis)),
              member<Axis>("low_z", low + 2 * sizeof(Axis)), member<Axis>("high_x", high),
              member<Axis>("high_y", high + sizeof(Axis)), member<Axis>("high_z", high + 2 * sizeof(Axis)),
              M(child), M(spare)});
}
Json pair_range() {
  using T = contact::PairRange;
  return row("PairRange", "contact/pushes/paper.wgsl", sizeof(T), 256, {M(first), M(count), M(chunk)});
}
Json analytic_collider() {
  using T = contact::AnalyticCollider;
  return row("AnalyticCollider", "contact/pushes/analytic.wgsl", sizeof(T), kExact, {M(point), M(normal)});
}
Json convex_body() {
  using T = contact::ConvexBody;
  return row("ConvexBody", "contact/pushes/gjk.wgsl", sizeof(T), kExact,
             {M(low), M(high), M(first_point), M(points), M(first_face), M(faces), M(first_edge), M(edges),
              M(first_ring), M(first_corner)});
}
Json limited_edge() {
  using T = LimitedEdge;
  return row("LimitedEdge", "contact/proximity/limited_edge.wgsl", sizeof(T), kExact,
             {M(a), M(b), M(longest)});
}
Json cord() {
  using T = Cord;
  return row("Cord", "method/multigrid/cord_terms.wgsl", sizeof(T), kExact,
             {M(a), M(b), M(longest), M(stiffness), M(damping)});
}
Json listed_pair() {
  using T = ListedPair;
  return row("ListedPair", "state/contact.wgsl", sizeof(T), kExact, {M(ids), M(words)});
}
Json contact_of_pair() {
  using T = Contact;
  return row("Contact", "state/contact.wgsl", sizeof(T), kUniform,
             {M(ids), M(next), M(normal), M(place), M(surface), M(force), M(urgency), M(solid), M(near),
              M(other_end), M(thickness), M(solid_speed), M(begun), M(held)});
}
Json pair_hold() {
  using T = PairHold;
  return row("PairHold", "state/pair_holds.wgsl", sizeof(T), kUniform,
             {M(ids), M(normal), M(along), M(force), M(place), M(start)});
}
Json search_params() {
  using T = contact::SearchParams;
  return row("SearchParams", "contact/proximity/triangles.wgsl", sizeof(T), kExact,
             {M(triangle_count), M(collider_count), M(self_contact), M(first_row), M(candidate_capacity),
              M(pair_capacity), M(thickness), M(self_thickness), M(vertex_count), M(first_opposite),
              M(first_rim), M(first_rest), M(patch_columns)});
}
Json patch_place() {
  using T = contact::PatchPlace;
  return row("PatchPlace", "contact/proximity/patches.wgsl", sizeof(T), kExact,
             {M(cell_vertex), M(patch_vertex), M(stride), M(cell_size), M(patch_size), M(per_width),
              M(per_height), M(columns)});
}
Json tree_params() {
  using T = contact::TreeParams;
  return row("TreeParams", "contact/proximity/tree_params.wgsl", sizeof(T), kExact,
             {M(tree), M(top), M(first_triangle), M(triangle_count)});
}
Json contact_round() {
  using T = contact::Round;
  return row("Round", "contact/proximity/rounds.wgsl", sizeof(T), kExact,
             {M(number), M(is_first), M(is_last), M(since)});
}
Json colliders() {
  using List = std::array<std::array<std::uint32_t, 4>, contact::kMostColliders>;
  static_assert(sizeof(List) == contact::kMostColliders * sizeof(contact::TreeWord));
  return row("Colliders", "contact/proximity/find_candidates.wgsl", sizeof(List), kExact,
             {member<List>("list", 0)});
}
Json collider_place() {
  using T = contact::ColliderPlace;
  return row("ColliderPlace", "contact/proximity/move_points.wgsl", sizeof(T), kExact,
             {M(rows), M(shape), M(spin)});
}
Json frame() {
  using T = render::FrameParams;
  return row("Frame", "render/frame.wgsl", sizeof(T), kExact,
             {M(view_projection), M(light_projection), M(eye), M(to_light), M(viewport), M(field_range),
              M(color_map), M(right), M(up), M(forward), M(shadow_span)});
}
Json fabric() {
  using T = render::FabricParams;
  return row("Fabric", "render/weave.wgsl", sizeof(T), kExact,
             {M(tint), M(warp), M(weft), M(stripe), M(accent), M(back), M(rim), M(gloss), M(weave),
              M(pattern), M(period), M(shift)});
}
Json light() {
  using T = render::LightParams;
  return row("Light", "render/surroundings.wgsl", sizeof(T), kExact,
             {M(sun), M(irradiance), M(level), M(slope), M(curve), M(area_direction), M(area_radiance),
              M(backdrop_horizon), M(backdrop_zenith)});
}
Json overlay_params() {
  using T = overlay::Params;
  return row("OverlayParams", "overlay/overlay.wgsl", sizeof(T), kExact,
             {M(width), M(height), M(atlas_width), M(atlas_height)});
}
Json overlay_vertex() {
  using T = overlay::Vertex;
  return row("OverlayVertex", "overlay/overlay.wgsl", sizeof(T), kExact,
             {M(x), M(y), M(u), M(v), M(color), M(clip)});
}
Json overlay_place() {
  using T = overlay::Place;
  return row("OverlayPlace", "overlay/picture.wgsl", sizeof(T), kExact, {M(x), M(y), M(width), M(height)});
}
Json plane() {
  using T = render::PlaneParams;
  return row("Plane", "render/floor_square.wgsl", sizeof(T), kExact, {M(center), M(along), M(across)});
}

#undef M

Json constant(const char* name, const char* file, double value) {
  return {{"name", name}, {"file", file}, {"value", value}};
}

/// One that kernels have as f32.
Json real(const char* name, const char* file, double value) {
  return constant(name, file, static_cast<double>(static_cast<float>(value)));
}

/// Kernels know the statistics as words of an array.
void add_statistics(Json& constants) {
  const Statistics statistics;
  for_each(statistics, [&](const char* name, const auto& value) {
    std::string word = "kStat";
    for (const char* at = name; *at != 0; ++at) {
      const bool begins = at == name || at[-1] == '_';
      if (*at != '_') word += static_cast<char>(begins ? std::toupper(*at) : *at);
    }
    const auto offset = reinterpret_cast<const char*>(&value) - reinterpret_cast<const char*>(&statistics);
    constants.push_back(
        constant(word.c_str(), "state/statistics.wgsl", static_cast<double>(offset) / sizeof(std::uint32_t)));
  });
}

}  // namespace

Json struct_layouts() {
  return Json::array({step_block(),
                      step_time(),
                      step_nodes(),
                      step_contact(),
                      step_air(),
                      step_hands(),
                      step_method(),
                      spring(),
                      spring_kind(),
                      limited_edge(),
                      cord(),
                      spring_block(),
                      block_spring(),
                      neighbour(),
                      mesh_params(),
                      membrane_law(),
                      enclosed_gas(),
                      gas_chunk(),
                      fabric_params(),
                      node_range(),
                      yield_law(),
                      solid_law(),
                      solid_params(),
                      surface_params(),
                      object_triangle(),
                      spring_grid_row(),
                      level_of_grid(),
                      tree_node(),
                      pair_range(),
                      analytic_collider(),
                      listed_pair(),
                      contact_of_pair(),
                      pair_hold(),
                      search_params(),
                      patch_place(),
                      contact_round(),
                      tree_params(),
                      colliders(),
                      collider_place(),
                      frame(),
                      fabric(),
                      light(),
                      plane(),
                      overlay_params(),
                      overlay_vertex(),
                      overlay_place(),
                      fine_grid(),
                      cloth_nodes(),
                      bottom_sweeps(),
                      elements_of_color(),
                      nodes_of_color(),
                      gathered_color(),
                      relaxed_nodes(),
                      spring_kinds(),
                      fabric_pair(),
                      turned_tet(),
                      iteration(),
                      level_of_mesh(),
                      share(),
                      convex_body()});
}

Json shared_constants() {
  Json constants = Json::array({
      constant("kGroupsPerRow", "gpu/index.wgsl", gpu::kGroupsPerRow),
      constant("kRigidWords", "contact/proximity/rigid_words.wgsl", contact::kRigidWords),
      constant("kRigidRows", "contact/proximity/rigid_words.wgsl", contact::kRigidRows),
      constant("kMesh", "contact/proximity/rigid_words.wgsl", static_cast<double>(SolidKind::Mesh)),
      constant("kMostTouches", "contact/proximity/move_rigid.wgsl", kMostTouches),
      constant("kTouchRounds", "contact/proximity/move_rigid.wgsl", kTouchRounds),
      real("kTouchPart", "contact/proximity/move_rigid.wgsl", kTouchPart),
      real("kOutPart", "contact/proximity/move_rigid.wgsl", kOutPart),
      constant("kOutSpeed", "contact/proximity/move_rigid.wgsl", kOutSpeed),
      real("kNoFriction", "contact/proximity/move_rigid.wgsl", kRigidFriction),
      constant("kWorkgroupSize", "gpu/index.wgsl", gpu::kDefaultWorkgroupSize),
      constant("kAnalyticId", "contact/pushes/analytic.wgsl", contact::kAnalyticId),
      constant("kConvexId", "contact/pushes/convex.wgsl", contact::kConvexId),
      constant("kEdgeWords", "contact/pushes/gjk.wgsl", contact::kEdgeWords),
      constant("kStackSize", "contact/pushes/bvh.wgsl", contact::kStackSize),
      constant("kWireframe", "render/frame.wgsl", static_cast<double>(scene::View::Wireframe)),
      constant("kResidual", "method/multigrid/cloth.wgsl", multigrid::kResidual),
      constant("kInverse", "method/multigrid/cloth.wgsl", multigrid::kInverse),
      constant("kDirection", "method/multigrid/cloth.wgsl", multigrid::kDirection),
      constant("kCoarseTile", "method/multigrid/descend_coarse.wgsl", multigrid::kCoarseTile),
      constant("kTile", "method/multigrid/ascend_coarse.wgsl", multigrid::kTile),
      constant("kFirst", "method/multigrid/cloth.wgsl", multigrid::kFirst),
      constant("kSecond", "method/multigrid/cloth.wgsl", multigrid::kSecond),
      constant("kVectors", "method/multigrid/cloth.wgsl", multigrid::kVectors),
      constant("kGasChunk", "method/gas.wgsl", kGasChunk),
      constant("kPieceChunk", "method/pieces/piece.wgsl", kPieceChunk),
      constant("kChunkWords", "method/pieces/piece.wgsl", kChunkWords),
      constant("kPieceColumns", "method/pieces/piece.wgsl", kPieceColumns),
      constant("kTurnColumns", "method/pieces/piece.wgsl", kTurnColumns),
      real("kLeastVolume", "method/gas.wgsl", gas::kLeastVolume),
      constant("kTaps", "method/multigrid/mesh_level.wgsl", multigrid::taps_of(false)),
      constant("kReachMargin", "state/step.wgsl", kReachMargin),
      constant("kHoldWords", "contact/proximity/press_sums.wgsl", kHoldWords),
      constant("kPressWords", "contact/proximity/press_sums.wgsl", kPressWords),
      constant("kDetectNo", "state/step.wgsl", static_cast<double>(Detect::No)),
      constant("kDetectIfDue", "state/step.wgsl", static_cast<double>(Detect::IfDue)),
      constant("kDetectAlways", "state/step.wgsl", static_cast<double>(Detect::Always)),
      constant("kColliderPoint", "state/contact.wgsl", kColliderPoint),
      constant("kPairFlag", "state/contact.wgsl", kPairFlag),
      constant("kIdBits", "state/contact.wgsl", kIdBits),
      constant("kVertexWords", "state/contact.wgsl", kVertexWords),
      constant("kTangledWord", "state/contact.wgsl", kTangledWord),
      constant("kHasRecord", "state/contact.wgsl", kHasRecord),
      constant("kKeptRoomWord", "contact/proximity/kept_forces.wgsl", kKeptRoomWord),
      constant("kCrossingFlag", "state/contact.wgsl", kCrossingFlag),
      constant("kUntangles", "state/contact.wgsl", kUntangles),
      constant("kNoCorner", "contact/proximity/triangles.wgsl", kNoCorner),
      constant("kNoCell", "contact/proximity/patches.wgsl", contact::kNoCell),
      constant("kCellQuads", "contact/proximity/patches.wgsl", contact::kCellQuads),
      real("kUntanglePart", "state/contact.wgsl", kUntanglePart),
      real("kUntangleRate", "state/contact.wgsl", kUntangleRate),
      real("kContourGain", "contact/proximity/untangle.wgsl", kContourGain),
      real("kRimPart", "contact/proximity/untangle.wgsl", kRimPart),
      real("kLeastSlope", "contact/proximity/untangle.wgsl", kLeastSlope),
      real("kLeastOutward", "contact/proximity/untangle.wgsl", kLeastOutward),
      real("kOutwardPart", "contact/proximity/untangle.wgsl", kOutwardPart),
      real("kConeSlack", "contact/proximity/cones.wgsl", kConeSlack),
      constant("kHasInside", "contact/proximity/find_pairs.wgsl", kHasInside),
      constant("kIsJoined", "contact/proximity/find_pairs.wgsl", kIsJoined),
      real("kNoDistance", "contact/proximity/measure.wgsl", kNoDistance),
      real("kTouch", "contact/proximity/evaluate.wgsl", kTouch),
      real("kContactTouching", "state/contact.wgsl", kContactTouching),
      real("kHoldPart", "contact/proximity/press.wgsl", kHoldPart),
      real("kWholeWeight", "contact/proximity/press.wgsl", kWholeWeight),
      real("kHoldRate", "method/multigrid/hold_law.wgsl", kHoldRate),
      real("kHoldSpeed", "method/multigrid/hold_law.wgsl", kHoldSpeed),
      real("kAhead", "contact/proximity/contact_impulse.wgsl", kImpulseAhead),
      real("kHeavyAhead", "contact/proximity/contact_impulse.wgsl", kHeavyAhead),
      real("kPushPart", "state/contact.wgsl", kPushPart),
      real("kSoftLack", "state/contact.wgsl", kSoftLack),
      constant("kPressedOften", "state/contact.wgsl", kPressedOften),
      real("kPressedGap", "state/contact.wgsl", kPressedGap),
      real("kHeldLack", "state/contact.wgsl", kHeldLack),
      real("kStruckNear", "state/contact.wgsl", kStruckNear),
      real("kPushSpeed", "state/contact.wgsl", kPushSpeed),
      real("kPartingSteps", "contact/proximity/parting.wgsl", kPartingSteps),
      constant("kSumWords", "state/pair_holds.wgsl", kPairSumWords),
      constant("kHeader", "contact/proximity/kept_forces.wgsl", kHeader),
      constant("kKeptWords", "contact/proximity/kept_forces.wgsl", kKeptWords),
      real("kTouchingAtRest", "contact/proximity/find_pairs.wgsl", kTouchingAtRest),
      real("kMostSpare", "contact/proximity/measure.wgsl", kMostSpare),
      real("kContactMargin", "contact/proximity/planes.wgsl", kContactMargin),
      real("kContactFloor", "contact/proximity/planes.wgsl", kContactFloor),
      real("kTurningWay", "contact/proximity/turned_plane.wgsl", kTurningWay),
      constant("kPlaneRounds", "contact/proximity/before_solids.wgsl", kPlaneRounds),
      real("kBeyondPlane", "contact/proximity/before_solids.wgsl", kBeyondPlane),
      real("kStoppedPart", "contact/proximity/before_solids.wgsl", kStoppedPart),
      constant("kLeafTriangles", "contact/proximity/tree.wgsl", contact::kTreeLeafTriangles),
      constant("kTreeArity", "contact/proximity/tree.wgsl", contact::kTreeArity),
  });
  add_statistics(constants);
  return constants;
}

}  // namespace weft
