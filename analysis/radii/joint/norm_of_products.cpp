#include "norm_of_products.hpp"

#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/numbers/flint.hpp>

#include <algorithm>
#include <cmath>

namespace subcert {
namespace {

constexpr std::size_t most_products = 512;
constexpr double most_work = 4e7;  // products of limbs, for one length; larger families have better bounds than norms
constexpr int longest = 24;

/// Products of one length, times a power of the common denominator.
class Products {
 public:
  explicit Products(const MatrixFamily& family) : unit_(common_denominator(family)), denominator_(unit_) {
    const std::size_t n = family.size();
    for (const RationalMatrix& matrix : family) {
      const std::vector<Integer> entries = integer_multiple(matrix, unit_);
      letters_.emplace_back(n, n);
      for (std::size_t k = 0; k < entries.size(); ++k) flint::set(letters_.back().entry(k / n, k % n), entries[k]);
      products_.emplace_back(n, n);
      fmpz_mat_set(products_.back().get(), letters_.back().get());
    }
  }

  /// One letter longer; false where the deadline passes first.
  bool lengthen(const Deadline& deadline) {
    const auto n = static_cast<std::size_t>(letters_.front().get()->r);
    std::vector<flint::WholeMatrix> longer;
    for (const flint::WholeMatrix& product : products_)
      for (const flint::WholeMatrix& letter : letters_) {
        if (deadline.expired()) return false;
        longer.emplace_back(n, n);
        fmpz_mat_mul(longer.back().get(), product.get(), letter.get());
      }
    products_ = std::move(longer);
    denominator_ *= unit_;
    return true;
  }

  /// The largest sum of absolute values in a column.
  Rational norm() const {
    flint::Whole most, sum, size;
    for (const flint::WholeMatrix& product : products_)
      for (slong j = 0; j < product.get()->c; ++j) {
        fmpz_zero(sum.get());
        for (slong i = 0; i < product.get()->r; ++i) {
          fmpz_abs(size.get(), fmpz_mat_entry(product.get(), i, j));
          fmpz_add(sum.get(), sum.get(), size.get());
        }
        if (fmpz_cmp(sum.get(), most.get()) > 0) fmpz_set(most.get(), sum.get());
      }
    return Rational(flint::to_integer(most.get()), denominator_);
  }

  std::size_t count() const { return products_.size(); }

  /// Of an entry, at most.
  std::size_t limbs() const {
    slong bits = 0;
    for (const flint::WholeMatrix& product : products_)
      bits = std::max(bits, std::abs(fmpz_mat_max_bits(product.get())));
    return static_cast<std::size_t>(bits) / FLINT_BITS + 1;
  }

 private:
  Integer unit_, denominator_;
  std::vector<flint::WholeMatrix> letters_, products_;
};

}  // namespace

NormProof norm_of_products(const MatrixFamily& family, const Budget& budget, std::size_t count) {
  const Deadline end = budget.deadline.later(schedule::grace_of_norms);
  const auto entries = static_cast<double>(family.size() * family.size());
  const std::size_t letters = std::max(count, family.count());
  Products products(family);
  std::size_t words = letters;
  NormProof best;
  Rational best_bound = 0;
  for (int level = 1;; ++level) {
    NormProof proof{level, products.norm()};
    const Rational bound = proof.bound();
    if (level == 1 || bound < best_bound) {
      best = proof;
      best_bound = bound;
    }
    words *= letters;
    const double numbers = static_cast<double>(products.count() * family.count()) * entries,
                 limbs = static_cast<double>(products.limbs());
    if (proof.norm == 0 || words > most_products || level >= longest ||
        numbers * static_cast<double>(family.size()) * limbs > most_work ||
        numbers * (limbs + 1) * sizeof(limbs) > static_cast<double>(budget.memory) / 2 || !products.lengthen(end))
      return best;
  }
}

}  // namespace subcert
