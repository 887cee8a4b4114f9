#include "family_radius.hpp"

#include <subcert/analysis/radii/joint/one_block.hpp>
#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/radii/polytope_proof/round_family.hpp>
#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace subcert::family {
namespace {

constexpr double form_seconds = 0.2;              // for one interval
constexpr std::size_t most_product_terms = 1500;  // of the polynomial of a product
constexpr double nearly_real = 1e-9;              // imaginary parts, relatively

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

Look look_at(const MatrixFamily& family, const Deadline& deadline) {
  const polytope::Candidate found = radius::find_product(family, deadline);
  return {found.written(), polytope::product_radius(radius::to_search_family(family).matrices, found.word)};
}

/// det(matrix_at(w)) as a polynomial in the first letters, with these sizes, for some values of the others; nothing
/// past the deadline.
std::optional<Powers<Rational>> determinant_in(const std::vector<std::size_t>& sizes, const Values& others,
                                               const std::function<RationalMatrix(const Values&)>& matrix_at,
                                               const Deadline& deadline) {
  const auto with = [&](const Rational& last) {
    Values values{last};
    values.insert(values.end(), others.begin(), others.end());
    return values;
  };
  const std::size_t size = sizes.back();
  if (sizes.size() == 1) {
    const auto polynomial = determinant([&](const Rational& w) { return matrix_at(with(w)); },
                                        static_cast<long>(size) - 1, deadline);
    return polynomial ? std::optional(in_powers(*polynomial, size)) : std::nullopt;
  }
  const std::vector<std::size_t> before(sizes.begin(), sizes.end() - 1);
  Values nodes;
  std::vector<Powers<Rational>> slices;
  for (std::size_t node = 0; node < size; ++node) {
    nodes.emplace_back(static_cast<long>(node));
    auto slice = determinant_in(before, with(nodes.back()), matrix_at, deadline);
    if (!slice) return std::nullopt;
    slices.push_back(std::move(*slice));
  }
  Powers<Rational> result{sizes, std::vector<Rational>(slices.front().entries.size() * size)};
  for (std::size_t at = 0; at < slices.front().entries.size(); ++at) {
    Values values;
    for (const Powers<Rational>& slice : slices) values.push_back(slice.entries[at]);
    const LaurentPolynomial last = interpolation(nodes, std::move(values));
    for (std::size_t k = 0; k < size; ++k)
      result.entries[at + k * slices.front().entries.size()] = last.coefficient(static_cast<long>(k));
  }
  return result;
}

}  // namespace

Look FamilyRadius::look(const Values& w, const Deadline& deadline) const { return look_at(family_.at(w), deadline); }

std::optional<JointSpectralRadius> FamilyRadius::from_above(const Box& box, const Rational& target, bool try_form,
                                                            const Budget& budget) const {
  const auto controls = family_.controls(box);
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

std::optional<JointSpectralRadius> FamilyRadius::from_above(const Box& box, double excess, const Budget& budget) const {
  const auto controls = family_.controls(box);
  if (!controls) return std::nullopt;
  const double near = look_at(*controls, budget.deadline).radius;
  return joint_spectral_radius(*controls, budget, largest_norm(*controls), Rational(near * (1 + excess)));
}

std::optional<EigenvalueBound> FamilyRadius::from_below(const Box& box, const std::vector<int>& word,
                                                        const Rational& least, bool sharp, const Deadline& deadline) {
  // Of one letter it is known that the denominator has no zero; of several it has none where there are controls.
  if (box.letters() > 1 && !family_.mask.controls(box)) return std::nullopt;
  for (EigenvalueBound& bound : guesses(box, word, least.convert_to<double>(), sharp)) {
    if (bound.modulus() < least) (bound.re == 0 ? bound.im : bound.re) = bound.re < 0 ? Rational(-least) : least;
    if (is_negative(bound, box, deadline)) return std::move(bound);
  }
  return std::nullopt;
}

/// Whether that is proved of the characteristic polynomial on the box: exactly for one letter, else by its Bernstein
/// coefficients.
bool FamilyRadius::is_negative(const EigenvalueBound& bound, const Box& box, const Deadline& deadline) {
  Powers<Rational> value = characteristic(bound, deadline);
  const bool is_odd = bound.re != 0 && family_.size() * bound.word.size() % 2 == 1;
  if (is_odd && value_at(family_.mask.denominators(), box.low) < 0)
    for (Rational& c : value.entries) c = -c;
  if (box.letters() == 1)
    return has_no_real_root(in_one_letter(value), box.low[0], box.high[0], deadline) && value_at(value, box.low) < 0;
  return std::ranges::all_of(bernstein(value, box, value.sizes).entries, [](const Rational& c) { return c < 0; });
}

/// Numbers that an odd number of eigenvalues exceed, as far as floating point tells from the corners and the middle.
std::vector<EigenvalueBound> FamilyRadius::guesses(const Box& box, const std::vector<int>& word, double least,
                                                   bool sharp) const {
  std::vector<polytope::Matrix> products{in_doubles(family_.at(box.middle()).product(word))};
  for (unsigned corner = 0; corner < box.corners(); ++corner)
    products.push_back(in_doubles(family_.at(box.corner(corner)).product(word)));
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
    if (second < first && box.letters() == 1) add(std::sqrt(first) * std::sqrt(second), 20);
  }
  if (sharp)
    std::stable_sort(result.begin(), result.end(),
                     [](const auto& a, const auto& b) { return a.modulus() > b.modulus(); });
  return result;
}

Powers<Rational> FamilyRadius::characteristic(const EigenvalueBound& bound, const Deadline& deadline) {
  const auto key = std::tuple(bound.word, bound.re, bound.im);
  {
    const std::scoped_lock lock(mutex_);
    if (const auto known = characteristics_.find(key); known != characteristics_.end()) return known->second;
  }
  const bool pair = bound.re == 0;
  const std::size_t n = family_.size(), size = pair ? n * (n - 1) / 2 : n;
  const std::size_t factors = bound.word.size() * (pair ? 2 : 1);
  std::vector<std::size_t> sizes = family_.mask.sizes();
  const Powers<Rational> zero{std::vector<std::size_t>(sizes.size(), 1), {0}};
  std::size_t terms = 1;
  for (std::size_t& one : sizes) {
    one = (one - 1) * size * factors + 1;
    if ((terms *= one) > most_product_terms) return zero;
  }
  const auto shifted = [&](const Values& w) {
    const RationalMatrix product = family_.numerators_at(w).product(bound.word);
    RationalMatrix result = Rational(bound.re < 0 ? 1 : -1) * (pair ? second_compound(product) : product);
    const Rational diagonal = (pair ? Rational(bound.im * bound.im) : bound.modulus()) *
                              power(value_at(family_.mask.denominators(), w), static_cast<long>(factors));
    for (std::size_t i = 0; i < size; ++i) result(i, i) += diagonal;
    return result;
  };
  auto result = determinant_in(sizes, {}, shifted, deadline);
  if (!result) return zero;
  const std::scoped_lock lock(mutex_);
  return characteristics_.emplace(key, std::move(*result)).first->second;
}

}  // namespace subcert::family
