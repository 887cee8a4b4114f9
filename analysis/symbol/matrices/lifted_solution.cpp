#include "lifted_solution.hpp"

#include <subcert/analysis/symbol/numbers/flint.hpp>

#include <flint/nmod_mat.h>
#include <flint/ulong_extras.h>

namespace subcert {
namespace {

constexpr int most_primes = 3;
constexpr mp_limb_t first_prime_above = mp_limb_t{1} << 62;
constexpr int first_attempt = 8;        // steps
constexpr double attempt_factor = 1.4;  // of the steps between attempts

class Residues {
 public:
  Residues(std::size_t rows, std::size_t columns, mp_limb_t prime) {
    nmod_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns), prime);
  }
  Residues(const Residues&) = delete;
  Residues& operator=(const Residues&) = delete;
  ~Residues() { nmod_mat_clear(value_); }
  nmod_mat_struct* get() { return value_; }

 private:
  nmod_mat_t value_;
};

/// a x = b with rows multiplied so that they are integers.
class Lifting {
 public:
  Lifting(const RationalMatrix& a, const std::vector<Rational>& b)
      : size_(a.rows()), a_(size_, size_), b_(size_, 1), x_(size_, 1) {
    for (std::size_t i = 0; i < size_; ++i) {
      Integer common = denominator(b[i]);
      for (std::size_t j = 0; j < size_; ++j) common = lcm(common, denominator(a(i, j)));
      flint::set(b_.entry(i), numerator(b[i] * Rational(common)));
      for (std::size_t j = 0; j < size_; ++j) flint::set(a_.entry(i, j), numerator(a(i, j) * Rational(common)));
    }
  }

  std::optional<std::vector<Rational>> run(const Deadline& deadline) {
    mp_limb_t prime = first_prime_above;
    for (int k = 0; k < most_primes; ++k) {
      prime = n_nextprime(prime, 1);
      Residues inverse(size_, size_, prime);
      fmpz_mat_get_nmod_mat(inverse.get(), a_.get());
      if (deadline.expired()) return std::nullopt;
      if (nmod_mat_inv(inverse.get(), inverse.get())) return lift(inverse, prime, deadline);
    }
    return std::nullopt;
  }

 private:
  /// x modulo ever higher powers of the prime.
  std::optional<std::vector<Rational>> lift(Residues& inverse, mp_limb_t prime, const Deadline& deadline) {
    flint::WholeMatrix rest(size_, 1), digits(size_, 1), image(size_, 1);
    Residues rest_modulo(size_, 1, prime), digits_modulo(size_, 1, prime);
    fmpz_mat_set(rest.get(), b_.get());
    fmpz_one(modulus_.get());
    double attempt = first_attempt;
    for (int step = 1; !deadline.expired(); ++step) {
      fmpz_mat_get_nmod_mat(rest_modulo.get(), rest.get());
      nmod_mat_mul(digits_modulo.get(), inverse.get(), rest_modulo.get());
      fmpz_mat_set_nmod_mat_unsigned(digits.get(), digits_modulo.get());
      fmpz_mat_scalar_addmul_fmpz(x_.get(), digits.get(), modulus_.get());
      fmpz_mul_ui(modulus_.get(), modulus_.get(), prime);
      fmpz_mat_mul(image.get(), a_.get(), digits.get());
      fmpz_mat_sub(rest.get(), rest.get(), image.get());
      for (std::size_t i = 0; i < size_; ++i) fmpz_divexact_ui(rest.entry(i), rest.entry(i), prime);
      if (step < attempt) continue;
      attempt *= attempt_factor;
      if (auto solution = read_off(deadline)) return solution;
    }
    return std::nullopt;
  }

  /// The fractions of which x are the residues, over one denominator, where they are a solution.
  std::optional<std::vector<Rational>> read_off(const Deadline& deadline) {
    flint::WholeMatrix numerators(size_, 1), image(size_, 1), right(size_, 1);
    flint::Whole common, factor, residue;
    fmpz_one(common.get());
    for (std::size_t i = 0; i < size_; ++i) {
      if (deadline.expired()) return std::nullopt;
      fmpz_mul(residue.get(), x_.entry(i), common.get());
      fmpz_mod(residue.get(), residue.get(), modulus_.get());
      if (!_fmpq_reconstruct_fmpz(numerators.entry(i), factor.get(), residue.get(), modulus_.get()))
        return std::nullopt;
      fmpz_mul(common.get(), common.get(), factor.get());
      for (std::size_t k = 0; k < i && !fmpz_is_one(factor.get()); ++k)
        fmpz_mul(numerators.entry(k), numerators.entry(k), factor.get());
    }
    fmpz_mat_mul(image.get(), a_.get(), numerators.get());
    fmpz_mat_scalar_mul_fmpz(right.get(), b_.get(), common.get());
    if (!fmpz_mat_equal(image.get(), right.get())) return std::nullopt;
    std::vector<Rational> result;
    const Integer below = flint::to_integer(common.get());
    for (std::size_t i = 0; i < size_; ++i) result.emplace_back(flint::to_integer(numerators.entry(i)), below);
    return result;
  }

  std::size_t size_;
  flint::WholeMatrix a_, b_, x_;
  flint::Whole modulus_;
};

}  // namespace

std::optional<std::vector<Rational>> lifted_solution(const RationalMatrix& a, const std::vector<Rational>& b,
                                                     const Deadline& deadline) {
  require(a.rows() >= 1 && a.rows() == a.columns() && a.rows() == b.size(),
          "lifted_solution: need a square matrix and as many numbers, got {} x {} and {}", a.rows(), a.columns(),
          b.size());
  return Lifting(a, b).run(deadline);
}

}  // namespace subcert
