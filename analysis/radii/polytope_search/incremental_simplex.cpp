#include "incremental_simplex.hpp"
#include "kernels.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::polytope {

namespace {

constexpr int oldest_basis = 100;             // pivots between factorisations: rounding has grown to some 1e-12 by then
constexpr std::size_t cache_size = 512;       // bases; more are slower to look through than they save
constexpr std::size_t long_list = 60;         // vertices per coordinate beyond which short lists pay
constexpr std::size_t long_cone_list = 500;   // vertices: cones are priced in double precision, one by one
constexpr double no_artificial_part = 1e-13;  // the rounding of a combination of real vertices
constexpr int between_looks = 64;             // pivots between looks at the clock

// Makes room for one more element at least; grows by a quarter, as the old array is held beside the new one.
template <class T>
void make_room(std::vector<T>& v, std::size_t more) {
  if (v.size() + more > v.capacity()) v.reserve(v.size() + more + v.size() / 4);
}

}  // namespace

IncrementalSimplex::IncrementalSimplex(PolytopeKind kind, const GroupAction& action, const Budget& budget)
    : kind_(kind),
      action_(action),
      half_(action.dimension()),
      size_(kind == PolytopeKind::complex ? 2 * half_ : half_),
      stride_((size_ + 3) / 4 * 4),
      deadline_(budget.deadline) {
  require(half_ >= 1, "IncrementalSimplex: need dimension >= 1, got {}", half_);
  cache_size_ = std::clamp<std::size_t>(budget.memory / bytes_of_basis(), 1, cache_size);
  for (auto* v : {&lambda_, &y_, &direction_, &column_, &row_, &scratch_}) v->assign(stride_, 0.0);
  single_.assign(stride_, 0.0F);
}

int IncrementalSimplex::add(std::span<const double> vertex) {
  require(vertex.size() == size_, "IncrementalSimplex::add: need {} numbers, got {}", size_, vertex.size());
  make_room(vertices_, stride_);
  vertices_.insert(vertices_.end(), vertex.begin(), vertex.end());
  vertices_.resize((count_ + 1) * stride_, 0.0);
  lengths_.push_back(std::sqrt(kernels::dot(vertex.data(), vertex.data(), size_)));
  if (kind_ != PolytopeKind::nonnegative) {
    const std::size_t place = count_ % block_size;
    if (place == 0) {
      make_room(blocks_, block_size * size_);
      blocks_.resize(blocks_.size() + block_size * size_, 0.0F);
    }
    float* block = blocks_.data() + count_ / block_size * block_size * size_;
    for (std::size_t k = 0; k < size_; ++k) block[k * block_size + place] = static_cast<float>(vertex[k]);
  }
  for (Basis& basis : cache_) {
    if (basis.largest > 0) basis.largest = std::max(basis.largest, price_one(count_, basis.y.data()).price);
  }
  return static_cast<int>(count_++);
}

Membership IncrementalSimplex::solve(std::span<const double> x, double accept, double reject, WarmStart* warm) {
  require(x.size() == size_, "IncrementalSimplex::solve: need {} numbers, got {}", size_, x.size());
  const Question question{x, accept, reject, warm};
  Membership result;
  if (!start(question, result)) return result;
  iterate(question, result);
  cache_basis();
  return result;
}

// False if remembered multipliers answer the question.
bool IncrementalSimplex::start(const Question& question, Membership& result) {
  WarmStart* warm = question.warm;
  if (warm != nullptr && !warm->multipliers.empty()) {
    if (still_outside(*warm, question.reject)) {
      result = {Membership::Answer::outside, warm->value / warm->largest, warm->upper};
      return false;
    }
    if (start_from(warm->basis, question.x)) return true;
  }
  const double lower = choose_start(question.x);
  if (lower <= question.reject * (1 + price_margin)) return true;
  result = {Membership::Answer::outside, lower, objective()};
  store(warm, result, 1);
  return false;
}

void IncrementalSimplex::iterate(const Question& question, Membership& result) {
  short_list_.clear();
  // A short list serves as many pivots as make it as expensive as pricing everything once.
  short_list_pivots_ = kind_ == PolytopeKind::nonnegative ? count_ / long_cone_list : count_ / (long_list * size_);
  std::size_t served = 0;
  bool cold = false;
  const int limit = 200 + 20 * static_cast<int>(size_);  // several times what programs that end need
  for (int iteration = 0; iteration < limit; ++iteration) {
    if (iteration % between_looks == between_looks - 1 && deadline_.expired()) return;
    result.upper = objective();
    if (is_inside(question, result)) return;
    if (work_.age > oldest_basis) {
      const bool sound = refactor(work_);
      set_coefficients(question.x);
      if (!sound) {
        if (cold) return;
        cold = true;
        start_cold(question.x);
        short_list_.clear();
        continue;
      }
    }
    update_multipliers();
    bool found = choose_slack();
    if (!found && served < short_list_pivots_) {
      ++served;
      found = choose_vertex();
    }
    if (!found) {
      served = 0;
      const double largest = price_all();
      result.lower = std::max(result.lower, result.upper / largest);
      if (result.lower > question.reject * (1 + price_margin)) {
        result.answer = Membership::Answer::outside;
        keep_multipliers(largest);
        store(question.warm, result, largest);
        return;
      }
      found = choose_vertex() || choose_among_all();
    }
    if (found && pivot()) continue;
    return conclude(question, !found, result);
  }
  conclude(question, false, result);
}

bool IncrementalSimplex::is_inside(const Question& question, Membership& result) {
  if (result.upper > question.accept || artificial_part() >= no_artificial_part) return false;
  const bool sound = refine(question.x);
  result.upper = objective();
  if (!sound || result.upper > question.accept) return false;
  result.combined = true;
  result.answer = Membership::Answer::inside;
  return true;
}

// Optimal up to the pricing tolerance, or no acceptable pivot: then only the upper bound counts.
void IncrementalSimplex::conclude(const Question& question, bool optimal, Membership& result) {
  const bool sound = refine(question.x);
  result.upper = objective();
  if (optimal) result.lower = std::max(result.lower, result.upper * (1 - price_margin));
  result.combined = sound && artificial_part() < no_artificial_part;
  if (result.combined && result.upper <= question.accept) {
    result.answer = Membership::Answer::inside;
  } else if (sound && optimal) {
    result.answer = Membership::Answer::outside;
    keep_multipliers(1 + price_margin);
    store(question.warm, result, 1 + price_margin);
  }
}

std::vector<CombinationTerm> IncrementalSimplex::combination() const {
  const auto counts = [this](std::size_t k) { return work_.columns[k].vertex >= 0 && lambda_[k] != 0; };
  std::size_t most = 0;
  for (std::size_t k = 0; k < size_; ++k) most += counts(k) ? 1 : 0;
  std::vector<CombinationTerm> terms;
  terms.reserve(most);
  for (std::size_t k = 0; k < size_; ++k) {
    if (!counts(k)) continue;
    const BasisColumn& column = work_.columns[k];
    CombinationTerm term{column.vertex, column.element, column.conjugated, lambda_[k]};
    if (kind_ == PolytopeKind::complex) {
      term.coefficient = std::polar(std::abs(lambda_[k]), column.phase);
      if (lambda_[k] < 0) term.coefficient = -term.coefficient;
    }
    const auto same = std::find_if(terms.begin(), terms.end(), [&term](const CombinationTerm& t) {
      return t.vertex == term.vertex && t.element == term.element && t.conjugated == term.conjugated;
    });
    if (same == terms.end()) {
      terms.push_back(term);
    } else {
      same->coefficient += term.coefficient;
    }
  }
  return terms;
}

std::size_t IncrementalSimplex::bytes() const {
  return vertices_.capacity() * sizeof(double) + cache_.size() * bytes_of_basis() +
         (blocks_.capacity() + prices_.capacity() + peaks_.capacity()) * sizeof(float);
}

std::size_t IncrementalSimplex::bytes_of_next_vertex() const {
  const auto growth = [](const auto& v, std::size_t more) {
    return v.size() + more > v.capacity() ? (v.size() + more + v.size() / 4) * sizeof(v.front()) : 0;
  };
  return growth(vertices_, stride_) + growth(blocks_, block_size * size_);
}

}  // namespace subcert::polytope
