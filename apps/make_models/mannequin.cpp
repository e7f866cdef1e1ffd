#include "mannequin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <numbers>

#include "base/vec.hpp"
#include "mesh/glb_chunks.hpp"
#include "mesh/little_endian.hpp"

namespace weft::mesh {
namespace {

enum Joint : std::uint8_t {
  kHips,
  kSpine,
  kChest,
  kNeck,
  kHead,
  kLeftThigh,
  kLeftShin,
  kLeftFoot,
  kRightThigh,
  kRightShin,
  kRightFoot,
  kLeftArm,
  kLeftForearm,
  kLeftHand,
  kRightArm,
  kRightForearm,
  kRightHand,
  kJoints
};

struct Bone {
  const char* name;
  int parent;   // -1: none
  Vec3d place;  // at rest [m]
};

// Of the left side x > 0; the right is its mirror.
constexpr std::array<Bone, kJoints> kBones = {{{"hips", -1, {0, 0.96, 0}},
                                               {"spine", kHips, {0, 1.06, 0}},
                                               {"chest", kSpine, {0, 1.24, 0}},
                                               {"neck", kChest, {0, 1.45, -0.01}},
                                               {"head", kNeck, {0, 1.54, 0}},
                                               {"left_thigh", kHips, {0.1, 0.92, 0}},
                                               {"left_shin", kLeftThigh, {0.105, 0.5, 0.01}},
                                               {"left_foot", kLeftShin, {0.11, 0.09, -0.02}},
                                               {"right_thigh", kHips, {-0.1, 0.92, 0}},
                                               {"right_shin", kRightThigh, {-0.105, 0.5, 0.01}},
                                               {"right_foot", kRightShin, {-0.11, 0.09, -0.02}},
                                               {"left_arm", kChest, {0.19, 1.39, -0.01}},
                                               {"left_forearm", kLeftArm, {0.3, 1.14, -0.01}},
                                               {"left_hand", kLeftForearm, {0.39, 0.92, 0.01}},
                                               {"right_arm", kChest, {-0.19, 1.39, -0.01}},
                                               {"right_forearm", kRightArm, {-0.3, 1.14, -0.01}},
                                               {"right_hand", kRightForearm, {-0.39, 0.92, 0.01}}}};

/// A cone with round ends that a joint carries [m]; `flat` is its depth along z by its width.
struct Limb {
  Joint joint;
  Vec3d a, b;
  double radius_a, radius_b, flat;
};

std::vector<Limb> limbs() {
  std::vector<Limb> all = {{kHips, {-0.07, 0.96, -0.01}, {0.07, 0.96, -0.01}, 0.115, 0.115, 0.85},
                           {kSpine, {0, 1.02, 0}, {0, 1.18, 0}, 0.12, 0.125, 0.8},
                           {kChest, {0, 1.22, 0}, {0, 1.34, 0}, 0.14, 0.13, 0.75},
                           {kChest, {-0.13, 1.39, -0.01}, {0.13, 1.39, -0.01}, 0.065, 0.065, 0.9},
                           {kNeck, {0, 1.42, -0.01}, {0, 1.55, 0}, 0.055, 0.05, 1},
                           {kHead, {0, 1.59, 0.01}, {0, 1.63, 0.005}, 0.08, 0.09, 1.1}};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3d{side * x, y, z}; };
    const auto of = [&](Joint left, Joint right) { return side > 0 ? left : right; };
    all.push_back({of(kLeftThigh, kRightThigh), at(0.1, 0.9, 0), at(0.105, 0.5, 0.01), 0.088, 0.058, 1});
    all.push_back({of(kLeftShin, kRightShin), at(0.105, 0.5, 0.01), at(0.11, 0.1, -0.02), 0.058, 0.038, 1});
    all.push_back({of(kLeftFoot, kRightFoot), at(0.11, 0.05, -0.03), at(0.12, 0.035, 0.14), 0.042, 0.032, 1});
    all.push_back({of(kLeftArm, kRightArm), at(0.18, 1.38, -0.01), at(0.3, 1.14, -0.01), 0.052, 0.04, 1});
    all.push_back(
        {of(kLeftForearm, kRightForearm), at(0.3, 1.14, -0.01), at(0.39, 0.92, 0.01), 0.04, 0.03, 1});
    all.push_back({of(kLeftHand, kRightHand), at(0.4, 0.9, 0.01), at(0.44, 0.8, 0.02), 0.034, 0.026, 0.8});
  }
  return all;
}

/// How far a point is outside of a limb, about [m].
double distance_to(const Limb& limb, Vec3d p) {
  const Vec3d axis = limb.b - limb.a;
  p.z = limb.a.z + (p.z - limb.a.z) / limb.flat;
  const double t = std::clamp(dot(p - limb.a, axis) / dot(axis, axis), 0.0, 1.0);
  return length(p - limb.a - t * axis) - (limb.radius_a + t * (limb.radius_b - limb.radius_a));
}

/// The body: limbs that run into each other, over `kBlend` [m].
class Body {
 public:
  double operator()(const Vec3d& p) const {
    double sum = 1;
    for (const Limb& limb : limbs_) {
      const double d = distance_to(limb, p), h = std::max(kBlend - std::abs(d - sum), 0.0) / kBlend;
      sum = std::min(d, sum) - h * h * kBlend / 4;  // the polynomial smooth minimum (Quilez)
    }
    return sum;
  }
  Vec3d slope(const Vec3d& p) const {
    constexpr double kStep = 1e-4;
    const auto along = [&](const Vec3d& by) { return ((*this)(p + by) - (*this)(p - by)) / (2 * kStep); };
    return {along({kStep, 0, 0}), along({0, kStep, 0}), along({0, 0, kStep})};
  }
  const std::vector<Limb>& all() const { return limbs_; }

 private:
  static constexpr double kBlend = 0.035;
  std::vector<Limb> limbs_ = limbs();
};

constexpr double kCell = 0.018;  // [m]
constexpr Vec3d kLow{-0.55, -0.06, -0.26};
constexpr std::array<int, 3> kCells = {62, 105, 30};

/// The surface of the body by surface nets (Gibson 1998): a vertex a cell that it crosses, in the middle of its
/// crossings and then moved onto it; a quadrilateral an edge of the lattice that it crosses.
TriangleMesh surface_of(const Body& body) {
  const auto corner = [](int i, int j, int k) {
    return kLow + kCell * Vec3d{double(i), double(j), double(k)};
  };
  const auto number = [](int i, int j, int k) { return (k * (kCells[1] + 1) + j) * (kCells[0] + 1) + i; };
  std::vector<double> value(static_cast<std::size_t>(number(kCells[0], kCells[1], kCells[2]) + 1));
  for (int k = 0; k <= kCells[2]; ++k)
    for (int j = 0; j <= kCells[1]; ++j)
      for (int i = 0; i <= kCells[0]; ++i)
        value[static_cast<std::size_t>(number(i, j, k))] = body(corner(i, j, k));
  const auto at = [&](int i, int j, int k) { return value[static_cast<std::size_t>(number(i, j, k))]; };
  TriangleMesh mesh;
  std::map<int, std::uint32_t> vertex_of;
  for (int k = 0; k < kCells[2]; ++k)
    for (int j = 0; j < kCells[1]; ++j)
      for (int i = 0; i < kCells[0]; ++i) {
        Vec3d sum;
        int crossings = 0;
        for (int axis = 0; axis < 3; ++axis)
          for (int side = 0; side < 4; ++side) {
            std::array<int, 3> from = {i, j, k};
            from[static_cast<std::size_t>((axis + 1) % 3)] += side & 1;
            from[static_cast<std::size_t>((axis + 2) % 3)] += side >> 1;
            std::array<int, 3> to = from;
            ++to[static_cast<std::size_t>(axis)];
            const double a = at(from[0], from[1], from[2]), b = at(to[0], to[1], to[2]);
            if ((a < 0) == (b < 0)) continue;
            const Vec3d begin = corner(from[0], from[1], from[2]), end = corner(to[0], to[1], to[2]);
            sum += begin + a / (a - b) * (end - begin);
            ++crossings;
          }
        if (crossings == 0) continue;
        Vec3d place = 1.0 / crossings * sum;
        for (int round = 0; round < 4; ++round) {
          const Vec3d slope = body.slope(place);
          place -= body(place) / dot(slope, slope) * slope;
        }
        vertex_of[number(i, j, k)] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(place.to<float>());
      }
  for (int k = 1; k < kCells[2]; ++k)
    for (int j = 1; j < kCells[1]; ++j)
      for (int i = 1; i < kCells[0]; ++i)
        for (int axis = 0; axis < 3; ++axis) {
          std::array<int, 3> to = {i, j, k};
          ++to[static_cast<std::size_t>(axis)];
          const bool inside = at(i, j, k) < 0;
          if (inside == (at(to[0], to[1], to[2]) < 0)) continue;
          std::array<std::uint32_t, 4> quad{};  // the cells around the edge, turning about the axis
          for (std::size_t q = 0; q < 4; ++q) {
            std::array<int, 3> cell = {i, j, k};
            if (q == 0 || q == 3) --cell[static_cast<std::size_t>((axis + 1) % 3)];
            if (q < 2) --cell[static_cast<std::size_t>((axis + 2) % 3)];
            quad[q] = vertex_of.at(number(cell[0], cell[1], cell[2]));
          }
          if (!inside) std::swap(quad[1], quad[3]);
          const auto span = [&](std::size_t a, std::size_t b) {
            return length(mesh.positions[quad[a]] - mesh.positions[quad[b]]);
          };
          if (span(0, 2) <= span(1, 3)) {
            mesh.triangles.push_back({quad[0], quad[1], quad[2]});
            mesh.triangles.push_back({quad[0], quad[2], quad[3]});
          } else {
            mesh.triangles.push_back({quad[0], quad[1], quad[3]});
            mesh.triangles.push_back({quad[1], quad[2], quad[3]});
          }
        }
  return mesh;
}

struct Binding {
  std::array<std::uint8_t, 4> joints{};
  std::array<float, 4> weights{};
};

/// From 0 at one height to 1 at the other, without a kink.
double rising(double from, double to, double height) {
  const double part = std::clamp((height - from) / (to - from), 0.0, 1.0);
  return part * part * (3 - 2 * part);
}

/// The joints whose limbs are nearest, by the inverse sixth power of the distance; none of the other leg's or arm's.
/// The trunk is shared out by height alone: a belt around it keeps its length.
Binding binding_of(const Body& body, const Vec3d& p) {
  std::array<double, kJoints> weights{};
  for (const Limb& limb : body.all()) {
    const double side = limb.a.x + limb.b.x;
    if (side * p.x < 0 && std::abs(p.x) > 0.01) continue;
    const double d = 0.02 + std::max(0.0, distance_to(limb, p));
    weights[limb.joint] = std::max(weights[limb.joint], std::pow(0.02 / d, 6));
  }
  const double trunk = std::max({weights[kHips], weights[kSpine], weights[kChest]});
  const double above_hips = rising(1.06, 1.16, p.y), above_spine = rising(1.18, 1.3, p.y);
  weights[kHips] = trunk * (1 - above_hips);
  weights[kSpine] = trunk * (above_hips - above_spine);
  weights[kChest] = trunk * above_spine;
  Binding binding;
  double sum = 0;
  std::array<double, 4> best{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto most = std::max_element(weights.begin(), weights.end());
    binding.joints[k] = static_cast<std::uint8_t>(most - weights.begin());
    best[k] = *most;
    sum += *most;
    *most = 0;
  }
  for (std::size_t k = 0; k < 4; ++k) binding.weights[k] = static_cast<float>(best[k] / sum);
  return binding;
}

using Quaternion4 = std::array<double, 4>;

Quaternion4 about(const Vec3d& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {s * axis.x, s * axis.y, s * axis.z, std::cos(angle / 2)};
}

/// How a joint is turned at a phase of the walk [rad].
Quaternion4 walking(Joint joint, double phase) {
  constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0};
  const bool left = joint == kLeftThigh || joint == kLeftShin || joint == kLeftFoot || joint == kLeftArm ||
                    joint == kLeftForearm;
  const double own = left ? phase : phase + std::numbers::pi;
  switch (joint) {
    case kHips:
      return about(kY, -0.05 * std::sin(phase));
    case kSpine:
      return about(kY, 0.08 * std::sin(phase));
    case kChest:
      return about(kY, 0.06 * std::sin(phase));
    case kLeftThigh:
    case kRightThigh:
      return about(kX, -0.08 - 0.4 * std::sin(own));
    case kLeftShin:
    case kRightShin:
      return about(kX, 0.1 + 0.4 * (1 + std::cos(own + 0.3)));
    case kLeftFoot:
    case kRightFoot:
      return about(kX, -0.1 + 0.15 * std::sin(own));
    case kLeftArm:
    case kRightArm:
      return about(kX, 0.35 * std::sin(own));
    case kLeftForearm:
    case kRightForearm:
      return about(kX, -0.3 + 0.15 * std::sin(own));
    default:
      return {0, 0, 0, 1};
  }
}

/// Where the hips are at a phase of the walk [m]: down and up twice a cycle, to either side once; at rest at its start.
Vec3d hips_at(double phase) {
  return kBones[kHips].place + Vec3d{0.012 * std::sin(phase), 0.012 * (std::cos(2 * phase) - 1), 0};
}

/// The binary chunk of a GLB file, and the JSON of its views and accessors.
class Binary {
 public:
  template <class Component>
  std::size_t add(const std::vector<Component>& values, int component_type, const char* type,
                  std::size_t count, const std::string& more = "") {
    static_assert(sizeof(Component) == 1 || sizeof(Component) == 4);
    const std::size_t offset = bytes.size();
    for (const Component value : values) {
      if constexpr (sizeof(Component) == 1) {
        bytes.push_back(static_cast<std::byte>(value));
      } else {
        std::uint32_t word = 0;
        std::memcpy(&word, &value, sizeof word);
        append_little_endian(bytes, word);
      }
    }
    const auto text = [](std::size_t number) { return std::to_string(number); };
    views += (views.empty() ? "" : ",") + std::string(R"({"buffer":0,"byteOffset":)") + text(offset) +
             R"(,"byteLength":)" + text(bytes.size() - offset) + "}";
    accessors += (accessors.empty() ? "" : ",") + std::string(R"({"bufferView":)") + text(made_) +
                 R"(,"componentType":)" + std::to_string(component_type) + R"(,"count":)" + text(count) +
                 R"(,"type":")" + type + '"' + more + "}";
    return made_++;
  }
  std::vector<std::byte> bytes;
  std::string views, accessors;

 private:
  std::size_t made_ = 0;
};

constexpr int kByte = 5121, kInteger = 5125, kFloat = 5126;

std::string point(const Vec3d& p) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "[%.9g,%.9g,%.9g]", p.x, p.y, p.z);
  return text.data();
}

std::string list(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ",") + part;
  return "[" + text + "]";
}

/// The joints as nodes 1 on; node 0 has the mesh.
std::string nodes_text() {
  std::vector<std::string> nodes = {R"({"mesh":0,"skin":0})"};
  for (std::size_t j = 0; j < kBones.size(); ++j) {
    const Bone& bone = kBones[j];
    std::vector<std::string> children;
    for (std::size_t c = 0; c < kBones.size(); ++c)
      if (kBones[c].parent == static_cast<int>(j)) children.push_back(std::to_string(c + 1));
    const Vec3d from = bone.parent < 0 ? Vec3d{} : kBones[static_cast<std::size_t>(bone.parent)].place;
    nodes.push_back(R"({"name":")" + std::string(bone.name) + R"(","translation":)" +
                    point(bone.place - from) + (children.empty() ? "" : R"(,"children":)" + list(children)) +
                    "}");
  }
  return list(nodes);
}

std::string animation_text(Binary& binary, const char* name, double duration, bool walks) {
  constexpr std::size_t kKeys = 33;
  std::vector<float> times;
  for (std::size_t key = 0; key < kKeys; ++key)
    times.push_back(static_cast<float>(duration * static_cast<double>(key) / (kKeys - 1)));
  const std::size_t input = binary.add(times, kFloat, "SCALAR", kKeys,
                                       R"(,"min":[0],"max":[)" + std::to_string(times.back()) + "]");
  std::vector<std::string> samplers, channels;
  for (std::size_t j = 0; j < kBones.size(); ++j) {
    std::vector<float> rotations;
    for (std::size_t key = 0; key < kKeys; ++key) {
      const double phase = 2 * std::numbers::pi * static_cast<double>(key % (kKeys - 1)) / (kKeys - 1);
      const Quaternion4 q = walks ? walking(static_cast<Joint>(j), phase) : Quaternion4{0, 0, 0, 1};
      for (const double part : q) rotations.push_back(static_cast<float>(part));
    }
    const std::size_t output = binary.add(rotations, kFloat, "VEC4", kKeys);
    channels.push_back(R"({"sampler":)" + std::to_string(samplers.size()) + R"(,"target":{"node":)" +
                       std::to_string(j + 1) + R"(,"path":"rotation"}})");
    samplers.push_back(R"({"input":)" + std::to_string(input) + R"(,"output":)" + std::to_string(output) +
                       "}");
  }
  std::vector<float> hips;
  for (std::size_t key = 0; key < kKeys; ++key) {
    const double phase = 2 * std::numbers::pi * static_cast<double>(key % (kKeys - 1)) / (kKeys - 1);
    const Vec3d at = walks ? hips_at(phase) : kBones[kHips].place;
    for (int axis = 0; axis < 3; ++axis) hips.push_back(static_cast<float>(at[axis]));
  }
  const std::size_t output = binary.add(hips, kFloat, "VEC3", kKeys);
  channels.push_back(R"({"sampler":)" + std::to_string(samplers.size()) + R"(,"target":{"node":)" +
                     std::to_string(kHips + 1) + R"(,"path":"translation"}})");
  samplers.push_back(R"({"input":)" + std::to_string(input) + R"(,"output":)" + std::to_string(output) + "}");
  return R"({"name":")" + std::string(name) + R"(","channels":)" + list(channels) + R"(,"samplers":)" +
         list(samplers) + "}";
}

/// How far from the axis of the waist a direction meets the surface that lies `off` the body [m].
double waist_radius(const Body& body, double height, double angle, double off) {
  double low = 0, high = 0.5;
  for (int round = 0; round < 60; ++round) {
    const double middle = (low + high) / 2;
    (body({middle * std::sin(angle), height, middle * std::cos(angle)}) < off ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::vector<std::byte> make_mannequin(const std::string& generator) {
  const Body body;
  const TriangleMesh mesh = surface_of(body);
  const std::size_t count = mesh.positions.size();
  std::vector<float> positions, weights, matrices;
  std::vector<std::uint8_t> joints;
  std::vector<std::uint32_t> corners;
  for (const Vec3f& p : mesh.positions) {
    positions.insert(positions.end(), {p.x, p.y, p.z});
    const Binding binding = binding_of(body, p.to<double>());
    joints.insert(joints.end(), binding.joints.begin(), binding.joints.end());
    weights.insert(weights.end(), binding.weights.begin(), binding.weights.end());
  }
  for (const Triangle& triangle : mesh.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  for (const Bone& bone : kBones) {
    const Vec3f at = bone.place.to<float>();
    matrices.insert(matrices.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -at.x, -at.y, -at.z, 1});
  }
  Binary binary;
  const Bounds box = bounds(mesh);
  const std::string attributes =
      R"("POSITION":)" +
      std::to_string(binary.add(
          positions, kFloat, "VEC3", count,
          R"(,"min":)" + point(box.low.to<double>()) + R"(,"max":)" + point(box.high.to<double>()))) +
      R"(,"JOINTS_0":)" + std::to_string(binary.add(joints, kByte, "VEC4", count)) + R"(,"WEIGHTS_0":)" +
      std::to_string(binary.add(weights, kFloat, "VEC4", count));
  const std::string indices = std::to_string(binary.add(corners, kInteger, "SCALAR", corners.size()));
  const std::string bind = std::to_string(binary.add(matrices, kFloat, "MAT4", kBones.size()));
  std::vector<std::string> bones;
  for (std::size_t j = 0; j < kBones.size(); ++j) bones.push_back(std::to_string(j + 1));
  const std::string animations =
      list({animation_text(binary, "walk", 1.2, true), animation_text(binary, "stand", 1, false)});
  const std::string json = R"({"asset":{"version":"2.0","generator":")" + generator +
                           R"("},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":)" + nodes_text() +
                           R"(,"meshes":[{"primitives":[{"attributes":{)" + attributes + R"(},"indices":)" +
                           indices + R"(}]}],"skins":[{"inverseBindMatrices":)" + bind + R"(,"joints":)" +
                           list(bones) + R"(}],"animations":)" + animations + R"(,"accessors":[)" +
                           binary.accessors + R"(],"bufferViews":[)" + binary.views +
                           R"(],"buffers":[{"byteLength":)" + std::to_string(binary.bytes.size()) + "}]}";
  while (binary.bytes.size() % 4 != 0) binary.bytes.push_back(std::byte{0});
  std::vector<std::byte> file = glb_before_binary(json, binary.bytes.size());
  file.insert(file.end(), binary.bytes.begin(), binary.bytes.end());
  return file;
}

TriangleMesh make_skirt() {
  constexpr std::uint32_t kAround = 72, kRings = 28;
  constexpr double kWaist = 1.03, kHem = 0.45, kWide = 0.36;  // heights, and the radius of the hem [m]
  const Body body;
  TriangleMesh mesh;
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    const double part = static_cast<double>(ring) / (kRings - 1);
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double angle = 2 * std::numbers::pi * (i + (ring % 2) / 2.0) / kAround;
      const double waist = waist_radius(body, kWaist, angle, 0.012);
      // It clears the hips, which are wider than the waist, and opens evenly below.
      const double radius = waist + (kWide - waist) * std::sqrt(part);
      mesh.positions.push_back(
          Vec3d{radius * std::sin(angle), kWaist + part * (kHem - kWaist), radius * std::cos(angle)}
              .to<float>());
    }
  }
  for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring)
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t next = (i + 1) % kAround, above = ring * kAround, below = above + kAround;
      if (ring % 2 == 0) {
        mesh.triangles.push_back({above + i, below + i, above + next});
        mesh.triangles.push_back({below + i, below + next, above + next});
      } else {
        mesh.triangles.push_back({above + i, below + next, above + next});
        mesh.triangles.push_back({above + i, below + i, below + next});
      }
    }
  return mesh;
}

}  // namespace weft::mesh
