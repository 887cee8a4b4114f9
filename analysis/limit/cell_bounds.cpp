#include "cell_bounds.hpp"

#include <subcert/analysis/difference/difference.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace subcert::cells {
namespace {

using namespace outward;

constexpr std::size_t most_moments = 4;
constexpr std::size_t most_words = 16;  // looked at one by one where the remainder of a cell is bounded

std::vector<double> rounded(const std::vector<Rational>& coefficients) {
  std::vector<double> result;
  for (const Rational& c : coefficients) result.push_back(outward::to_double(c));
  return result;
}

VectorPolynomial recentred(const VectorPolynomial& p, const Recentring& matrix, std::size_t length) {
  const std::size_t nodes = p.errors.size();
  VectorPolynomial result{std::vector<double>(nodes * length, 0.0), std::vector<double>(nodes, 0.0), {}};
  for (std::size_t j = 0; j < nodes; ++j) {
    const double norm = one_norm(&p.coefficients[j * length], length);
    for (std::size_t i = 0; i <= j; ++i) {
      const double factor = matrix(i, j);
      for (std::size_t k = 0; k < length; ++k)
        result.coefficients[i * length + k] += factor * p.coefficients[j * length + k];
      result.errors[i] += std::abs(factor) * (p.errors[j] + gamma(nodes) * norm);
    }
  }
  for (double& error : result.errors) error = up(error);
  return result;
}

}  // namespace

CellBounds::CellBounds(const CellSetup& setup, bool exact)
    : setup_(setup),
      length_(setup.rows_width()),
      transition_(rounded(RefinementWindow(divided_difference_scheme(setup.mask, setup.order())).coefficients),
                  setup.arity) {
  if (transition_.width() != length_)
    throw std::logic_error("limit cells: the widths of the mask and of its difference scheme do not fit");
  for (int t = 0; t < setup.arity; ++t) recentring_.emplace_back(setup.arity, t, 2 * most_nodes - 1);
  if (exact) return;
  set_fit(std::min<std::size_t>({static_cast<std::size_t>(sum_rules(setup.mask)), most_moments, setup.width}));
  set_contraction();
}

// ---- How a remainder shrinks from level to level

/// The least squares fit by polynomials of degree count - 1 in position_[k]. Its rounding errors matter to no bound:
/// every polynomial may be taken.
void CellBounds::set_fit(std::size_t count) {
  const std::size_t width = setup_.width;
  moments_ = count;
  for (std::size_t k = 0; k < width; ++k)
    position_.push_back((2 * static_cast<double>(k) + 1 - static_cast<double>(width)) / static_cast<double>(width));
  std::vector<std::vector<double>> basis, in_powers;  // orthonormal, and its coefficients
  for (std::size_t q = 0; q < count; ++q) {
    std::vector<double> values_of_q(width), powers(count, 0.0);
    for (std::size_t k = 0; k < width; ++k) values_of_q[k] = std::pow(position_[k], static_cast<double>(q));
    powers[q] = 1;
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t r = 0; r < q; ++r) {
        const double part = dot(values_of_q.data(), basis[r].data(), width);
        for (std::size_t k = 0; k < width; ++k) values_of_q[k] -= part * basis[r][k];
        for (std::size_t i = 0; i < count; ++i) powers[i] -= part * in_powers[r][i];
      }
    const double norm = std::sqrt(dot(values_of_q.data(), values_of_q.data(), width));
    for (double& x : values_of_q) x /= norm;
    for (double& x : powers) x /= norm;
    basis.push_back(std::move(values_of_q));
    in_powers.push_back(std::move(powers));
  }
  fit_.assign(count * width, 0.0);
  for (std::size_t q = 0; q < count; ++q)
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < width; ++k) fit_[i * width + k] += in_powers[q][i] * basis[q][k];
}

/// Subtracts a polynomial in k of degree below `moments` from x; returns a bound for the rounding error of an entry.
double CellBounds::remove_polynomial(double* x) const {
  const std::size_t width = setup_.width;
  double c[most_moments] = {}, size = largest(x, width);
  for (std::size_t i = 0; i < moments_; ++i) {
    c[i] = dot(&fit_[i * width], x, width);
    size += std::abs(c[i]);
  }
  for (std::size_t k = 0; k < width; ++k) {
    double value = 0;
    const double place = position_[k];
    for (std::size_t i = moments_; i-- > 0;) value = value * place + c[i];
    x[k] -= value;
  }
  return up(gamma(0) * size);
}

/// contraction_[j]: the matrix of j steps has the rows (A_{q - l})_l, 0 <= l < width, cut out of the coefficients A of
/// the j-th power of the mask; a polynomial in l may be taken off each, as epsilon is orthogonal to it.
void CellBounds::set_contraction() {
  const double norm_of_mask = to_double_above(operator_norm(setup_.mask));
  const std::vector<double> mask_coefficients = rounded(setup_.window.coefficients);
  const auto arity = static_cast<std::size_t>(setup_.arity), width = setup_.width;
  std::vector<double> coefficients{1.0};
  double error = 0, size = 1;
  contraction_.assign(1, 1.0);
  for (int j = 1;; ++j) {
    const double work = real_power(setup_.arity, j) * static_cast<double>(width * width) *
                        static_cast<double>(2 * moments_ + 2);
    if (j > 1 && work > 4e6) break;
    std::vector<double> finer(mask_coefficients.size() + (coefficients.size() - 1) * arity, 0.0);
    for (std::size_t q = 0; q < coefficients.size(); ++q)
      for (std::size_t i = 0; i < mask_coefficients.size(); ++i)
        finer[q * arity + i] += coefficients[q] * mask_coefficients[i];
    error = up(norm_of_mask * (error + gamma(mask_coefficients.size()) * size));
    coefficients = std::move(finer);
    size = up(largest(coefficients.data(), coefficients.size()) + error);
    const auto count = static_cast<std::size_t>(int_power(setup_.arity, j));
    contraction_.push_back(up(worst_row(coefficients, count) + static_cast<double>(width) * error));
  }
  for (std::size_t j = 1; j < contraction_.size(); ++j)
    contraction_[j] = std::min(contraction_[j], difference_bound(static_cast<int>(j)));
}

/// The largest sum over rows of what is left of an entry, over the `count` matrices of one length.
double CellBounds::worst_row(const std::vector<double>& coefficients, std::size_t count) const {
  const std::size_t width = setup_.width;
  double worst = 0;
  std::vector<double> sums(width), window(width);
  for (std::size_t r = 0; r < count; ++r) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t q = r; q < count * width; q += count) {
      for (std::size_t l = 0; l < width; ++l)
        window[l] = l <= q && q - l < coefficients.size() ? coefficients[q - l] : 0;
      const double rounding = remove_polynomial(window.data());
      for (std::size_t l = 0; l < width; ++l) sums[l] += std::abs(window[l]) + rounding;
    }
    worst = std::max(worst, largest(sums.data(), width));
  }
  return worst;
}

/// By differences: epsilon = nabla^m eta, || eta || <= (width / 2)^m || epsilon ||.
double CellBounds::difference_bound(int level) const {
  const int order = setup_.order();
  return up(setup_.contraction.norm_bound(level) * real_power(static_cast<int>(setup_.width), order) /
            real_power(setup_.arity, order * level));
}

double CellBounds::contraction_bound(int level) const {
  if (contraction_.empty()) return 0;
  const auto known = static_cast<int>(contraction_.size()) - 1;
  double result = 1;
  for (int rest = level; rest > 0; rest -= known)
    result = up(result * contraction_[static_cast<std::size_t>(std::min(rest, known))]);
  return level == 0 ? 1 : std::min(result, difference_bound(level));
}

/// The least bound B with B <= top (1 + r_1 + ... + r_{q-1}) + r_q B, r_i = arity^(growth i level) contraction(i
/// level).
double CellBounds::geometric(double top, int level, int growth) const {
  double sum = 1, best = infinite;
  for (int q = 1; q <= 64; ++q) {
    const double ratio = up(contraction_bound(q * level) * real_power(setup_.arity, growth * q * level));
    if (ratio < 1) best = std::min(best, up(up(top * sum) / (1 - ratio)));
    sum = up(sum + ratio);
  }
  return best;
}

// ---- The remainder of all cells

/// On the cells one level finer.
std::vector<VectorPolynomial> CellBounds::recentred(const std::vector<VectorPolynomial>& pieces) const {
  std::vector<VectorPolynomial> finer;
  for (const VectorPolynomial& piece : pieces)
    for (const Recentring& matrix : recentring_) finer.push_back(cells::recentred(piece, matrix, length_));
  return finer;
}

/// The words with one digit before them: piece[t * count + word] + arity^-m T_t words[word].
std::vector<VectorPolynomial> CellBounds::longer(const std::vector<VectorPolynomial>& words,
                                                 std::vector<VectorPolynomial> pieces) const {
  const double shrink = 1 / real_power(setup_.arity, setup_.order()), norm = norm_of_step();
  std::vector<double> image(length_);
  for (std::size_t at = 0; at < pieces.size(); ++at) {
    const VectorPolynomial& word = words[at % words.size()];
    VectorPolynomial& sum = pieces[at];
    for (std::size_t j = 0; j < sum.errors.size(); ++j) {
      const double* source = &word.coefficients[j * length_];
      transition_.apply(static_cast<long>(at / words.size()), source, image.data());
      for (std::size_t k = 0; k < length_; ++k) sum.coefficients[j * length_ + k] += shrink * image[k];
      const double moved = shrink * norm * one_norm(source, length_);
      sum.errors[j] = up(sum.errors[j] + shrink * norm * word.errors[j] + gamma(length_) * moved +
                         gamma(4) * one_norm(&sum.coefficients[j * length_], length_));
    }
  }
  return pieces;
}

/// Largest 1-norms over the words of the m-th differences: what they contribute to epsilon and to epsilon'.
std::pair<double, double> CellBounds::largest_differences(const std::vector<VectorPolynomial>& words) const {
  double value = 0, slope = 0;
  std::vector<double> differences;
  for (const VectorPolynomial& word : words) {
    double value_sum = 0, slope_sum = 0;
    for (std::size_t j = 0; j < word.errors.size(); ++j) {
      const double* c = &word.coefficients[j * length_];
      differences.assign(c, c + length_);
      for (int m = 0; m < setup_.order(); ++m) {
        differences.push_back(0);
        for (std::size_t k = differences.size(); k-- > 1;) differences[k] -= differences[k - 1];
      }
      const double norm = one_norm(differences.data(), differences.size()) + 4 * word.errors[j] +
                          gamma(4) * 4 * one_norm(c, length_);
      value_sum += half_power(j) * norm;
      slope_sum += static_cast<double>(j) * 2 * half_power(j) * norm;
    }
    value = std::max(value, up(value_sum));
    slope = std::max(slope, up(slope_sum));
  }
  return {value, slope};
}

Remainder CellBounds::remainder(const std::vector<VectorPolynomial>& sources) const {
  const int arity = setup_.arity;
  Remainder result;
  result.words = sources;
  result.word_level = 1;
  std::vector<VectorPolynomial> all = sources, pieces = sources;  // pieces[t * count + word]: k_t on the cell of word
  int level = 1;
  const auto work = static_cast<double>(length_ * length_) / 2 * static_cast<double>(sources.front().errors.size());
  while (real_power(arity, level + 1) <= 256 && real_power(arity, level + 1) * work <= 1.5e7) {
    pieces = recentred(pieces);
    all = longer(all, pieces);
    ++level;
    if (all.size() <= most_words) {
      result.words = all;
      result.word_level = level;
    }
  }
  for (VectorPolynomial& word : result.words)
    for (std::size_t j = 0; j < word.errors.size(); ++j)
      word.norms.push_back(one_norm(&word.coefficients[j * length_], length_));
  const auto [value, slope] = largest_differences(all);
  result.value = geometric(value, level, 0);
  result.slope = setup_.order() == 2 ? geometric(up(slope * real_power(arity, level)), level, 1) : infinite;
  return result;
}

std::pair<double, double> CellBounds::square_bounds(const Remainder& rest, int level, bool slopes) const {
  if (rest.value == 0) return {0, 0};
  const double factor = contraction_bound(level);
  const double value = up(factor * rest.value);
  const double slope = slopes ? up(up(factor * rest.slope) * real_power(setup_.arity, level)) : 0;
  return {up(value * value / 2), up(value * slope)};
}

// ---- The remainder of one cell

/// A bound for |row . eta| / rest.value, and at the same time for |row . eta'| / rest.slope: the row is the m-th
/// difference of a longer one, of which a polynomial may be taken off.
double CellBounds::pairing(const double* row, double error) const {
  const std::size_t width = setup_.width;
  thread_local std::vector<double> sums;
  sums.assign(row, row + length_);
  for (int m = 0; m < setup_.order(); ++m) {
    double sum = 0, size = 0;
    for (double& x : sums) {  // s_k - s_{k+1} = x_k with s_0 = 0
      size += std::abs(x);
      const double next = sum - x;
      x = sum;
      sum = next;
    }
    sums.push_back(sum);
    error = up(static_cast<double>(width) * error + gamma(width) * size);
  }
  const double rounding = remove_polynomial(sums.data());
  return up(largest(sums.data(), width) + rounding + error);
}

RowBounds CellBounds::row_bounds(const RowSpan& span, const Remainder& rest, bool slopes) const {
  RowBounds bounds;
  if (rest.value == 0) return bounds;
  const int arity = setup_.arity;
  const std::vector<double> errors = row_errors(span.losses, span.rows.size() / length_);
  const double scale = up(span.factor / real_power(arity, setup_.order() * span.level));
  const double speed = real_power(arity, span.level);
  const double shrink = contraction_bound(rest.word_level), faster = real_power(arity, rest.word_level);
  for (std::size_t j = 0; j < errors.size(); ++j) {
    const double* row = &span.rows[j * length_];
    const double paired = up(pairing(row, errors[j]) * shrink), size = up(largest(row, length_) + errors[j]);
    double value = 0, slope = 0;  // of row . eta on the words
    for (const VectorPolynomial& word : rest.words) {
      double value_sum = 0, slope_sum = 0;
      for (std::size_t l = 0; l < word.errors.size(); ++l) {
        const double* c = &word.coefficients[l * length_];
        const double term = std::abs(dot(row, c, length_)) + (errors[j] + gamma(length_) * size) * word.norms[l] +
                            size * word.errors[l];
        value_sum += half_power(l) * term;
        slope_sum += static_cast<double>(l) * 2 * half_power(l) * term;
      }
      value = std::max(value, up(value_sum));
      slope = std::max(slope, up(slope_sum));
    }
    value = up(value + paired * rest.value);
    bounds.value[j] = up(scale * half_power(j) * value);
    if (slopes)
      bounds.slope[j] = up(scale * speed * half_power(j) *
                           up(faster * up(slope + paired * rest.slope) + 2 * static_cast<double>(j) * value));
  }
  return bounds;
}

std::vector<double> CellBounds::row_errors(const std::vector<double>& losses, std::size_t count) const {
  const std::size_t steps = losses.size() / count;
  std::vector<double> errors(count, 0.0);
  for (std::size_t k = 0; k < steps; ++k) {
    const double norm = setup_.contraction.norm_bound(static_cast<int>(steps - 1 - k));
    for (std::size_t j = 0; j < count; ++j) errors[j] = up(errors[j] + norm * losses[k * count + j]);
  }
  return errors;
}

}  // namespace subcert::cells
