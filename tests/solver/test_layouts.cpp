#include <doctest/doctest.h>

#include "element/neighbours.hpp"
#include "gpu/shader_source.hpp"
#include "solver/mass_spring/advance_grid.hpp"
#include "wgsl_layout.hpp"

using namespace weft;

TEST_CASE("GridParams and Neighbour lie in C++ as in WGSL") {
  const WgslLayout grid =
      wgsl_layout(gpu::ShaderSource::load("mass_spring/advance_grid.wgsl")->text, "GridParams");
  CHECK(grid.offset.size() == 7);
  CHECK(grid.offset.at("first_vertex") == offsetof(GridParams, first_vertex));
  CHECK(grid.offset.at("nx") == offsetof(GridParams, nx));
  CHECK(grid.offset.at("ny") == offsetof(GridParams, ny));
  CHECK(grid.offset.at("uniform_weights") == offsetof(GridParams, uniform_weights));
  CHECK(grid.offset.at("stiffness") == offsetof(GridParams, stiffness));
  CHECK(grid.offset.at("rest_length") == offsetof(GridParams, rest_length));
  CHECK(grid.offset.at("damping") == offsetof(GridParams, damping));
  CHECK(grid.size == sizeof(GridParams));
  const WgslLayout neighbour =
      wgsl_layout(gpu::ShaderSource::load("shared/neighbour.wgsl")->text, "Neighbour");
  CHECK(neighbour.offset.at("node") == offsetof(Neighbour, node));
  CHECK(neighbour.offset.at("rest_length") == offsetof(Neighbour, rest_length));
  CHECK(neighbour.offset.at("stiffness") == offsetof(Neighbour, stiffness));
  CHECK(neighbour.offset.at("damping") == offsetof(Neighbour, damping));
  CHECK(neighbour.size == sizeof(Neighbour));
}
