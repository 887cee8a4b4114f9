#include "paper_text.hpp"

#include "signs.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>
#include <subcert/schemes/plain_text.hpp>

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::formats {
namespace {

std::string with_all_replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string latex_fraction(const std::string& above, const std::string& below) {
  return below == "1" ? above : "\\frac{" + above + "}{" + below + "}";
}

/// The longest piece from here on of which each character is one of these.
template <class Is>
std::string_view run_of(std::string_view text, std::size_t begin, Is is) {
  std::size_t end = begin;
  while (end < text.size() && is(text[end])) ++end;
  return text.substr(begin, end - begin);
}

/// With the zeros at its end that make so many significant digits.
std::string with_zeros(std::string decimal, int digits) {
  if (decimal.find('e') != std::string::npos) return decimal;
  const auto first = std::ranges::find_if(decimal, [](char c) { return c >= '1' && c <= '9'; });
  const auto shown = std::count_if(first, decimal.end(), is_digit);
  if (shown >= digits) return decimal;
  if (decimal.find('.') == std::string::npos) decimal += '.';
  return decimal + std::string(static_cast<std::size_t>(digits - shown), '0');
}

std::string joined_cells(const std::vector<std::string>& cells, const char* between) {
  return fmt::format("{}", fmt::join(cells, between));
}

struct WholeMask {
  Integer below;
  std::vector<Monomial> terms;  ///< with whole coefficients
};

WholeMask whole(const MultivariatePolynomial& symbol) {
  WholeMask result{1, symbol.terms()};
  for (const Monomial& term : result.terms) result.below = lcm(result.below, denominator(term.coefficient));
  for (Monomial& term : result.terms) term.coefficient *= result.below;
  return result;
}

std::string factor_before(const Integer& below) { return below == 1 ? "" : latex_fraction("1", below.str()); }

/// Rows from the largest second index down.
std::string matrix_latex(const MultivariatePolynomial& symbol) {
  const auto [below, terms] = whole(symbol);
  const auto low = symbol.lowest(), high = symbol.highest();
  std::vector<std::string> rows;
  for (long j = high[1]; j >= low[1]; --j) {
    std::vector<std::string> row;
    for (long i = low[0]; i <= high[0]; ++i) {
      const auto there = std::ranges::find(terms, std::vector<long>{i, j}, &Monomial::exponents);
      row.push_back(there == terms.end() ? "0" : to_text(there->coefficient));
    }
    rows.push_back(joined_cells(row, " & "));
  }
  return fmt::format(
      "(a_{{i,j}}) = {}\\begin{{bmatrix}} {} \\end{{bmatrix}},\\quad i = {}, \\ldots, {},\\; j = {}, "
      "\\ldots, {}",
      factor_before(below), joined_cells(rows, " \\\\ "), low[0], high[0], high[1], low[1]);
}

}  // namespace

std::string latex_text(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '-' && is_minus(text, at))
      result += "$-$";
    else if (c == '\\')
      result += "\\textbackslash{}";
    else if (c == '~')
      result += "\\textasciitilde{}";
    else if (c == '^')
      result += "\\textasciicircum{}";
    else if (c == '|')
      result += "\\textbar{}";
    else
      result += (std::string_view("&%$#_{}").find(c) == std::string_view::npos ? "" : "\\") + std::string(1, c);
  }
  result = with_all_replaced(std::move(result), "Hoelder", "H\\\"older");
  result = with_all_replaced(with_all_replaced(result, ">=", "$\\ge$"), "<=", "$\\le$");
  return with_all_replaced(with_all_replaced(result, "<", "\\textless{}"), ">", "\\textgreater{}");
}

std::string latex_tabular(const TableRows& rows, std::string_view column) {
  std::string text = "\\begin{tabular}{l";
  for (std::size_t i = 1; i < rows.front().size(); ++i) text += column;
  text += "}\n  \\toprule\n";
  for (std::size_t r = 0; r < rows.size(); ++r)
    text += "  " + joined_cells(rows[r], " & ") + (r == 0 ? " \\\\\n  \\midrule\n" : " \\\\\n");
  return text + "  \\bottomrule\n\\end{tabular}\n";
}

std::string markdown_table(const TableRows& rows) {
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::vector<std::string> cells;
    for (const std::string& cell : rows[r])
      cells.push_back(with_all_replaced(with_all_replaced(cell, "|", "\\|"), "\n", " "));
    text += "| " + joined_cells(cells, " | ") + " |\n";
    if (r == 0) text += "|" + joined_cells(std::vector<std::string>(cells.size(), "---"), "|") + "|\n";
  }
  return text;
}

std::string latex_formula(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::string_view word = run_of(text, i, is_letter); !word.empty()) {
      result += is_greek(word)     ? "\\" + std::string(word)
                : word.size() == 1 ? std::string(word)
                                   : "\\mathrm{" + std::string(word) + "}";
      i += word.size();
    } else if (const std::string_view digits = run_of(text, i, is_digit); !digits.empty()) {
      const bool is_index = i > 0 && is_letter(text[i - 1]);
      i += digits.size();
      if (is_index) {
        result += "_{" + std::string(digits) + "}";
        continue;
      }
      const std::string_view below = i < text.size() && text[i] == '/' ? run_of(text, i + 1, is_digit) : "";
      result += below.empty() ? std::string(digits) : latex_fraction(std::string(digits), std::string(below));
      i += below.empty() ? 0 : below.size() + 1;
    } else if (text[i] == '^') {
      const std::size_t sign = i + 1 < text.size() && text[i + 1] == '-' ? 1 : 0;
      const std::string_view power = run_of(text, i + 1 + sign, is_digit);
      result += "^{" + std::string(sign, '-') + std::string(power) + "}";
      i += 1 + sign + power.size();
    } else {
      const std::string_view two = text.substr(i, 2);
      result += two == "<=" ? "\\le" : two == ">=" ? "\\ge" : text[i] == '*' ? " " : std::string(1, text[i]);
      const bool relation = two == "<=" || two == ">=";
      i += relation ? 2 : 1;
      if (relation && i < text.size() && is_letter(text[i])) result += ' ';  // as \lex is another command
    }
  }
  return result;
}

std::string mask_latex(const LatticeMask& mask) {
  require(mask.dimension() <= 2, "mask: need one or two variables for a formula, got {}", mask.dimension());
  if (mask.dimension() == 2) return matrix_latex(mask.symbol());
  const LaurentPolynomial& symbol = mask.curve().symbol();
  Integer below = 1;
  for (const Rational& c : symbol.coefficients()) below = lcm(below, denominator(c));
  std::vector<std::string> numbers;
  for (const Rational& c : symbol.coefficients()) numbers.push_back(to_text(Rational(c * below)));
  return fmt::format("(a_{{{}}}, \\ldots, a_{{{}}}) = {}({})", symbol.lowest(), symbol.highest(), factor_before(below),
                     joined_cells(numbers, ",\\, "));
}

std::string symbol_latex(const Mask& mask) {
  const int rules = sum_rules(mask);
  const LaurentPolynomial smooth = LaurentPolynomial::all_ones(mask.arity());
  LaurentPolynomial rest = *mask.symbol().exact_quotient(smooth.pow(rules));
  const long shift = rest.lowest();
  rest = rest.shifted(-shift);
  Integer below = 1, common = 0;
  for (const Rational& c : rest.coefficients()) below = lcm(below, denominator(c));
  for (const Rational& c : rest.coefficients()) common = gcd(common, numerator(Rational(c * below)));
  rest *= LaurentPolynomial(Rational(below, common));
  const auto power = [](const std::string& base, long exponent) {
    return exponent == 0 ? "" : exponent == 1 ? base : fmt::format("{}^{{{}}}", base, exponent);
  };
  std::string above = common == 1 ? "" : common.str() + "\\,";
  if (shift > 0) above += power("z", shift);
  above += power("(" + smooth.to_latex() + ")", rules);
  if (!(rest == LaurentPolynomial(1))) above += "(" + rest.to_latex() + ")";
  if (above.empty()) above = "1";
  const std::string denominators = (below == 1 ? "" : below.str()) + (shift < 0 ? " " + power("z", -shift) : "");
  return "a(z) = " + (denominators.empty() ? above : latex_fraction(above, denominators));
}

std::string relation_latex(const Enclosure& value, int digits) {
  if (!value.lower && !value.upper) return "";
  if (!value.upper) return "\\ge " + value.lower_text(digits);
  if (!value.lower) return "\\le " + value.upper_text(digits);
  if (value.is_exact()) {
    const std::string exact = to_text(*value.lower);
    return "= " + (exact.find('/') == std::string::npos ? exact : latex_formula(exact));
  }
  const std::string low = value.lower_text(digits), down = to_decimal(*value.upper, digits, Rounding::down);
  // The digits of both ends, where they are the same: the number goes on.
  return low == down ? "= " + with_zeros(low, digits) + "\\ldots"
                     : "\\in [" + low + ",\\, " + value.upper_text(digits) + "]";
}

}  // namespace subcert::formats
