#include "context_forms.hpp"

#include "limited_memory.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/radii/polytope_search/root_cycles.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace subcert::quadratic {
namespace {

using polytope::fast_product;
using polytope::Matrix;
using polytope::Vector;

constexpr std::size_t most_states = 256;  // of contexts, and of a cycle
// The weight t of the bound, for each singular value, doubles.
constexpr double first_weight = 16;
constexpr int weights = 5;           // up to 256
constexpr double first_level = 1.1;  // that g is above the largest norm at first, squared
constexpr int steps_per_weight = 1000;
constexpr double first_step = 1e-3, longest_step = 1;
constexpr int most_halvings = 25;                                      // of a step
constexpr double least_gain = 1e-3;                                    // of a step
constexpr std::size_t matrices_per_step = 5, matrices_per_state = 50;  // that a descent holds, about
constexpr std::size_t worth_threads = 64;                              // matrices

constexpr double real_enough = 1e-9, simple_enough = 1e-6;  // of the leading eigenvalue, relatively
constexpr int orbit_generations = 80;
constexpr std::size_t orbit_width = 64;
constexpr double more_than_orbit = 1.03;  // that words come near to the cycle before they are on it
constexpr double across_share = 0.7;      // of the form of the context that W reaches
constexpr double most_norm = 6.5;         // of a step at the end of a word, by the bound
constexpr int most_turns = 200;
constexpr double settled = 1e-6;

/// matrix g^T
Matrix times_transposed(const Matrix& matrix, const polytope::GroupAction& action, int element) {
  Matrix result = matrix.transposed();
  for (std::size_t j = 0; j < result.columns(); ++j) action.apply(element, &result(0, j));
  return result.transposed();
}
/// g matrix
Matrix applied(const polytope::GroupAction& action, int element, Matrix matrix) {
  for (std::size_t j = 0; j < matrix.columns(); ++j) action.apply(element, &matrix(0, j));
  return matrix;
}
/// m^T form m
Matrix congruent(const Matrix& m, const Matrix& form) { return m.transposed() * (form * m); }

/// Left and right leading eigenvectors before each letter of a product, u_0 A = r u_1, ..., of a simple eigenvalue or
/// of a pair of them.
struct LeadingVectors {
  std::vector<polytope::ComplexVector> left, right;  // left[p] right[p] = 1
  double radius = 0;
  bool is_pair = false;
};

std::optional<LeadingVectors> leading_vectors(const std::vector<Matrix>& matrices, const std::vector<int>& product,
                                              const Deadline& deadline) {
  polytope::Candidate candidate{polytope::turned(product)};
  candidate.radius = polytope::product_radius(matrices, candidate.word);
  const auto cycles = polytope::leading_cycles(matrices, {candidate}, simple_enough, deadline);
  if (cycles.size() != 1 || cycles[0].left.empty()) return std::nullopt;
  LeadingVectors result{{}, {}, candidate.radius, std::abs(cycles[0].phase.imag()) > real_enough};
  const std::size_t length = product.size();
  for (std::size_t p = 0; p < length; ++p) {
    result.right.push_back(cycles[0].right[(length - p) % length]);
    result.left.push_back(cycles[0].left[(length - p) % length]);
  }
  return result;
}

/// The largest |Re(z x)|, |z| = 1.
double longest_half_axis(const polytope::ComplexVector& x) {
  std::complex<double> square = 0;
  for (const auto& entry : x) square += entry * entry;
  return std::sqrt((polytope::squared_norm(x) + std::abs(square)) / 2);
}

/// work(0), ..., work(count - 1), on all cores where there are many.
template <class Work>
void in_parts(std::size_t count, const Work& work) {
  const auto range = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) work(k);
  };
  if (count < worth_threads)
    range(0, count);
  else
    parallel_ranges(count, static_cast<std::size_t>(all_cores()), all_cores(), range);
}

double largest_norm(const StateForms& forms) {
  std::vector<double> norms(forms.steps.size());
  in_parts(norms.size(), [&](std::size_t k) { norms[k] = polytope::spectral_norm(forms.steps[k].matrix); });
  return *std::ranges::max_element(norms);
}

/// Forms, and g^2 by its logarithm.
struct Point {
  StateForms forms;
  double log_level = 0;
};

/// t log g^2 - sum log det (1 - B^T B/g^2), and its gradient with respect to X_j where the coordinates of the state j
/// are multiplied by e^(X_j/2), matrix after matrix, and to log g^2.
struct Value {
  double barrier = 0;
  Vector gradient;
};
std::optional<Value> value_of(const Point& at, double weight) {
  const std::vector<Step>& steps = at.forms.steps;
  const std::size_t n = at.forms.to.front().rows(), entries = n * n;
  const double level = std::exp(at.log_level);
  struct Part {
    Matrix before, behind;  // B (1 - B^T B/g^2)^-1 B^T/g^2 and 1 - (1 - B^T B/g^2)^-1
    double log_determinant = 0;
  };
  std::vector<std::optional<Part>> parts(steps.size());
  in_parts(steps.size(), [&](std::size_t s) {
    const Matrix& b = steps[s].matrix;
    Matrix rest = fast_product(b.transposed(), b);
    rest /= -level;
    for (std::size_t k = 0; k < n; ++k) rest(k, k) += 1;
    auto found = polytope::positive_inverse(rest);
    if (!found) return;
    Part part{fast_product(b, fast_product(found->inverse, b.transposed())), std::move(found->inverse),
              found->log_determinant};
    part.before /= level;
    part.behind /= -1;
    for (std::size_t k = 0; k < n; ++k) part.behind(k, k) += 1;
    parts[s] = std::move(part);
  });
  Value result{weight * at.log_level, Vector(at.forms.states() * entries + 1)};
  double& by_level = result.gradient.back();
  by_level = weight;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    if (!parts[s]) return std::nullopt;
    result.barrier -= parts[s]->log_determinant;
    double* const before = &result.gradient[steps[s].from * entries];
    double* const behind = &result.gradient[steps[s].to * entries];
    for (std::size_t i = 0; i < entries; ++i) before[i] += parts[s]->before.entries()[i] / 2;
    for (std::size_t i = 0; i < entries; ++i) behind[i] += parts[s]->behind.entries()[i] / 2;
    for (std::size_t k = 0; k < n; ++k) by_level += parts[s]->behind(k, k);
  }
  return result;
}

/// The coordinates of each state multiplied by (1 + X/4)/(1 - X/4), nearly e^(X/2), where X is its part of the
/// direction, symmetric, times the share.
Point moved(const Point& at, const Vector& direction, double share) {
  const std::size_t n = at.forms.to.front().rows(), entries = n * n;
  Point result = at;
  result.log_level += share * direction.back();
  std::vector<Matrix> map(at.forms.states()), back(at.forms.states());
  in_parts(at.forms.states(), [&](std::size_t j) {
    Matrix up = Matrix::identity(n), down = up;
    for (std::size_t c = 0; c < n; ++c)
      for (std::size_t r = 0; r < n; ++r) {
        const double x = share / 4 * direction[j * entries + c * n + r];
        up(r, c) += x;
        down(r, c) -= x;
      }
    map[j] = fast_product(up, polytope::positive_inverse(down).value().inverse);
    back[j] = fast_product(down, polytope::positive_inverse(up).value().inverse);
    result.forms.to[j] = map[j] * at.forms.to[j];
    result.forms.from[j] = at.forms.from[j] * back[j];
  });
  in_parts(at.forms.steps.size(), [&](std::size_t s) {
    Step& step = result.forms.steps[s];
    step.matrix = fast_product(map[step.from], fast_product(step.matrix, back[step.to]));
  });
  return result;
}

/// The largest norm of the part of a state.
double longest_part(const Vector& direction, std::size_t states) {
  const std::size_t entries = direction.size() / states;
  double longest = 0;
  for (std::size_t j = 0; j < states; ++j)
    longest = std::max(longest, polytope::norm(std::span(direction).subspan(j * entries, entries)));
  return longest;
}

/// Follows the gradient for one weight.
void descend(Point& at, double weight, const Deadline& deadline) {
  if (deadline.expired()) return;
  LimitedMemory memory(first_step);
  std::optional<Value> here = value_of(at, weight);
  for (int k = 0; k < steps_per_weight && here && !deadline.expired(); ++k) {
    const std::optional<Vector> way = memory.direction(here->gradient);
    if (!way) return;
    const double slope = polytope::inner(here->gradient, *way);
    double share = std::min(1.0, longest_step / longest_part(*way, at.forms.states()));
    Point next;
    std::optional<Value> there;
    for (int halvings = 0;; share /= 2) {
      next = moved(at, *way, share);
      there = value_of(next, weight);
      if (there && there->barrier <= here->barrier + 1e-4 * share * slope) break;
      if (++halvings == most_halvings || deadline.expired()) return;
    }
    memory.remember(share, *way, here->gradient, there->gradient);
    const double gain = here->barrier - there->barrier;
    at = std::move(next);
    here = std::move(there);
    if (gain < least_gain) return;
  }
}

}  // namespace

ContextForms::ContextForms(const polytope::SearchFamily& family, EllipsoidalCoordinates for_letters)
    : family_(family), for_letters_(std::move(for_letters)), contexts_{{}} {
  forms_ = {{for_letters_.to}, {for_letters_.from}, {}, {}, for_letters_.bound, {}};
  for (const Matrix& m : for_letters_.matrices) forms_.steps.push_back({0, 0, 0, m});
  forms_.ends.resize(forms_.steps.size());
}

std::vector<int> ContextForms::least_image(const std::vector<int>& context) const {
  std::vector<int> least = context;
  for (int g = 1; g < family_.symmetry.order(); ++g)
    least = std::min(least, family_.symmetry.word(g, context, family_.matrices.size()));
  return least;
}

std::pair<std::size_t, int> ContextForms::state_of(const std::vector<int>& context) const {
  const std::vector<int> least = least_image(context);
  const auto found = std::ranges::lower_bound(contexts_, least);
  return {static_cast<std::size_t>(found - contexts_.begin()), least == context ? 0 : 1};
}

void ContextForms::add_steps(StateForms& forms, std::size_t state, const std::vector<int>& context) const {
  const polytope::GroupAction action = family_.symmetry.action(family_.matrices.front().rows());
  for (std::size_t letter = 0; letter < family_.matrices.size(); ++letter) {
    std::vector<int> next = context;
    next.push_back(static_cast<int>(letter));
    if (next.size() > contexts_.front().size()) next.erase(next.begin());
    const auto [to, element] = state_of(next);
    const Matrix image = forms.to[state] * family_.matrices[letter];
    forms.steps.push_back({state, to, element, times_transposed(image, action, element) * forms.from[to]});
  }
}

StateForms ContextForms::lengthen() {
  const std::size_t count = family_.matrices.size();
  const polytope::GroupAction action = family_.symmetry.action(family_.matrices.front().rows());
  std::set<std::vector<int>> longer;
  for (std::size_t letter = 0; letter < count; ++letter)
    for (const std::vector<int>& context : contexts_)
      for (int g = 0; g < family_.symmetry.order(); ++g) {
        std::vector<int> word = family_.symmetry.word(g, context, count);
        word.insert(word.begin(), static_cast<int>(letter));
        longer.insert(least_image(word));
      }
  StateForms result;
  for (const std::vector<int>& context : longer) {
    const auto [state, element] = state_of({context.begin() + 1, context.end()});
    result.to.push_back(times_transposed(forms_.to[state], action, element));
    result.from.push_back(applied(action, element, forms_.from[state]));
  }
  contexts_.assign(longer.begin(), longer.end());
  for (std::size_t state = 0; state < result.states(); ++state) add_steps(result, state, contexts_[state]);
  result.ends.resize(result.steps.size());
  return result;
}

bool ContextForms::grow(const Budget& budget) {
  const std::size_t count = family_.matrices.size(), states = forms_.states() * count;
  const double entries = std::pow(static_cast<double>(family_.matrices.front().rows()), 2);
  const double bytes = 8 * entries * static_cast<double>(states * (matrices_per_step * count + matrices_per_state));
  if (count == 1 || states > most_states || bytes > static_cast<double>(budget.memory) ||
      schedule::forms::next_contexts * static_cast<double>(count) * seconds_ > budget.deadline.remaining())
    return false;
  const Stopwatch stopwatch;
  if (family_.symmetry.is_dense()) family_.symmetry = {};
  // The flip may leave one context of one letter.
  while ((forms_ = lengthen()).states() == 1) {
  }
  Point at{std::move(forms_), 0};
  at.log_level = 2 * std::log(largest_norm(at.forms)) + std::log(first_level);
  const double values = static_cast<double>(at.forms.steps.size() * family_.matrices.front().rows());
  for (int k = 0; k < weights; ++k) descend(at, std::ldexp(first_weight, k) * values, budget.deadline);
  forms_ = std::move(at.forms);
  forms_.bound = largest_norm(forms_);
  seconds_ = stopwatch.seconds();
  return true;
}

std::optional<StateForms> ContextForms::with_cycle(const std::vector<int>& product, const Budget& budget) const {
  const Deadline& deadline = budget.deadline;
  const std::size_t most_matrices = budget.memory / (sizeof(double) * family_.matrices.front().entries().size());
  if (product.size() > most_states || product.size() * family_.matrices.size() > most_matrices) return std::nullopt;
  const auto cycle = leading_vectors(family_.matrices, product, deadline);
  if (!cycle) return std::nullopt;
  const std::size_t n = family_.matrices.front().rows(), length = product.size(), first = forms_.states();
  const std::size_t reach = contexts_.front().size();
  const polytope::GroupAction action = family_.symmetry.action(n);
  std::vector<Matrix> matrices = family_.matrices;
  for (Matrix& m : matrices) m /= cycle->radius;

  // The largest norm, for any state, of what words make of those x in the span of the eigenvectors with |u x| = 1.
  const double share = cycle->is_pair ? 2 : 1;  // x = Re(share z v), |z| = 1
  double largest = 0;
  const auto look = [&](const polytope::ComplexVector& x) {
    for (const Matrix& to : forms_.to) largest = std::max(largest, share * longest_half_axis(to * x));
  };
  for (const polytope::ComplexVector& x : cycle->right) look(x);
  polytope::follow_orbit(
      cycle->right, matrices, orbit_generations, orbit_width, deadline,
      [&](const polytope::ComplexVector& x) { return polytope::squared_norm(for_letters_.to * x); }, look);

  // The form of the context before each letter, without the eigenvectors.
  struct Place {
    std::vector<int> context;
    std::size_t state = 0;
    int element = 0;
    Matrix to, from, across;
  };
  std::vector<Place> places(length);
  for (std::size_t p = 0; p < length; ++p) {
    Place& place = places[p];
    for (std::size_t k = reach; k > 0; --k) place.context.push_back(product[(p + reach * length - k) % length]);
    std::tie(place.state, place.element) = state_of(place.context);
    place.to = times_transposed(forms_.to[place.state], action, place.element);
    place.from = applied(action, place.element, forms_.from[place.state]);
    Matrix projection = Matrix::identity(n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) projection(i, j) -= share * (cycle->right[p][i] * cycle->left[p][j]).real();
    place.across = congruent(place.to * projection, Matrix::identity(n));
  }
  // W before the next letter is A^T W A and the form there, so that A^T W A is below it.
  std::vector<Matrix> w(length);
  Matrix next = places[0].across;
  for (int turn = 0; turn < most_turns; ++turn) {
    const double before = turn == 0 ? 0 : polytope::norm(w[0].entries());
    for (std::size_t p = 0; p < length; ++p) {
      if (deadline.expired()) return std::nullopt;
      w[p] = next;
      next = congruent(matrices[static_cast<std::size_t>(product[p])], w[p]);
      next += places[(p + 1) % length].across;
    }
    if (polytope::norm(w[0].entries()) < before * (1 + settled)) break;
  }
  double reached = 0;
  for (std::size_t p = 0; p < length; ++p) {
    w[p] = congruent(places[p].from, w[p]);
    reached = std::max(reached, polytope::symmetric_eigenvalues(w[p]).back());
  }

  StateForms at = forms_;
  at.ends.clear();
  std::vector<std::vector<Step>> endings(forms_.states());  // from the state of a context to those of the cycle
  const double along = more_than_orbit * largest;
  for (std::size_t p = 0; p < length; ++p) {
    const Place& place = places[p];
    w[p] /= reached / across_share;
    const polytope::ComplexVector row = multiply_transposed(place.from, cycle->left[p]);
    Matrix form = std::move(w[p]);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) form(i, j) += along * along * (std::conj(row[i]) * row[j]).real();
    polytope::SymmetricDecomposition roots = polytope::symmetric_decomposition(form);
    Vector inverses;
    for (double& value : roots.values) {
      if (!(value > 0)) return std::nullopt;
      value = std::sqrt(value);
      inverses.push_back(1 / value);
    }
    const Matrix back = polytope::composed(roots.vectors, inverses);
    at.to.push_back(polytope::composed(roots.vectors, roots.values) * place.to);
    at.from.push_back(place.from * back);
    endings[place.state].push_back({place.state, first + p, place.element, back});
  }
  for (std::size_t p = 0; p < length; ++p) {
    add_steps(at, first + p, places[p].context);
    Step& on = at.steps[at.steps.size() - matrices.size() + static_cast<std::size_t>(product[p])];
    on.to = first + (p + 1) % length;
    on.element = 0;
    on.matrix = at.to[first + p] * family_.matrices[static_cast<std::size_t>(product[p])] * at.from[on.to];
  }
  std::size_t held = at.steps.size();
  for (const Step& step : at.steps) {
    at.ends.emplace_back();
    if (step.to >= first) continue;
    for (const Step& ending : endings[step.to]) {
      if (held > most_matrices || deadline.expired()) return std::nullopt;
      Step end{step.from, ending.to, step.element ^ ending.element, fast_product(step.matrix, ending.matrix)};
      if (polytope::spectral_norm(end.matrix) < most_norm * forms_.bound) {
        at.ends.back().push_back(std::move(end));
        ++held;
      }
    }
  }
  at.bound = std::max(at.bound, cycle->radius);
  at.product = product;
  return at;
}

}  // namespace subcert::quadratic
