#include "mesh/gltf_animation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/trig.hpp"
#include "mesh/gltf_accessor.hpp"
#include "mesh/gltf_values.hpp"

namespace weft::mesh {
namespace {

using Path = GltfChannel::Path;
using Interpolation = GltfChannel::Interpolation;

constexpr std::array<const char*, 3> kPaths = {"translation", "rotation", "scale"};
constexpr std::array<const char*, 3> kInterpolations = {"LINEAR", "STEP", "CUBICSPLINE"};

std::size_t components_of(Path path) { return path == Path::Rotation ? 4 : 3; }

/// Its place in a list of words, which has it.
template <class Words>
Result<std::size_t> word_of(const Json& object, const std::string& path, const char* key, const Words& words,
                            std::size_t otherwise) {
  const Json* value = object.find(key);
  if (value == nullptr) return otherwise;
  for (std::size_t w = 0; w < words.size(); ++w)
    if (value->kind == Json::Kind::Text && value->text == words[w]) return w;
  return input_error("%s is %s; it must be \"%s\", \"%s\" or \"%s\".", path_of_key(path, key).c_str(),
                     describe(*value).c_str(), words[0], words[1], words[2]);
}

double norm(const double* q) { return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]); }

/// Of length 1; what has no length is `otherwise`.
std::vector<double> unit(std::vector<double> q, const double* otherwise) {
  const double size = norm(q.data());
  if (!(size > 0)) return {otherwise, otherwise + 4};
  for (double& part : q) part /= size;
  return q;
}

/// The angle between two unit quaternions less than a right angle apart, from their distance, which is twice the sine
/// of its half: by Newton's method, with the same bits on every host.
double angle_between(const double* from, const double* to, double sign) {
  double square = 0;
  for (int k = 0; k < 4; ++k) square += (sign * to[k] - from[k]) * (sign * to[k] - from[k]);
  const double sine = std::sqrt(square) / 2;
  double half = sine;
  for (int round = 0; round < 5; ++round) {
    const Turn now = turn_of(half);
    half -= (now.sine - sine) / now.cosine;
  }
  return 2 * half;
}

/// Along the great circle, the shorter way round.
std::vector<double> turned(const double* from, const double* to, double part) {
  double cosine = 0;
  for (int k = 0; k < 4; ++k) cosine += from[k] * to[k];
  const double sign = cosine < 0 ? -1 : 1, angle = angle_between(from, to, sign);
  double a = 1 - part, b = part;  // over a small angle the circle is straight
  if (angle > 1e-6) {
    const double scale = 1 / turn_of(angle).sine;
    a = scale * turn_of((1 - part) * angle).sine;
    b = scale * turn_of(part * angle).sine;
  }
  std::vector<double> q(4);
  for (std::size_t k = 0; k < 4; ++k) q[k] = a * from[k] + sign * b * to[k];
  return unit(std::move(q), from);
}

/// Reads animations, each sampler once, within a bound on their numbers.
class Reader {
 public:
  Reader(const GlbChunks& glb, const std::vector<SceneNode>& nodes, std::uint64_t limit)
      : glb_(glb), limit_(limit) {
    for (std::size_t n = 0; n < nodes.size(); ++n) places_[nodes[n].number] = n;
    for (const SceneNode& node : nodes) has_matrix_.push_back(node.matrix.has_value());
  }

  Result<GltfAnimation> read(const Json& animation, const std::string& path) {
    if (animation.kind != Json::Kind::Object)
      return input_error("%s is %s; it must be an object.", path.c_str(), describe(animation).c_str());
    GltfAnimation made;
    if (const Json* name = animation.find("name"); name != nullptr && name->kind == Json::Kind::Text)
      made.name = name->text;
    WEFT_TRY(channels, entries(animation, path, "channels"));
    for (std::size_t c = 0; c < channels->size(); ++c)
      WEFT_CHECK(add_channel((*channels)[c], path_of_index(path + ".channels", c), animation, path, made));
    return made;
  }

 private:
  Result<void> add_channel(const Json& channel, const std::string& path, const Json& animation,
                           const std::string& of, GltfAnimation& made) {
    const Json* target = channel.kind == Json::Kind::Object ? channel.find("target") : nullptr;
    if (target == nullptr || target->kind != Json::Kind::Object)
      return input_error("%s.target is missing; it must be an object.", path.c_str());
    if (target->find("node") == nullptr) return {};
    if (const Json* word = target->find("path"); word != nullptr && word->text == "weights") return {};
    WEFT_TRY(number, whole_number(*target, path + ".target", "node", kMostIndex));
    const auto place = places_.find(number);
    if (place == places_.end()) return {};
    if (target->find("path") == nullptr) return input_error("%s.target.path is missing.", path.c_str());
    WEFT_TRY(part, word_of(*target, path + ".target", "path", kPaths, 0));
    if (has_matrix_[place->second])
      return input_error("%s.target moves nodes[%llu], which has a matrix.", path.c_str(),
                         static_cast<unsigned long long>(number));
    GltfChannel one;
    one.node = place->second;
    one.path = static_cast<Path>(part);
    WEFT_TRY(sampler, whole_number(channel, path, "sampler", kMostIndex));
    WEFT_CHECK(sample(sampler, animation, of, one));
    made.duration = std::max(made.duration, one.times.back());
    made.channels.push_back(std::move(one));
    return {};
  }

  Result<void> sample(std::uint64_t number, const Json& animation, const std::string& of, GltfChannel& into) {
    WEFT_TRY(samplers, entries(animation, of, "samplers"));
    const std::string path = path_of_index(of + ".samplers", static_cast<std::size_t>(number));
    if (number >= samplers->size() ||
        (*samplers)[static_cast<std::size_t>(number)].kind != Json::Kind::Object)
      return input_error("%s is none of the %zu samplers.", path.c_str(), samplers->size());
    const Json& sampler = (*samplers)[static_cast<std::size_t>(number)];
    WEFT_TRY(word, word_of(sampler, path, "interpolation", kInterpolations, 0));
    into.interpolation = static_cast<Interpolation>(word);
    WEFT_TRY(input, whole_number(sampler, path, "input", kMostIndex));
    WEFT_TRY(output, whole_number(sampler, path, "output", kMostIndex));
    WEFT_TRY(times, GltfAccessor::find(glb_, input, path + ".input", GltfKind::Times));
    WEFT_TRY(values,
             GltfAccessor::find(glb_, output, path + ".output",
                                into.path == Path::Rotation ? GltfKind::Rotations : GltfKind::Vectors));
    const std::uint64_t each = into.interpolation == Interpolation::CubicSpline ? 3 : 1;
    if (times.count() == 0 || values.count() != each * times.count())
      return input_error(
          "%s has %llu times and %llu values; it must have one at least, and %llu values for each.",
          path.c_str(), static_cast<unsigned long long>(times.count()),
          static_cast<unsigned long long>(values.count()), static_cast<unsigned long long>(each));
    const std::size_t components = components_of(into.path);
    taken_ += sizeof(double) * (times.count() + components * values.count());
    if (taken_ > limit_)
      return input_error("The animations repeat their data until they take over %llu bytes, the limit.",
                         static_cast<unsigned long long>(limit_));
    WEFT_CHECK(read_times(times, path, into));
    return read_values(values, path, components, into);
  }

  static Result<void> read_times(const GltfAccessor& times, const std::string& path, GltfChannel& into) {
    for (std::uint64_t i = 0; i < times.count(); ++i) {
      const double time = times.value(i, 0), before = into.times.empty() ? -1 : into.times.back();
      if (!(time >= 0 && time < 1e6 && time > before))
        return input_error(
            "%s.input: time %llu is %g s, after %g; times must rise from 0 on, to 1e6 s at most.",
            path.c_str(), static_cast<unsigned long long>(i), time, before);
      into.times.push_back(time);
    }
    return {};
  }

  static Result<void> read_values(const GltfAccessor& values, const std::string& path, std::size_t components,
                                  GltfChannel& into) {
    for (std::uint64_t i = 0; i < values.count(); ++i)
      for (std::size_t k = 0; k < components; ++k) {
        const double value = values.value(i, static_cast<std::uint32_t>(k));
        if (!std::isfinite(value))
          return input_error("%s.output: number %zu of value %llu is not finite.", path.c_str(), k,
                             static_cast<unsigned long long>(i));
        into.values.push_back(value);
      }
    if (into.path != Path::Rotation) return {};
    const std::size_t stride = into.interpolation == Interpolation::CubicSpline ? 12 : 4;
    for (std::size_t at = stride == 12 ? 4 : 0; at < into.values.size(); at += stride) {
      const double size = norm(&into.values[at]);
      if (!(size > 0))
        return input_error("%s.output: rotation %zu is 0; it must be a quaternion of length 1.", path.c_str(),
                           at / stride);
      if (stride == 4)
        for (std::size_t k = 0; k < 4; ++k) into.values[at + k] /= size;
    }
    return {};
  }

  const GlbChunks& glb_;
  std::uint64_t limit_, taken_ = 0;              // bytes
  std::map<std::uint64_t, std::size_t> places_;  // of nodes, by their number
  std::vector<bool> has_matrix_;
};

}  // namespace

std::vector<double> GltfChannel::at(double time) const {
  const std::size_t n = components_of(path);
  const std::size_t stride = interpolation == Interpolation::CubicSpline ? 3 * n : n;
  const std::size_t middle =
      interpolation == Interpolation::CubicSpline ? n : 0;  // of a spline's three values
  const auto value = [&](std::size_t key) { return values.data() + stride * key + middle; };
  const auto next =
      static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  const std::size_t key = next == 0 ? 0 : next - 1;
  std::vector<double> found(value(key), value(key) + n);
  if (next == 0 || next == times.size() || interpolation == Interpolation::Step)
    return path == Path::Rotation ? unit(std::move(found), value(key)) : found;
  const double span = times[next] - times[key], s = (time - times[key]) / span;
  if (interpolation == Interpolation::CubicSpline) {  // glTF 2.0, appendix C.3
    const double *slope = value(key) + n, *slope_next = value(next) - n;
    const double s2 = s * s, s3 = s2 * s;
    for (std::size_t k = 0; k < n; ++k)
      found[k] = (2 * s3 - 3 * s2 + 1) * value(key)[k] + span * (s3 - 2 * s2 + s) * slope[k] +
                 (3 * s2 - 2 * s3) * value(next)[k] + span * (s3 - s2) * slope_next[k];
    return path == Path::Rotation ? unit(std::move(found), value(key)) : found;
  }
  if (path == Path::Rotation) return turned(value(key), value(next), s);
  for (std::size_t k = 0; k < n; ++k) found[k] += s * (value(next)[k] - found[k]);
  return found;
}

void GltfAnimation::move(double time, std::vector<NodeParts>& parts) const {
  for (const GltfChannel& channel : channels) {
    NodeParts& node = parts[channel.node];
    std::vector<double>& part = channel.path == Path::Translation ? node.translation
                                : channel.path == Path::Rotation  ? node.rotation
                                                                  : node.scale;
    part = channel.at(time);
  }
}

Result<std::vector<GltfAnimation>> gltf_animations(const GlbChunks& glb, const std::vector<SceneNode>& nodes,
                                                   std::uint64_t limit) {
  WEFT_TRY(list, entries(glb.json, "", "animations"));
  std::vector<GltfAnimation> all;
  Reader reader(glb, nodes, limit);
  for (std::size_t a = 0; a < list->size(); ++a) {
    WEFT_TRY(animation, reader.read((*list)[a], path_of_index("animations", a)));
    all.push_back(std::move(animation));
  }
  return all;
}

}  // namespace weft::mesh
