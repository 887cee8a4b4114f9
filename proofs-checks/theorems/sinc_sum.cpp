#include "sinc_sum.hpp"

namespace subcert::theorems {
namespace {

Ball zero_centred(const Ball& radius) { return Ball(0, radius.bits()).widened(radius); }

}  // namespace

SincTable::SincTable(const Ball& point, int count) {
  const Ball sine = sin(point), cosine = cos(point);
  for (int k = 0; k < count; ++k) {
    const Ball& wave = k % 2 == 0 ? sine : cosine;
    Ball value = k % 4 < 2 ? wave : -wave;
    if (k > 0) value = value - values_.back() * k;
    values_.push_back(value / point);
  }
}

SincSum SincSum::derivative() const {
  std::vector<Ball> shifted{Ball(0, c_.front().bits())};
  shifted.insert(shifted.end(), c_.begin(), c_.end());
  return SincSum(shifted);
}

Ball SincSum::over(const SincTable& table, const Ball& radius) const {
  const slong bits = c_.front().bits();
  const Ball step = zero_centred(radius);
  Ball sum(bits), power(1, bits);
  for (int l = 0; l < order; ++l) {
    Ball derivative(bits);
    for (std::size_t k = 0; k < c_.size(); ++k) derivative += c_[k] * table[k + static_cast<std::size_t>(l)];
    sum += derivative * power;
    power = power * step / (l + 1);
  }
  Ball rest(bits);
  for (std::size_t k = 0; k < c_.size(); ++k) rest += abs(c_[k]) / (static_cast<long>(k) + order + 1);
  return sum + power * rest;
}

Ball SincSum::decay(const Ball& from) const {
  const slong bits = c_.front().bits();
  Ball even(bits), odd(bits);
  std::vector<Ball> lowered;
  for (std::size_t k = 0; k < c_.size(); ++k) {
    (k % 2 == 0 ? even : odd) += k % 4 < 2 ? c_[k] : -c_[k];
    if (k > 0) lowered.push_back(c_[k] * static_cast<long>(k));
  }
  const Ball boundary = abs(even) + abs(odd);
  return lowered.empty() ? boundary : boundary + SincSum(lowered).decay(from) / from;
}

Ball SincSum::on_disc(const Ball& radius) const {
  // |sinc^(k)(z)| <= the integral of t^k cosh(t |z|) over [0, 1] = sum of |z|^2i / ((2i)! (2i+k+1)); for |z| <= 8 the
  // terms from i = 60 on are below 2^-190 together.
  const slong bits = c_.front().bits();
  Ball sum(bits);
  for (std::size_t k = 0; k < c_.size(); ++k) {
    Ball term(1, bits), integral = Ball(1, bits).scaled(-190);
    for (long i = 0; i < 60; ++i) {
      integral += term / (2 * i + static_cast<long>(k) + 1);
      term = term * radius * radius / ((2 * i + 1) * (2 * i + 2));
    }
    sum += abs(c_[k]) * integral;
  }
  return sum;
}

}  // namespace subcert::theorems
