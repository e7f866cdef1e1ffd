// The engine's errors as Python's exceptions.
#pragma once

#include <nanobind/nanobind.h>

#include "weft/result.hpp"

namespace weft::python {

/// An error of the engine on its way to Python.
struct Raised {
  Error error;
};

inline void check(const Result<void>& result) {
  if (!result) throw Raised{result.error()};
}
template <class T>
T value_of(Result<T> result) {
  if (!result) throw Raised{result.error()};
  return std::move(*result);
}

/// Has Raised become the class of weft.errors that stands for its kind, with the engine's sentence.
void register_errors();

}  // namespace weft::python
