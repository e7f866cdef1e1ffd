#include "bench/sheet_errors.hpp"

#include "bench/upsample.hpp"

namespace weft::bench {

SheetShape shape_of(const Model& model, const sim::Snapshot& state, double time) {
  SheetShape shape;
  shape.time = time;
  for (const Vec4f& node : state.position) shape.position.push_back(node.xyz().to<double>());
  shape.kinetic_energy = kinetic_energy(model.mass, state.velocity);
  return shape;
}

SheetShape upsampled(const Model& coarse, const SheetShape& shape, const Model& fine) {
  SheetShape drawn = shape;
  drawn.position = upsample(*coarse.bodies[0].grid, coarse.rest_position, shape.position,
                            *fine.bodies[0].grid, fine.rest_position);
  return drawn;
}

std::vector<SheetError> sheet_errors(const Model& model, std::span<const SheetShape> shapes,
                                     std::span<const SheetShape> reference) {
  const std::vector<Chain> sides = free_sides(model, model.bodies[0]);
  std::vector<SheetError> errors;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    const SheetShape &shape = shapes[k], &exact = reference[k];
    SheetError error;
    error.time = exact.time;
    error.position = position_error(shape.position, exact.position, model.start_position);
    error.normal_degrees = mean_normal_angle(shape.position, exact.position, model.triangles);
    error.edge_stretch = stretch_of(sides, shape.position, model.rest_position);
    error.edge_stretch_reference = stretch_of(sides, exact.position, model.rest_position);
    error.kinetic_energy = shape.kinetic_energy;
    error.kinetic_energy_reference = exact.kinetic_energy;
    errors.push_back(error);
  }
  return errors;
}

}  // namespace weft::bench
