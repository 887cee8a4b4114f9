#include "joint_spectral_radius.hpp"

#include "exact_radius.hpp"
#include "polytope/decompositions.hpp"

#include <subcert/analysis/symbol/balls.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace subcert {
namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<80>, boost::multiprecision::et_off>;

const Rational rounding = power(Rational(10), -15);

Eigen::MatrixXd to_double(const RationalMatrix& m) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(m.rows()), static_cast<Eigen::Index>(m.columns()));
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = m(i, j).convert_to<double>();
  return result;
}

/// J M_t J = M_{count-1-t} for the reversal J of the coordinates.
bool is_flip_symmetric(const std::vector<RationalMatrix>& matrices) {
  const std::size_t n = matrices.front().rows(), count = matrices.size();
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (matrices[t](i, j) != matrices[count - 1 - t](n - 1 - i, n - 1 - j)) return false;
  return true;
}

RationalMatrix product_of(const std::vector<RationalMatrix>& matrices, const std::vector<int>& word) {
  RationalMatrix product = matrices[static_cast<std::size_t>(word.front())];
  for (std::size_t k = 1; k < word.size(); ++k) product = product * matrices[static_cast<std::size_t>(word[k])];
  return product;
}

template <class Number>
struct Gaussian {
  Number re, im;
};

/// p and p' at a Gaussian number, by Horner.
template <class Number, class Coefficients>
std::pair<Gaussian<Number>, Gaussian<Number>> evaluate(const Coefficients& coefficients, const Gaussian<Number>& z) {
  Gaussian<Number> value{0, 0}, slope{0, 0};
  const auto times_z = [&z](const Gaussian<Number>& x) -> Gaussian<Number> {
    return {Number(x.re * z.re - x.im * z.im), Number(x.re * z.im + x.im * z.re)};
  };
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
    slope = times_z(slope);
    slope.re += value.re;
    slope.im += value.im;
    value = times_z(value);
    value.re += *c;
  }
  return {value, slope};
}

Rational to_dyadic(const Real& value) {
  constexpr int bits = 200;
  return Rational(Integer(round(ldexp(value, bits))), Integer(1) << bits);
}

Rational squared_modulus(const Gaussian<Rational>& z) { return z.re * z.re + z.im * z.im; }

std::vector<Rational> coefficients_of(const LaurentPolynomial& p) {
  std::vector<Rational> result(static_cast<std::size_t>(p.highest()) + 1);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = p.coefficient(static_cast<long>(k));
  return result;
}

/// A fraction with a small denominator next to the number, by its continued fraction; nothing to trust.
std::optional<Rational> near_fraction(Real value) {
  static const Real tiny("1e-55"), large("1e20");
  Integer num = 1, den = 0, last_num = 0, last_den = 1;
  const Real target = value;
  for (int k = 0; k < 60; ++k) {
    const Real whole = floor(value);
    if (abs(whole) > large) return std::nullopt;
    const Integer a(whole);
    std::tie(num, last_num) = std::pair(Integer(a * num + last_num), num);
    std::tie(den, last_den) = std::pair(Integer(a * den + last_den), den);
    if (Real(den) > large) return std::nullopt;
    if (abs(target - Real(num) / Real(den)) < tiny * (1 + abs(target))) return Rational(num, den);
    value = 1 / (value - whole);
  }
  return std::nullopt;
}

/// Whether all zeros of p but root and -root are smaller in modulus.
bool is_largest_root(const LaurentPolynomial& p, const Rational& root) {
  LaurentPolynomial rest = p;
  for (const Rational& r : {root, Rational(-root)})
    while (rest.length() > 1 && rest(r) == 0) rest = *rest.exact_quotient(LaurentPolynomial({-r, 1}, 0));
  return *largest_root_modulus(rest).largest.upper < abs(root);
}

Rational one_norm(const RationalMatrix& m) {
  Rational most = 0;
  for (std::size_t j = 0; j < m.columns(); ++j) {
    Rational sum = 0;
    for (std::size_t i = 0; i < m.rows(); ++i) sum += abs(m(i, j));
    most = std::max(most, sum);
  }
  return most;
}

/// The best root of a largest norm over all products of one length, for short lengths.
KnownNorm norm_of_products(const std::vector<RationalMatrix>& matrices) {
  std::vector<RationalMatrix> products = matrices;
  KnownNorm best{1, 0};
  Rational best_bound = 0;
  for (int level = 1;; ++level) {
    Rational most = 0;
    for (const RationalMatrix& product : products) most = std::max(most, one_norm(product));
    const Rational bound = *root_enclosure(most, level).upper;
    if (level == 1 || bound < best_bound) {
      best = {level, most};
      best_bound = bound;
    }
    if (most == 0 || products.size() * matrices.size() > 512 || level >= 24) return best;
    std::vector<RationalMatrix> longer;
    for (const RationalMatrix& product : products)
      for (const RationalMatrix& m : matrices) longer.push_back(product * m);
    products = std::move(longer);
  }
}

void check(const std::vector<RationalMatrix>& matrices, double seconds) {
  const auto fail = [](const std::string& what) { throw std::invalid_argument("joint_spectral_radius: need " + what); };
  if (matrices.empty() || matrices.size() > 64) fail("1 to 64 matrices, got " + std::to_string(matrices.size()));
  const std::size_t n = matrices.front().rows();
  if (n < 1 || n > 256) fail("matrices of size 1 to 256, got " + std::to_string(n));
  for (const RationalMatrix& m : matrices)
    if (m.rows() != n || m.columns() != n) fail("square matrices of one size");
  if (!(seconds > 0)) fail("seconds > 0");
}

}  // namespace

ProductEvidence prove_product(const std::vector<RationalMatrix>& matrices, const std::vector<int>& word) {
  ProductEvidence evidence{word, 0, 0, Enclosure::at_least(0), std::nullopt};
  const RationalMatrix product = product_of(matrices, word);
  const LaurentPolynomial p = characteristic_polynomial(product);
  const std::vector<Rational> coefficients = coefficients_of(p);

  const Eigen::VectorXcd eigenvalues = detail::eigenvalues(to_double(product));
  Eigen::Index leading = 0;
  for (Eigen::Index k = 0; k < eigenvalues.size(); ++k)
    if (std::abs(eigenvalues[k]) > std::abs(eigenvalues[leading]) * (1 + 1e-12)) leading = k;
  if (std::abs(eigenvalues[leading]) == 0) return evidence;

  // Multiple eigenvalues are found as simple zeros of the squarefree part.
  const LaurentPolynomial nonzero = p.shifted(-p.lowest());
  const LaurentPolynomial squarefree = *nonzero.exact_quotient(gcd(nonzero, nonzero.derivative()));
  if (squarefree.length() == 1) return evidence;
  std::vector<Real> real_coefficients;
  for (const Rational& c : coefficients_of(squarefree))
    real_coefficients.push_back(Real(numerator(c)) / Real(denominator(c)));
  // A multiple real eigenvalue may come out as a pair that is off by the root of the rounding.
  const double imaginary = std::abs(eigenvalues[leading].imag());
  const bool multiple = squarefree.length() < nonzero.length();
  const bool real = imaginary <= (multiple ? 1e-6 : 1e-12) * std::abs(eigenvalues[leading]);
  Gaussian<Real> z{eigenvalues[leading].real(), real ? 0 : imaginary};
  for (int k = 0; k < 16; ++k) {  // Newton
    const auto [value, slope] = evaluate(real_coefficients, z);
    const Real square = slope.re * slope.re + slope.im * slope.im;
    if (square == 0) break;
    z.re -= (value.re * slope.re + value.im * slope.im) / square;
    z.im -= (value.im * slope.re - value.re * slope.im) / square;
  }
  Gaussian<Rational> c{to_dyadic(z.re), to_dyadic(z.im)};
  const auto fraction = real ? near_fraction(z.re) : std::nullopt;
  const bool rational = fraction && *fraction != 0 && p(*fraction) == 0;
  if (rational) c = {*fraction, 0};
  auto [value, slope] = evaluate(coefficients, c);
  if (squarefree.length() < nonzero.length() && squared_modulus(slope) == 0) {
    c.re += power(Rational(2), -200);
    std::tie(value, slope) = evaluate(coefficients, c);
  }
  evidence.re = c.re;
  evidence.im = c.im;
  if (squared_modulus(slope) == 0) return evidence;
  const Rational distance = static_cast<long>(matrices.front().rows()) *
                            *root_enclosure(squared_modulus(value) / squared_modulus(slope), 2).upper;
  const Enclosure modulus = root_enclosure(squared_modulus(c), 2);
  const int length = static_cast<int>(word.size());
  const Rational low = *modulus.lower - distance;
  if (low > 0)
    evidence.radius = {root_enclosure(low, length).lower, root_enclosure(*modulus.upper + distance, length).upper};
  if (rational && is_largest_root(p, *fraction)) {
    const Enclosure exact = root_enclosure(abs(*fraction), length);
    if (exact.is_exact()) evidence.exact = exact.lower;
  }
  return evidence;
}

namespace {

void set_closed(JointSpectralRadius& result) {
  result.closed = *result.radius.upper <= *result.radius.lower * (1 + 1000 * rounding);
}

/// Whether rho(second)^(1/length) <= rho(first)^(1/length'), exactly, for products over two families: all leading
/// eigenvalues of a common power of the second are among those of the first, or smaller.
bool is_dominated(const std::vector<RationalMatrix>& first, const ProductEvidence& above,
                  const std::vector<RationalMatrix>& second, const ProductEvidence& below) {
  const std::size_t common = 2 * std::lcm(above.word.size(), below.word.size());
  if (common > 64) return false;
  const auto power_of = [common](const std::vector<RationalMatrix>& family, const std::vector<int>& word) {
    std::vector<int> repeated;
    while (repeated.size() < common) repeated.insert(repeated.end(), word.begin(), word.end());
    return characteristic_polynomial(product_of(family, repeated));
  };
  const LaurentPolynomial p = power_of(first, above.word);
  LaurentPolynomial rest = power_of(second, below.word);
  rest = rest.shifted(-rest.lowest());
  for (;;) {
    const LaurentPolynomial shared = gcd(rest, p);
    if (shared.length() == 1) break;
    rest = *rest.exact_quotient(shared);
  }
  const Rational bound = power(*above.radius.lower, static_cast<long>(common));
  return *largest_root_modulus(rest).largest.upper <= bound;
}

/// Whether all maximizing products of the search have the radius of the first, exactly.
bool have_equal_radii(const std::vector<RationalMatrix>& matrices, const SearchResult& search,
                      const ProductEvidence& first) {
  for (std::size_t k = 1; k < search.maximizing; ++k) {
    std::vector<int> word = search.products[k].word;
    if (!search.transposed) std::reverse(word.begin(), word.end());
    const ProductEvidence other = prove_product(matrices, word);
    if (!is_dominated(matrices, first, matrices, other) || !is_dominated(matrices, other, matrices, first))
      return false;
  }
  return true;
}

/// Without looking for invariant subspaces.
JointSpectralRadius radius_of_family(const std::vector<RationalMatrix>& matrices, double seconds,
                                     const std::optional<KnownNorm>& known) {
  const bool symmetric = is_flip_symmetric(matrices);
  SearchFamily family;
  for (const RationalMatrix& m : matrices) family.matrices.push_back(to_double(m));
  family.flip_symmetric = symmetric;
  SearchOptions options;
  options.seconds = seconds;
  const SearchResult search = search_polytope(family, options);

  JointSpectralRadius result;
  // The word of the search lists the matrix applied first; its transposed words are the other way round already.
  std::vector<int> word = search.products.front().word;
  if (!search.transposed) std::reverse(word.begin(), word.end());
  result.product = prove_product(matrices, word);
  result.radius.lower = result.product.radius.lower;
  result.polytope = certify_polytope(matrices, symmetric, search);

  const KnownNorm norm = known ? *known : norm_of_products(matrices);
  const Rational norm_bound = *root_enclosure(norm.norm, norm.level).upper;
  // Of two bounds that differ by rounding only, the polytope is the shorter proof.
  if (result.polytope && result.polytope->bound < norm_bound * (1 + rounding)) {
    result.method = JsrMethod::invariant_polytope;
    result.certified_upper = result.polytope->bound;
    result.vertices = result.polytope->vertices.size();
  } else {
    result.method = JsrMethod::norm_of_products;
    result.certified_upper = norm_bound;
    result.norm_level = norm.level;
    result.polytope.reset();
  }
  result.radius.upper = result.certified_upper;
  if (*result.radius.upper == *result.radius.lower)
    result.exact = {Truth::yes, "both ends of the enclosure are the same number"};
  else if (result.method != JsrMethod::invariant_polytope || *result.radius.lower <= 0)
    result.exact = {Truth::unknown, "no polytope closed"};
  else if (search.status == SearchStatus::closed && !have_equal_radii(matrices, search, result.product))
    result.exact = {Truth::unknown,
                    "several products seem to attain the radius, but their radii were not proved equal"};
  else
    result.exact = product_attains_radius(matrices, search, *result.polytope, *result.radius.lower);
  if (result.exact.is_yes()) {
    if (result.product.exact) result.radius = Enclosure::exactly(*result.product.exact);
    // A norm that no matrix expands by more than the radius.
    result.growth.at_most = 0;
  }
  set_closed(result);
  return result;
}

/// The largest modulus of numbers.
JointSpectralRadius radius_of_numbers(const std::vector<RationalMatrix>& matrices) {
  std::size_t best = 0;
  for (std::size_t t = 1; t < matrices.size(); ++t)
    if (abs(matrices[t](0, 0)) > abs(matrices[best](0, 0))) best = t;
  const Rational& number = matrices[best](0, 0);
  JointSpectralRadius result;
  result.product = {{static_cast<int>(best)}, number, 0, Enclosure::exactly(abs(number)), abs(number)};
  result.radius = Enclosure::exactly(abs(number));
  result.certified_upper = abs(number);
  result.method = JsrMethod::norm_of_products;
  result.norm_level = 1;
  result.exact = {Truth::yes, "the largest modulus of numbers"};
  result.growth.at_most = 0;
  result.closed = true;
  return result;
}

/// A quick look at a family: a product, and norms.
JointSpectralRadius first_look(const std::vector<RationalMatrix>& matrices, double seconds) {
  SearchFamily family;
  for (const RationalMatrix& m : matrices) family.matrices.push_back(to_double(m));
  const auto candidates = search_products(family, {8, 12, seconds, 5e-3});
  std::vector<int> word = candidates.front().word;
  std::reverse(word.begin(), word.end());
  const KnownNorm norm = norm_of_products(matrices);
  JointSpectralRadius result;
  result.product = prove_product(matrices, word);
  result.certified_upper = *root_enclosure(norm.norm, norm.level).upper;
  result.radius = {*result.product.radius.lower, result.certified_upper};
  result.method = JsrMethod::norm_of_products;
  result.norm_level = norm.level;
  result.exact = {Truth::unknown, "only norms were computed"};
  set_closed(result);
  return result;
}

/// The size of the largest Jordan block of the leading eigenvalue of a product, less 1; 0 where that is not decided.
int jordan_power_of_product(const std::vector<RationalMatrix>& matrices, const std::vector<int>& word) {
  const RationalMatrix product = product_of(matrices, word);
  const auto factors = irreducible_factors(characteristic_polynomial(product));
  std::vector<Enclosure> moduli;
  std::size_t leading = 0;
  for (const PolynomialFactor& factor : factors) {
    moduli.push_back(largest_root_modulus(factor.polynomial).largest);
    if (*moduli.back().lower > *moduli[leading].lower) leading = moduli.size() - 1;
  }
  for (std::size_t i = 0; i < moduli.size(); ++i)
    if (i != leading && *moduli[i].upper >= *moduli[leading].lower) return 0;
  const LaurentPolynomial& f = factors[leading].polynomial;
  RationalMatrix value(product.rows(), product.rows());
  for (long k = f.highest(); k >= 0; --k) {
    value = value * product;
    for (std::size_t i = 0; i < value.rows(); ++i) value(i, i) += f.coefficient(k);
  }
  RationalMatrix repeated = value;
  int size = 1;
  for (std::size_t nullity = kernel(value).size();; ++size) {
    repeated = repeated * value;
    const std::size_t next = kernel(repeated).size();
    if (next == nullity) return size - 1;
    nullity = next;
  }
}

/// The radii of all diagonal blocks, as sharp as the largest needs them.
class BlockSearch {
 public:
  BlockSearch(const BlockTriangular& triangular, double seconds) : start_(Clock::now()), seconds_(seconds) {
    for (std::size_t k = 0; k < triangular.sizes.size(); ++k) {
      families_.push_back(triangular.block(k));
      const bool number = triangular.sizes[k] == 1;
      radii_.push_back(number ? radius_of_numbers(families_[k]) : first_look(families_[k], 0.02 * seconds));
      best_ = std::max(best_, *radii_[k].radius.lower);
      if (!number) open_.push_back(k);
    }
    // A large lower bound spares work for the others.
    std::sort(open_.begin(), open_.end(),
              [this](std::size_t a, std::size_t b) { return *radii_[a].radius.lower > *radii_[b].radius.lower; });
  }

  void run() {
    double work = 0;
    for (const std::size_t k : open_) work += cost(k);
    for (const std::size_t k : open_) {
      const double share = std::max(0.05 * seconds_, (seconds_ - elapsed()) * cost(k) / work);
      work -= cost(k);
      improve(k, share);
    }
  }

  const std::vector<std::vector<RationalMatrix>>& families() const { return families_; }
  std::vector<JointSpectralRadius>& radii() { return radii_; }

 private:
  using Clock = std::chrono::steady_clock;
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double cost(std::size_t k) const {
    return static_cast<double>(families_[k].front().rows() * families_[k].front().rows());
  }

  void improve(std::size_t k, double share) {
    const double begin = elapsed();
    const bool smaller = *radii_[k].radius.lower < best_ * (1 - rounding);
    // A block that seems smaller only has to get below the best lower bound: ever longer searches.
    for (double slice = smaller ? std::min(0.05, share) : share; !is_settled(k); slice *= 2) {
      const double left = share - (elapsed() - begin);
      if (left <= 0) break;
      JointSpectralRadius found = radius_of_family(families_[k], std::min(slice, left), std::nullopt);
      if (found.exact.is_yes() || found.certified_upper < radii_[k].certified_upper) radii_[k] = std::move(found);
      best_ = std::max(best_, *radii_[k].radius.lower);
      if (radii_[k].closed) break;
    }
  }

  bool is_settled(std::size_t k) const {
    return radii_[k].certified_upper < best_ || (*radii_[k].radius.lower < best_ && radii_[k].certified_upper <= best_);
  }

  Clock::time_point start_;
  double seconds_;
  std::vector<std::vector<RationalMatrix>> families_;
  std::vector<JointSpectralRadius> radii_;
  std::vector<std::size_t> open_;
  Rational best_ = 0;
};

/// Whether the product of the leading block attains the radius of the family, and how fast its products grow.
void settle_exactness(JointSpectralRadius& result, const std::vector<RationalMatrix>& matrices,
                      const std::vector<std::vector<RationalMatrix>>& families) {
  const JointSpectralRadius& leader = result.blocks[result.leading_block];
  result.exact = leader.exact;
  if (!leader.exact.is_yes()) return;
  int equal = 1;
  bool growth_known = leader.growth.at_most == 0;
  for (std::size_t k = 0; k < families.size(); ++k) {
    const JointSpectralRadius& other = result.blocks[k];
    if (k == result.leading_block || other.certified_upper < *leader.radius.lower) continue;
    const bool both_exact = leader.radius.is_exact() && *other.radius.upper <= *leader.radius.lower;
    if (!both_exact && !(other.exact.is_yes() &&
                         is_dominated(families[result.leading_block], leader.product, families[k], other.product))) {
      result.exact = {Truth::unknown, "two blocks have radii that could not be compared exactly"};
      return;
    }
    ++equal;
    growth_known = growth_known && other.growth.at_most == 0;
  }
  if (leader.radius.is_exact()) result.radius = leader.radius;
  if (growth_known) result.growth.at_most = equal - 1;
  if (equal > 1 && *leader.radius.lower > 0)
    result.growth.at_least = jordan_power_of_product(matrices, leader.product.word);
}

JointSpectralRadius radius_by_blocks(const std::vector<RationalMatrix>& matrices, BlockTriangular triangular,
                                     double seconds, const std::optional<KnownNorm>& known) {
  BlockSearch search(triangular, seconds);
  search.run();
  JointSpectralRadius result;
  result.triangular = std::move(triangular);
  result.blocks = std::move(search.radii());
  result.certified_upper = 0;
  const auto lower_of = [&](std::size_t k) { return *result.blocks[k].radius.lower; };
  for (std::size_t k = 0; k < result.blocks.size(); ++k) {
    const JointSpectralRadius& block = result.blocks[k];
    const bool larger = lower_of(k) > lower_of(result.leading_block);
    const bool sharper = lower_of(k) == lower_of(result.leading_block) && block.exact.is_yes() &&
                         !result.blocks[result.leading_block].exact.is_yes();
    if (larger || sharper) result.leading_block = k;
    result.certified_upper = std::max(result.certified_upper, block.certified_upper);
    result.vertices += block.vertices;
  }
  const JointSpectralRadius& leader = result.blocks[result.leading_block];
  result.product = leader.product;
  result.method = leader.method;
  result.radius = {*leader.radius.lower, result.certified_upper};
  settle_exactness(result, matrices, search.families());
  set_closed(result);
  if (result.closed) return result;
  const KnownNorm norm = known ? *known : norm_of_products(matrices);
  const Rational norm_bound = *root_enclosure(norm.norm, norm.level).upper;
  if (norm_bound < result.certified_upper) {
    JointSpectralRadius whole;
    whole.product = prove_product(matrices, leader.product.word);
    whole.certified_upper = norm_bound;
    whole.radius = {*whole.product.radius.lower, norm_bound};
    whole.method = JsrMethod::norm_of_products;
    whole.norm_level = norm.level;
    whole.exact = {Truth::unknown, "no polytope closed"};
    set_closed(whole);
    return whole;
  }
  return result;
}

}  // namespace

JointSpectralRadius joint_spectral_radius(const std::vector<RationalMatrix>& matrices, double seconds,
                                          const std::optional<KnownNorm>& known) {
  check(matrices, seconds);
  if (matrices.front().rows() == 1) return radius_of_numbers(matrices);
  const auto start = std::chrono::steady_clock::now();
  BlockTriangular triangular = block_triangularise(matrices, 0.2 * seconds);
  const double left = seconds - std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double rest = std::max(left, 0.1 * seconds);
  if (triangular.sizes.size() == 1) return radius_of_family(matrices, rest, known);
  return radius_by_blocks(matrices, std::move(triangular), rest, known);
}

}  // namespace subcert
