#include "graph.hpp"

#include "definite.hpp"
#include "group.hpp"
#include "kept_words.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace subcert_check {
namespace {

constexpr std::size_t longest_word = 1000;
// With so many bits `double` holds all integers on the way, which are below 2^53. |B| <= NORM <= 7 U, and where a word
// goes on |M| <= p + e <= 4 U, as p' + e' >= |M| NORM / U + d; so by Cauchy and Schwarz partial sums of M B are at
// most 28 U^2 in modulus, and so is e b + p d, while p (b + d) < 32 U^2 = 2^53. The same of M'^T M' if its diagonal is
// below c^2 <= U^2. Where the diagonal is not, sums of squares are exact or, rounded, 2^53 or more: it is found out.
constexpr std::size_t bits_of_doubles = 24;

// ---- what the walk needs of numbers beside definite.hpp -------------------------------------------------------------

void floor_shift(mpz_class* row, std::size_t bits, std::size_t n) {
  for (std::size_t j = 0; j < n; ++j) row[j] >>= bits;  // towards minus infinity
}
void floor_shift(double* row, std::size_t bits, std::size_t n) {
  const double part = std::ldexp(1.0, -static_cast<int>(bits));
  const auto shifted = [part](double x) { return std::floor(x * part); };
  std::transform(row, row + n, row, shifted);
}

void convert(const mpz_class& x, mpz_class& number) { number = x; }
void convert(const mpz_class& x, double& number) { number = x.get_d(); }

/// The work of a product of matrices or of a decomposition, in nanoseconds and more than half as much again; products
/// of integers count themselves.
void spend(double, std::size_t n, Arithmetic& arithmetic) { arithmetic.spend(70 + 3 * n * n + n * n * n / 8); }
void spend(const mpz_class&, std::size_t n, Arithmetic& arithmetic) { arithmetic.spend(300 + 50 * n * n); }

template <class Number>
struct Step {
  TurnedIndex to;
  Number norm;
  std::vector<Number> matrix;  // row by row
};

template <class Number>
struct State : KeptState {
  std::vector<std::vector<Step<Number>>> steps;  // by letters, of equal matrices the first one's
  std::string tree;
};

std::size_t number_of(char end) {
  constexpr std::string_view characters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  const std::size_t number = characters.find(end);
  require(number != characters.npos, "a word ends with none of 0-9, A-Z, a-z");
  return number;
}

template <class Number>
class Graph {
 public:
  /// `may_keep`: whether words may be kept.
  Graph(const Family& family, mpq_class bound, std::size_t bits, std::vector<Generator> generators, bool may_keep,
        Arithmetic& arithmetic)
      : family_(family),
        n_(family.size),
        letters_(family.letters()),
        bound_(std::move(bound)),
        bits_(bits),
        generators_(std::move(generators)),
        may_keep_(may_keep),
        arithmetic_(arithmetic) {
    std::ranges::sort(letters_);
    letters_.erase(std::unique(letters_.begin(), letters_.end()), letters_.end());
    convert(mpz_class(1) << bits, unit_);
    convert(mpz_class(n_), size_);
  }

  void read(std::size_t count, Reader& reader) {
    for (std::size_t j = 0; j < count; ++j) {
      State<Number>& state = states_.emplace_back();
      state.coordinates.resize(n_ * n_);
      for (std::size_t i = 0; i < n_; ++i) {
        const Fields row = reader.take("coordinates", i + 1, i + 1);
        for (std::size_t k = 0; k <= i; ++k) state.coordinates[k * n_ + i] = parse_integer(row[k]);
        require(state.coordinates[i * n_ + i] != 0, "the coordinates of a state have a 0 on the diagonal");
      }
      for (const std::size_t letter : letters_) {
        auto& steps = state.steps.emplace_back();
        const std::string head = "step " + std::to_string(letter);
        do steps.push_back(read_step(reader.take(head, 2 + n_ * n_, 2 + n_ * n_), count));
        while (reader.at(head));
      }
      state.tree = reader.take("tree", 1, 1)[0];
    }
  }

  void check() {
    for (const State<Number>& state : states_)
      for (std::size_t t = 0; t < letters_.size(); ++t)
        for (const Step<Number>& step : state.steps[t]) check_step(state, family_.matrix(letters_[t]), step);
    products_.assign(1, std::vector<Number>(n_ * n_));
    for (std::size_t i = 0; i < n_; ++i) products_[0][i * n_ + i] = unit_;
    for (State<Number>& state : states_) {
      ends_ = state.tree;
      follow(state, 0, unit_, 0);
      require(ends_.empty(), "a tree has more characters than its words");
    }
  }

  std::vector<KeptState> kept_states() const { return {states_.begin(), states_.end()}; }

 private:
  Step<Number> read_step(const Fields& fields, std::size_t count) {
    Step<Number> step{parse_turned_index(fields[0], count), {}, std::vector<Number>(n_ * n_)};
    for (const char letter : step.to.word) named_generator(letter, generators_);
    const mpz_class norm = parse_integer(fields[1]);
    require(norm >= 1 && norm <= mpz_class(7) << bits_, "the norm of a step is not from 1 to 7 2^BITS");
    Vector difference(n_ * n_);
    for (std::size_t i = 0; i < n_ * n_; ++i) {
      const mpz_class entry = parse_integer(fields[2 + i]);
      require(abs(entry) <= norm, norm_too_small);
      convert(entry, step.matrix[i]);
      difference[i % n_ * n_ + i / n_] = entry;
    }
    difference = gram(difference, n_, arithmetic_);
    for (std::size_t i = 0; i < n_ * n_; ++i)
      difference[i] = (i % (n_ + 1) == 0 ? mpz_class(norm * norm) : mpz_class(0)) - difference[i];
    require(is_positive(std::move(difference), n_, arithmetic_), norm_too_small);
    convert(norm, step.norm);
    return step;
  }

  void check_step(const State<Number>& from, std::span<const mpz_class> letter, const Step<Number>& step) {
    Vector to = states_[step.to.index].coordinates, matrix(n_ * n_);
    for (const char generator : step.to.word)
      to = arithmetic_.multiply(to, named_generator(generator, generators_).map, n_);
    for (std::size_t i = 0; i < n_ * n_; ++i) matrix[i % n_ * n_ + i / n_] = step.matrix[i];
    Vector apart = arithmetic_.multiply(from.coordinates, Vector(letter.begin(), letter.end()), n_);
    matrix = arithmetic_.multiply(matrix, to, n_);
    const mpz_class left = bound_.get_den() << bits_, right = family_.denominator * bound_.get_num(), near = n_ * right;
    for (std::size_t i = 0; i < n_ * n_; ++i) apart[i] = left * apart[i] - right * matrix[i];
    apart = gram(apart, n_, arithmetic_);
    to = gram(to, n_, arithmetic_);
    for (std::size_t i = 0; i < n_ * n_; ++i) to[i] = near * near * to[i] - apart[i];
    require(is_positive(std::move(to), n_, arithmetic_), "the matrix of a step is not near the one that it stands for");
  }

  /// What `ends_` says of the words that go on from a state after so many letters.
  void follow(State<Number>& state, std::size_t length, const Number& norm, const Number& error) {
    for (std::size_t t = 0; t < letters_.size(); ++t) {
      const auto& steps = state.steps[t];
      require(!ends_.empty(), "a tree has fewer characters than its words");
      const char end = ends_.front();
      ends_.remove_prefix(1);
      if (may_keep_ && end == '*') {
        require(length == 0, "a kept word has more than one letter");
        require(steps.front().to.word.empty(), "the step of a kept word has a word of the group");
        require(!state.word, "a state has two kept words");
        state.word = {letters_[t], steps.front().to.index};
        continue;
      }
      const bool goes_on = end == '+';
      require(!goes_on || length + 1 < longest_word, "a word of more than 1000 letters");
      const std::size_t number = goes_on ? 0 : number_of(end);
      require(number < steps.size(), "a word ends by a step that is not there");
      const Step<Number>& step = steps[number];
      if (products_.size() == length + 1) products_.emplace_back(n_ * n_);
      multiply(products_[length].data(), step.matrix.data(), products_[length + 1].data());
      const Number next_norm = ceiling(norm * (step.norm + size_));
      const Number next_error = ceiling(error * step.norm + norm * size_) + size_;
      if (goes_on) {
        require(next_norm + next_error <= 4 * unit_, "the product of a word that goes on is too large");
        follow(states_[step.to.index], length + 1, next_norm, next_error);
      } else {
        require(is_at_most(products_[length + 1].data(), unit_ - next_error),
                "the product of a word is not below the bound");
      }
    }
  }

  /// x / U, rounded up.
  Number ceiling(Number x) const {
    x = -x;
    floor_shift(&x, bits_, 1);
    return -x;
  }

  void multiply(const Number* x, const Number* y, Number* product) {
    spend(unit_, n_, arithmetic_);
    std::fill_n(product, n_ * n_, Number(0));
    for (std::size_t i = 0; i < n_; ++i) add_multiples(product + i * n_, x + i * n_, 1, y, n_, n_, n_, arithmetic_);
    floor_shift(product, bits_, n_ * n_);
  }

  /// Whether the norm of a product is shown to be at most c.
  bool is_at_most(const Number* product, const Number& c) {
    spend(unit_, n_, arithmetic_);
    if (c <= 0) return false;
    std::vector<Number>& s = difference_;
    s.assign(n_ * n_, Number(0));
    for (std::size_t i = 0; i < n_; ++i) {
      Number* const diagonal = &s[i * (n_ + 1)];
      *diagonal = -c * c;
      add_multiples(diagonal, product + i, n_, product + i, n_, n_, n_ - i, arithmetic_);
      if (*diagonal >= 0) return false;
      *diagonal += size_ * unit_;
    }
    return is_decomposed(s.data(), n_, arithmetic_);
  }

  static constexpr const char* norm_too_small = "the norm of a step is larger than it says";
  const Family& family_;
  std::size_t n_;
  std::vector<std::size_t> letters_;  // of equal matrices the first one's
  mpq_class bound_;
  std::size_t bits_;
  std::vector<Generator> generators_;
  bool may_keep_;
  Arithmetic& arithmetic_;
  Number unit_, size_;
  std::vector<State<Number>> states_;
  std::string_view ends_;
  std::vector<std::vector<Number>> products_;  // of the beginnings of a word
  std::vector<Number> difference_;
};

}  // namespace

GraphBound read_graph(const Family& family, const Fields& fields, const ExactRadius* exact, Reader& reader,
                      Arithmetic& arithmetic) {
  require(fields.size() == 4 || (fields.size() == 5 && parse_group(fields[4]) > 0),
          "expected 'graph', a number of states, a bound, a number of bits and perhaps a group");
  const std::size_t states = parse_size(fields[1], 1, 4096), bits = parse_size(fields[3], 8, 1000);
  const mpq_class bound = parse_rational(fields[2]);
  require(bound > 0, "the bound of a graph is not positive");
  const std::size_t generators = fields.size() == 5 ? parse_group(fields[4]) : 0;
  const auto check = [&]<class Number>(Number) {
    Graph<Number> graph(family, bound, bits, read_generators(family, generators, reader, arithmetic), exact != nullptr,
                        arithmetic);
    graph.read(states, reader);
    graph.check();
    return graph.kept_states();
  };
  const std::vector<KeptState> kept = bits <= bits_of_doubles ? check(double()) : check(mpz_class());
  const bool attained = exact && check_kept_words(family, bound, kept, *exact, reader, arithmetic);
  return {attained ? exact->high : bound, attained};
}

}  // namespace subcert_check
