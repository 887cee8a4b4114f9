#include "component.hpp"

#include "transition.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

using Residues = std::vector<std::uint64_t>;

/// Of numbers below the prime the inverse, by Fermat's theorem.
std::uint64_t inverse(std::uint64_t x) {
  std::uint64_t result = 1;
  for (std::uint64_t e = prime - 2; e > 0; e /= 2, x = x * x % prime)
    if (e % 2 == 1) result = result * x % prime;
  return result;
}

/// A space of functionals modulo the prime. Each row is 1 at its pivot, where all later ones are 0.
class Functionals {
 public:
  explicit Functionals(Arithmetic& arithmetic) : arithmetic_(arithmetic) {}

  const std::vector<Residues>& rows() const { return rows_; }

  void add(Residues x) {
    arithmetic_.spend(10 * x.size() * (rows_.size() + 2));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (const std::uint64_t factor = x[pivots_[i]]; factor != 0)
        for (std::size_t k = 0; k < x.size(); ++k) x[k] = (x[k] + (prime - factor) * rows_[i][k]) % prime;
    const auto pivot = std::ranges::find_if(x, [](std::uint64_t entry) { return entry != 0; });
    if (pivot == x.end()) return;
    pivots_.push_back(static_cast<std::size_t>(pivot - x.begin()));
    const std::uint64_t factor = inverse(*pivot);
    for (std::uint64_t& entry : x) entry = entry * factor % prime;
    rows_.push_back(std::move(x));
  }

 private:
  Arithmetic& arithmetic_;
  std::vector<Residues> rows_;
  std::vector<std::size_t> pivots_;
};

Residues residues(std::span<const mpz_class> numbers) {
  Residues result;
  for (const mpz_class& x : numbers) result.push_back(mpz_fdiv_ui(x.get_mpz_t(), prime));
  return result;
}

}  // namespace

void check_unobservable(const Component& component, const Vector& basis, std::size_t size, Arithmetic& arithmetic) {
  for (const Vector& reading : component.readings)
    for (std::size_t k = 0; k < component.unobservable; ++k) {
      mpz_class sum = 0;
      for (std::size_t i = 0; i < size; ++i) arithmetic.add_product(sum, reading[i], basis[k * size + i]);
      require(sum == 0, "the component shows what is said to be unobservable");
    }
}

void check_observable(const Component& component, const Family& family, Arithmetic& arithmetic) {
  const std::size_t size = family.size;
  arithmetic.spend(20 * family.entries.size());
  const Residues entries = residues(family.entries);  // column by column
  Functionals functionals(arithmetic);
  for (const Vector& reading : component.readings) functionals.add(residues(reading));
  for (std::size_t i = 0; i < functionals.rows().size(); ++i)
    for (std::size_t first = 0; first < entries.size(); first += size * size) {
      arithmetic.spend(10 * size * size);
      Residues image;
      for (std::size_t k = 0; k < size; ++k) {
        std::uint64_t sum = 0;
        for (std::size_t j = 0; j < size; ++j)
          sum = (sum + functionals.rows()[i][j] * entries[first + k * size + j]) % prime;
        image.push_back(sum);
      }
      functionals.add(std::move(image));
    }
  require(functionals.rows().size() + component.degree * component.unobservable >= size,
          "more than what is said to be unobservable may be so");
}

}  // namespace subcert_check
