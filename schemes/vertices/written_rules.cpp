#include "written_rules.hpp"

#include <subcert/analysis/symbol/polynomials/cosine_field.hpp>
#include <subcert/analysis/symbol/polynomials/rational_function.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <algorithm>
#include <set>

namespace subcert {
namespace {

const LatticePoint origin{0, 0};
constexpr long first_of_family = 7, most_degree = 24;

/// The same coefficients at other places.
template <class Place>
LatticeMask placed_at(const LatticeMask& mask, Place place) {
  std::vector<Monomial> terms;
  for (const Monomial& term : mask.symbol().terms()) terms.push_back({term.coefficient, place(term.exponents)});
  return {MultivariatePolynomial(2, terms), mask.arity()};
}

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
  fail(ErrorKind::data, "{}{}{}", place, place.empty() ? "" : ": ", what);
}

/// A number in the place of a letter.
std::string with_number(const std::string& text, char letter, const Rational& value) {
  std::string result;
  for (const char one : text) result += one == letter ? "(" + to_text(value) + ")" : std::string(1, one);
  return result;
}

/// Of an expression the coefficients of the powers of C, each a polynomial in c and, behind it, in further letters.
using Powers = std::vector<MultivariatePolynomial>;

/// The terms by the exponent of C, without it.
Powers by_powers(const MultivariatePolynomial& p, const std::string& place) {
  Powers result;
  for (const Monomial& term : p.terms()) {
    const long power = term.exponents[1];
    if (power < 0) refuse(place, "a quotient by C = cos(2 pi t/n); need a polynomial in it");
    result.resize(std::max(result.size(), static_cast<std::size_t>(power) + 1),
                  MultivariatePolynomial(p.variables() - 1));
    LatticePoint others = term.exponents;
    others.erase(others.begin() + 1);
    result[static_cast<std::size_t>(power)] += MultivariatePolynomial(p.variables() - 1, {{term.coefficient, others}});
  }
  return result;
}

LaurentPolynomial in_c(const MultivariatePolynomial& p) {
  LaurentPolynomial result;
  for (const Monomial& term : p.terms())
    result += LaurentPolynomial::monomial(term.coefficient, letter_power(term.exponents));
  return result;
}

bool has_c_alone(const MultivariatePolynomial& p) {
  return std::ranges::all_of(p.terms(), [](const Monomial& t) {
    return std::all_of(t.exponents.begin() + 1, t.exponents.end(), [](long exponent) { return exponent == 0; });
  });
}

/// sum of a_k C^k as one of b_k T_k(C): the leading coefficient of T_k is 2^(k-1).
std::vector<LaurentPolynomial> in_cosines(std::vector<LaurentPolynomial> a) {
  std::vector<LaurentPolynomial> result(a.size());
  for (std::size_t k = a.size(); k-- > 0;) {
    const LaurentPolynomial t = chebyshev(static_cast<long>(k));
    result[k] = LaurentPolynomial(Rational(1 / t.coefficient(static_cast<long>(k)))) * a[k];
    for (std::size_t j = 0; j < k; ++j) a[j] -= LaurentPolynomial(t.coefficient(static_cast<long>(j))) * result[k];
  }
  return result;
}

/// Makes the rules of one valence; those of a family where it is that of so many sectors.
class Reader {
 public:
  enum class Letter { value, power, share };  ///< numbers; letters with their powers; no letter, and 1/n as one

  Reader(const WrittenRules& written, long valence, Letter letter)
      : written_(written), valence_(valence), letter_(letter), field_(letter == Letter::share ? 7 : valence) {}

  SectorRule rule(const WrittenRule& written) const {
    SectorRule result;
    for (const WrittenWeights& weights : written.weights) add(result, weights);
    if (letter_ == Letter::value) require_sum(result, written.place);
    return result;
  }

 private:
  /// The weights as polynomials, C replaced by its frequencies: b_k of cos(2 pi k t/n).
  std::vector<LaurentPolynomial> cosines(const std::string& text, const std::string& place) const {
    std::vector<LaurentPolynomial> powers;
    for (const MultivariatePolynomial& p : read(text, place)) powers.push_back(in_c(p));
    return in_cosines(powers);
  }

  Powers read(const std::string& text, const std::string& place) const {
    std::string numbers = text, letters = "cC";
    if (letter_ == Letter::share)
      letters += 'n';
    else
      numbers = with_number(numbers, 'n', Rational(valence_));
    for (const WrittenLetter& letter : written_.letters)
      if (!letter.value)
        letters += letter.name;
      else
        numbers = with_number(numbers, letter.name, *letter.value);
    try {
      return by_powers(polynomial_of(LetterFunction::parse(numbers, letters), place), place);
    } catch (const ParseError& error) {
      refuse(place,
             fmt::format("'{}': {}; expected {}", printable(text),
                         error.token().empty() ? "its end" : in_quotes(error.token().substr(0, 1)), expected(error)));
    }
  }

  /// With the letters that are numbers now.
  std::string expected(const ParseError& error) const {
    std::string letters = "c, C, n";
    for (const WrittenLetter& letter : written_.letters) letters += fmt::format(", {}", letter.name);
    const std::size_t at = error.expected().find("exact numbers, ");
    if (at == std::string::npos) return error.expected();
    return "exact numbers, " + letters + ", +, -, *, /, ^ and parentheses";
  }

  /// In c, C and one letter at least.
  MultivariatePolynomial polynomial_of(const LetterFunction& f, const std::string& place) const {
    const MultivariatePolynomial numerator = in_all(f.numerator()), denominator = in_all(f.denominator());
    const std::vector<Monomial> below = denominator.terms();
    LatticePoint at = below.front().exponents;
    const bool is_constant = std::ranges::all_of(at, [](long exponent) { return exponent == 0; });
    if (below.size() == 1 && at[0] == 0 && at[1] == 0 && (is_constant || letter_ == Letter::share)) {
      for (long& exponent : at) exponent = -exponent;
      return MultivariatePolynomial(numerator.variables(), Rational(1 / below.front().coefficient)) *
             numerator.shifted(at);
    }
    if (letter_ != Letter::value || !has_c_alone(denominator))
      refuse(place, "a quotient by what is no number; need polynomials in the letters but n");
    const CosineField::Number divisor = field_.number(in_c_alone(denominator));
    if (divisor.is_zero()) refuse(place, fmt::format("a quotient by 0 at valence {}", valence_));
    return numerator * MultivariatePolynomial::in_variable(numerator.variables(), 0, divisor.inverse().polynomial());
  }

  static MultivariatePolynomial in_all(const MultivariatePolynomial& p) {
    const int letters = std::max(3, p.variables());
    std::vector<Monomial> terms = p.terms();
    for (Monomial& term : terms) term.exponents.resize(static_cast<std::size_t>(letters), 0);
    return {letters, terms};
  }

  static LaurentPolynomial in_c_alone(const MultivariatePolynomial& p) {
    LaurentPolynomial result;
    for (const Monomial& t : p.terms()) result += LaurentPolynomial::monomial(t.coefficient, t.exponents[0]);
    return result;
  }

  bool is_vertex(const LatticePoint& point) const { return written_.lattice != SectorLattice::dual && point == origin; }

  void add(SectorRule& rule, const WrittenWeights& weights) const {
    if (weights.values.size() > 1 || (weights.turn && weights.values.size() != 1)) return add_row(rule, weights);
    const std::vector<LaurentPolynomial> found = cosines(weights.values.front(), weights.place);
    if (is_vertex(weights.point) || weights.turn) {
      if (found.size() > 1) refuse(weights.place, "C = cos(2 pi t/n) is of data of all sectors t");
      add_term(rule, weights.point, weights.turn.value_or(0), found.empty() ? LaurentPolynomial() : found[0]);
      return;
    }
    for (std::size_t k = 0; k < found.size(); ++k) add_ring(rule, weights, static_cast<long>(k), found[k]);
  }

  void add_term(SectorRule& rule, const LatticePoint& point, long turn, const LaurentPolynomial& weight) const {
    if (!weight.is_zero()) rule.terms.push_back({turned({point, 0}, turn, written_.lattice, valence_), weight});
  }

  /// What is b_k cos(2 pi k t/n) at the sector t acts on one frequency.
  void add_ring(SectorRule& rule, const WrittenWeights& weights, long k, const LaurentPolynomial& b) const {
    if (b.is_zero()) return;
    const long rest = k % valence_, frequency = std::min(rest, valence_ - rest);
    const bool is_alone = frequency == 0 || 2 * frequency == valence_;
    const Rational sectors(is_alone ? 1 : 2);
    // Of a family n is the third letter.
    const LaurentPolynomial weight = letter_ == Letter::share
                                         ? LaurentPolynomial(Rational(1 / sectors)) * b.shifted(letter_stride)
                                         : LaurentPolynomial(Rational(Rational(valence_) / sectors)) * b;
    const auto own = std::ranges::find_if(
        rule.rings, [&](const RingTerm& ring) { return ring.point == weights.point && ring.frequency == frequency; });
    if (own != rule.rings.end())
      own->weight += weight;
    else
      rule.rings.push_back({weights.point, frequency, weight});
  }

  /// One weight for each sector. Where they are equal they are one of all.
  void add_row(SectorRule& rule, const WrittenWeights& weights) const {
    const auto count = static_cast<long>(weights.values.size());
    if (letter_ == Letter::share)
      refuse(weights.place, fmt::format("a row of {} weights; need an expression for all valences at once", count));
    if (count != valence_)
      refuse(weights.place, fmt::format("a row of {} weights; need {}, one for each sector", count, valence_));
    std::vector<LaurentPolynomial> row;
    for (const std::string& value : weights.values) {
      const std::vector<LaurentPolynomial> found = cosines(value, weights.place);
      if (found.size() > 1) refuse(weights.place, "C = cos(2 pi t/n) is of one expression for all sectors");
      const LaurentPolynomial weight = found.empty() ? LaurentPolynomial() : found[0];
      row.push_back(letter_ == Letter::value ? field_.number(weight).polynomial() : weight);
    }
    if (std::ranges::all_of(row, [&](const LaurentPolynomial& weight) { return weight == row.front(); }))
      return add_ring(rule, weights, 0, row.front());
    for (long t = 0; t < count; ++t) add_term(rule, weights.point, t, row[static_cast<std::size_t>(t)]);
  }

  void require_sum(const SectorRule& rule, const std::string& place) const {
    if (place.empty()) return;  // ours
    LaurentPolynomial sum;
    for (const SectorTerm& term : rule.terms) sum += term.weight;
    for (const RingTerm& ring : rule.rings)
      if (ring.frequency == 0) sum += ring.weight;
    const CosineField::Number total = field_.number(sum);
    if ((total - field_.number(1)).is_zero()) return;
    refuse(place,
           fmt::format("the weights at valence {} sum to {}; need 1", valence_, to_text(total.polynomial(), 'c')));
  }

  const WrittenRules& written_;
  long valence_;
  Letter letter_;
  CosineField field_;
};

const WrittenRule* rule_of(const WrittenRules& written, const LatticePoint& point, long valence) {
  const WrittenRule* place = nullptr;
  for (const WrittenRule& rule : written.rules) {
    if (rule.point != point) continue;
    if (rule.covers(valence)) return &rule;
    if (!place) place = &rule;
  }
  if (!place || valence == regular_valence(written.lattice)) return nullptr;
  const std::string what = valence == SectorRuleFamily::many ? "all large valences"
                                                             : fmt::format("valence {}", valence);
  refuse(place->place,
         fmt::format("no rule of the point ({},{}) is for {}; expected one, as the file replaces the scheme's rules of "
                     "this point at all valences",
                     point[0], point[1], what));
}

void require_value(const WrittenRules& written) {
  if (const WrittenLetter* letter = written.free_letter())
    fail(ErrorKind::usage,
         "the letter {0} has no value; expected one in the file, as value = \"3/8\", or a range at single valences, "
         "--over {0}=LOW..HIGH",
         letter->name);
}

SectorRules made(const WrittenRules& written, long valence, Reader::Letter letter) {
  const Reader reader(written, valence, letter);
  SectorRules result{valence, written.lattice, written.mask};
  std::set<LatticePoint> points;
  for (const WrittenRule& rule : written.rules) points.insert(rule.point);
  for (const LatticePoint& point : points)
    if (const WrittenRule* rule = rule_of(written, point, valence)) result.rules[point] = reader.rule(*rule);
  return result;
}

/// The parts of a weight by the power of n, which is c^(letter_stride k): without n, and over n.
std::pair<LaurentPolynomial, LaurentPolynomial> without_and_over_n(const LaurentPolynomial& weight,
                                                                   const WrittenRule& rule) {
  std::pair<LaurentPolynomial, LaurentPolynomial> result;
  for (long k = weight.is_zero() ? 0 : weight.lowest(); !weight.is_zero() && k <= weight.highest(); ++k) {
    if (weight.coefficient(k) == 0) continue;
    const bool over = k < 0;
    const long power = over ? k + letter_stride : k;
    if (power < 0 || power > most_degree || (over && rule.point != origin))
      refuse(rule.place,
             "for all valences at once need weights of single data without n and of data of all sectors "
             "over n, of the point (0,0) also one order less");
    (over ? result.second : result.first) += LaurentPolynomial::monomial(weight.coefficient(k), power);
  }
  return result;
}

}  // namespace

const WrittenLetter* WrittenRules::free_letter() const {
  const auto found = std::ranges::find_if(letters, [](const WrittenLetter& letter) { return !letter.value; });
  return found == letters.end() ? nullptr : &*found;
}

WrittenRules WrittenRules::with_numbers() const {
  WrittenRules result = *this;
  std::erase_if(result.letters, [](const WrittenLetter& letter) { return letter.value.has_value(); });
  for (const WrittenLetter& letter : letters)
    if (letter.value)
      for (WrittenRule& rule : result.rules)
        for (WrittenWeights& weights : rule.weights)
          for (std::string& text : weights.values) text = with_number(text, letter.name, *letter.value);
  return result;
}

WrittenRules WrittenRules::with_free(const std::vector<std::string>& names) const {
  std::vector<WrittenLetter> free, others;
  for (const WrittenLetter& letter : letters)
    if (std::ranges::find(names, std::string(1, letter.name)) == names.end()) others.push_back(letter);
  for (const std::string& name : names) free.push_back({name.front()});
  const bool fit = std::ranges::all_of(names, [](const std::string& name) { return name.size() == 1; }) &&
                   others.size() + free.size() == letters.size() &&
                   std::ranges::all_of(others, [](const WrittenLetter& letter) { return letter.value.has_value(); });
  if (!fit) {
    std::string known;
    for (const WrittenLetter& letter : letters)
      known += fmt::format("{}{}{}", known.empty() ? "" : ", ", letter.name, letter.value ? " (with a value)" : "");
    fail(ErrorKind::usage, "need a range for each letter without a value, and for no other; letters of the rules: {}",
         known.empty() ? "none" : known);
  }
  WrittenRules result = *this;
  result.letters = free;
  result.letters.insert(result.letters.end(), others.begin(), others.end());
  return result;
}

LatticeMask mask_in_sectors(const LatticeMask& mask, SectorLattice lattice) {
  if (lattice == SectorLattice::quads) return mask;
  if (lattice == SectorLattice::triangles)
    return placed_at(mask, [](const LatticePoint& at) { return LatticePoint{at[0] - at[1], at[1]}; });
  const LatticePoint low = mask.symbol().lowest(), high = mask.symbol().highest();
  return placed_at(mask, [&](const LatticePoint& at) {
    LatticePoint result = at;
    for (std::size_t v = 0; v < 2; ++v) result[v] += (mask.arity() - 1 - low[v] - high[v]) / 2;
    return result;
  });
}

void check_rules(const WrittenRules& written) {
  for (const WrittenRule& rule : written.rules)
    Reader(written, rule.first, written.free_letter() ? Reader::Letter::power : Reader::Letter::value).rule(rule);
}

SectorRules rules_at(const WrittenRules& written, long valence) {
  require_value(written);
  return made(written, valence, Reader::Letter::value);
}

SectorRules rules_with_letters(const WrittenRules& written, long valence) {
  require(written.free_letter() != nullptr, "rules at a vertex: need a letter without a value");
  return made(written, valence, Reader::Letter::power);
}

SectorRuleFamily rule_family(const WrittenRules& written) {
  require_value(written);
  const Reader reader(written, SectorRuleFamily::many, Reader::Letter::share);
  SectorRuleFamily result{{SectorRuleFamily::many, written.lattice, written.mask}, first_of_family};
  for (const WrittenRule& rule : written.rules)
    result.least = std::max({result.least, rule.first, rule.last.value_or(0) + 1});
  std::set<LatticePoint> points;
  for (const WrittenRule& rule : written.rules) points.insert(rule.point);
  for (const LatticePoint& point : points) {
    const WrittenRule& rule = *rule_of(written, point, SectorRuleFamily::many);
    const SectorRule all = reader.rule(rule);
    SectorRule& own = result.rules.rules[point];
    const auto add = [&](const auto& term, auto& without, auto& over) {
      auto [first, second] = without_and_over_n(term.weight, rule);
      auto part = term;
      part.weight = std::move(first);
      if (!part.weight.is_zero()) without.push_back(part);
      part.weight = std::move(second);
      if (!part.weight.is_zero()) over.push_back(part);
    };
    for (const SectorTerm& term : all.terms) add(term, own.terms, result.over_vertex.terms);
    for (const RingTerm& ring : all.rings) add(ring, own.rings, result.over_vertex.rings);
  }
  return result;
}

}  // namespace subcert
