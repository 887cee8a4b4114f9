// The extension module subcert._core: what the modules in ../subcert call. Its functions take and give plain values;
// their meaning, domain and errors are those of the functions of the library of the same name.

#include "casters.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/reports/formats/paper_text.hpp>
#include <subcert/reports/formats/provenance.hpp>

#include <exception>

namespace subcert::python {
namespace {

const char* exception_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage: return "UsageError";
    case ErrorKind::domain: return "DomainError";
    case ErrorKind::size: return "SizeError";
    case ErrorKind::data: return "DataError";
    case ErrorKind::missing_file: return "MissingFileError";
    default: return "UndecidedError";
  }
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 asks for this signature
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Error& error) {
    const py::object type = py::module_::import("subcert._errors").attr(exception_of(error.kind()));
    PyErr_SetString(type.ptr(), error.what());
  }
}

}  // namespace
}  // namespace subcert::python

PYBIND11_MODULE(_core, module) {
  using namespace subcert::python;
  py::register_exception_translator(&translate);
  module.attr("version") = subcert::formats::version();
  module.def("enclosure_text", &subcert::enclosure_text);
  module.def("latex_formula", [](const std::string& text) { return subcert::formats::latex_formula(text); });
  add_schemes(module);
  add_regularity(module);
  add_limits(module);
  add_families(module);
  add_data(module);
  add_meshes(module);
  add_proofs(module);
}
