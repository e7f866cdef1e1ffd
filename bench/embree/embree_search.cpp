#include "embree_search.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace weft {
namespace {

/// The rule of src/contact/proximity/find_candidates.wgsl, in its arithmetic.
bool lie_flat(const std::vector<Vec3f>& positions, const mesh::Triangle& x, const mesh::Triangle& y) {
  Vec3f middle;
  int shared = 0;
  for (const std::uint32_t v : x) {
    if (std::find(y.begin(), y.end(), v) == y.end()) continue;
    ++shared;
    middle += positions[v];
  }
  if (shared != 2) return false;
  middle = 0.5F * middle;
  const auto from_middle = [&](const mesh::Triangle& t) {
    return (positions[t[0]] + positions[t[1]] + positions[t[2]]) - 2.0F * middle - middle;
  };
  const Vec3f u = from_middle(x), v = from_middle(y);
  const float along = dot(u, v);
  return along < 0 && along * along > 0.0625F * dot(u, u) * dot(v, v);
}

}  // namespace

EmbreeSearch::EmbreeSearch(RTCDevice device, const SearchCase& search,
                           const std::vector<std::uint32_t>& order, Update update, std::size_t room)
    : search_(search), found_(room) {
  for (const std::uint32_t t : order) sheet_.push_back(search.model.triangles[t]);
  sheet_scene_ = make_scene(device, sheet_.size(), bounds_of_sheet, update);
  if (!search.self())  // an object keeps its shape, so its tree is the best that Embree builds
    object_scene_ = make_scene(device, search.object.triangles.size(), bounds_of_object, Update::Build);
}

EmbreeSearch::~EmbreeSearch() {
  rtcReleaseScene(sheet_scene_);
  if (object_scene_ != nullptr) rtcReleaseScene(object_scene_);
}

RTCScene EmbreeSearch::make_scene(RTCDevice device, std::size_t count, RTCBoundsFunction bounds,
                                  Update update) {
  RTCScene scene = rtcNewScene(device);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned int>(count));
  rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
  rtcSetGeometryUserData(geometry, this);
  if (update == Update::Refit) {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
  } else {
    rtcSetSceneBuildQuality(scene,
                            update == Update::Build ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_LOW);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, 0);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

void EmbreeSearch::update() {
  RTCGeometry geometry = rtcGetGeometry(sheet_scene_, 0);
  rtcCommitGeometry(geometry);
  rtcCommitScene(sheet_scene_);
}

void EmbreeSearch::collide() {
  found_count_ = 0;
  rtcCollide(sheet_scene_, search_.self() ? sheet_scene_ : object_scene_, take, this);
  if (found_count_ > found_.size()) {
    std::fprintf(stderr, "weft: there is no room for %zu pairs.\n", found_count_.load());
    std::exit(1);
  }
}

std::vector<PairKey> EmbreeSearch::pairs() const {
  std::vector<PairKey> keys(found_.begin(),
                            found_.begin() + static_cast<std::ptrdiff_t>(found_count_.load()));
  std::sort(keys.begin(), keys.end());
  return keys;
}

EmbreeSearch::Box EmbreeSearch::box_of(const std::vector<Vec3f>& positions, const mesh::Triangle& t) const {
  const Vec3f &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
  return {min(min(a, b), c), max(max(a, b), c)};
}

/// Boxes of the sheet are grown by the radius towards an object, by half of it towards each other; a little
/// more, so that rounding loses no pair.
void EmbreeSearch::bounds_of_sheet(const RTCBoundsFunctionArguments* arguments) {
  const auto& own = *static_cast<const EmbreeSearch*>(arguments->geometryUserPtr);
  const Box box = own.box_of(own.search_.positions, own.sheet_[arguments->primID]);
  const float radius = own.search_.own_radius() + own.search_.other_radius();
  const float by = own.search_.self() ? 0.50001F * radius : radius;
  *arguments->bounds_o = {box.low.x - by,  box.low.y - by,  box.low.z - by,  0,
                          box.high.x + by, box.high.y + by, box.high.z + by, 0};
}

void EmbreeSearch::bounds_of_object(const RTCBoundsFunctionArguments* arguments) {
  const auto& own = *static_cast<const EmbreeSearch*>(arguments->geometryUserPtr);
  const mesh::TriangleMesh& object = own.search_.object;
  const Box box = own.box_of(object.positions, object.triangles[arguments->primID]);
  *arguments->bounds_o = {box.low.x, box.low.y, box.low.z, 0, box.high.x, box.high.y, box.high.z, 0};
}

bool EmbreeSearch::is_pair(std::uint32_t own, std::uint32_t other) const {
  const bool self = search_.self();
  const std::vector<Vec3f>& positions = self ? search_.positions : search_.object.positions;
  const mesh::Triangle& triangle = self ? sheet_[other] : search_.object.triangles[other];
  const Box a = box_of(search_.positions, sheet_[own]), b = box_of(positions, triangle);
  const float own_radius = search_.own_radius(), other_radius = search_.other_radius();
  for (int axis = 0; axis < 3; ++axis)
    if (!(a.low[axis] - own_radius <= b.high[axis] + other_radius &&
          b.low[axis] - other_radius <= a.high[axis] + own_radius))
      return false;
  return !self || !lie_flat(positions, sheet_[own], triangle);
}

/// Called by several threads at once. Embree gives leaves whose boxes overlap, of one scene each pair both
/// ways.
void EmbreeSearch::take(void* user, RTCCollision* collisions, unsigned int count) {
  auto& own = *static_cast<EmbreeSearch*>(user);
  std::array<PairKey, 64> keys;
  std::size_t kept = 0;
  const auto flush = [&] {
    const std::size_t first = own.found_count_.fetch_add(kept);
    if (first + kept <= own.found_.size())
      std::copy_n(keys.begin(), kept, own.found_.begin() + static_cast<std::ptrdiff_t>(first));
    kept = 0;
  };
  for (unsigned int k = 0; k < count; ++k) {
    const std::uint32_t a = collisions[k].primID0, b = collisions[k].primID1;
    if (own.search_.self() && a >= b) continue;
    if (!own.is_pair(a, b)) continue;
    keys[kept++] = pair_key(a, b);
    if (kept == keys.size()) flush();
  }
  if (kept > 0) flush();
}

}  // namespace weft
