#include <doctest/doctest.h>

#include "gpu/shader_source.hpp"

using namespace weft;
using namespace weft::gpu;

TEST_CASE("bindings are read from the text, by kind and name and in order") {
  const auto bindings = parse_bindings(
      "//\n// one a step: StepBlock\n//\n"
      "@group(0) @binding(1) var<storage, read> position : array<vec4f>;  // node_count\n"
      "@group(0) @binding(0) var<uniform>       step     : StepBlock;\n"
      "@group(0) @binding(2) var<storage, read_write> force : array<atomic<i32>>;\n"
      "@group(0) @binding(3) var<uniform> grid : GridParams;\n"
      "@group(0) @binding(4) var shadow : texture_depth_2d;\n"
      "@group(0) @binding(5) var compare : sampler_comparison;\n"
      "@group(0) @binding(6) var<uniform> steps : array<StepBlock, 2>;\n");
  REQUIRE_MESSAGE(bindings, bindings.error().message);
  REQUIRE(bindings->size() == 7);
  CHECK((*bindings)[0].name == "step");
  CHECK((*bindings)[0].kind == BindingKind::StepUniform);
  CHECK((*bindings)[1].kind == BindingKind::StorageRead);
  CHECK((*bindings)[2].name == "force");
  CHECK((*bindings)[2].kind == BindingKind::StorageReadWrite);
  CHECK((*bindings)[3].kind == BindingKind::Uniform);
  CHECK((*bindings)[4].kind == BindingKind::DepthTexture);
  CHECK((*bindings)[5].kind == BindingKind::ComparisonSampler);
  CHECK((*bindings)[6].kind == BindingKind::StepUniform);
  CHECK((*bindings)[0].steps == 1);
  CHECK((*bindings)[6].steps == 2);
}

TEST_CASE("a uniform is one block a step only where the text says so of its type") {
  const std::string binding = "@group(0) @binding(0) var<uniform> step : StepBlock;\n";
  for (const char* mark : {"", "\n// one a step: Step\n", "\n// one a step: StepBlocks\n"}) {
    const auto bindings = parse_bindings(mark + binding);
    REQUIRE(bindings);
    CHECK((*bindings)[0].kind == BindingKind::Uniform);
  }
}

TEST_CASE("a gap in the binding numbers and an unknown type are errors") {
  CHECK_FALSE(parse_bindings("@group(0) @binding(1) var<uniform> a : A;\n"));
  CHECK_FALSE(parse_bindings("@group(0) @binding(0) var a : texture_cube<f32>;\n"));
}

TEST_CASE("an include is put in once, and the embedded shaders are complete") {
  const auto source = ShaderSource::load("gpu/test/double.wgsl");
  REQUIRE(source);
  CHECK(source->text.find("#include") == std::string::npos);
  CHECK(source->text.find("fn flat_index") == source->text.rfind("fn flat_index"));
  for (const EmbeddedShader& shader : embedded_shaders())
    CHECK_MESSAGE(ShaderSource::load(shader.path), shader.path);
}
