#include "width.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert::cli {
namespace {

constexpr long most_places = 1000;

}  // namespace

void add_width(Command& command, SearchOptions& options) {
  command
      .option("--width", options.width,
              "At most so wide, 1e-1000 to 1, where a product is proved to attain the radius; wider is undecided")
      .exact_number();
}

WantedWidth wanted_width(const SearchOptions& options) {
  if (options.width.empty()) return {};
  const auto width = parse_number(options.width);
  const Rational least = power(Rational(10), -most_places);
  if (!width || *width < least || *width > 1)
    fail(ErrorKind::usage, "--width: expected a number from 1e-{} to 1, got '{}'", most_places, options.width);
  return {width, bits_for_width(*width), decimal_places(*width) + 2};
}

}  // namespace subcert::cli
