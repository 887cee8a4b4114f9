#pragma once
// numpy's arrays and the library's vectors.

#include <pybind11/numpy.h>

#include <memory>
#include <vector>

namespace subcert::python {

/// A one-dimensional array that owns the numbers; nothing is copied.
inline pybind11::array_t<double> array_of(std::vector<double> numbers) {
  auto kept = std::make_unique<std::vector<double>>(std::move(numbers));
  const pybind11::capsule owner(kept.get(), [](void* p) { delete static_cast<std::vector<double>*>(p); });
  std::vector<double>* held = kept.release();
  return pybind11::array_t<double>(static_cast<pybind11::ssize_t>(held->size()), held->data(), owner);
}

using DoubleArray = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

inline std::vector<double> numbers_of(const DoubleArray& array) { return {array.data(), array.data() + array.size()}; }

}  // namespace subcert::python
