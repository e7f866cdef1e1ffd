#include <doctest/doctest.h>

#include <cmath>

#include "base/quaternion.hpp"
#include "base/random.hpp"
#include "weft/placement.hpp"

using namespace weft;

namespace {

Quaternion random_turn(Random& random) {
  Quaternion q;
  double sum = 0;
  for (double& part : q) {
    part = random.uniform(-1, 1);
    sum += part * part;
  }
  for (double& part : q) part /= std::sqrt(sum);
  return q;
}

std::array<double, 16> matrix(const Quaternion& q, const Vec3d& place) {
  const Mat3 r = matrix_of(q);
  return {r.x.x, r.y.x, r.z.x, 0, r.x.y,   r.y.y,   r.z.y,   0,
          r.x.z, r.y.z, r.z.z, 0, place.x, place.y, place.z, 1};
}

std::string refusal(const std::array<double, 16>& columns) {
  const auto read = Placement::from_matrix(columns);
  REQUIRE(!read);
  CHECK(read.error().kind == ErrorKind::Input);
  return read.error().message;
}

}  // namespace

TEST_CASE("a placement is read back from its matrix") {
  Random random(3);
  for (int k = 0; k < 1000; ++k) {
    const Quaternion q = random_turn(random);
    const Vec3d place{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
    const auto read = Placement::from_matrix(matrix(q, place));
    REQUIRE(read);
    CHECK(read->position == place);
    double product = 0;  // a quaternion and its negative are one turn
    for (std::size_t i = 0; i < 4; ++i) product += q[i] * read->rotation[i];
    CHECK(std::abs(product) == doctest::Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("a matrix that is no placement is refused with the value and the limit") {
  std::array<double, 16> columns = matrix({0, 0, 0, 1}, {1, 2, 3});
  auto scaled = columns, sheared = columns, mirrored = columns, projected = columns, infinite = columns;
  scaled[5] = 1.1;
  CHECK(refusal(scaled) == "Column 1 of the matrix has length 1.1; a placement does not scale, to 0.001.");
  sheared[4] = 0.01;
  CHECK(refusal(sheared) ==
        "Columns 0 and 1 of the matrix have the product 0.01; a placement does not shear, to 0.001.");
  mirrored[10] = -1;
  CHECK(refusal(mirrored) == "The matrix mirrors: its determinant is -1; that of a placement is 1.");
  projected[11] = -1;
  CHECK(refusal(projected) ==
        "The last row of the matrix is (0, 0, -1, 1); that of a placement is (0, 0, 0, 1).");
  infinite[12] = HUGE_VAL;
  CHECK(refusal(infinite) == "Number 12 of the matrix is not finite: inf.");
}
