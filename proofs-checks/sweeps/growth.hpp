#pragma once
/// How a quantity grows over a sweep: what is found by least squares, not proved.

#include "condition.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace subcert::sweeps {

/// `holder by n`, or `2 - holder by n`: a member of the answers, or what a number exceeds it by, and a key.
struct GrowthQuestion {
  std::optional<Rational> from;
  std::string name, key;

  /// Errors: throws ParseError.
  static GrowthQuestion parse(std::string_view text);
  std::string text() const;
};

/// factor * key^power for the schemes of a family whose other keys are the same.
struct Growth {
  std::string schemes;    ///< which, as `primal:d=1`
  std::size_t count = 0;  ///< of values that are positive, as their keys are
  Rational first, last;   ///< least and largest key among them
  double factor = 0, power = 0;
  double deviation = 0;   ///< the largest of a value from the formula, as a part of it
  double last_power = 0;  ///< between the last two
};

/// Values as they come, in any order.
class Growths {
 public:
  explicit Growths(GrowthQuestion question) : question_(std::move(question)) {}

  const GrowthQuestion& question() const { return question_; }
  /// Takes the middle of an enclosure; leaves out what is no number, or not positive.
  void add(const Json& answers);
  /// For each choice of the other keys with at least three values the line of least squares through their logarithms.
  std::vector<Growth> result() const;

 private:
  GrowthQuestion question_;
  std::map<std::string, std::map<Rational, Rational>> values_;  ///< by the other keys, by the key
};

}  // namespace subcert::sweeps
