#include "bessel_sum.hpp"

namespace subcert::theorems {
namespace {

/// j_l' = (l j_{l-1} - (l+1) j_{l+1})/(2l+1).
std::vector<Ball> differentiated(const std::vector<Ball>& c) {
  std::vector<Ball> result(c.size() + 1, Ball(0, c.front().bits()));
  for (std::size_t l = 0; l < c.size(); ++l) {
    const auto degree = static_cast<long>(l);
    const Ball share = c[l] / (2 * degree + 1);
    if (l > 0) result[l - 1] += share * degree;
    result[l + 1] = result[l + 1] - share * (degree + 1);
  }
  return result;
}

}  // namespace

BesselTable::BesselTable(const Ball& point, std::size_t count) {
  values_.push_back(sin(point) / point);
  if (count > 1) values_.push_back((values_.front() - cos(point)) / point);
  for (std::size_t l = 1; l + 1 < count; ++l)
    values_.push_back(values_[l] * (2 * static_cast<long>(l) + 1) / point - values_[l - 1]);
}

BesselSum::BesselSum(std::vector<Ball> coefficients) : derivatives_{std::move(coefficients)} {
  for (int k = 1; k < order; ++k) derivatives_.push_back(differentiated(derivatives_.back()));
}

Ball BesselSum::over(const BesselTable& table, const Ball& radius) const {
  const slong bits = radius.bits();
  const Ball step = Ball(0, bits).widened(radius);
  Ball sum(bits), power(1, bits);
  long k = 0;
  for (const std::vector<Ball>& c : derivatives_) {
    Ball value(bits);
    for (std::size_t l = 0; l < c.size(); ++l) value.add_product(c[l], table[l]);
    sum.add_product(value, power);
    power = power * step / ++k;
  }
  Ball rest(bits);
  for (const Ball& c : derivatives_.front()) rest += abs(c);
  return sum + power * rest / (order + 1);
}

Ball BesselSum::decay(const Ball& from) const {
  // f is the transform of g = sum of a_l P_l up to factors i; v f = boundary terms - the transform of g'. Even and odd
  // l are kept apart, as their transforms are real and imaginary.
  std::vector<Ball> a = derivatives_.front();
  for (std::size_t l = 0; l < a.size(); ++l)
    if (l % 4 >= 2) a[l] = -a[l];
  Ball sum(from.bits()), factor(1, from.bits());
  for (; !a.empty(); factor = factor / from) {
    Ball ends[2] = {Ball(from.bits()), Ball(from.bits())};
    for (std::size_t l = 0; l < a.size(); ++l) ends[l % 2] += a[l];
    sum += (abs(ends[0]) + abs(ends[1])) * factor;
    // P_l' = the sum of (2k+1) P_k over k = l-1, l-3, ...
    Ball above[2] = {Ball(from.bits()), Ball(from.bits())};
    for (std::size_t l = a.size(); l-- > 0;) {
      const Ball derivative = above[(l + 1) % 2] * (2 * static_cast<long>(l) + 1);
      above[l % 2] += a[l];
      a[l] = derivative;
    }
    a.pop_back();
  }
  return sum;
}

Ball BesselSum::on_disc(const Ball& radius) const {
  // |j_l(z)| <= sum over i of |z|^(l+2i)/(2^i i! (2l+2i+1)!!); for |z| <= 64 the terms from i = 120 on fall by more
  // than a half each.
  const slong bits = radius.bits();
  Ball sum(bits), head(1, bits);
  for (std::size_t l = 0; l < derivatives_.front().size(); ++l) {
    const auto degree = static_cast<long>(l);
    if (l > 0) head = head * radius / (2 * degree + 1);
    Ball term = head, bound = head;
    for (long i = 1; i < 120; ++i) {
      term = term * radius * radius / (2 * i * (2 * degree + 2 * i + 1));
      bound += term;
    }
    sum += abs(derivatives_.front()[l]) * (bound + term);
  }
  return sum;
}

}  // namespace subcert::theorems
