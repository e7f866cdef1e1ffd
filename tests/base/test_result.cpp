#include <doctest/doctest.h>

#include "base/random.hpp"
#include "base/result.hpp"

using namespace weft;

namespace {

Result<int> half(int number) {
  if (number % 2 != 0) return input_error("Number %d is odd.", number);
  return number / 2;
}

Result<int> quarter(int number) {
  WEFT_TRY(first, half(number));
  WEFT_TRY(second, half(first));
  return second;
}

}  // namespace

TEST_CASE("a result passes its value or its error on") {
  CHECK(*quarter(12) == 3);
  CHECK(quarter(6).error().message == "Number 3 is odd.");
  CHECK(quarter(6).error().kind == ErrorKind::Input);
  CHECK(quarter(6).error().while_doing("dividing").message == "While dividing: Number 3 is odd.");
}

TEST_CASE("each kind of error has the exit code that docs/cli.md names") {
  CHECK(exit_code(ErrorKind::Failure) == 1);
  CHECK(exit_code(ErrorKind::Shader) == 1);
  CHECK(exit_code(ErrorKind::Usage) == 2);
  CHECK(exit_code(ErrorKind::Input) == 3);
  CHECK(exit_code(ErrorKind::NoAdapter) == 4);
  CHECK(exit_code(ErrorKind::Limit) == 4);
  CHECK(exit_code(ErrorKind::OutOfMemory) == 4);
  CHECK(exit_code(ErrorKind::DeviceLost) == 5);
  CHECK(exit_code(ErrorKind::Diverged) == 6);
  CHECK(exit_code(ErrorKind::Interrupted) == 130);
}

TEST_CASE("random numbers repeat and stay in their range") {
  Random a(7), b(7), c(8);
  bool differs = false;
  for (int i = 0; i < 1000; ++i) {
    const auto x = a.next();
    CHECK(x == b.next());
    differs = differs || x != c.next();
    CHECK(a.below(10) < 10);
    b.below(10);
    const double u = a.uniform(-2, 3);
    CHECK(u >= -2);
    CHECK(u < 3);
    b.uniform(0, 1);
  }
  CHECK(differs);
}
