#include "graph_prover.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/radii/polytope_search/kernels.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <type_traits>

namespace subcert {
namespace quadratic {
namespace {

constexpr double least_slack = 1e-11, first_slack = 1.3;  // of the bound, relatively; for what a letter loses
constexpr double slack_factors[] = {1, 2, 10, 100, 1e4, 1e6};
constexpr double most_slack = 1e-2;
constexpr int bound_bits = 50;
constexpr std::size_t guard_bits = 64;  // of matrices of steps before they are rounded
constexpr double norm_rounding = 1e-12;
constexpr int most_step_norm = 7;

// Floor and ceiling of x/2^bits. A double is x times the power, exactly.
double floor_shifted(double x, int bits) { return std::floor(std::ldexp(x, -bits)); }
Integer floor_shifted(const Integer& x, int bits) { return x >> static_cast<std::size_t>(bits); }

/// The matrices of the proof in the numbers of its products, and a walk along all words.
template <class Number>
class Walk {
 public:
  Walk(const GraphProof& proof, std::size_t n)
      : proof_(proof), n_(n), bits_(proof.bits), size_(static_cast<double>(n)), unit_(Number(1)) {
    for (int k = 0; k < bits_; ++k) unit_ = unit_ + unit_;
    for (const GraphProof::State& state : proof.states) {
      auto& of_state = steps_.emplace_back();
      for (const GraphProof::Step& step : state.steps) {
        if (of_state.size() == step.letter) of_state.emplace_back();
        of_state.back().push_back({step.to, Number(step.norm), {step.matrix.begin(), step.matrix.end()}});
      }
    }
  }

  /// Whether all words of the state are contractions.
  bool holds(std::size_t state, const Deadline& deadline) const {
    std::vector<Number> identity(n_ * n_);
    for (std::size_t k = 0; k < n_; ++k) identity[k * n_ + k] = unit_;
    // The words of the inner nodes on the way to the next one: their state, the letter that is next, and products.
    struct Place {
      std::size_t state, letter;
      std::vector<Number> product;
      Number norm, error;
    };
    std::vector<Place> way;
    way.push_back({state, 0, std::move(identity), unit_, Number(0)});
    const auto leave_finished = [&] {
      while (!way.empty() && way.back().letter == steps_[way.back().state].size()) way.pop_back();
    };
    for (const char end : proof_.states[state].ends) {
      if (deadline.expired()) return false;
      Place& at = way.back();
      if (end == kept_character) {
        ++at.letter;
        leave_finished();
        continue;
      }
      const bool goes_on = end == '+';
      const auto& steps = steps_[at.state][at.letter++];
      const Step& step = steps[goes_on ? 0 : end_number(end)];
      Number norm = ceiling(at.norm * (step.norm + size_)),
             error = size_ + ceiling(at.error * step.norm + at.norm * size_);
      if (goes_on && norm + error > Number(4) * unit_) return false;
      std::vector<Number> product = times(at.product, step.matrix);
      if (goes_on)
        way.push_back({step.to, 0, std::move(product), std::move(norm), std::move(error)});
      else if (!is_contraction(product, error))
        return false;
      leave_finished();
    }
    return way.empty();
  }

 private:
  struct Step {
    std::size_t to;
    Number norm;
    std::vector<Number> matrix;
  };

  Number ceiling(const Number& x) const { return -floor_shifted(-x, bits_); }

  std::vector<Number> times(const std::vector<Number>& a, const std::vector<Number>& b) const {
    if constexpr (std::is_same_v<Number, double>) {
      // Column by column the products of the transposed matrices.
      std::vector<double> result(n_ * n_);
      polytope::kernels::add_product(b.data(), n_, n_, a.data(), n_, result.data());
      const double scale = 1 / unit_;
      for (double& x : result) x = std::floor(x * scale);
      return result;
    } else {
      Integers result = product(a, b, n_);
      for (Integer& x : result) x >>= static_cast<std::size_t>(bits_);
      return result;
    }
  }

  bool is_contraction(const std::vector<Number>& m, const Number& error) const {
    const Number most = unit_ - error;
    if (!(most > Number(0))) return false;
    std::vector<Number> rest(n_ * n_);
    for (std::size_t i = 0; i < n_; ++i) rest[i * n_ + i] = most * most;
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t i = 0; i < n_; ++i) {
        const Number& factor = m[k * n_ + i];
        for (std::size_t j = i; j < n_; ++j) subtract_product(rest[i * n_ + j], factor, m[k * n_ + j]);
      }
    for (std::size_t i = 0; i < n_; ++i)
      if (!(rest[i * n_ + i] > Number(0))) return false;
    return has_root(rest, n_, Number(size_ * unit_));
  }

  const GraphProof& proof_;
  std::size_t n_;
  int bits_;
  Number size_, unit_;
  std::vector<std::vector<std::vector<Step>>> steps_;  // of each state with each letter
};

template <class Number>
bool all_words_hold(const GraphProof& proof, std::size_t n, const Deadline& deadline) {
  const Walk<Number> walk(proof, n);
  std::atomic<bool> failed = false;
  parallel_for_each(proof.states.size(), all_cores(), [&](std::size_t state) {
    if (!failed && !walk.holds(state, deadline)) failed = true;
  });
  return !failed;
}

/// The steps of a proof for one bound.
class StepRounder {
 public:
  StepRounder(const MatrixFamily& family, const std::vector<Integers>& coordinates, int bits, const Rational& bound)
      : n_(family.size()), coordinates_(coordinates), bits_(static_cast<std::size_t>(bits)) {
    const Integer denominator = common_denominator(family);
    for (const RationalMatrix& m : family) letters_.push_back(integer_multiple(m, denominator));
    for (const FamilySymmetry& g : family.group()) {
      maps_.push_back(integer_multiple(g.map.matrix(), 1));
      inverses_.push_back(integer_multiple(g.map.inverse().matrix(), 1));
    }
    top_ = subcert::numerator(bound) * denominator;
    bottom_ = subcert::denominator(bound);
  }

  /// Nothing where the errors are too large.
  std::optional<GraphProof::Step> rounded(std::size_t letter, const Step& step) const {
    const auto element = static_cast<std::size_t>(step.element);
    const Integers image = quadratic::product(coordinates_[step.from], letters_[letter], n_);
    const Integers& last = coordinates_[step.to];
    Integers matrix = quadratic::product(image, inverses_[element], n_);
    for (Integer& entry : matrix) {
      entry *= bottom_ << (bits_ + guard_bits);
      floor_divide(entry, top_);
    }
    GraphProof::Step result{letter, step.to, element, 0, {}};
    Integers numbers(n_ * n_);
    const Integer most = Integer(most_step_norm) << bits_;
    polytope::Matrix approximate(n_, n_);
    for (std::size_t row = 0; row < n_; ++row)
      for (std::size_t j = n_; j-- > 0;) {
        Integer& entry = matrix[row * n_ + j];
        for (std::size_t k = j + 1; k < n_; ++k) subtract_product(entry, matrix[row * n_ + k], last[k * n_ + j]);
        floor_divide(entry, last[j * n_ + j]);
      }
    for (std::size_t i = 0; i < n_ * n_; ++i) {
      numbers[i] = (matrix[i] + (Integer(1) << (guard_bits - 1))) >> guard_bits;
      if (abs(numbers[i]) > most) return std::nullopt;
      result.matrix.push_back(numbers[i].convert_to<std::int64_t>());
      approximate(i / n_, i % n_) = numbers[i].convert_to<double>();
    }
    const Integer norm(std::ceil(polytope::spectral_norm(approximate) * (1 + norm_rounding)) + 1);
    if (norm > most) return std::nullopt;
    result.norm = norm.convert_to<std::int64_t>();
    if (!has_norm(numbers, norm) || !is_near(image, quadratic::product(last, maps_[element], n_), numbers))
      return std::nullopt;
    return result;
  }

 private:
  bool has_norm(const Integers& numbers, const Integer& norm) const {
    Integers rest = gram_matrix(numbers, n_);
    for (Integer& entry : rest) entry = -entry;
    for (std::size_t i = 0; i < n_; ++i) rest[i * n_ + i] += norm * norm;
    return is_positive(std::move(rest), n_);
  }

  /// Whether |(image - bound B last / 2^bits) x| <= bound size |last x| / 2^bits for all x.
  bool is_near(const Integers& image, const Integers& last, const Integers& numbers) const {
    Integers error = quadratic::product(numbers, last, n_);
    for (std::size_t i = 0; i < error.size(); ++i) error[i] = (image[i] * bottom_ << bits_) - error[i] * top_;
    const Integers squares = gram_matrix(error, n_);
    Integers rest = gram_matrix(last, n_);
    const Integer factor = top_ * top_ * Integer(n_ * n_);
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = rest[i] * factor - squares[i];
    return is_positive(std::move(rest), n_);
  }

  std::size_t n_;
  const std::vector<Integers>& coordinates_;
  std::size_t bits_;
  std::vector<Integers> letters_;          // times their denominator
  std::vector<Integers> maps_, inverses_;  // of the group
  Integer top_, bottom_;                   // of the bound times the denominator
};

/// All steps for this bound; false where one is not near enough.
bool set_steps(GraphProof& proof, const StepRounder& rounder, const StateForms& forms, const Deadline& deadline) {
  const std::size_t letters = forms.steps.size() / forms.states();
  std::atomic<bool> failed = false;
  parallel_for_each(forms.states(), all_cores(), [&](std::size_t state) {
    proof.states[state].steps.clear();
    const auto add = [&](std::size_t letter, const Step& step) {
      if (failed || deadline.expired()) return;
      if (auto rounded = rounder.rounded(letter, step))
        proof.states[state].steps.push_back(std::move(*rounded));
      else
        failed = true;
    };
    for (std::size_t letter = 0; letter < letters; ++letter) {
      add(letter, forms.steps[state * letters + letter]);
      for (const Step& end : forms.ends[state * letters + letter]) add(letter, end);
    }
  });
  return !failed && !deadline.expired();
}

/// A proof whose bound is still to be chosen.
struct Graph {
  Graph(const MatrixFamily& of, const std::vector<Integers>& rows, const StateForms& states, const ProductTree& tree,
        int bits)
      : proof{{}, bits, of.group(), 0}, family(of), coordinates(rows), forms(states) {
    const std::size_t n = family.size();
    for (std::size_t j = 0; j < forms.states(); ++j) {
      GraphProof::State& state = proof.states.emplace_back();
      for (std::size_t i = 0; i < n; ++i)
        state.coordinates.emplace_back(&coordinates[j][i * n], &coordinates[j][i * n + i] + 1);
      state.ends = tree.ends[j];
    }
  }

  /// False where the bound is not finite or a step cannot be rounded.
  bool set_bound(double bound, const Deadline& deadline) {
    if (!std::isfinite(std::ldexp(bound, bound_bits))) return false;
    proof.bound = Rational(Integer(std::ceil(std::ldexp(bound, bound_bits)))) * power(Rational(2), -bound_bits);
    return set_steps(proof, StepRounder(family, coordinates, proof.bits, proof.bound), forms, deadline);
  }

  bool holds(const Deadline& deadline) const {
    return proof.bits <= double_bits ? all_words_hold<double>(proof, family.size(), deadline)
                                     : all_words_hold<Integer>(proof, family.size(), deadline);
  }

  GraphProof proof;
  const MatrixFamily& family;
  const std::vector<Integers>& coordinates;
  const StateForms& forms;
};

}  // namespace

double slack_of(int bits, std::size_t size) {
  // Each letter loses twice the size.
  return std::max(least_slack, first_slack * 2 * static_cast<double>(size) * std::ldexp(1.0, -bits));
}

std::optional<GraphProof> prove_graph(const MatrixFamily& family, const std::vector<Integers>& coordinates,
                                      const StateForms& forms, const ProductTree& tree, int bits,
                                      const Deadline& deadline) {
  Graph graph(family, coordinates, forms, tree, bits);
  for (GraphProof::State& state : graph.proof.states)
    std::ranges::replace(state.ends, kept_character, end_character(0));
  for (const double factor : slack_factors) {
    const double slack = slack_of(bits, family.size()) * factor;
    if (slack > most_slack || deadline.expired()) break;
    if (!graph.set_bound(tree.bound * (1 + slack), deadline)) return std::nullopt;
    if (graph.holds(deadline)) return std::move(graph.proof);
  }
  return std::nullopt;
}

std::optional<AttainedGraph> prove_attained(const MatrixFamily& family, const std::vector<Integers>& coordinates,
                                            const StateForms& forms, const ProductTree& tree, int bits,
                                            const RationalComplex& eigenvalue, double bound, const Deadline& deadline) {
  const std::size_t first = forms.first_of_product();
  Graph graph(family, coordinates, forms, tree, bits);
  if (!graph.set_bound(bound, deadline)) return std::nullopt;
  const auto cycle = prove_kept_cycle(family, forms.product, eigenvalue, std::span(coordinates).subspan(first),
                                      graph.proof.bound);
  if (!cycle || !graph.holds(deadline)) return std::nullopt;
  return AttainedGraph{std::move(graph.proof), first,        forms.product, cycle->coordinate, cycle->kept,
                       cycle->scale,           cycle->radius};
}

}  // namespace quadratic

std::size_t GraphProof::words() const {
  std::size_t count = 0;
  for (const State& state : states)
    count += static_cast<std::size_t>(std::ranges::count_if(state.ends, [](char c) { return c != '+'; }));
  return count;
}

GraphProof scaled(GraphProof proof, const Rational& factor) {
  proof.bound *= factor;
  if (proof.attained) {
    AttainedGraph attained = *proof.attained;
    attained.graph.bound *= factor;
    if (attained.number) attained.number = scaled(*attained.number, factor);
    attained.radius = {*attained.radius.lower * factor, *attained.radius.upper * factor};
    proof.attained = std::make_shared<AttainedGraph>(std::move(attained));
  }
  return proof;
}

}  // namespace subcert
