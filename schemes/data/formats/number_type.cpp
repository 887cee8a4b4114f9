#include "number_type.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace subcert::data {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are turned from this order");

/// Calls work(zero) with a zero of the type.
template <class Work>
auto with_type(const NumberType& type, const Work& work) {
  if (!type.whole) return type.size == 4 ? work(float{}) : work(double{});
  switch (type.size) {
    case 1: return type.with_sign ? work(std::int8_t{}) : work(std::uint8_t{});
    case 2: return type.with_sign ? work(std::int16_t{}) : work(std::uint16_t{});
    case 4: return type.with_sign ? work(std::int32_t{}) : work(std::uint32_t{});
    default: return type.with_sign ? work(std::int64_t{}) : work(std::uint64_t{});
  }
}

}  // namespace

double NumberType::low() const { return with_sign ? -std::ldexp(1, static_cast<int>(8 * size) - 1) : 0; }
double NumberType::high() const { return std::ldexp(1, static_cast<int>(8 * size) - (with_sign ? 1 : 0)) - 1; }

double fitted(double value, const NumberType& type) {
  if (!type.whole) return value;
  return std::isnan(value) ? 0 : std::clamp(std::round(value), type.low(), type.high());
}

double read_number(const char* bytes, const NumberType& type, Encoding encoding) {
  std::array<char, 8> turned{};
  std::copy_n(bytes, type.size, turned.begin());
  if (encoding == Encoding::big_endian)
    std::reverse(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(type.size));
  return with_type(type, [&](auto number) {
    std::memcpy(&number, turned.data(), sizeof number);
    return static_cast<double>(number);
  });
}

void append_number(double value, const NumberType& type, Encoding encoding, std::string& bytes) {
  const std::size_t old = bytes.size();
  with_type(type, [&](auto number) {
    number = static_cast<decltype(number)>(fitted(value, type));
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    return 0.0;
  });
  if (encoding == Encoding::big_endian) std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(old), bytes.end());
}

}  // namespace subcert::data
