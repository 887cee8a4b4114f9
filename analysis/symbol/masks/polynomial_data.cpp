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

/// Numerators and denominators of masks at so many values of the letters that what is linear in both and vanishes there
/// vanishes for all.
class Samples {
 public:
  explicit Samples(const std::vector<ParametricMask>& masks)
      : arity_(masks.front().arity()),
        components_(static_cast<long>(masks.front().components())),
        support_(masks.front().support()) {
    for (const ParametricMask& mask : masks) add(mask);
  }

  std::size_t components() const { return static_cast<std::size_t>(components_); }
  std::size_t count() const { return samples_.size(); }
  const IndexRange& support() const { return support_; }
  /// The first one at which the denominator is not 0.
  std::size_t regular() const {
    const auto found = std::ranges::find_if(samples_, [](const auto& sample) { return sample.second != 0; });
    return static_cast<std::size_t>(found - samples_.begin());
  }

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
  void add(const ParametricMask& mask) {
    const IndexRange own = mask.support();
    support_ = {std::min(support_.first, own.first), std::max(support_.last, own.last)};
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

/// y_0, ..., y_l.
using Chain = std::vector<Values>;

/// The sum of weights times these, the first ones.
Chain combined(const std::vector<Chain>& candidates, const Values& weights) {
  Chain sum(candidates.front().size(), Values(candidates.front().front().size()));
  for (std::size_t k = 0; k < candidates.size(); ++k)
    for (std::size_t s = 0; s < sum.size(); ++s)
      for (std::size_t c = 0; c < sum[s].size(); ++c) sum[s][c] += weights[k] * candidates[k][s][c];
  return sum;
}

/// Data that are kept, degree by degree: with S of one sample S e_l = a^-l e_l, with that of another one it is a^-l
/// times e_l + r_1 e_{l-1} + ... + r_l e_0, where the r_i of this sample do not depend on l.
class OtherData {
 public:
  OtherData(const Samples& samples, int arity, long root)
      : samples_(samples), arity_(arity), root_(root), shifts_(samples.count()) {}

  /// Adds y_l; whether there is one.
  bool add() {
    const std::size_t l = data.size();
    std::vector<Chain> candidates;  // y_l alone, and then solutions with y_l = 0
    for (std::size_t c = samples_.components(); c-- > 0;) {
      candidates.emplace_back(l + 1, Values(samples_.components()));
      candidates.back().back()[c] = 1;
    }
    for (auto one = solutions_.rbegin(); one != solutions_.rend(); ++one) {
      candidates.push_back(*one);
      candidates.back().emplace_back(samples_.components());
    }
    if (root_ > 0) std::ranges::reverse(candidates);
    std::vector<Values> columns;
    for (const Chain& candidate : candidates) columns.push_back(defects(candidate, l));
    const bool has_leading = l > 0 && root_ == 0;  // the last candidate alone has a y_0 that is not 0
    std::vector<Chain> found;
    if (has_leading) {
      auto leading = with_shifts(candidates, columns, l);
      if (!leading) return false;
      found.push_back(std::move(*leading));
      candidates.pop_back();
      columns.pop_back();
    }
    for (const Values& weights : kernel(from_columns(columns, columns.front().size())))
      found.push_back(combined(candidates, weights));
    const auto is_leading = [](const Chain& one) {
      return std::ranges::any_of(one.front(), [](const Rational& x) { return x != 0; });
    };
    const auto leading = std::ranges::find_if(found, is_leading);
    if (leading == found.end() || (l == 0 && found.size() > (root_ > 0 ? 2 : 1))) return false;
    data = *leading;
    solutions_ = std::move(found);
    return true;
  }

  Chain data;

 private:
  std::size_t rows(std::size_t l) const {
    return static_cast<std::size_t>(points_for(l, arity_)) * samples_.components();
  }

  /// Of the e_l of a candidate, with the r_i that are known, for all samples.
  Values defects(const Chain& candidate, std::size_t l) const {
    const Rational factor = power(Rational(arity_), -static_cast<long>(l));
    Values result = samples_.defects([&](long j) { return value_of(candidate, l, j); }, factor, points_for(l, arity_));
    for (std::size_t sample = 0; sample < shifts_.size(); ++sample)
      for (std::size_t i = 0; i < shifts_[sample].size(); ++i)
        if (shifts_[sample][i] != 0)
          subtract(result, sample, shifts_[sample][i] * power(Rational(arity_), -static_cast<long>(l - 1 - i)),
                   candidate, l, l - 1 - i);
    return result;
  }

  void subtract(Values& defects, std::size_t sample, const Rational& times, const Chain& candidate, std::size_t l,
                std::size_t degree) const {
    const std::size_t size = samples_.components();
    for (std::size_t row = 0; row < rows(l); row += size) {
      const Values value = value_of(candidate, degree, static_cast<long>(row / size));
      for (std::size_t c = 0; c < size; ++c) defects[sample * rows(l) + row + c] -= times * value[c];
    }
  }

  /// The solution with the y_0 of the last candidate, and the r_l of each sample but one, which become known. None of
  /// them where it is one without.
  std::optional<Chain> with_shifts(const std::vector<Chain>& candidates, const std::vector<Values>& columns,
                                   std::size_t l) {
    std::vector<Values> all(columns.begin(), columns.end() - 1);
    const std::size_t first = all.size(), fixed = samples_.regular();
    for (std::size_t sample = 0; sample < samples_.count(); ++sample)
      if (sample != fixed) subtract(all.emplace_back(columns.front().size()), sample, 1, candidates.back(), l, 0);
    all.push_back(columns.back());
    for (Values weights : kernel(from_columns(all, all.front().size()))) {
      const Rational scale = weights.back();
      if (scale == 0) continue;
      for (Rational& weight : weights) weight /= scale;
      auto shift = weights.begin() + static_cast<std::ptrdiff_t>(first);
      for (std::size_t sample = 0; sample < samples_.count(); ++sample)
        shifts_[sample].push_back(sample == fixed ? Rational(0) : *shift++);
      weights[first] = 1;  // of the last candidate
      return combined(candidates, weights);
    }
    return std::nullopt;
  }

  const Samples& samples_;
  int arity_;
  long root_;
  std::vector<Chain> solutions_;  // a basis of all y_0, ..., y_{l-1}; that of `data` first
  std::vector<Values> shifts_;    // a^-1 r_1, a^-2 r_2, ... times the denominator, sample by sample
};

}  // namespace

std::vector<Values> PolynomialData::at(long j) const {
  std::vector<Values> result;
  for (std::size_t l = 0; l < data.size(); ++l) result.push_back(value_of(data, l, j));
  for (std::size_t l = 0; root > 0 && l < data.size(); ++l) result.push_back(times_root(result[l], root));
  return result;
}

PolynomialData kept_polynomials(const std::vector<ParametricMask>& masks, long root) {
  const Samples samples(masks);
  const ParametricMask& first = masks.front();
  // As many data as there are on the support of the functions.
  const std::size_t size = first.components() / (root > 0 ? 2 : 1);
  const std::size_t most = size * static_cast<std::size_t>(1 + (samples.support().last - samples.support().first) /
                                                                   (first.arity() - 1));
  PolynomialData result{hermite_data(samples, first.arity(), most, root)};
  result.root = root;
  result.hermite = result.data.size() >= size;
  if (result.hermite) {
    result.interpolating = samples.interpolate(first, size);
    return result;
  }
  OtherData other(samples, first.arity(), root);
  while (other.data.size() < most && other.add()) continue;
  result.data = std::move(other.data);
  return result;
}

PolynomialData kept_polynomials(const ParametricMask& mask, long root) {
  return kept_polynomials(std::vector{mask}, root);
}

}  // namespace subcert
