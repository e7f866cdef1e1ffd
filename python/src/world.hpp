#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <mutex>
#include <utility>

#include "errors.hpp"
#include "weft/weft.hpp"

namespace weft::python {

/// A world that Python's threads may share: each call lets the others run, and has the world for itself.
class SharedWorld {
 public:
  explicit SharedWorld(World world) : world_(std::move(world)) {}

  /// What call(world) gives, without Python's lock and with the world's own.
  template <class Call>
  auto with(Call&& call) {
    nanobind::gil_scoped_release released;
    std::scoped_lock locked(mutex_);
    return call(world_);
  }

 private:
  World world_;
  std::mutex mutex_;
};

void bind_world(nanobind::module_& module);

}  // namespace weft::python
