#pragma once
/// The constants that a proof states: rounded decimals, each bounded by one inequality of the proof.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <string>
#include <utility>
#include <vector>

namespace subcert::theorems {

/// What the proof needs of the stated value: to be above the number it stands for, or below it.
enum class Side { above, below };

struct Constant {
  std::string name;  ///< as in the text
  Rational value;    ///< as stated
  Side side;
  std::string check;  ///< number of the inequality that a value on the wrong side violates
  std::string meaning;
};

/// The constants of one proof, by name.
class Constants {
 public:
  Constants() = default;
  explicit Constants(std::vector<Constant> list);

  const std::vector<Constant>& all() const& { return list_; }
  std::vector<Constant> all() && { return std::move(list_); }
  /// Errors: throws a domain error with the name.
  const Rational& operator[](const std::string& name) const;
  /// The same constants, but `name` moved by a part in a hundred towards its wrong side.
  /// Errors: throws a domain error with the name.
  Constants broken(const std::string& name) const;

 private:
  std::size_t index(const std::string& name) const;
  std::vector<Constant> list_;
};

/// A decimal as printed, `193.31` or `7.8e-8`, without rounding. Errors: throws Error.
Rational decimal(const std::string& text);

}  // namespace subcert::theorems
