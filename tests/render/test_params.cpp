#include <doctest/doctest.h>

#include <string>

#include "gpu/shader_source.hpp"
#include "render/cloth_surface.hpp"
#include "render/floor.hpp"
#include "render/frame_params.hpp"

using namespace weft;
using namespace weft::render;

namespace {

/// The bytes of a WGSL struct whose members are vec4f, mat4x4f and arrays of vec4f, all aligned to 16.
std::size_t struct_size(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find("struct " + name + " {");
  REQUIRE(begin != std::string::npos);
  const std::string body = text.substr(begin, text.find('}', begin) - begin);
  std::size_t size = 0;
  for (std::size_t colon = body.find(" : "); colon != std::string::npos;
       colon = body.find(" : ", colon + 1)) {
    const std::string type = body.substr(colon + 3, body.find_first_of("\n/", colon) - colon - 3);
    if (type.rfind("vec4f", 0) == 0)
      size += 16;
    else if (type.rfind("mat4x4f", 0) == 0)
      size += 64;
    else if (type.rfind("array<vec4f, 9>", 0) == 0)
      size += 144;
    else
      FAIL("unknown type " << type);
  }
  return size;
}

}  // namespace

TEST_CASE("structs have the same size in C++ and in WGSL") {
  const auto frame = gpu::ShaderSource::load("render/frame.wgsl");
  const auto weave = gpu::ShaderSource::load("render/weave.wgsl");
  const auto floor = gpu::ShaderSource::load("render/floor.wgsl");
  REQUIRE(frame);
  REQUIRE(weave);
  REQUIRE(floor);
  CHECK(struct_size(frame->text, "Frame") == sizeof(FrameParams));
  CHECK(struct_size(weave->text, "Weave") == sizeof(WeaveParams));
  CHECK(struct_size(floor->text, "Plane") == sizeof(PlaneParams));
}

TEST_CASE("a floor's axes are unit, at right angles, and turn to its normal") {
  for (const Vec3d& normal : {Vec3d{0, 1, 0}, Vec3d{1, 0, 0}, Vec3d{0.3, 2, -0.4}, Vec3d{-1, 0.1, 0}}) {
    const PlaneParams plane = plane_params({{1, 2, 3}, normal}, {4, 5, 6}, 10, false);
    const Vec3d along = plane.along.xyz().to<double>(), across = plane.across.xyz().to<double>();
    const Vec3d unit = normal / length(normal);
    CHECK(length(cross(along, across) - unit) < 1e-6);
    CHECK(length(along) == doctest::Approx(1));
    CHECK(dot(plane.center.xyz().to<double>() - Vec3d{1, 2, 3}, unit) == doctest::Approx(0).epsilon(1e-6));
  }
}

TEST_CASE("cloths without a colour get different ones") {
  const ClothRange plain;
  CHECK_FALSE(weave_of(plain, 0).base == weave_of(plain, 1).base);
  ClothRange red;
  red.color = Vec3d{1, 0, 0};
  CHECK(weave_of(red, 0).base.x == doctest::Approx(1));
  CHECK(weave_of(red, 0).base.y == doctest::Approx(0));
}
