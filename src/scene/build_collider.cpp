#include "scene/build_collider.hpp"

#include "scene/build_motion.hpp"
#include "scene/checked_values.hpp"
#include "scene/names.hpp"

namespace weft::scene {
namespace {

Result<std::vector<ColliderKeyframe>> build_keyframes(const Json& json, const std::string& file,
                                                      const std::string& path) {
  std::vector<ColliderKeyframe> keyframes;
  for (const Json& one : json.values) {
    const double time = number(one, "time");
    if (!keyframes.empty() && time <= keyframes.back().time)
      return input_error("%s: %s.time is %s s, not after the %s s of the keyframe before it.", file.c_str(),
                         path_of_index(path, keyframes.size()).c_str(), number_text(time).c_str(),
                         number_text(keyframes.back().time).c_str());
    keyframes.push_back({time, text(one, "mesh")});
  }
  return keyframes;
}

/// Features of method proximity alone: the older ones know only still objects with an inside. Method none meets
/// nothing, and draws all.
Result<void> check_method(const Json& json, ContactMethod method, const std::string& file,
                          const std::string& path) {
  if (method == ContactMethod::None || method == ContactMethod::Proximity) return {};
  const auto refused = [&](const char* what) {
    return input_error("%s: %s%s needs contact.method \"proximity\"; it is \"%s\".", file.c_str(),
                       path.c_str(), what, name_of(method));
  };
  if (at(json, "kind").text == "capsule") return refused(", a capsule,");
  if (json.find("motion")) return refused(".motion");
  const Json* keyframes = json.find("keyframes");
  if (keyframes && !keyframes->values.empty()) return refused(".keyframes");
  if (json.find("animation")) return refused(".animation");
  return {};
}

Result<std::optional<Rigid>> build_rigid(const Json& json, ContactMethod method, const std::string& file,
                                         const std::string& path) {
  const Json* given = json.find("rigid");
  if (given == nullptr) return std::optional<Rigid>{};
  const std::string& kind = at(json, "kind").text;
  if (kind == "mesh" || kind == "plane")
    return input_error(
        "%s: %s.rigid is of a %s; spheres, boxes, capsules and convex hulls can be rigid bodies.",
        file.c_str(), path.c_str(), kind.c_str());
  if (json.find("motion"))
    return input_error("%s: %s has a motion and is rigid; it moves by one of them.", file.c_str(),
                       path.c_str());
  if (method != ContactMethod::Proximity)
    return input_error("%s: %s.rigid needs contact.method \"proximity\"; it is \"%s\".", file.c_str(),
                       path.c_str(), name_of(method));
  return std::optional<Rigid>(Rigid{maybe_number(*given, "density"), maybe_number(*given, "mass"),
                                    vector(*given, "velocity"), vector(*given, "spin")});
}

std::optional<ColliderAnimation> build_animation(const Json& json) {
  const Json* given = json.find("animation");
  if (given == nullptr) return {};
  return ColliderAnimation{text(*given, "name"), number(*given, "start"), number(*given, "speed"),
                           at(*given, "loop").boolean, number(*given, "rate")};
}

Result<Collider> build_shape(const Json& json, ContactMethod method, const std::string& file,
                             const std::string& path) {
  WEFT_CHECK(check_method(json, method, file, path));
  const std::optional<double> friction = maybe_number(json, "friction");
  std::optional<ColliderMotion> motion;
  if (const Json* given = json.find("motion")) {
    WEFT_TRY(built, build_motion(*given, file, path + ".motion"));
    motion = std::move(built);
    // Nodes go each by itself, a collider as a whole.
    if (const auto* moved = std::get_if<MotionGiven>(&*motion)) motion = MotionCarried{moved->speed, {}};
  }
  WEFT_TRY(rigid, build_rigid(json, method, file, path));
  const std::string& kind = at(json, "kind").text;
  if (kind == "mesh") {
    WEFT_TRY(keyframes, build_keyframes(at(json, "keyframes"), file, path + ".keyframes"));
    std::optional<ColliderAnimation> animation = build_animation(json);
    if (animation && !keyframes.empty())
      return input_error("%s: %s has keyframes and an animation; it deforms by one of them.", file.c_str(),
                         path.c_str());
    return Collider(ColliderMesh{file + ": " + path, text(json, "mesh"), transform_of(at(json, "transform")),
                                 std::move(keyframes), std::move(animation), friction, std::move(motion)});
  }
  if (kind == "sphere")
    return Collider(
        ColliderSphere{vector(json, "center"), number(json, "radius"), friction, std::move(motion), rigid});
  if (kind == "plane")
    return Collider(
        ColliderPlane{vector(json, "point"), unit(vector(json, "normal")), friction, std::move(motion)});
  if (kind == "box")
    return Collider(ColliderBox{vector(json, "center"), vector(json, "size"),
                                unit_quaternion(at(json, "rotate")), friction, std::move(motion), rigid});
  if (kind == "convex") {
    ColliderConvex convex{file + ": " + path, text(json, "mesh"), {},   transform_of(at(json, "transform")),
                          friction,           std::move(motion),  rigid};
    if (const Json* points = json.find("points"))
      for (const Json& point : points->values) convex.points.push_back(vector(point));
    return Collider(std::move(convex));
  }
  const Vec3d a = vector(json, "a"), b = vector(json, "b");
  if (a == b)
    return input_error("%s: %s.b is its a; a capsule without a length is a sphere.", file.c_str(),
                       path.c_str());
  return Collider(ColliderCapsule{a, b, number(json, "radius"), friction, std::move(motion), rigid});
}

}  // namespace

Result<Collider> build_collider(const Json& json, ContactMethod method, const std::string& file,
                                const std::string& path) {
  WEFT_TRY(built, build_shape(json, method, file, path));
  std::visit([&](auto& one) { one.material = word<Material>(at(json, "material"), kMaterialNames); }, built);
  return built;
}

}  // namespace weft::scene
