#include "component_support.hpp"

#include "value_space.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr std::size_t longest_period = 6, longest_beginning = 24;

/// What reads a number on a space: a row.
using Functional = std::vector<Rational>;

bool is_zero(const Functional& f) {
  return std::ranges::all_of(f, [](const Rational& x) { return x == 0; });
}

Functional times(const Functional& f, const RationalMatrix& matrix) {
  Functional result(matrix.columns(), 0);
  for (std::size_t i = 0; i < f.size(); ++i)
    if (f[i] != 0)
      for (std::size_t k = 0; k < result.size(); ++k)
        if (matrix(i, k) != 0) result[k] += f[i] * matrix(i, k);
  return result;
}

/// The digits of the first cells, or the last ones, on which a functional of T_d v(x) does not vanish.
class Digits {
 public:
  Digits(const MatrixFamily& family, bool last) : family_(family), last_(last) {}

  /// The first point in [0, 1] near which f v(x) is not 0, or the last one. Domain: f is not 0. Nothing where no period
  /// is found.
  std::optional<Rational> end(const Functional& start) const {
    Functional f = start;
    std::vector<std::size_t> digits;
    std::vector<Functional> before;
    for (std::size_t n = 0; n < longest_beginning + longest_period; ++n) {
      before.push_back(f);
      digits.push_back(next(f));
      f = times(f, family_[digits.back()]);
    }
    for (std::size_t begin = 0; begin < longest_beginning; ++begin)
      for (std::size_t period = 1; period <= longest_period; ++period) {
        const std::vector<std::size_t> word(digits.begin() + static_cast<long>(begin),
                                            digits.begin() + static_cast<long>(begin + period));
        if (is_repeated(before[begin], word)) return point(digits, begin, period);
      }
    return std::nullopt;
  }

 private:
  std::size_t next(const Functional& f) const {
    const std::size_t count = family_.count();
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t d = last_ ? count - 1 - k : k;
      if (!is_zero(times(f, family_[d]))) return d;
    }
    fail(ErrorKind::undecided, "component_supports: a functional vanishes on all cells of one on which it does not");
  }

  /// Whether these digits follow each other for ever: f T_w^k is not 0 for all k, and after f T_w^k and a part of w all
  /// digits that come before the next one vanish. Powers of T_w on a space of dimension n are combinations of the first
  /// n, and f T_w^n is 0 if f T_w^k is for some k.
  bool is_repeated(Functional f, const std::vector<std::size_t>& word) const {
    for (std::size_t k = 0; k <= f.size(); ++k)
      for (const std::size_t d : word) {
        if (is_zero(f)) return false;
        for (std::size_t other = last_ ? d + 1 : 0; other < (last_ ? family_.count() : d); ++other)
          if (!is_zero(times(f, family_[other]))) return false;
        f = times(f, family_[d]);
      }
    return !is_zero(f);
  }

  Rational point(const std::vector<std::size_t>& digits, std::size_t begin, std::size_t period) const {
    const Rational arity(static_cast<long>(family_.count()));
    Rational result = 0, repeated = 0;
    for (std::size_t k = 0; k < begin; ++k)
      result += static_cast<long>(digits[k]) * power(arity, -static_cast<long>(k) - 1);
    for (std::size_t k = 0; k < period; ++k)
      repeated += static_cast<long>(digits[begin + k]) * power(arity, -static_cast<long>(k) - 1);
    // Cells get smaller, and so the last point of the last ones is the limit of the first points.
    return result + power(arity, -static_cast<long>(begin)) * repeated / (1 - power(arity, -static_cast<long>(period)));
  }

  const MatrixFamily& family_;
  bool last_;
};

}  // namespace

std::vector<std::optional<Interval>> component_supports(const LatticeMask& given, const LatticeSequence& values) {
  require(given.dimension() == 1 && given.components() > 1 && given.dilation().factor().value_or(0) > 1,
          "component_supports: need a mask of matrices of one variable with an arity, got the dilation {}",
          given.dilation().to_text());
  const LatticeMask mask = given.with_dilation(Dilation::multiple(1, given.arity()));
  // T_0 v = v: long words on v are all words on it.
  const auto space = space_of_long_words(mask, {values}, 0);
  require(space.has_value(), "component_supports: the values span no space that is found");
  std::vector<std::optional<Interval>> result(mask.components());
  std::map<long, Functional> cells;
  for (std::size_t c = 0; c < mask.components(); ++c) {
    cells.clear();
    for (std::size_t k = 0; k < space->basis.size(); ++k)
      for (const auto& [place, value] : space->basis[k])
        if (place.back() == static_cast<long>(c))
          cells.try_emplace(place.front(), space->basis.size(), 0).first->second[k] = value;
    if (cells.empty()) continue;
    const auto first = Digits(space->family, false).end(cells.begin()->second),
               last = Digits(space->family, true).end(cells.rbegin()->second);
    if (!first || !last)
      fail(ErrorKind::undecided, "component_supports: the digits of an end of function {} show no period", c + 1);
    result[c] = Interval{cells.begin()->first + *first, cells.rbegin()->first + *last};
  }
  return result;
}

}  // namespace subcert
