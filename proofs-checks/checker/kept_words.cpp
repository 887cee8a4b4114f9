#include "kept_words.hpp"

#include "definite.hpp"
#include "rounding.hpp"

#include <algorithm>
#include <utility>

namespace subcert_check {
namespace {

constexpr std::size_t vector_bits = 1024;        // of the numbers of an eigenvector
constexpr std::uint64_t work_of_state = 50'000;  // with a few fractions

/// A row that is a multiple of an eigenvector of a product, but for an error in the sum of |re| + |im|.
struct Row {
  Vector numbers;  // the real parts, then the imaginary parts
  mpq_class error;
  std::size_t cut = 0;  // so many binary digits were dropped, which is one more error

  explicit Row(const Eigenvector& eigenvector) : error(eigenvector.error) {
    for (const Complex& z : eigenvector.point) numbers.push_back(z.re);
    for (const Complex& z : eigenvector.point) numbers.push_back(z.im);
    std::size_t most = 0;
    for (const mpz_class& x : numbers) most = std::max(most, bits(x));
    cut = most - std::min(most, vector_bits);
    for (mpz_class& x : numbers) x >>= cut;
    error = rounded_up(error / (mpz_class(1) << cut)) + mpz_class(cut > 0 ? numbers.size() : 0);
  }
  /// The squared length of an image changes by at most that times the one of the vector.
  mpq_class change() const { return 2 * norm(numbers) * error; }
};

class KeptWords {
 public:
  KeptWords(const Family& family, const mpq_class& bound, const std::vector<KeptState>& states,
            const ExactRadius& radius, Reader& reader, Arithmetic& arithmetic)
      : rows_(family),
        n_(family.size),
        bound_(bound),
        states_(states),
        radius_(radius),
        reader_(reader),
        arithmetic_(arithmetic),
        used_(states.size()) {
    rows_.transpose();
  }

  bool run() {
    const bool any = reader_.at("cycle");
    while (reader_.at("cycle")) read_cycle();
    for (std::size_t j = 0; j < states_.size(); ++j)
      require(used_[j] || !states_[j].word, "a kept word is on no cycle");
    return any;
  }

 private:
  void read_cycle() {
    const Fields fields = reader_.take("cycle", 4, 4);
    require(bound_ <= radius_.low, "the bound of a graph with cycles is above the exact radius");
    const std::size_t first = parse_size(fields[0], 0, states_.size() - 1), place = parse_size(fields[1], 0, n_ - 1);
    const mpq_class kept = parse_rational(fields[2]), scale = parse_rational(fields[3]);
    require(kept >= 0 && kept < 1, "the kept part of a norm is not from 0 to 1");
    require(scale > 0, "the scale of a cycle is not positive");
    const std::vector<std::size_t> way = way_from(first);
    scale_ = power(rows_.denominator, radius_.length).get_num();
    std::vector<Vector> basis = read_seed(
        radius_, n_, scale_,
        [&](Vector x) {
          for (const std::size_t j : way) x = moved(j, x);
          return x;
        },
        reader_, arithmetic_);
    check_states(way, std::move(basis), place, kept, scale);
  }

  /// The states of a cycle.
  std::vector<std::size_t> way_from(std::size_t first) {
    std::vector<std::size_t> way;
    std::size_t at = first;
    do {
      require(states_[at].word.has_value(), "a cycle leads to a state without a kept word");
      require(!used_[at] && way.size() < radius_.length, "a cycle is too long, or meets one that came before");
      used_[at] = true;
      way.push_back(at);
      at = states_[at].word->to;
    } while (at != first);
    require(way.size() == radius_.length, "a cycle is too short");
    return way;
  }

  /// The transposed matrix of the kept word of a state; and what it makes of a row.
  std::span<const mpz_class> matrix_from(std::size_t state) const { return rows_.matrix(states_[state].word->letter); }
  Vector moved(std::size_t state, const Vector& row) { return arithmetic_.multiply(matrix_from(state), row, n_); }

  /// The two matrices of each state. `below` and `above` are what stands before |u_i|^2 in the second one, rounded up,
  /// and the reciprocal of that in the first one without 1 - KEPT, rounded up.
  void check_states(const std::vector<std::size_t>& way, std::vector<Vector> basis, std::size_t place,
                    const mpq_class& kept, const mpq_class& scale) {
    Row row(eigenvector_of(radius_, basis, scale_, arithmetic_));
    const Complex pivot{row.numbers[place], row.numbers[n_ + place]};
    const mpz_class squared = pivot.re * pivot.re + pivot.im * pivot.im;
    const mpq_class off = 2 * norm(pivot) * row.error, least = squared - off,
                    most = squared + off + row.error * row.error, low = radius_.low * radius_.low,
                    high = radius_.high * radius_.high, room = low / (bound_ * bound_),
                    denominator = rows_.denominator * rows_.denominator;
    require(least > 0, "the eigenvector of a cycle may be zero at its coordinate");
    mpq_class below = few_digits_up(scale * scale / least), above = most / (scale * scale);
    for (std::size_t i = 0; i < way.size(); ++i) {
      const KeptState& state = states_[way[i]];
      arithmetic_.spend(work_of_state);
      require(is_positive_sum({{room, gram(state.coordinates, n_, arithmetic_)}, {-below, squares(row.numbers)}},
                              -below * (row.change() + row.error * row.error)),
              "the norm of a state does not bound the eigenvector");
      for (Vector& y : basis) y = moved(way[i], y);
      const std::size_t last_cut = row.cut;
      row = Row(eigenvector_of(radius_, basis, scale_, arithmetic_));
      // What the squares of the row are times, in place of those of the last one.
      const mpq_class factor = denominator * (mpz_class(1) << 2 * last_cut) / (mpz_class(1) << 2 * row.cut);
      above = few_digits_up(above * factor);
      const KeptState& next = states_[state.word->to];
      Family letter{n_, {matrix_from(way[i]).begin(), matrix_from(way[i]).end()}, 1};
      letter.transpose();
      const Vector image = arithmetic_.multiply(state.coordinates, letter.entries, n_);
      require(is_positive_sum({{above * kept * low, gram(next.coordinates, n_, arithmetic_)},
                               {1 - kept, squares(row.numbers)},
                               {-above / denominator, gram(image, n_, arithmetic_)}},
                              -(1 - kept) * row.change()),
              "the norm of a kept word is not that of the radius");
      below = few_digits_up(below / (factor * low));
      above *= high;
    }
  }

  /// The form |u x|^2 of x, row by row, on and above the diagonal.
  Vector squares(const Vector& u) {
    Vector form(n_ * n_);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = i; j < n_; ++j) {
        arithmetic_.add_product(form[i * n_ + j], u[i], u[j]);
        arithmetic_.add_product(form[i * n_ + j], u[n_ + i], u[n_ + j]);
      }
    return form;
  }

  /// Whether a sum of multiples of matrices and of the unit matrix is shown to be positive semidefinite.
  bool is_positive_sum(const std::vector<std::pair<mpq_class, Vector>>& terms, const mpq_class& diagonal) {
    mpz_class common = diagonal.get_den();
    for (const auto& [factor, matrix] : terms) common = lcm(common, factor.get_den());
    Vector sum(n_ * n_);
    for (std::size_t i = 0; i < n_; ++i) sum[i * n_ + i] = diagonal.get_num() * (common / diagonal.get_den());
    for (const auto& [factor, matrix] : terms) {
      const mpz_class multiple = factor.get_num() * (common / factor.get_den());
      for (std::size_t i = 0; i < n_ * n_; ++i) arithmetic_.add_product(sum[i], multiple, matrix[i]);
    }
    return is_positive(std::move(sum), n_, arithmetic_);
  }

  Family rows_;  // the matrices transposed
  std::size_t n_;
  const mpq_class& bound_;
  const std::vector<KeptState>& states_;
  const ExactRadius& radius_;
  Reader& reader_;
  Arithmetic& arithmetic_;
  mpz_class scale_;         // the denominator of a product
  std::vector<bool> used_;  // states that are on a cycle
};

}  // namespace

bool check_kept_words(const Family& family, const mpq_class& bound, const std::vector<KeptState>& states,
                      const ExactRadius& radius, Reader& reader, Arithmetic& arithmetic) {
  return KeptWords(family, bound, states, radius, reader, arithmetic).run();
}

}  // namespace subcert_check
