#include "scene/copies.hpp"

#include "scene/checked_values.hpp"
#include "scene/format.hpp"

namespace weft::scene {
namespace {

std::uint64_t value_count(const Json& json) {
  std::uint64_t count = 1;
  for (const Json& inner : json.values) count += value_count(inner);
  return count;
}

void shift_places(std::vector<Selector>& selectors, const Vec3d& shift) {
  for (Selector& selector : selectors) {
    if (auto* box = std::get_if<SelectorBox>(&selector.what)) {
      box->min = box->min + shift;
      box->max = box->max + shift;
    }
    if (auto* near = std::get_if<SelectorNear>(&selector.what)) near->point = near->point + shift;
  }
}

}  // namespace

Result<Copies> copies_of(const Json& json, const std::string& file, const std::string& path) {
  const Json* given = json.find("copies");
  if (!given) return Copies{};
  const Copies copies{whole(at(*given, "count")), vector(*given, "offset")};
  if (!at(json, "grabs").values.empty())
    return input_error("%s: %s has both \"copies\" and \"grabs\"; what is grabbed stands once.", file.c_str(),
                       path.c_str());
  if (json.find("seams"))
    return input_error("%s: %s has both \"copies\" and \"seams\"; what is sewn stands once.", file.c_str(),
                       path.c_str());
  const Vec3d last = transform_of(at(json, "transform")).translate + copies.offset * (copies.count - 1.0);
  for (int axis = 0; axis < 3; ++axis)
    if (last[axis] < -kMaxCoordinate || last[axis] > kMaxCoordinate)
      return input_error(
          "%s: %s.copies take the last copy's translate[%d] to %s; it must be from %s to %s m.", file.c_str(),
          path.c_str(), axis, number_text(last[axis]).c_str(), number_text(-kMaxCoordinate).c_str(),
          number_text(kMaxCoordinate).c_str());
  // Each copy has pins and paths of its own: a file that is small must not become a scene that is huge.
  const std::uint64_t values = copies.count * value_count(json);
  if (copies.count > 1 && values > kMaxJsonValues)
    return input_error("%s: %s.copies written out would be %llu values, more than the limit of %zu.",
                       file.c_str(), path.c_str(), static_cast<unsigned long long>(values), kMaxJsonValues);
  return copies;
}

Cloth shifted(Cloth cloth, const Vec3d& shift) {
  cloth.transform.translate = cloth.transform.translate + shift;
  shift_places(cloth.pins, shift);
  for (Attachment& attachment : cloth.attachments) shift_places(attachment.nodes, shift);
  for (Motion& motion : cloth.motions) {
    shift_places(motion.nodes, shift);
    if (auto* turn = std::get_if<MotionRotation>(&motion.shape)) turn->center = turn->center + shift;
  }
  return cloth;
}

}  // namespace weft::scene
