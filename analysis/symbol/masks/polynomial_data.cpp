#include "polynomial_data.hpp"

#include "matrix_masks.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>

#include <algorithm>

namespace subcert {
namespace {

/// j^n / n! for n = 0, ..., degree.
Values divided_powers(long j, std::size_t degree) {
  Values result{1};
  while (result.size() <= degree) result.push_back(result.back() * j / static_cast<long>(result.size()));
  return result;
}

/// Numerators and denominator of a mask at so many values of the letters that what is linear in both and vanishes there
/// vanishes for all.
class Samples {
 public:
  explicit Samples(const ParametricMask& mask)
      : arity_(mask.arity()), components_(static_cast<long>(mask.components())), support_(mask.support()) {
    std::vector<Values> grid{{}};
    for (const std::size_t size : mask.sizes()) {
      std::vector<Values> next;
      for (const Values& values : grid)
        for (std::size_t k = 0; k < size; ++k) {
          next.push_back(values);
          next.back().emplace_back(static_cast<long>(k));
        }
      grid = std::move(next);
    }
    for (const Values& values : grid)
      samples_.emplace_back(mask.numerator_at(values), value_at(mask.denominators(), values));
  }

  std::size_t components() const { return static_cast<std::size_t>(components_); }
  std::size_t count() const { return samples_.size(); }

  /// (S e)(i) q - factor q e(i) for all samples and all i from 0 to points - 1, component by component.
  template <class Data>
  Values defects(const Data& e, const Rational& factor, long points) const {
    Values result;
    for (const auto& [numerator, denominator] : samples_)
      for (long i = 0; i < points; ++i) {
        const Values image = image_at(numerator, e, i), own = e(i);
        for (std::size_t c = 0; c < own.size(); ++c) result.push_back(image[c] - factor * denominator * own[c]);
      }
    return result;
  }

  /// `size`: of the matrices; of a doubled mask those are P, and Q below them.
  bool interpolate(const ParametricMask& mask, std::size_t size) const {
    return std::ranges::all_of(samples_, [&](const auto& sample) {
      std::vector<LatticeMask::Term> terms = mask.terms_of(sample.first);
      std::erase_if(terms, [&](const LatticeMask::Term& term) { return term.column >= size; });
      const bool is_rational = std::ranges::none_of(terms, [&](const LatticeMask::Term& term) {
        return term.row >= size && modulo(term.exponents[0], arity_) == 0 && term.coefficient != 0;
      });
      std::erase_if(terms, [&](const LatticeMask::Term& term) { return term.row >= size; });
      return is_rational && keeps_data(terms, size, Dilation::multiple(1, mask.arity()), true, sample.second);
    });
  }

 private:
  template <class Data>
  Values image_at(const LaurentPolynomial& numerator, const Data& e, long i) const {
    Values result(components());
    for (long j = -floor_divide(support_.last - i, arity_); arity_ * j <= i - support_.first; ++j) {
      const Values from = e(j);
      const long block = (i - arity_ * j) * components_ * components_;
      for (long row = 0; row < components_; ++row)
        if (const Rational& x = from[static_cast<std::size_t>(row)]; x != 0)
          for (long c = 0; c < components_; ++c)
            result[static_cast<std::size_t>(c)] += numerator.coefficient(block + components_ * row + c) * x;
    }
    return result;
  }

  long arity_, components_;
  IndexRange support_;
  std::vector<std::pair<LaurentPolynomial, Rational>> samples_;
};

/// What the e_l have at j.
Values value_of(const std::vector<Values>& data, std::size_t l, long j) {
  const Values powers = divided_powers(j, l);
  Values result(data.front().size());
  for (std::size_t s = 0; s <= std::min(l, data.size() - 1); ++s)
    for (std::size_t c = 0; c < result.size(); ++c) result[c] += data[s][c] * powers[l - s];
  return result;
}

/// Of vectors (q, p) for p + sqrt(root) q those times the root.
Values times_root(const Values& y, long root) {
  const std::size_t half = y.size() / 2;
  Values result(y.begin() + static_cast<std::ptrdiff_t>(half), y.end());
  for (std::size_t c = 0; c < half; ++c) result.push_back(root * y[c]);
  return result;
}

/// As many points as decide an equation of polynomials of this degree in each class.
long points_for(std::size_t degree, int arity) { return arity * (static_cast<long>(degree) + 1); }

/// The y_s of values and derivatives, as far as they are kept.
std::vector<Values> hermite_data(const Samples& samples, int arity, std::size_t most, long root) {
  const std::size_t components = samples.components(), first = root > 0 ? components / 2 : 0,
                    multiples = root > 0 ? 2 : 1;
  std::vector<Values> data;
  while (data.size() < most) {
    const std::size_t l = data.size();
    data.emplace_back(components);
    if (first + l < components) data.back()[first + l] = 1;
    const long points = points_for(l, arity);
    const auto e = [&](std::size_t degree) { return [&data, degree](long j) { return value_of(data, degree, j); }; };
    const Values defects = samples.defects(e(l), power(Rational(arity), -static_cast<long>(l)), points);
    const std::size_t rows = static_cast<std::size_t>(points) * components;
    bool is_kept = true;
    for (std::size_t sample = 0; sample < samples.count() && is_kept; ++sample) {
      RationalMatrix columns(rows, multiples * l + 1);
      for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t d = 0; d < l; ++d) {
          const Values value = e(d)(static_cast<long>(r / components));
          columns(r, d) = value[r % components];
          if (root > 0) columns(r, l + d) = times_root(value, root)[r % components];
        }
        columns(r, multiples * l) = defects[sample * rows + r];
      }
      is_kept = !kernel(columns).empty();  // the e_d, and their multiples, are independent
    }
    if (!is_kept) {
      data.pop_back();
      break;
    }
  }
  return data;
}

/// Whatever data satisfy S e_l = a^-l e_l for all values of the letters.
std::vector<Values> other_data(const Samples& samples, int arity, std::size_t most, long root) {
  const std::size_t components = samples.components();
  std::vector<std::vector<Values>> solutions{{}};  // a basis of all y_0, ..., y_{l-1}
  std::vector<Values> result;
  while (result.size() < most) {
    const std::size_t l = result.size();
    const Rational factor = power(Rational(arity), -static_cast<long>(l));
    std::vector<std::vector<Values>> candidates;  // a solution and y_l = 0, or y_l alone
    if (l > 0)
      for (std::vector<Values> solution : solutions) {
        solution.emplace_back(components);
        candidates.push_back(std::move(solution));
      }
    for (std::size_t c = 0; c < components; ++c) {
      candidates.emplace_back(l + 1, Values(components));
      candidates.back().back()[c] = 1;
    }
    std::vector<Values> columns;
    for (const std::vector<Values>& candidate : candidates)
      columns.push_back(
          samples.defects([&](long j) { return value_of(candidate, l, j); }, factor, points_for(l, arity)));
    solutions.clear();
    for (const Values& weights : kernel(from_columns(columns, columns.front().size()))) {
      std::vector<Values>& sum = solutions.emplace_back(l + 1, Values(components));
      for (std::size_t k = 0; k < weights.size(); ++k)
        for (std::size_t s = 0; s <= l; ++s)
          for (std::size_t c = 0; c < components; ++c) sum[s][c] += weights[k] * candidates[k][s][c];
    }
    const auto found = std::ranges::find_if(solutions, [](const std::vector<Values>& solution) {
      return std::ranges::any_of(solution.front(), [](const Rational& x) { return x != 0; });
    });
    if (found == solutions.end() || (l == 0 && solutions.size() > (root > 0 ? 2 : 1))) break;
    result = *found;
  }
  return result;
}

}  // namespace

std::vector<Values> PolynomialData::at(long j) const {
  std::vector<Values> result;
  for (std::size_t l = 0; l < data.size(); ++l) result.push_back(value_of(data, l, j));
  for (std::size_t l = 0; root > 0 && l < data.size(); ++l) result.push_back(times_root(result[l], root));
  return result;
}

PolynomialData kept_polynomials(const ParametricMask& mask, long root) {
  const Samples samples(mask);
  const IndexRange support = mask.support();
  // As many data as there are on the support of the functions.
  const std::size_t size = mask.components() / (root > 0 ? 2 : 1);
  const std::size_t most = size * static_cast<std::size_t>(1 + (support.last - support.first) / (mask.arity() - 1));
  PolynomialData result{hermite_data(samples, mask.arity(), most, root)};
  result.root = root;
  result.hermite = result.data.size() >= size;
  if (result.hermite)
    result.interpolating = samples.interpolate(mask, size);
  else
    result.data = other_data(samples, mask.arity(), most, root);
  return result;
}

}  // namespace subcert
