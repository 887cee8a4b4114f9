#pragma once
/// What is proved of rules with letters in their weights, for all values in a box. Inner header.

#include "characteristic_map.hpp"
#include "letter_spectrum.hpp"
#include "weight_range.hpp"

#include <subcert/analysis/symbol/polynomials/box.hpp>

#include <functional>
#include <optional>

namespace subcert::vertex {

class WeightProof {
 public:
  /// How far smaller boxes help.
  enum class Help { fine, coarse, none };
  struct Found {
    Decision holds;
    Help help = Help::fine;
  };

  /// Domain: rules with so many letters. Keeps references to both. Errors: as vertex_smoothness().
  WeightProof(const SectorRules& rules, const RegularPart& regular, WeightProperty property, std::size_t letters);

  Found on(const Box& box) const;
  /// The end in a small interval where the answer changes. Domain: one letter.
  std::optional<WeightEnd> end_in(const Rational& low, const Rational& high) const;

 private:
  std::optional<CharacteristicMap> map_of(const LetterZero& zero, const Letters& weights) const;
  Found by_map(const LetterZero& first, const Letters& weights) const;
  bool is_refuted_by(const LetterZero& leader, const Letters& weights) const;
  /// By a leader of another frequency.
  Found refuted(const Letters& weights) const;
  Found curvature(const LetterZero& first, const Letters& weights) const;
  Ball value_of(const LetterSpectrum::Polynomial& p, const Ball& letter) const;
  /// Different signs at the ends, and a slope that is not 0 between them.
  bool has_one_zero(const LetterSpectrum::Polynomial& p, const Rational& low, const Rational& high) const;
  /// The factor that has the zero, where the coefficients are rational; the value, where it is linear.
  void simplify(WeightEnd& end) const;
  Decision at(const LaurentPolynomial& value) const;

  const SectorRules& rules_;
  const RegularPart& regular_;
  WeightProperty property_;
  ClosedSet set_;
  std::optional<LetterSpectrum> spectrum_;
};

/// A box that is decided, or was not cut further.
struct WeightBox {
  Box box;
  Decision holds;
  bool is_last = true;  ///< not left open for lack of time
};

/// Halves in each letter what is not decided, until it is as small as is asked for with this help, or the time is up.
std::vector<WeightBox> decide_boxes(const WeightProof& proof, const Box& range, int jobs, const Budget& budget,
                                    const std::function<bool(const Box&, WeightProof::Help)>& is_smallest);

}  // namespace subcert::vertex
