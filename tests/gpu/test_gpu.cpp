#include <numeric>

#include "base/vec.hpp"

#include "gpu/gpu_fixture.hpp"
#include "gpu/kernel.hpp"
#include "gpu/readback.hpp"
#include "gpu/render_pipeline.hpp"
#include "gpu/timer.hpp"

using namespace weft;
using namespace weft::gpu;

TEST_CASE("a kernel sees what was written and its result comes back, for any size and workgroup") {
  GpuFixture fixture;
  Device& device = fixture.device();
  for (const std::uint32_t workgroup : {64U, 128U, 256U}) {
    auto kernel = Kernel::create(device, "gpu/test/double.wgsl", {}, workgroup);
    REQUIRE_MESSAGE(kernel, kernel.error().message);
    for (const std::size_t count : {1UL, 63UL, 257UL, 100000UL}) {
      std::vector<std::uint32_t> values(count);
      std::iota(values.begin(), values.end(), 1U);
      auto buffer = Buffer<std::uint32_t>::create_from(device, values, "values");
      REQUIRE(buffer);
      auto group = kernel->bind({*buffer});
      REQUIRE_MESSAGE(group, group.error().message);
      CommandList list;
      {
        ComputePass pass(list, "double");
        kernel->dispatch(pass, *group, count);
      }
      REQUIRE(device.submit(list));
      REQUIRE(device.submit(list));  // a list can be replayed
      auto result = download(device, *buffer);
      REQUIRE(result);
      for (std::size_t i = 0; i < count; ++i) values[i] *= 4;
      CHECK(*result == values);
    }
  }
}

TEST_CASE("a kernel is compiled once for all who ask for the same text, constants and workgroup") {
  GpuFixture fixture{OwnDevice{}};
  Device& device = fixture.device();
  for (const std::uint32_t workgroup : {64U, 128U, 64U, 128U})
    CHECK(Kernel::create(device, "gpu/test/double.wgsl", {}, workgroup));
  CHECK(device.kernels().size() == 2);
  CHECK_FALSE(Kernel::create(device, "gpu/test/double.wgsl", {{"kNoSuchConstant", 1}}));
  CHECK(device.kernels().size() == 2);
}

TEST_CASE("a render pipeline is compiled once for all who ask for the same shaders, formats and constants") {
  GpuFixture fixture{OwnDevice{}};
  Device& device = fixture.device();
  RenderPipelineInfo info;
  info.color = TextureFormat::Rgba8Unorm;
  const auto make = [&] { return RenderPipeline::create(device, "overlay/overlay.wgsl", info); };
  const auto first = make(), second = make();
  REQUIRE(first);
  REQUIRE(second);
  CHECK(first->id() == second->id());
  info.blend = true;
  const auto blended = make();
  REQUIRE(blended);
  CHECK(blended->id() != first->id());
  CHECK(device.render_pipelines().size() == 2);
}

TEST_CASE("of too many kernels the one goes that was asked for the longest ago") {
  KernelCache kernels;
  for (std::size_t i = 0; i < KernelCache::kMost; ++i)
    kernels[std::to_string(i)] = std::make_shared<const CompiledPipeline>();
  CHECK(kernels.find("0") != nullptr);
  kernels["new"] = std::make_shared<const CompiledPipeline>();
  CHECK(kernels.size() == KernelCache::kMost);
  CHECK(kernels.find("0") != nullptr);
  CHECK(kernels.find("1") == nullptr);
}

TEST_CASE("past 65,535 workgroups a dispatch gets rows and still touches each element once") {
  GpuFixture fixture;
  Device& device = fixture.device();
  const std::size_t count = 64UL * 65535 + 12345;
  auto kernel = Kernel::create(device, "gpu/test/double.wgsl", {}, 64);
  REQUIRE(kernel);
  const std::vector<std::uint32_t> values(count, 1);
  auto buffer = Buffer<std::uint32_t>::create_from(device, values, "values");
  REQUIRE(buffer);
  auto group = kernel->bind({*buffer});
  REQUIRE(group);
  CommandList list;
  {
    ComputePass pass(list, "double");
    kernel->dispatch(pass, *group, count);
  }
  REQUIRE(device.submit(list));
  auto result = download(device, *buffer);
  REQUIRE(result);
  CHECK(*result == std::vector<std::uint32_t>(count, 2));
}

TEST_CASE("a buffer over a limit is refused by its name and both numbers") {
  GpuFixture fixture{OwnDevice{}};
  Device& device = fixture.device();
  Limits limits = device.limits();
  limits.max_storage_binding_size = 1000;
  device.lower_limits(limits);
  auto buffer = Buffer<float>::create(device, 251, "position");
  REQUIRE_FALSE(buffer);
  CHECK(buffer.error().kind == ErrorKind::Limit);
  CHECK(buffer.error().message ==
        "Buffer position needs 1004 bytes, more than this adapter's maxStorageBufferBindingSize of 1000.");
  CHECK(Buffer<float>::create(device, 250, "position"));
}

TEST_CASE("a device can be asked for WebGPU's default limits, whatever the adapter has") {
  const auto device = Device::create({.default_limits = true});
  REQUIRE(device);
  const Limits& limits = (*device)->limits();
  CHECK(limits.max_buffer_size == 256ULL << 20U);  // the table of WebGPU, "Limits"
  CHECK(limits.max_storage_binding_size == 128ULL << 20U);
  CHECK(limits.max_storage_buffers_per_stage == 8);
  CHECK(limits.max_invocations_per_workgroup == 256);
  CHECK(limits.max_workgroup_storage == 16384);
  CHECK(limits.max_workgroups_per_dimension == 65535);
  CHECK(limits.max_texture_size == 8192);
  GpuFixture fixture;
  const Limits& own = fixture.device().limits();
  const bool gives_more = own.max_texture_size > limits.max_texture_size ||
                          own.max_buffer_size > limits.max_buffer_size ||
                          own.max_storage_buffers_per_stage > limits.max_storage_buffers_per_stage;
  CHECK(gives_more);  // else the rest says nothing
}

TEST_CASE("the bytes of buffers are counted while they live") {
  GpuFixture fixture{OwnDevice{}};
  Device& device = fixture.device();
  {
    auto a = Buffer<float>::create(device, 100, "a");
    auto b = Buffer<Vec4f>::create(device, 10, "b");
    CHECK(device.allocated_bytes() == 560);
    *a = std::move(*Buffer<float>::create(device, 1, "c"));
    CHECK(device.allocated_bytes() == 164);
    CHECK(device.take_largest_buffer() == 400);
    CHECK(Buffer<float>::create(device, 3, "d"));
    CHECK(device.take_largest_buffer() == 12);  // since it was last asked
  }
  CHECK(device.allocated_bytes() == 0);
}

TEST_CASE(
    "a wrong kernel, a missing kernel and a wrong number of buffers are errors, not ends of the process") {
  GpuFixture fixture;
  Device& device = fixture.device();
  CHECK(Kernel::create(device, "test/none.wgsl").error().kind == ErrorKind::Shader);
  CHECK(Kernel::create(device, "gpu/test/double.wgsl", {{"kNothing", 1}}).error().kind == ErrorKind::Shader);
  auto kernel = Kernel::create(device, "gpu/test/double.wgsl");
  REQUIRE(kernel);
  CHECK(kernel->bind({}).error().message == "Shader gpu/test/double.wgsl binds 1 things, not 0.");
  auto uniform = Buffer<float>::create(device, 4, "uniform", kUniform);
  REQUIRE(uniform);
  const auto group = kernel->bind({*uniform});  // not a storage buffer
  CHECK(group.error().kind == ErrorKind::Shader);
}

TEST_CASE("a list that does not validate is not submitted, and the device lives on") {
  GpuFixture fixture;
  Device& device = fixture.device();
  auto a = Buffer<float>::create(device, 4, "a");
  auto b = Buffer<float>::create(device, 2, "b");
  REQUIRE(a);
  REQUIRE(b);
  CommandList list;
  list.copy(a->source(), b->range(0, 16));  // past the end of b
  const auto submitted = device.submit(list);
  REQUIRE_FALSE(submitted);
  CHECK(submitted.error().kind == ErrorKind::Shader);
  CHECK(download(device, *a));
}

TEST_CASE("after a loss every call says so, and a new device works") {
  auto device = Device::create();
  REQUIRE(device);
  auto buffer = Buffer<float>::create(**device, 4, "a");
  REQUIRE(buffer);
  (*device)->lose();
  CHECK(download(**device, *buffer).error().kind == ErrorKind::DeviceLost);
  CHECK(Buffer<float>::create(**device, 4, "b").error().kind == ErrorKind::DeviceLost);
  CHECK((*device)->wait().error().kind == ErrorKind::DeviceLost);
  GpuFixture fresh;
  CHECK(Buffer<float>::create(fresh.device(), 4, "b"));
}

TEST_CASE("a readback does not block, and can be used again") {
  GpuFixture fixture;
  Device& device = fixture.device();
  const std::vector<std::uint32_t> values = {1, 2, 3, 4};
  auto buffer = Buffer<std::uint32_t>::create_from(device, values, "values");
  auto readback = Readback::create(device, 16, "readback");
  REQUIRE(readback);
  for (int round = 0; round < 3; ++round) {
    CommandList list;
    list.copy(buffer->source(), readback->target());
    REQUIRE(device.submit(list));
    CHECK_FALSE(readback->pending());
    readback->start();
    CHECK(readback->pending());
    while (!readback->ready()) device.poll();
    const auto bytes = readback->take();
    CHECK(std::equal(bytes.begin(), bytes.end(), std::as_bytes(std::span(values)).begin()));
  }
}

TEST_CASE("a readback that goes while its bytes are on their way harms nothing") {
  GpuFixture fixture;
  Device& device = fixture.device();
  auto buffer = Buffer<std::uint32_t>::create(device, 1000, "values");
  for (int round = 0; round < 20; ++round) {
    auto readback = Readback::create(device, 4000, "readback");
    REQUIRE(readback);
    CommandList list;
    list.copy(buffer->source(), readback->target());
    REQUIRE(device.submit(list));
    readback->start();
  }
  CHECK(device.wait());
}

TEST_CASE("a timer gives each pass a label and a time that is not negative") {
  auto device = Device::create({.timestamps = true});
  REQUIRE(device);
  if (!(*device)->has_timestamps()) {
    CHECK(Timer::create(**device, 4).error().kind == ErrorKind::Limit);
    return;
  }
  auto timer = Timer::create(**device, 4);
  REQUIRE(timer);
  auto kernel = Kernel::create(**device, "gpu/test/double.wgsl");
  auto buffer = Buffer<std::uint32_t>::create(**device, 1000000, "values");
  auto group = kernel->bind({*buffer});
  CommandList list;
  for (const char* name : {"first", "second"}) {
    ComputePass pass(list, name, timer->span(name));
    kernel->dispatch(pass, *group, buffer->size());
  }
  timer->finish(list);
  REQUIRE((*device)->submit(list));
  auto spans = timer->read();
  REQUIRE_MESSAGE(spans, spans.error().message);
  REQUIRE(spans->size() == 2);
  CHECK((*spans)[1].label == "second");
  CHECK((*spans)[0].milliseconds > 0);
  CHECK((*spans)[0].milliseconds < 1000);
}

TEST_CASE("an adapter is chosen by a part of its name, in any case") {
  auto all = Device::adapters();
  REQUIRE(all);
  REQUIRE_FALSE(all->empty());
  const std::string name = all->front().name;
  CHECK(Device::create({.adapter = name.substr(0, 4)}));
  const auto none = Device::create({.adapter = "no such card"});
  REQUIRE_FALSE(none);
  CHECK(none.error().kind == ErrorKind::NoAdapter);
  CHECK(none.error().message.find(name) != std::string::npos);
}

TEST_CASE("every shader compiles in naga") {
  GpuFixture fixture;
  std::string all;
  for (const EmbeddedShader& shader : embedded_shaders()) all += shader.text;
  int compiled = 0;
  for (const EmbeddedShader& shader : embedded_shaders()) {
    if (all.find("#include \"" + std::string(shader.path) + "\"") != std::string::npos)
      continue;  // a part of others
    const auto source = ShaderSource::load(shader.path);
    REQUIRE(source);
    if (source->text.find("@compute") == std::string::npos &&
        source->text.find("@vertex") == std::string::npos)
      continue;
    const auto module = backend::create_shader_module(fixture.device().context(), source->text, shader.path);
    CHECK_MESSAGE(module, (module ? "" : module.error().message));
    if (module) backend::release(ObjectKind::ShaderModule, *module);
    ++compiled;
  }
  CHECK(compiled > 10);
}
