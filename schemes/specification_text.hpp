#pragma once
// What the readers of specifications share.

#include "as_written.hpp"
#include "grid_regression.hpp"
#include "specification.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/expression.hpp>
#include <subcert/analysis/symbol/polynomials/term_text.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace subcert::specification_text {

constexpr std::size_t max_text = 30'000;  // also bounds the digits that a common denominator can gather
constexpr long max_points = 4096;
constexpr long max_work = 200'000;         // points * degree: keeps every accepted mask within seconds
constexpr long max_long_work = 1'000'000;  // points * degree^2 * digits, for weighted fits and long positions
constexpr long max_arity = 64;
constexpr long max_entry = 64;                             // of a dilation matrix
constexpr long max_entries = 20'000, max_components = 64;  // of masks of matrices

/// A piece of the specification and where it begins (0-based).
struct Piece {
  std::string_view text;
  std::size_t at;
};

[[noreturn]] inline void fail(const Piece& piece, const std::string& expected) {
  throw SpecificationError(piece.text, piece.at + 1, expected);
}

/// Without the blanks at its ends.
inline Piece trimmed(Piece piece) {
  const std::size_t begin = std::min(piece.text.find_first_not_of(" \t"), piece.text.size());
  piece.text.remove_prefix(begin);
  piece.text = piece.text.substr(0, piece.text.find_last_not_of(" \t") + 1);
  return {piece.text, piece.at + begin};
}

/// Splits at `separator` outside of brackets; blanks about the pieces go.
inline std::vector<Piece> split(const Piece& piece, char separator) {
  std::vector<Piece> result;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= piece.text.size(); ++i) {
    const char c = i < piece.text.size() ? piece.text[i] : separator;
    if (c == '[' || c == '(' || c == '{') ++depth;
    if (c == ']' || c == ')' || c == '}') --depth;
    if (i == piece.text.size() || (c == separator && depth <= 0)) {
      result.push_back(trimmed({piece.text.substr(begin, i - begin), piece.at + begin}));
      begin = i + 1;
    }
  }
  return result;
}

/// The elements between '[' and ']'.
inline std::vector<Piece> read_list(const Piece& piece, char separator) {
  if (piece.text.size() < 2 || piece.text.front() != '[' || piece.text.back() != ']')
    fail(piece, "a list in brackets, as [1" + std::string(1, separator) + "2]");
  return split({piece.text.substr(1, piece.text.size() - 2), piece.at + 1}, separator);
}

/// The rows of `[1,1;1,-1]` or `[[1,1],[1,-1]]`, without their brackets.
inline std::vector<Piece> read_rows(const Piece& piece) {
  if (!piece.text.starts_with("[[")) return read_list(piece, ';');
  std::vector<Piece> rows = read_list(piece, ',');
  for (Piece& row : rows) {
    (void)read_list(row, ',');
    row = trimmed({row.text.substr(1, row.text.size() - 2), row.at + 1});
  }
  return rows;
}

inline Rational read_rational(const Piece& piece) {
  const auto value = parse_constant(piece.text);
  if (!value) fail(piece, "an exact number p, p/q with q > 0, a decimal, or a sum of such (for example 1/16)");
  return *value;
}

inline long read_integer(const Piece& piece, const std::string& name, long low, long high) {
  const std::string range = name + " as an integer from " + std::to_string(low) + " to " + std::to_string(high);
  const auto value = parse_rational(piece.text);
  if (!value || denominator(*value) != 1 || *value < low || *value > high) fail(piece, range);
  return numerator(*value).convert_to<long>();
}

/// The `key=value` fields of a specification; each is to be taken once, and finish() refuses what is left.
class Fields {
 public:
  Fields(const Piece& family, const Piece& body, std::string usage) : family_(family), usage_(std::move(usage)) {
    if (body.text.empty()) return;
    for (const Piece& piece : split(body, ',')) add(piece);
  }
  Fields(const Piece& family, const std::vector<Piece>& pieces, std::string usage)
      : family_(family), usage_(std::move(usage)) {
    for (const Piece& piece : pieces) add(piece);
  }

  std::optional<Piece> optional(std::string_view key) {
    for (Field& field : fields_)
      if (field.key.text == key) {
        field.used = true;
        return field.value;
      }
    return std::nullopt;
  }

  /// Where the key is absent a key that `usage` does not have is taken for it.
  Piece required(std::string_view key) {
    if (const auto value = optional(key)) return *value;
    const std::string expected = "the key '" + std::string(key) + "', as in " + usage_;
    const std::vector<std::string> keys = keys_of(usage_);
    for (const Field& field : fields_)
      if (!field.used && std::ranges::find(keys, field.key.text) == keys.end()) fail(field.key, expected);
    fail(family_, expected);
  }

  void finish() const {
    for (const Field& field : fields_)
      if (!field.used) fail(field.key, "a key of " + usage_ + did_you_mean(field.key.text, keys_of(usage_)));
  }

 private:
  struct Field {
    Piece key;
    Piece value;
    bool used = false;
  };

  /// What stands between a colon or a comma and = there.
  static std::vector<std::string> keys_of(const std::string& usage) {
    std::vector<std::string> keys;
    for (std::size_t at = usage.find('='); at != std::string::npos; at = usage.find('=', at + 1)) {
      const std::size_t begin = usage.find_last_of(":,", at) + 1;
      keys.push_back(usage.substr(begin, at - begin));
    }
    return keys;
  }

  void add(const Piece& piece) {
    const std::size_t equals = piece.text.find('=');
    if (equals == std::string_view::npos) fail(piece, "key=value, as in " + usage_);
    const Piece key = trimmed({piece.text.substr(0, equals), piece.at});
    for (const Field& field : fields_)
      if (field.key.text == key.text) fail(key, "each key once");
    fields_.push_back({key, trimmed({piece.text.substr(equals + 1), piece.at + equals + 1})});
  }

  Piece family_;
  std::string usage_;
  std::vector<Field> fields_;
};

/// The key arity; 2 unless given.
inline long read_arity(Fields& fields) {
  const auto piece = fields.optional("arity");
  return piece ? read_integer(*piece, "arity", 2, max_arity) : 2;
}

/// Of coefficients whose sum over `where` is to be 1: what their sum is, exactly, and how to go on. `common`: the sum
/// that all classes have.
inline std::string sum_text(const std::string& where, const Rational& sum, const std::optional<Rational>& common) {
  constexpr long rounding = 1000;  // sums nearer to 1 than its reciprocal are taken for rounded ones
  const auto exact = [](const Rational& value) {
    constexpr std::size_t longest = 60;
    if (std::string decimal = to_decimal(value, 40, Rounding::nearest); parse_number(decimal) == value) return decimal;
    const std::string text = to_text(value);
    return text.size() <= longest ? text : short_text(value);
  };
  std::string text = where + " sums to ";
  const Rational rest = sum - 1;
  if (rest * rounding <= 1 && rest * rounding >= -1)
    return text + "1 " + (rest < 0 ? "- " : "+ ") + exact(abs(rest)) + "; where coefficients are rounded " +
           (rest < 0 ? "add that to" : "take that from") + " one of the class";
  text += exact(sum);
  return common && *common != 0 ? text + ", as all do: divide by that" : text;
}

/// The sum that all classes have, if it is one.
inline std::optional<Rational> common_sum(const std::vector<Rational>& sums) {
  const bool same = std::all_of(sums.begin(), sums.end(), [&](const Rational& sum) { return sum == sums.front(); });
  return same ? std::optional<Rational>(sums.front()) : std::nullopt;
}

/// Degree of a fit on `points` data, bounded so that the mask is made in seconds.
inline long read_degree(Fields& fields, long points) {
  const auto piece = fields.optional("d");
  if (!piece) return 1;
  const long degree = read_integer(*piece, "d", 0, std::numeric_limits<std::int32_t>::max());
  if (std::min(degree, points - 1) * points > max_work)
    fail(*piece, "a degree d with points * d <= " + std::to_string(max_work) +
                     " (here points = " + std::to_string(points) + ")");
  return degree;
}

/// What `read` makes of the text of the piece, with its places in the specification.
template <class Read>
auto placed(const Piece& piece, Read read) {
  try {
    return read();
  } catch (const ParseError& error) {
    throw SpecificationError(error.token(), piece.at + error.position(), error.expected());
  }
}

/// What `make` returns; what it says to be needed is what is expected in place of the piece.
template <class Make>
auto checked(const Piece& piece, Make make) {
  try {
    return make();
  } catch (const SpecificationError&) {
    throw;
  } catch (const Error& error) {
    const std::string what = error.what();
    const std::size_t need = what.find("need ");
    fail(piece, need == std::string::npos ? what : what.substr(need + 5));
  }
}

/// Points as `1,0;0,1`, with as many coordinates as variables.
std::vector<LatticePoint> read_lattice_points(const Piece& piece, const std::string& name, std::size_t variables,
                                              long bound);

/// The specifications in `(A)x(B)` or `(A)x(B)x(C)`.
std::vector<Piece> read_factors(const Piece& body);

/// The coefficients that are not 0 with their places, of matrices with rows and columns.
std::vector<LatticeMask::Term> terms_of(const text::MaskText& mask, text::Entries entries);

/// The fields arity, dilation and digits; 2 times the identity unless given.
Dilation read_dilation(Fields& fields, std::size_t variables);
/// The fields that read_dilation reads.
std::string fields_text(const Dilation& dilation);

/// The coefficients at the beginning of the body of a specification, and the fields that follow. Domain: at most `most`
/// coefficients.
std::pair<Piece, Fields> split_mask(const Piece& family, const Piece& body, const std::string& usage, int variables,
                                    long most);

/// The expression at the beginning of the body, and the fields that follow.
std::pair<Piece, Fields> split_symbol(const Piece& family, const Piece& body, const std::string& usage);

/// A Laurent polynomial in the letters.
MultivariatePolynomial read_symbol(const Piece& expression, std::string_view letters);

/// The rows of square matrices, from two on.
template <class Number>
std::size_t read_components(const text::MaskTextOf<Number>& parts, const Piece& mask) {
  const std::size_t columns = parts.sizes[0], rows = parts.sizes[1];
  if (rows == 1 && columns == 1) fail(mask, "matrices of at least 2 rows; numbers are a mask:[...]");
  if (rows != columns || rows > max_components)
    fail(mask, "square matrices of at most " + std::to_string(max_components) + " rows, got " + std::to_string(rows) +
                   " rows and " + std::to_string(columns) + " columns");
  return rows;
}

/// The form that a family of typed matrices names.
std::optional<VectorForm> form_of(std::string_view family);
std::string name_of(VectorForm form);

/// Functions whose matrices have the square root of a number in them.
Scheme quadratic_scheme(const std::string& specification, const std::string& title, VectorForm form,
                        const QuadraticMask& mask);

struct MaskAndFields {
  text::MaskText mask;
  Fields fields;
};

/// Domain: at most `most` coefficients.
MaskAndFields read_mask(const Piece& family, const Piece& body, const std::string& usage, int variables, long most);

/// `mask:[...],where=t^2-3:1.7..1.8`: coefficients that are polynomials in a real algebraic number.
Scheme make_algebraic_mask(const Piece& family, const Piece& body);

/// The name of a family, an example with all keys, and how its schemes are made.
struct Family {
  FamilyHelp help;
  std::function<Scheme(const Piece& family, const Piece& body, const std::string& usage)> make;
};

template <class Make>
auto from_fields(Make make) {
  return [make](const Piece& family, const Piece& body, const std::string& usage) {
    Fields fields(family, body, usage);
    return make(fields);
  };
}

/// The fits of `triangular:`; nothing for what names another family. Errors: as make_linear_scheme().
std::optional<BallRegression> ball_regression_of(std::string_view specification);

/// Of vectors of functions by name. Two of them also name families of numbers, which they make as well.
const std::vector<Family>& named_vectors();

inline std::vector<FamilyHelp> help_of(const std::vector<Family>& families) {
  std::vector<FamilyHelp> result;
  for (const Family& family : families) result.push_back(family.help);
  return result;
}

/// What is expected in the place of a vector of functions.
constexpr const char* numbers_only =
    "a scheme of numbers; of vectors 'subcert regularity', 'mask' and 'limit' tell what is known, and 'refine' takes "
    "data";

/// `primal, dual, ...`
inline std::string names_of(const std::vector<FamilyHelp>& families) {
  std::string names;
  for (const FamilyHelp& help : families) names += (names.empty() ? "" : ", ") + help.family;
  return names;
}

/// What is expected in place of a word that is no family.
inline std::string unknown_family(std::string_view word) {
  std::vector<std::string> names = other_names();
  names.emplace_back("l1");
  for (const auto* helps : {&families(), &multivariate_families(), &vector_families()})
    for (const FamilyHelp& help : *helps) names.push_back(help.family);
  if (const std::string first(word.substr(0, word.find_first_of(" (="))); first.size() < word.size())
    if (std::ranges::find(names, first) != names.end()) return "a colon behind '" + first + "', as in primal:n=3";
  return "a family (primal:n=3; 'subcert mask --help' lists all), a mask ([1,3,3,1]/4) or a symbol ((1+z)^3/4z)" +
         did_you_mean(word, names);
}

/// What `read` makes of a specification that stands for a text. Errors speak of the specification, where it is another,
/// and end with `meaning`, of what only the specification has.
template <class Read>
auto read_as(std::string_view text, const std::string& specification, const std::string& meaning, Read read) {
  try {
    return read(specification);
  } catch (const SpecificationError& error) {
    if (specification == text) throw;
    throw SpecificationError(error.token(), error.position(),
                             error.expected() + "; read as '" + printable(specification) + "'" + meaning);
  }
}

/// The same of a text as it is written.
template <class Read>
auto from_written(std::string_view text, Read read) {
  if (text.size() > max_text) fail({text, 0}, "at most " + std::to_string(max_text) + " characters");
  return read_as(text, specification_as_written(text), "", read);
}

inline Piece family_of(std::string_view specification) { return {specification.substr(0, specification.find(':')), 0}; }

/// What follows the colon.
inline Piece body_of(std::string_view specification) {
  const std::size_t begin = std::min(family_of(specification).text.size() + 1, specification.size());
  return {specification.substr(begin), begin};
}

/// The scheme, where the specification names one of the families. A family without keys may do without its colon.
inline std::optional<Scheme> make_one_of(const std::vector<Family>& families, std::string_view specification) {
  const Piece family = family_of(specification);
  for (const Family& candidate : families)
    if (candidate.help.family == family.text) {
      const std::string& usage = candidate.help.usage;
      if (family.text.size() == specification.size() && usage != candidate.help.family) fail(family, usage);
      return candidate.make(family, body_of(specification), usage);
    }
  return std::nullopt;
}

}  // namespace subcert::specification_text
