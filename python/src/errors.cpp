#include "errors.hpp"

namespace weft::python {
namespace {

namespace nb = nanobind;

const char* class_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::Input:
      return "InputError";
    case ErrorKind::Shape:
      return "ShapeError";
    case ErrorKind::Shader:
      return "ShaderError";
    case ErrorKind::NoAdapter:
      return "NoAdapterError";
    case ErrorKind::Limit:
      return "LimitError";
    case ErrorKind::OutOfMemory:
      return "OutOfMemoryError";
    case ErrorKind::DeviceLost:
      return "DeviceLostError";
    case ErrorKind::Diverged:
      return "DivergedError";
    case ErrorKind::Failure:
    case ErrorKind::Usage:        // of the command line alone
    case ErrorKind::Interrupted:  // likewise
      break;
  }
  return "Error";
}

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Raised& raised) {
    const nb::object type = nb::module_::import_("weft.errors").attr(class_of(raised.error.kind));
    PyErr_SetString(type.ptr(), raised.error.message.c_str());
  }
}

}  // namespace

void register_errors() { nb::register_exception_translator(translate); }

}  // namespace weft::python
