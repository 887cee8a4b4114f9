#include "family_radius.hpp"

#include <subcert/analysis/regularity/polytope_proof/candidate.hpp>
#include <subcert/analysis/regularity/polytope_proof/round_family.hpp>
#include <subcert/analysis/regularity/polytope_search/decompositions.hpp>
#include <subcert/analysis/regularity/radius/one_block.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::family {
namespace {

constexpr double form_seconds = 0.2;  // for one interval
constexpr long most_terms = 1500;     // of the polynomial of a product
constexpr double nearly_real = 1e-9;  // imaginary parts, relatively

/// Kinds of eigenvalue bounds.
enum class Side { positive, negative, pair };

polytope::Matrix in_doubles(const RationalMatrix& matrix) {
  return radius::to_search_family({matrix}).matrices.front();
}

/// The real eigenvalues above 0, largest first: of the product, of its negative, or of its second compound.
std::vector<double> positive_eigenvalues(const polytope::Matrix& product, Side side) {
  std::vector<std::complex<double>> values;
  for (const std::complex<double>& value : polytope::eigenvalues(product)) values.push_back(value);
  if (side == Side::pair) {
    std::vector<std::complex<double>> products;
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t j = i + 1; j < values.size(); ++j) products.push_back(values[i] * values[j]);
    values = std::move(products);
  }
  std::vector<double> result;
  for (const std::complex<double>& value : values) {
    const double real = side == Side::negative ? -value.real() : value.real();
    if (real > 0 && std::abs(value.imag()) < nearly_real * std::abs(value)) result.push_back(real);
  }
  std::sort(result.rbegin(), result.rend());
  return result;
}

/// A number with few digits, below the value but near to it.
Rational rounded_down(double value, int bits) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return Rational(std::ldexp(std::floor(std::ldexp(fraction, bits)), exponent - bits));
}

/// The bound by single matrices, which costs nothing.
NormProof largest_norm(const MatrixFamily& family) {
  NormProof proof{1, 0};
  for (const RationalMatrix& matrix : family) proof.norm = std::max(proof.norm, one_norm(matrix));
  return proof;
}

}  // namespace

Look look_at(const MatrixFamily& family, const Deadline& deadline) {
  Look result{radius::find_product(family, deadline), 0};
  // From left to right here, the letter applied first there.
  const std::vector<int> word(result.word.rbegin(), result.word.rend());
  result.radius = polytope::product_radius(radius::to_search_family(family).matrices, word);
  return result;
}

std::optional<JointSpectralRadius> radius_below(const std::optional<MatrixFamily>& controls, const Rational& target,
                                                bool try_form, const Budget& budget) {
  if (!controls || look_at(*controls, budget.deadline).radius >= target.convert_to<double>()) return std::nullopt;
  if (try_form) {
    auto form = radius::quadratic_bound(*controls, target, {budget.deadline.at_most(form_seconds), budget.memory});
    if (form && form->bound < target) {
      JointSpectralRadius result;
      result.radius = {0, form->bound};
      result.proof = std::move(*form);
      return result;
    }
  }
  JointSpectralRadius result = joint_spectral_radius(*controls, budget, largest_norm(*controls), target);
  if (result.proved_upper() < target) return result;
  return std::nullopt;
}

Look FamilyRadius::look(const Rational& w, const Deadline& deadline) const { return look_at(family_.at(w), deadline); }

std::optional<JointSpectralRadius> FamilyRadius::from_above(const Segment& segment, const Rational& target,
                                                            bool try_form, const Budget& budget) const {
  return radius_below(family_.controls(segment.low, segment.high), target, try_form, budget);
}

std::optional<JointSpectralRadius> FamilyRadius::from_above(const Segment& segment, double excess,
                                                            const Budget& budget) const {
  const auto controls = family_.controls(segment.low, segment.high);
  if (!controls) return std::nullopt;
  const double near = look_at(*controls, budget.deadline).radius;
  return joint_spectral_radius(*controls, budget, largest_norm(*controls), Rational(near * (1 + excess)));
}

std::optional<EigenvalueBound> FamilyRadius::from_below(const Segment& segment, const std::vector<int>& word,
                                                        const Rational& least, bool sharp, const Deadline& deadline) {
  for (EigenvalueBound& bound : guesses(segment, word, least.convert_to<double>(), sharp)) {
    if (bound.modulus() < least) (bound.re == 0 ? bound.im : bound.re) = bound.re < 0 ? Rational(-least) : least;
    const LaurentPolynomial value = characteristic(bound, deadline);
    if (has_no_real_root(value, segment.low, segment.high, deadline) && value(segment.low) < 0) return std::move(bound);
  }
  return std::nullopt;
}

/// Numbers that an odd number of eigenvalues exceed, as far as floating point tells from the ends and the middle.
std::vector<EigenvalueBound> FamilyRadius::guesses(const Segment& segment, const std::vector<int>& word, double least,
                                                   bool sharp) const {
  std::vector<polytope::Matrix> products;
  for (const Rational& w : {segment.low, segment.middle(), segment.high})
    products.push_back(in_doubles(family_.at(w).product(word)));
  std::vector<EigenvalueBound> result;
  for (const Side side : {Side::positive, Side::negative, Side::pair}) {
    const double floor = side == Side::pair ? least * least : least;
    double first = INFINITY, second = floor;
    bool odd = true;
    for (const polytope::Matrix& product : products) {
      const std::vector<double> values = positive_eigenvalues(product, side);
      first = std::min(first, values.empty() ? 0 : values[0]);
      if (values.size() > 1) second = std::max(second, values[1]);
      odd = odd && std::count_if(values.begin(), values.end(), [=](double value) { return value > floor; }) % 2 == 1;
    }
    if (!(first > floor)) continue;
    const auto add = [&](double value, int bits) {
      const Rational number = rounded_down(side == Side::pair ? std::sqrt(value) : value, bits);
      result.push_back({word, 0, 0});
      (side == Side::pair ? result.back().im : result.back().re) = side == Side::negative ? Rational(-number) : number;
    };
    if (sharp)
      for (const double slack : {1e-9, 1e-4}) add(first * (1 - slack), 40);
    else if (odd)
      add(floor / 2, 20);  // `least` itself
    if (second < first) add(std::sqrt(first) * std::sqrt(second), 20);
  }
  if (sharp)
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& a, const auto& b) { return a.modulus() > b.modulus(); });
  return result;
}

LaurentPolynomial FamilyRadius::characteristic(const EigenvalueBound& bound, const Deadline& deadline) {
  const auto key = std::tuple(bound.word, bound.re, bound.im);
  {
    const std::scoped_lock lock(mutex_);
    if (const auto known = characteristics_.find(key); known != characteristics_.end()) return known->second;
  }
  const bool pair = bound.re == 0;
  const std::size_t n = family_.size(), size = pair ? n * (n - 1) / 2 : n;
  const long factors = static_cast<long>(bound.word.size()) * (pair ? 2 : 1);
  const long degree = static_cast<long>(size) * factors * family_.degree;
  if (degree > most_terms) return {};
  const auto shifted = [&](const Rational& w) {
    const RationalMatrix product = family_.numerators_at(w).product(bound.word);
    RationalMatrix result = Rational(bound.re < 0 ? 1 : -1) * (pair ? second_compound(product) : product);
    const Rational diagonal = (pair ? Rational(bound.im * bound.im) : bound.modulus()) *
                              power(family_.denominator(w), factors);
    for (std::size_t i = 0; i < size; ++i) result(i, i) += diagonal;
    return result;
  };
  auto result = determinant(shifted, degree, deadline);
  if (!result) return {};
  const std::scoped_lock lock(mutex_);
  return characteristics_.emplace(key, std::move(*result)).first->second;
}

}  // namespace subcert::family
