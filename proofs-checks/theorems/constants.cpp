#include "constants.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <stdexcept>

namespace subcert::theorems {

Constants::Constants(std::vector<Constant> list) : list_(std::move(list)) {}

std::size_t Constants::index(const std::string& name) const {
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (list_[i].name == name) return i;
  fail(ErrorKind::domain, "no constant is called '{}'", name);
}

const Rational& Constants::operator[](const std::string& name) const { return list_[index(name)].value; }

Constants Constants::broken(const std::string& name) const {
  Constants result(*this);
  Constant& constant = result.list_[index(name)];
  // The constants are positive.
  constant.value *= constant.side == Side::above ? Rational(99, 100) : Rational(101, 100);
  return result;
}

Rational decimal(const std::string& text) {
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return read_decimal(text).value;
  const std::optional<Rational> value = parse_number(text);
  if (!value) fail(ErrorKind::usage, "need a decimal number, got '{}'", text);
  return *value;
}

}  // namespace subcert::theorems
