#pragma once
// How values of the library look in Python: exact numbers are int and fractions.Fraction, enclosures pairs of them
// (None for an absent end), answers pairs of a word and a reason. What is made of them stands in the modules in
// ../subcert.

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace pybind11::detail {

template <>
struct type_caster<subcert::Integer> {
  PYBIND11_TYPE_CASTER(subcert::Integer, const_name("int"));

  bool load(handle source, bool) {
    // Whatever has an __index__, numpy's integers too.
    const auto index = reinterpret_steal<object>(PyNumber_Index(source.ptr()));
    const auto digits = index ? reinterpret_steal<object>(PyNumber_ToBase(index.ptr(), 16)) : object();
    if (!digits) {
      PyErr_Clear();
      return false;
    }
    return mpz_set_str(value.get(), PyUnicode_AsUTF8(digits.ptr()), 0) == 0;
  }
  static handle cast(const subcert::Integer& number, return_value_policy, handle) {
    std::string digits(mpz_sizeinbase(number.get(), 16) + 2, '\0');
    mpz_get_str(digits.data(), 16, number.get());
    return PyLong_FromString(digits.c_str(), nullptr, 16);
  }
};

template <>
struct type_caster<subcert::Rational> {
  PYBIND11_TYPE_CASTER(subcert::Rational, const_name("fractions.Fraction"));

  // Numbers that name their numerator and denominator are exact: int, Fraction, numpy's integers, sympy's rationals.
  bool load(handle source, bool convert) {
    type_caster<subcert::Integer> above, below;
    if (!hasattr(source, "numerator") || !hasattr(source, "denominator")) return false;
    if (!above.load(source.attr("numerator"), convert) || !below.load(source.attr("denominator"), convert))
      return false;
    value = subcert::Rational(cast_op<subcert::Integer&>(above), cast_op<subcert::Integer&>(below));
    return true;
  }
  static handle cast(const subcert::Rational& number, return_value_policy, handle) {
    static PyObject* type = nullptr;  // looked up once; it lives as long as the process
    if (!type) type = object(module_::import("fractions").attr("Fraction")).release().ptr();
    return reinterpret_borrow<object>(type)(numerator(number), denominator(number)).release();
  }
};

template <>
struct type_caster<subcert::Enclosure> {
  PYBIND11_TYPE_CASTER(subcert::Enclosure, const_name("Ends"));

  bool load(handle source, bool) {
    if (!isinstance<tuple>(source) || len(source) != 2) return false;
    const auto ends = source.cast<std::pair<std::optional<subcert::Rational>, std::optional<subcert::Rational>>>();
    value = {ends.first, ends.second};
    return true;
  }
  static handle cast(const subcert::Enclosure& enclosure, return_value_policy, handle) {
    return pybind11::make_tuple(enclosure.lower, enclosure.upper).release();
  }
};

template <>
struct type_caster<subcert::Truth> {
  PYBIND11_TYPE_CASTER(subcert::Truth, const_name("str"));

  bool load(handle, bool) { return false; }
  static handle cast(subcert::Truth truth, return_value_policy, handle) { return str(to_text(truth)).release(); }
};

template <>
struct type_caster<subcert::Decision> {
  PYBIND11_TYPE_CASTER(subcert::Decision, const_name("tuple[str, str]"));

  bool load(handle, bool) { return false; }
  static handle cast(const subcert::Decision& decision, return_value_policy, handle) {
    return pybind11::make_tuple(decision.truth, decision.reason).release();
  }
};

/// Coefficients and the lowest exponent.
template <>
struct type_caster<subcert::LaurentPolynomial> {
  PYBIND11_TYPE_CASTER(subcert::LaurentPolynomial, const_name("tuple[list[Fraction], int]"));

  bool load(handle source, bool) {
    if (!isinstance<tuple>(source) || len(source) != 2) return false;
    const auto parts = source.cast<std::pair<std::vector<subcert::Rational>, long>>();
    value = subcert::LaurentPolynomial(parts.first, parts.second);
    return true;
  }
  static handle cast(const subcert::LaurentPolynomial& p, return_value_policy, handle) {
    return pybind11::make_tuple(p.coefficients(), p.is_zero() ? 0 : p.lowest()).release();
  }
};

}  // namespace pybind11::detail

namespace subcert::python {

namespace py = pybind11;
using namespace pybind11::literals;

void add_schemes(py::module_& module);
void add_regularity(py::module_& module);
void add_limits(py::module_& module);
void add_families(py::module_& module);
void add_data(py::module_& module);
void add_meshes(py::module_& module);
void add_proofs(py::module_& module);

}  // namespace subcert::python
