#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "at_end.hpp"

namespace {

std::vector<std::function<void()>>& jobs() {
  static std::vector<std::function<void()>> all;
  return all;
}

}  // namespace

void weft::at_end(std::function<void()> job) { jobs().push_back(std::move(job)); }

int main(int count, char** arguments) {
  const int result = doctest::Context(count, arguments).run();
  for (const auto& job : jobs()) job();
  return result;
}
