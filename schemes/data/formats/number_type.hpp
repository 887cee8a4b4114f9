#pragma once
/// Numbers as files of meshes and volumes hold them, as text or in bytes.

#include <cstddef>
#include <string>
#include <string_view>

namespace subcert::data {

/// How numbers stand in a file.
enum class Encoding { text, little_endian, big_endian };

/// A type of numbers: its size in bytes, and whether it is whole, with a sign, or floating.
struct NumberType {
  std::size_t size = 8;
  bool whole = false;
  bool with_sign = true;

  /// The least and the largest number of a whole type.
  double low() const;
  double high() const;
};

/// The number in these bytes. Domain: type.size of them; not Encoding::text. 64-bit whole numbers are rounded.
double read_number(const char* bytes, const NumberType& type, Encoding encoding);

/// Appends a number to bytes. A whole type takes the nearest of its numbers. Domain: as read_number().
void append_number(double value, const NumberType& type, Encoding encoding, std::string& bytes);

/// The nearest number of a whole type, 0 for NaN, or the value itself.
double fitted(double value, const NumberType& type);

}  // namespace subcert::data
