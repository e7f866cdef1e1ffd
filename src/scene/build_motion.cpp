#include "scene/build_motion.hpp"

#include "scene/checked_values.hpp"

namespace weft::scene {

Result<MotionShape> build_motion(const Json& json, const std::string& file, const std::string& path) {
  const std::string& kind = at(json, "kind").text;
  if (kind == "line")
    return MotionShape(MotionLine{unit(vector(json, "direction")), number(json, "speed"),
                                  maybe_number(json, "distance"), number(json, "start"),
                                  number(json, "ramp")});
  if (kind == "rotation")
    return MotionShape(MotionRotation{unit(vector(json, "axis")), vector(json, "center"),
                                      number(json, "speed"), maybe_number(json, "angle"),
                                      number(json, "start"), number(json, "ramp")});
  if (kind == "given") return MotionShape(MotionGiven{number(json, "speed")});
  MotionPath shape;
  for (const Json& point : at(json, "points").values) {
    const double time = point.values[0].number;
    if (!shape.points.empty() && time <= shape.points.back().time)
      return input_error("%s: %s[0] is %s s, not after the %s s of the point before it.", file.c_str(),
                         path_of_index(path + ".points", shape.points.size()).c_str(),
                         number_text(time).c_str(), number_text(shape.points.back().time).c_str());
    shape.points.push_back({time, vector(point.values[1])});
  }
  return MotionShape(std::move(shape));
}

}  // namespace weft::scene
