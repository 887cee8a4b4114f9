#include "specification_fields.hpp"

namespace subcert::specification {

void fail(const Piece& piece, const std::string& expected) {
  throw SpecificationError(piece.text, piece.at + 1, expected);
}

std::vector<Piece> split(const Piece& piece, char separator) {
  std::vector<Piece> result;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= piece.text.size(); ++i) {
    const char c = i < piece.text.size() ? piece.text[i] : separator;
    if (c == '[' || c == '(') ++depth;
    if (c == ']' || c == ')') --depth;
    if (i == piece.text.size() || (c == separator && depth <= 0)) {
      result.push_back({piece.text.substr(begin, i - begin), piece.at + begin});
      begin = i + 1;
    }
  }
  return result;
}

Rational read_rational(const Piece& piece) {
  const auto value = parse_rational(piece.text);
  if (!value) fail(piece, "an exact number p or p/q with q > 0 (for example 1/16)");
  return *value;
}

long read_integer(const Piece& piece, const std::string& name, long low, long high) {
  const std::string range = name + " as an integer from " + std::to_string(low) + " to " + std::to_string(high);
  const auto value = parse_rational(piece.text);
  if (!value || denominator(*value) != 1 || *value < low || *value > high) fail(piece, range);
  return numerator(*value).convert_to<long>();
}

}  // namespace subcert::specification
