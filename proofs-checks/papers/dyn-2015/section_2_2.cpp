// Section 2.2: the basic limit function.

#include "checks.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::dyn_2015 {
namespace {

/// (6), between a level and the next: the limit does not change when the data are refined.
Outcome limits_from_shifts(const Context& context) {
  const int most = context.reach(5, 12);
  constexpr int level = 3;
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const Mask mask = s_n(n);
    const LimitValues phi = limit_values(mask, level + 1);
    const long reach = 6 * n;
    const auto datum = [](long j) { return Rational(j * j % 7 - 3, j % 2 == 0 ? 1 : 2); };
    const auto refined = [&](long i) {
      Rational sum = 0;
      for (long j = -2 * reach; j <= 2 * reach; ++j) sum += mask.symbol().coefficient(i - 2 * j) * datum(j);
      return sum;
    };
    std::vector<Rational> finer;
    for (long i = -reach; i <= reach; ++i) finer.push_back(refined(i));
    for (long index = 0; index <= 8; ++index) {  // x = index / 8
      Rational coarse = 0, fine = 0;
      for (long j = -reach; j <= reach; ++j) {
        coarse += datum(j) * phi.at(2 * (index - 8 * j));
        fine += finer[static_cast<std::size_t>(j + reach)] * phi.at(2 * 2 * index - 16 * j);
      }
      trial.equal(coarse, fine, at("n", n) + ", " + at("x", Rational(index, 8)));
    }
  }
  return trial.for_all("all n >= 1",
                       "every level is linear in the data and moves with them, few data matter at a point, and S_n "
                       "converges (theorem-1); compared for " +
                           range(1, most) + ", x = 0, 1/8, ..., 1, one set of data, refined once and not");
}

Outcome support(const Context& context) {
  const int most = context.reach(20, 100);
  Trial trial = limit_supports(context.formula("support-lower"), context.formula("support-upper"), s_n, 1, most);
  return trial.for_all("all n >= 1",
                       "by (3) the mask runs from -2n+1 to 2n-1 for every n, and its ends are those of the support");
}

Outcome positive_inside(const Context& context) {
  const int most = context.reach(6, 12);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const Rational end = 2 * n - 1;
    const Decision inside = is_positive(s_n(n), -end + Rational(1, 64), end - Rational(1, 64));
    trial.require(inside.is_yes(), at("n", n) + ": " + inside.reason);
  }
  trial.follow(positive(context.formula("eq-3-odd"), {{"n", "1 + x"}}));
  trial.follow(positive(context.formula("eq-3-even"), {{"n", "1 + x"}}));
  return trial.for_all(
      "all n >= 1",
      "a scheme with a positive mask on consecutive indices has a positive basic limit function inside its "
      "support; also decided for " +
          range(1, most));
}

Outcome partition_of_unity(const Context& context) {
  const int most = context.reach(10, 30);
  constexpr int level = 4;
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const LimitValues phi = limit_values(s_n(n), level);
    for (long i = 0; i < 16; ++i) {
      Rational sum = 0;
      for (long j = -2 * n; j <= 2 * n; ++j) sum += phi.at(i - 16 * j);
      trial.equal(1, sum, at("n", n) + ", " + at("x", Rational(i, 16)));
    }
  }
  trial.follow(sum_identity({context.formula("eq-3-odd"), "j", {-1, 1}, {1, 0}}, f("1"), {{"n", 1}}));
  trial.follow(sum_identity({context.formula("eq-3-even"), "j", {-1, 1}, {1, -1}}, f("1"), {{"n", 1}}));
  return trial.for_all("all n >= 1",
                       "the weights of both rules sum to 1, an identity in n, so that data 1 have the limit 1; values "
                       "compared for " +
                           range(1, most) + " at all dyadic x of level 4");
}

Outcome limits_at_integers(const Context& context) {
  const int most = context.reach(20, 60);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const LimitValues phi = limit_values(s_n(n), 0);
    for (long j : {-2 * n + 1, 2 * n - 1}) trial.equal(0, phi.at(j), at("n", n) + ", phi at " + std::to_string(j));
    trial.require(phi.at(-2 * n + 2) != 0 && phi.at(2 * n - 2) != 0, at("n", n) + ": the sum could be shorter");
  }
  return trial.for_all("all n >= 1",
                       "phi_n is continuous, so that it vanishes at the ends of its support, and positive inside "
                       "(phi-positive); values compared for " +
                           range(1, most));
}

Outcome symmetric(const Context& context) {
  const int most = context.reach(10, 30);
  constexpr int level = 4;
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const Mask mask = s_n(n);
    trial.require(symmetry(mask).kind == Symmetry::odd && symmetry(mask).centre == 0, at("n", n) + ", the mask");
    const LimitValues phi = limit_values(mask, level);
    const long end = 16 * (2 * n - 1);
    for (long i = 1; i <= end; ++i) trial.equal(phi.at(i), phi.at(-i), at("n", n) + ", " + at("x", Rational(i, 16)));
  }
  return trial.for_all("all n >= 1",
                       "the mask is its own mirror image about 0 (odd-symmetry), so that phi_n(-x) solves the same "
                       "refinement equation, whose solution of mean 1 is unique as S_n converges (theorem-1); values "
                       "compared for " +
                           range(1, most) + " at all dyadic x of level 4");
}

/// The (4n-3) x (4n-3) matrix a_{2k-m}, k and m from -2n+2 to 2n-2.
RationalMatrix refinement_matrix(int n) {
  const Mask mask = s_n(n);
  const auto size = static_cast<std::size_t>(4 * n - 3);
  RationalMatrix matrix(size, size);
  const long first = -2 * n + 2;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j)
      matrix(i, j) = mask.symbol().coefficient(2 * (first + static_cast<long>(i)) - (first + static_cast<long>(j)));
  return matrix;
}

/// A matrix for each n: the printed entries, r or s by column so many times, are those that were derived, and the
/// values of phi_n at -2n+2, -2n+3, ... are an eigenvector. `also` checks what else is said.
template <class Times, class Also>
Outcome matrix_as_printed(const Context& context, RationalMatrix (*derive)(int n), const Times& times,
                          const Also& also) {
  const Formula r = context.formula("r"), s = context.formula("s");
  const int most = context.reach(8, 20);
  Trial trial;
  for (int n = 1; n <= most && !trial.failed(); ++n) {
    const RationalMatrix derived = derive(n);
    const std::size_t size = derived.rows();
    const LimitValues phi = limit_values(s_n(n), 0);
    for (std::size_t i = 0; i < size; ++i) {
      Rational image = 0;
      for (std::size_t j = 0; j < size; ++j) {
        trial.equal(times(size, i, j) * (j % 2 == 0 ? r : s)({{"n", n}}), derived(i, j),
                    at("n", n) + ", row " + std::to_string(i + 1) + ", column " + std::to_string(j + 1));
        image += derived(i, j) * phi.at(-2 * n + 2 + static_cast<long>(j));
      }
      trial.equal(phi.at(-2 * n + 2 + static_cast<long>(i)), image,
                  at("n", n) + ", the eigenvector at row " + std::to_string(i + 1));
    }
    also(trial, n, derived);
  }
  return trial.over(range(1, most));
}

/// Row i of the printed matrices up to the first zeros: 2i entries r, s, r, s, ..., as many as the row has room for.
/// The rows below the middle mirror those above it.
Outcome matrix_a(const Context& context) {
  const auto times = [](std::size_t size, std::size_t i, std::size_t j) {
    const auto reaches = [size](std::size_t row, std::size_t column) {
      return column < 2 * (row + 1) || 2 * (row + 1) >= size;
    };
    return reaches(i, j) && reaches(size - 1 - i, size - 1 - j) ? 1 : 0;
  };
  return matrix_as_printed(context, refinement_matrix, times, [](Trial& trial, int n, const RationalMatrix& derived) {
    for (std::size_t j = 0; j < derived.columns(); ++j) {
      Rational sum = 0;
      for (std::size_t i = 0; i < derived.rows(); ++i) sum += derived(i, j);
      trial.equal(1, sum, at("n", n) + ", sum of column " + std::to_string(j + 1));
    }
  });
}

/// The (2n-1) x (2n-1) matrix with the columns beyond the middle added to their mirror images.
RationalMatrix folded_matrix(int n) {
  const RationalMatrix whole = refinement_matrix(n);
  const auto size = static_cast<std::size_t>(2 * n - 1);
  RationalMatrix folded(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j)
      folded(i, j) = j + 1 == size ? whole(i, j) : Rational(whole(i, j) + whole(i, whole.rows() - 1 - j));
  return folded;
}

/// The folded matrix as printed: r and s where one of the two mirrored columns is reached, twice that where both are.
/// No entry is below the one above it, and no row equals the one before it.
Outcome matrix_a_tilde(const Context& context) {
  // Printed: the row i+1 holds 2(i+1) entries from the left, and what passes the last column is folded back.
  const auto times = [](std::size_t size, std::size_t i, std::size_t j) {
    const std::size_t row_length = 2 * (i + 1), folded = row_length > size ? row_length - size : 0;
    return j >= row_length ? 0 : j + 1 < size && j + 1 + folded >= size ? 2 : 1;
  };
  return matrix_as_printed(context, folded_matrix, times, [](Trial& trial, int n, const RationalMatrix& derived) {
    for (std::size_t i = 1; i < derived.rows(); ++i) {
      const std::string row = at("n", n) + ": row " + std::to_string(i + 1);
      bool grows = false;
      for (std::size_t j = 0; j < derived.columns(); ++j) {
        trial.require(derived(i, j) >= derived(i - 1, j), row + " is not above the one before it");
        grows = grows || derived(i, j) > derived(i - 1, j);
      }
      trial.require(grows, row + " equals the one before it");
    }
  });
}

/// The two rows from which the value at -n follows: the last one is twice the row n-1, and r in the last place.
Outcome rows_of_the_proof(const Context& context) {
  const Formula r = context.formula("r"), s = context.formula("s");
  const int most = context.reach(8, 20);
  Trial trial;
  for (int n = 2; n <= most && !trial.failed(); ++n) {
    const RationalMatrix folded = folded_matrix(n);
    const std::size_t last = folded.rows() - 1, row = static_cast<std::size_t>(n) - 2;
    for (std::size_t j = 0; j <= last; ++j) {
      const std::string where = at("n", n) + ", column " + std::to_string(j + 1);
      trial.equal(j == last ? Rational(0) : (j % 2 == 0 ? r : s)({{"n", n}}), folded(row, j), where + ", row n-1");
      trial.equal(2 * folded(row, j) + (j == last ? r({{"n", n}}) : Rational(0)), folded(last, j),
                  where + ", the last row");
    }
  }
  return trial.over(range(2, most));
}

Outcome increasing_values(const Context& context) {
  const int most = context.reach(20, 60);
  Trial trial;
  for (int n = 1; n <= most && !trial.failed(); ++n) {
    const LimitValues phi = limit_values(s_n(n), 0);
    trial.require(phi.at(-2 * n + 2) > 0, at("n", n) + ": phi(-2n+2) is not positive");
    for (long k = -2 * n + 2; k < 0; ++k) {
      const Rational step = phi.at(k + 1) - phi.at(k);
      trial.require(step > 0, at("n", n) + ", phi does not grow from " + std::to_string(k));
      trial.equal(step, phi.at(2 * k + 2 * n) / (2 * n - 1) + phi.at(2 * k + 2 * n + 1) / (2 * n),
                  at("n", n) + ", step at " + std::to_string(k));
    }
  }
  return trial.for_all(
      "all n >= 1",
      "phi(k+1) - phi(k) = phi(2k+2n)/(2n-1) + phi(2k+2n+1)/(2n) for -2n+2 <= k < 0, which is positive; steps "
      "compared for " +
          range(1, most));
}

Outcome value_at_n(const Context& context) {
  const Formula ratio = context.formula("prop-3-ratio");
  const int most = context.reach(20, 60);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const LimitValues phi = limit_values(s_n(n), 0);
    trial.equal(Rational(ratio({{"n", n}}) * phi.at(0)), phi.at(-n), at("n", n) + ", phi(-n)");
  }
  trial.follow(identity(ratio, f("(1 - 1/(2*n - 1))/2"), {{"n", 1}}));
  return trial.for_all("all n >= 1",
                       "phi(0) = 2 phi(-n) + phi(0)/(2n-1), because the mask is constant on even and on odd indices");
}

Outcome equation_9(const Context& context) {
  const Formula half = context.formula("eq-9-half"), ratio = context.formula("prop-3-ratio");
  const int most = context.reach(20, 60);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const LimitValues phi = limit_values(s_n(n), 0);
    for (long j = n; j <= 2 * n; ++j)
      trial.require(phi.at(j) < half({}) * phi.at(0) && phi.at(-j) < half({}) * phi.at(0),
                    at("n", n) + ", " + at("j", j));
  }
  trial.follow(identity(half - ratio, f("1/(4*n - 2)"), {{"n", 1}}));
  return trial.for_all(
      "all n >= 1", "phi decreases away from 0, and phi(n)/phi(0) = 1/2 - 1/(4n-2); so 1/2 is also the best constant");
}

/// Strict inequalities between the two bounds and phi_n(0).
Trial bounds_of_phi(const Context& context, int first, int last) {
  const Formula lower = context.formula("eq-10-lower"), upper = context.formula("eq-10-upper");
  Trial trial;
  for (int n = first; n <= last; ++n) {
    const Rational value = limit_values(s_n(n), 0).at(0);
    const std::string where = at("n", n) + ", " + at("phi(0)", value) + ", lower bound ";
    if (!trial.require(lower({{"n", n}}) < value, where + subcert::to_text(lower({{"n", n}})))) break;
    trial.require(value < upper({{"n", n}}), at("n", n) + ", " + at("phi(0)", value) + ": the upper bound");
  }
  return trial;
}

Outcome corollary_4(const Context& context) {
  const Formula lower = context.formula("eq-10-lower"), upper = context.formula("eq-10-upper");
  const Formula chain = context.formula("cor-4-chain");
  const int most = context.reach(30, 100);
  Trial trial = bounds_of_phi(context, 2, most);
  // The two counts of the proof: 2n-2 values below half of phi(0) and 2n-1 values up to phi(0); 2n+1 values from phi(n)
  // up.
  trial.follow(identity(f("1") / lower, f("(2*n - 2)/2 + (2*n - 1)"), {{"n", 2}}));
  trial.follow(identity(chain, f("2*n + 1") * context.formula("prop-3-ratio"), {{"n", 2}}));
  trial.follow(positive(upper - f("1") / chain, {{"n", "2 + x"}}));
  trial.follow(identity(f("1") / chain * f("(2*n + 1)/(2*n - 1)"), upper, {{"n", 2}}));
  trial.for_all("all n >= 2",
                "the counts of the printed proof, as identities in n; exact values compared for " + range(2, most));
  return trial.but_not("n = 1", bounds_of_phi(context, 1, 1));
}

/// The sums of phi_n over |j| <= inner and over |j| <= outer.
struct TwoSums {
  Rational inner = 0, outer = 0;
  TwoSums(const LimitValues& phi, long inner_last, long outer_last) {
    for (long j = -outer_last; j <= outer_last; ++j) outer += phi.at(j);
    for (long j = -inner_last; j <= inner_last; ++j) inner += phi.at(j);
  }
};

/// The first inequality of the proof of the upper bound.
Trial longer_sum(int first, int last) {
  Trial trial;
  for (int n = first; n <= last; ++n) {
    const TwoSums sums(limit_values(s_n(n), 0), n, 2 * n - 2);
    trial.require(sums.outer > sums.inner, at("n", n) + ": the sums over |j| <= 2n-2 and |j| <= n are " +
                                               subcert::to_text(sums.outer) + " and " + subcert::to_text(sums.inner));
  }
  return trial;
}

Outcome corollary_4_proof(const Context& context) {
  const Formula chain = context.formula("cor-4-chain");
  const int most = context.reach(20, 60);
  Trial trial = longer_sum(3, most);
  for (int n = 2; n <= most; ++n) {
    const LimitValues phi = limit_values(s_n(n), 0);
    trial.require(TwoSums(phi, n, n).inner > (2 * n + 1) * phi.at(-n), at("n", n) + ": the second inequality");
    trial.equal(Rational(chain({{"n", n}}) * phi.at(0)), Rational((2 * n + 1) * phi.at(-n)),
                at("n", n) + ", the last equality");
  }
  trial.for_all("all n >= 3", "2n-2 > n, and phi_n is positive inside of its support; compared for " + range(3, most));
  return trial.but_not("n = 1 and n = 2, where >= holds", longer_sum(1, 2));
}

/// 1 = (the sum over n <= |j| <= 2n-2) + (the sum over |j| < n) < (2n-2) phi(0)/2 + (2n-1) phi(0).
Trial two_counts(int first, int last) {
  Trial trial;
  for (int n = first; n <= last; ++n) {
    const LimitValues phi = limit_values(s_n(n), 0);
    const TwoSums sums(phi, n - 1, 2 * n - 2);
    trial.equal(1, std::max(sums.inner, sums.outer), at("n", n) + ", the sum");
    trial.require(1 < ((2 * n - 2) * Rational(1, 2) + 2 * n - 1) * phi.at(0),
                  at("n", n) + ": " + subcert::to_text(((n - 1) + 2 * n - 1) * phi.at(0)) + " is not above 1");
  }
  return trial;
}

Outcome corollary_4_lower(const Context& context) {
  const int most = context.reach(20, 60);
  Trial trial = two_counts(2, most);
  trial.for_all("all n >= 2",
                "2n-2 values below phi_n(0)/2 by (9) and 2n-1 values up to phi_n(0) by Proposition 3; "
                "compared for " +
                    range(2, most));
  return trial.but_not("n = 1", two_counts(1, 1));
}

}  // namespace

Checks section_2_2() {
  return {{"eq-5-6", limits_from_shifts},
          {"support-primal", support},
          {"phi-positive", positive_inside},
          {"eq-7", partition_of_unity},
          {"eq-8", limits_at_integers},
          {"matrix-a", matrix_a},
          {"phi-symmetric", symmetric},
          {"matrix-a-tilde", matrix_a_tilde},
          {"proposition-3", increasing_values},
          {"proposition-3-proof", rows_of_the_proof},
          {"proposition-3-value", value_at_n},
          {"eq-9", equation_9},
          {"corollary-4", corollary_4},
          {"corollary-4-proof", corollary_4_proof},
          {"corollary-4-lower", corollary_4_lower}};
}

}  // namespace subcert::statements::dyn_2015
