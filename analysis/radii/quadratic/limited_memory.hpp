#pragma once
/// Directions of descent by L-BFGS. Inner header.

#include <subcert/analysis/radii/polytope_search/dense.hpp>
#include <subcert/analysis/radii/polytope_search/kernels.hpp>

#include <algorithm>
#include <deque>
#include <optional>

namespace subcert::quadratic {

/// The last steps of a descent and what they changed in the gradient. Ref: [Noc80].
class LimitedMemory {
 public:
  /// `first`: the length of the first step.
  explicit LimitedMemory(double first) : first_(first) {}

  void remember(double share, const polytope::Vector& direction, const polytope::Vector& before,
                const polytope::Vector& after) {
    Step step{direction, after, 0};
    for (double& entry : step.step) entry *= share;
    add(step.change, -1, before);
    step.product = inner(step.step, step.change);
    if (!(step.product > 1e-14 * polytope::norm(step.step) * polytope::norm(step.change))) return;
    steps_.push_back(std::move(step));
    if (steps_.size() > remembered) steps_.pop_front();
  }

  /// Where to go from here, downhill; nothing at a zero of the gradient.
  std::optional<polytope::Vector> direction(const polytope::Vector& gradient) {
    for (;; steps_.clear()) {
      polytope::Vector result = by_memory(gradient);
      if (inner(gradient, result) < 0) return result;
      if (steps_.empty()) return std::nullopt;
    }
  }

 private:
  static constexpr std::size_t remembered = 15;

  struct Step {
    polytope::Vector step, change;
    double product;
  };

  /// a += factor * b
  static void add(polytope::Vector& a, double factor, const polytope::Vector& b) {
    factor = -factor;
    polytope::kernels::rank_one(a.data(), a.size(), 1, b.data(), &factor);
  }
  static double inner(const polytope::Vector& a, const polytope::Vector& b) {
    return polytope::kernels::dot(a.data(), b.data(), a.size());
  }

  polytope::Vector by_memory(const polytope::Vector& gradient) const {
    polytope::Vector result(gradient.size());
    add(result, -1, gradient);
    std::vector<double> shares(steps_.size());
    for (std::size_t i = steps_.size(); i-- > 0;) {
      shares[i] = inner(steps_[i].step, result) / steps_[i].product;
      add(result, -shares[i], steps_[i].change);
    }
    const double length = steps_.empty() ? first_ / std::max(polytope::norm(gradient), 1e-300)
                                         : steps_.back().product / inner(steps_.back().change, steps_.back().change);
    for (double& entry : result) entry *= length;
    for (std::size_t i = 0; i < steps_.size(); ++i)
      add(result, shares[i] - inner(steps_[i].change, result) / steps_[i].product, steps_[i].step);
    return result;
  }

  double first_;
  std::deque<Step> steps_;
};

}  // namespace subcert::quadratic
