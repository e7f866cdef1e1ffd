// weft._core: the C++ library as the modules of python/weft use it; their functions carry the docstrings.
#include <nanobind/stl/string.h>

#include "world.hpp"

namespace {

namespace nb = nanobind;
using namespace weft;

nb::list list_adapters() {
  const auto found = python::value_of([] {
    nb::gil_scoped_release released;
    return weft::adapters();
  }());
  nb::list out;
  for (const AdapterInfo& info : found) {
    nb::dict one;
    one["name"] = info.name;
    one["vendor"] = info.vendor;
    one["driver"] = info.driver;
    one["backend"] = info.backend;
    one["type"] = info.type;
    out.append(one);
  }
  return out;
}

}  // namespace

NB_MODULE(_core, module) {
  python::register_errors();
  python::bind_world(module);
  module.def("adapters", &list_adapters);
  module.def("schema", &scene_schema);
}
