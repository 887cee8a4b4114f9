#include "scheme_grid.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/schemes/specification_text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace subcert::sweeps {
namespace {

using specification_text::fail;
using specification_text::Piece;
using specification_text::split;
using specification_text::trimmed;

constexpr double most_combinations = 1e8;

Piece part(const Piece& piece, std::size_t begin, std::size_t end = std::string_view::npos) {
  return {piece.text.substr(begin, end - begin), piece.at + begin};
}

Rational number(const Piece& piece) {
  const auto value = parse_number(trimmed(piece).text);
  if (!value) fail(piece, "a number, as 3 or 1/64");
  return *value;
}

/// Whether it is A..B; `...` is refused.
bool is_range(const Piece& piece) {
  if (piece.text.find("...") != std::string_view::npos) fail(piece, "A..B with two dots");
  return piece.text.find("..") != std::string_view::npos && piece.text.find_first_of("([") == std::string_view::npos;
}

void add_range(const Piece& piece, std::vector<std::string>& values) {
  const std::size_t dots = piece.text.find(".."), step_at = piece.text.find(" step ");
  const Rational low = number(part(piece, 0, dots)), high = number(part(piece, dots + 2, step_at)),
                 step = step_at == std::string_view::npos ? Rational(1) : number(part(piece, step_at + 6));
  if (high < low || step <= 0) fail(piece, "A..B or A..B step S with A <= B and S > 0");
  if ((high - low) / step >= most_schemes) fail(piece, fmt::format("at most {} values", most_schemes));
  for (Rational value = low; value <= high; value += step) values.push_back(to_text(value));
}

/// What may stand for a value.
std::vector<std::string> values_of(const Piece& written) {
  const Piece piece = trimmed(written);
  std::vector<std::string> values;
  const bool is_list = piece.text.starts_with('{');
  if (is_list && !piece.text.ends_with('}')) fail(piece, "a list {A,B,C..D}");
  for (const Piece& item : is_list ? split(part(piece, 1, piece.text.size() - 1), ',') : std::vector{piece}) {
    if (is_list && item.text.empty()) fail(piece, "a value between commas");
    if (is_range(item))
      add_range(item, values);
    else
      values.emplace_back(item.text);
  }
  return values;
}

struct Key {
  std::string name;  ///< with the sign =; empty where there is none
  std::vector<std::string> values;
};

std::vector<Key> keys_of(const Piece& body) {
  std::vector<Key> keys;
  for (const Piece& piece : split(body, ',')) {
    const std::size_t equals = piece.text.find('=');
    if (equals == std::string_view::npos || piece.text.find_first_of("([") < equals)
      keys.push_back({"", {std::string(piece.text)}});
    else
      keys.push_back({std::string(trimmed(part(piece, 0, equals + 1)).text), values_of(part(piece, equals + 1))});
  }
  return keys;
}

/// All choices of numerators with the sums of the classes, of mirror images the larger one.
class SmallMasks {
 public:
  SmallMasks(long length, long largest, long denominator, long arity)
      : length_(static_cast<std::size_t>(length)), largest_(largest), denominator_(denominator), arity_(arity) {}

  void add_to(std::vector<std::string>& masks) {
    masks_ = &masks;
    sums_.assign(static_cast<std::size_t>(arity_), 0);
    numerators_.clear();
    extend();
  }

 private:
  void extend() {
    const std::size_t k = numerators_.size();
    if (k == length_) return finish();
    long& sum = sums_[k % sums_.size()];
    const bool is_end = k == 0 || k + 1 == length_;
    const long left = static_cast<long>((length_ - 1 - k) / sums_.size());  // numerators of the class that follow
    for (long p = -largest_; p <= largest_; ++p) {
      if ((is_end && p == 0) || std::abs(denominator_ - sum - p) > left * largest_) continue;
      numerators_.push_back(p);
      sum += p;
      extend();
      sum -= p;
      numerators_.pop_back();
    }
  }

  void finish() {
    if (std::ranges::any_of(sums_, [this](long sum) { return sum != denominator_; }) ||
        std::lexicographical_compare(numerators_.begin(), numerators_.end(), numerators_.rbegin(), numerators_.rend()))
      return;
    require(masks_->size() < most_schemes, "schemes: need at most {} masks", most_schemes);
    masks_->push_back(denominator_ == 1 ? fmt::format("mask:[{}]", fmt::join(numerators_, ","))
                                        : fmt::format("mask:[{}]/{}", fmt::join(numerators_, ","), denominator_));
    if (arity_ != 2) masks_->back() += fmt::format(",arity={}", arity_);
  }

  std::size_t length_;
  long largest_, denominator_, arity_;
  std::vector<long> numerators_, sums_;
  std::vector<std::string>* masks_ = nullptr;
};

/// The integers of a key, one of a default where it is absent.
std::vector<long> integers_of(const std::vector<Key>& keys, const std::string& name, long least, long most, long usual,
                              const Piece& whole) {
  const auto found = std::ranges::find(keys, name + "=", &Key::name);
  if (found == keys.end()) return {usual};
  std::vector<long> result;
  for (const std::string& text : found->values) {
    const auto value = parse_number(text);
    if (!value || denominator(*value) != 1 || *value < least || *value > most)
      fail(whole, fmt::format("{}= with integers from {} to {}", name, least, most));
    result.push_back(numerator(*value).convert_to<long>());
  }
  return result;
}

std::vector<std::string> small_masks(const Piece& body) {
  const std::vector<Key> keys = keys_of(body);
  static const std::vector<std::string> known = {"length=", "numerators=", "denominator=", "arity="};
  for (const Key& key : keys)
    if (std::ranges::find(known, key.name) == known.end())
      fail(body, "masks:length=L,numerators=N,denominator=D, perhaps with arity=A");
  std::vector<std::string> masks;
  for (const long arity : integers_of(keys, "arity", 2, 8, 2, body))
    for (const long denominator : integers_of(keys, "denominator", 1, 1'000'000, 1, body))
      for (const long largest : integers_of(keys, "numerators", 1, 1'000'000, 1, body))
        for (const long length : integers_of(keys, "length", 1, 100, 3, body)) {
          const auto free = static_cast<double>(std::max(length - arity, 0L));
          if (std::pow(2 * static_cast<double>(largest) + 1, free) > most_combinations)
            fail(body, "at most 10^8 combinations of numerators");
          SmallMasks(length, largest, denominator, arity).add_to(masks);
        }
  return masks;
}

}  // namespace

std::vector<std::string> schemes_of_grid(std::string_view text) {
  const Piece whole = trimmed({text, 0});
  const std::size_t colon = whole.text.find(':');
  if (colon == std::string_view::npos || whole.text.find_first_of("[(") < colon) return {std::string(whole.text)};
  const Piece body = part(whole, colon + 1);
  if (whole.text.substr(0, colon) == "masks") return small_masks(body);
  const std::vector<Key> keys = keys_of(body);
  double count = 1;
  for (const Key& key : keys) count *= static_cast<double>(key.values.size());
  if (count == 1 && body.text.find('{') == std::string_view::npos && body.text.find("..") == std::string_view::npos)
    return {std::string(whole.text)};
  if (count > most_schemes) fail(whole, fmt::format("at most {} schemes", most_schemes));
  std::vector<std::string> schemes{std::string(whole.text.substr(0, colon + 1))};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    std::vector<std::string> longer;
    for (const std::string& begin : schemes)
      for (const std::string& value : keys[k].values)
        longer.push_back(begin + (k > 0 ? "," : "") + keys[k].name + value);
    schemes = std::move(longer);
  }
  return schemes;
}

std::vector<std::pair<std::string, std::string>> keys_of_scheme(std::string_view specification) {
  const std::size_t colon = specification.find(':');
  std::vector<std::pair<std::string, std::string>> result;
  if (colon == std::string_view::npos || specification.find_first_of("[(") < colon) return result;
  for (const Piece& piece : split({specification.substr(colon + 1), colon + 1}, ','))
    if (const std::size_t equals = piece.text.find('=');
        equals != std::string_view::npos && piece.text.find_first_of("([") > equals)
      result.emplace_back(trimmed(part(piece, 0, equals)).text, trimmed(part(piece, equals + 1)).text);
  return result;
}

}  // namespace subcert::sweeps
