#include "method/creases.hpp"

#include "element/hinge/parts.hpp"
#include "model/fabric.hpp"

namespace weft {
namespace {

/// Rows of three parts a facet, then their entries: a hinge, and the bits of its weight.
std::vector<FabricBuffers::Two> parts_of(const hinge::Plate& plate) {
  std::vector<FabricBuffers::Two> words(3 * plate.facets.size());
  for (std::size_t f = 0; f < plate.facets.size(); ++f) {
    const std::array<hinge::Part, 3> parts = hinge::parts_of(plate, plate.facets[f]);
    for (std::size_t side = 0; side < 3; ++side) {
      const auto first = static_cast<std::uint32_t>(words.size());
      for (std::size_t k = 0; k < parts[side].weights.size(); ++k)
        if (parts[side].weights[k] != 0)
          words.push_back({parts[side].hinges[k], bits_of(parts[side].weights[k])});
      words[3 * f + side] = {first, static_cast<std::uint32_t>(words.size())};
    }
  }
  return words;
}

/// Of each facet the diagonal, then twice xy, yz and zx.
std::vector<Vec4f> curving_of(const hinge::Plate& plate) {
  std::vector<Vec4f> rows;
  for (const hinge::Facet& facet : plate.facets) {
    const Mat3& m = facet.curving;
    rows.push_back(Vec4f::from(Vec3d{m.x.x, m.y.y, m.z.z}.to<float>(), 0));
    rows.push_back(Vec4f::from((2.0 * Vec3d{m.x.y, m.y.z, m.z.x}).to<float>(), 0));
  }
  return rows;
}

}  // namespace

Result<Creases> Creases::create(gpu::Device& device, const Model& model, const State& state, const Body& body,
                                const FabricBuffers& fabric, const gpu::RawBuffer& bends, std::uint32_t words,
                                std::uint32_t workgroup_size) {
  Creases made;
  const std::optional<hinge::Yield> law = yield_law(*body.fabric);
  if (!law || fabric.layout.hinges == 0) return made;
  const hinge::Plate& plate = model.plate(body);
  const YieldLawBlock block = {static_cast<float>(law->curvature), static_cast<float>(law->hardening),
                               first_crease(model, body)};
  WEFT_SET(made.law_, gpu::create_uniform(device, block, "yield of bends"));
  WEFT_SET(made.parts_,
           gpu::Buffer<FabricBuffers::Two>::create_from(device, parts_of(plate), "parts of angles"));
  WEFT_SET(made.curving_, gpu::Buffer<Vec4f>::create_from(device, curving_of(plate), "curvatures of facets"));
  const std::vector<gpu::Constant> constants = {{"kBendWords", static_cast<double>(words)}};
  WEFT_TRY(measure, gpu::create_shared_kernel(device, "method/start_bends.wgsl", constants, workgroup_size));
  WEFT_SET(made.measure_,
           gpu::Dispatch::create_by_parity(
               measure, measure->workgroups_of(fabric.layout.hinges),
               [&](std::size_t p) -> gpu::Dispatch::Bindings {
                 return {fabric.params, fabric.hinges, fabric.rest_angles, state.position[p], bends};
               }));
  WEFT_TRY(yield, gpu::create_shared_kernel(device, "method/yield_creases.wgsl", constants, workgroup_size));
  WEFT_SET(made.yield_, gpu::Dispatch::create(
                            yield, yield->workgroups_of(fabric.layout.triangles),
                            {fabric.params, made.law_, made.parts_, made.curving_, state.creases, bends}));
  return made;
}

void Creases::record(gpu::ComputePass& pass) const {
  measure_.record(pass);
  yield_.record(pass);
}

}  // namespace weft
