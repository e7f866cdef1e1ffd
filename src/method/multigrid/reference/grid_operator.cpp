#include "method/multigrid/reference/grid_operator.hpp"

namespace weft::reference {

Field GridOperator::apply(const Field& x) const {
  Field y(size());
  for (std::uint32_t j = 0; j < ny; ++j)
    for (std::uint32_t i = 0; i < nx; ++i) {
      const std::uint32_t a = j * nx + i;
      y[a] += rows[a][0] * x[a];
      const auto couple = [&](std::uint32_t b, const Sym3& block) {
        y[a] += block * x[b];
        y[b] += block * x[a];
      };
      if (i + 1 < nx) couple(a + 1, rows[a][1]);
      if (j + 1 < ny) couple(a + nx, rows[a][2]);
      if (i + 1 < nx && j + 1 < ny) couple(a + nx + 1, rows[a][3]);
      if (i > 0 && j + 1 < ny) couple(a + nx - 1, rows[a][4]);
    }
  for (const FarSpring& spring : far) {
    const Vec3d force = spring.block * (x[spring.a] - x[spring.b]);
    y[spring.a] += force;
    y[spring.b] -= force;
  }
  for (const bool along_i : {true, false}) {
    const std::uint32_t stride = along_i ? 1 : nx;
    for_each_bend(*this, along_i, [&](std::uint32_t m, double stiffness, double r) {
      const Vec3d curve = stiffness * (x[m - stride] - (1 + r) * x[m] + r * x[m + stride]);
      y[m - stride] += curve;
      y[m] -= (1 + r) * curve;
      y[m + stride] += r * curve;
    });
  }
  for (std::size_t a = 0; a < size(); ++a)
    if (fixed[a]) y[a] = {};
  return y;
}

std::vector<Sym3> GridOperator::diagonal() const {
  std::vector<Sym3> blocks(size());
  for (std::size_t a = 0; a < size(); ++a) blocks[a] = rows[a][0];
  for (const FarSpring& spring : far) {
    blocks[spring.a] += spring.block;
    blocks[spring.b] += spring.block;
  }
  for (const bool along_i : {true, false}) {
    const std::uint32_t stride = along_i ? 1 : nx;
    for_each_bend(*this, along_i, [&](std::uint32_t m, double stiffness, double r) {
      blocks[m - stride] += Sym3::identity(stiffness);
      blocks[m] += Sym3::identity((1 + r) * (1 + r) * stiffness);
      blocks[m + stride] += Sym3::identity(r * r * stiffness);
    });
  }
  return blocks;
}

std::vector<Sym3> GridOperator::inverse_diagonal() const {
  std::vector<Sym3> blocks = diagonal();
  for (std::size_t a = 0; a < size(); ++a)
    blocks[a] = fixed[a] ? Sym3{} : inverse(blocks[a] + Sym3::identity(kDiagonalMargin * blocks[a].trace()));
  return blocks;
}

}  // namespace weft::reference
