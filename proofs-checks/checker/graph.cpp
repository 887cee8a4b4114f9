
#include "graph.hpp"

#include "definite.hpp"
#include "group.hpp"
#include "scheme.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace subcert_check {
namespace {

constexpr std::size_t longest_path = 1000;
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
      require(!goes_on || length + 1 < longest_path, "a word of more than 1000 letters");
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
  std::vector<KeptState> kept;
  if (bits <= bits_of_doubles)
    kept = check(double());
  else
    kept = check(mpz_class());
  const bool attained = exact && check_kept_words(family, bound, kept, *exact, reader, arithmetic);
  return {attained ? exact->high : bound, attained};
}

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
