#include "levels.hpp"

#include <algorithm>
#include <numeric>
#include <ranges>

namespace subcert_check {
namespace {

constexpr std::size_t most_masks = 64, most_pairs = 4096, most_choices = 1024;
constexpr std::size_t most_entries = 1000;
constexpr unsigned most_classes = 64;
constexpr const char* expected_order = "an order is any, period=0,1,... or follows=0-1,1-0,...";

/// The coefficients of a mask of numbers for the class r.
mpz_class class_sum(const Mask& mask, std::size_t r, unsigned arity) {
  mpz_class sum = 0;
  for (std::size_t i = r; i < mask.points(); i += arity) sum += mask.coefficients[i];
  return sum;
}

/// A mask at the lower end of a range; and what the upper end adds to each coefficient, over the same denominator.
std::pair<Mask, Vector> ends_of(const Mask& mask, const Range& range) {
  const std::size_t points = mask.points();
  const auto is_zero = [](const mpz_class& x) { return x == 0; };
  require(mask.divisor[0] != 0 && std::all_of(mask.divisor.begin() + 1, mask.divisor.end(), is_zero) &&
              std::ranges::all_of(mask.coefficients | std::views::drop(2 * points), is_zero),
          "a value for each new point needs coefficients of degree 1 in it, over a number");
  Rationals ends(2 * points);
  for (std::size_t i = 0; i < points; ++i) {
    const mpq_class slope = mask.powers > 1 ? ratio(mask.coefficients[points + i], mask.denominator) : mpq_class(0);
    ends[i] = (ratio(mask.coefficients[i], mask.denominator) + slope * range.low) / mask.divisor[0];
    ends[points + i] = slope * (range.high - range.low) / mask.divisor[0];
  }
  const Family cleared = clear_denominators(1, ends);
  const auto middle = cleared.entries.begin() + static_cast<std::ptrdiff_t>(points);
  Mask low = mask;
  low.powers = 1;
  low.coefficients.assign(cleared.entries.begin(), middle);
  low.denominator = cleared.denominator;
  low.divisor = {1};
  return {low, {middle, cleared.entries.end()}};
}

/// Rejects unless the sums of a_i i^d over the multiples i of the arity are the powers of one number, d < order.
void check_one_place(const Mask& mask, unsigned arity, std::size_t order, Arithmetic& arithmetic) {
  mpz_class place = 0, power_of_place = mask.denominator;
  Vector terms;
  for (std::size_t i = 0; i < mask.points(); i += arity) {
    terms.push_back(mask.coefficients[i]);
    place += terms.back() * i;
  }
  const std::size_t limbs = 1 + mpz_size(mask.denominator.get_mpz_t());
  for (std::size_t d = 0; d < order; ++d, power_of_place *= place) {  // times the denominator to the power d + 1
    arithmetic.spend(terms.size() * (d + 1) * limbs * limbs);
    mpz_class sum = 0;
    for (std::size_t k = 0; k < terms.size(); terms[k] *= mask.denominator * (arity * k), ++k) sum += terms[k];
    require(sum == power_of_place, "the rules do not keep polynomials, or at places that depend on the parameter");
  }
}

/// Divides by (1 - z^arity)^order, times arity^order; empty for 0.
Vector divided_by_classes(Vector e, unsigned arity, std::size_t order) {
  for (std::size_t round = 0; round < order; ++round) {
    for (std::size_t i = arity; i < e.size(); ++i) e[i] += e[i - arity];
    for (unsigned i = 0; i < arity && !e.empty(); ++i, e.pop_back())
      require(e.back() == 0, "the rules do not keep polynomials for all values");
  }
  for (mpz_class& x : e) x *= power(arity, order).get_num();
  return e;
}

}  // namespace

namespace {

/// What may follow what, and how many masks there may be.
void parse_order(std::string_view order, MaskList& list) {
  require(list.masks.size() <= most_masks, "more masks than the checker allows");
  const auto number = [&](std::string_view text) { return parse_size(text, 0, list.masks.size() - 1); };
  constexpr std::string_view period = "period=", follows = "follows=";
  if (order.starts_with(period)) {
    for (const std::string_view text : split(order.substr(period.size()), ",")) {
      list.period.push_back(number(text));
      arity_in_one(list, list.period.size());
    }
  } else if (order.starts_with(follows)) {
    for (const std::string_view text : split(order.substr(follows.size()), ",")) {
      const Fields pair = split(text, "-");
      require(pair.size() == 2 && list.follows.size() < most_pairs, expected_order);
      list.follows.emplace_back(number(pair[0]), number(pair[1]));
    }
  } else {
    require(order == "any", expected_order);
  }
}

/// The matrices of the pairs, or those of all masks one after another. Domain: as many families, of one size and one
/// denominator, as masks.
Family along_pairs(const MaskList& list, const std::vector<Family>& families) {
  const std::size_t width = families.front().size;
  Family result{width, {}, families.front().denominator};
  if (list.follows.empty()) {
    for (const Family& family : families)
      result.entries.insert(result.entries.end(), family.entries.begin(), family.entries.end());
    return result;
  }
  std::size_t nodes = 0;
  for (const auto& [before, after] : list.follows) nodes = std::max({nodes, before + 1, after + 1});
  result.size = nodes * width;
  require(result.size <= 256, "transition matrices larger than 256");
  require(list.follows.size() * list.arity * result.size * result.size <= std::size_t{1} << 22, too_much_work);
  for (const auto& [before, after] : list.follows)
    for (std::size_t t = 0; t < list.arity; ++t) {
      Vector block(result.size * result.size);
      for (std::size_t k = 0; k < width; ++k)
        for (std::size_t i = 0; i < width; ++i)
          block[(after * width + k) * result.size + before * width + i] = families[after].matrix(t)[k * width + i];
      result.entries.insert(result.entries.end(), block.begin(), block.end());
    }
  return result;
}

}  // namespace

MaskList parse_mask_list(std::string_view masks, unsigned arity, std::string_view order) {
  MaskList list{{}, arity, {}, {}};
  for (const std::string_view text : split(masks, ";")) {
    const Mask& mask = list.masks.emplace_back(parse_mask(text, '\0'));
    require(mask.sizes.size() == 1 && mask.points() <= 1000 && mask.coefficients.front() != 0 &&
                mask.coefficients.back() != 0,
            "a mask has 1 to 1000 coefficients, the first and the last not zero");
  }
  parse_order(order, list);
  return list;
}

MaskList parse_matrix_mask_list(std::string_view masks, unsigned arity, std::string_view order) {
  MaskList list{{}, arity, {}, {}};
  for (const std::string_view text : split(masks, ";")) {
    const Mask& mask = list.masks.emplace_back(parse_matrix_mask(text, '\0'));
    require(mask.sizes.size() == 1 && mask.points() <= most_entries, "a mask has 1 to 1000 entries of coefficients");
    require(mask.components == list.masks.front().components, "the matrices of two masks have different sizes");
  }
  parse_order(order, list);
  if (list.period.empty()) return list;
  MaskList in_turn{{}, arity, {}, {}};
  for (std::size_t k = 0; k < list.period.size(); ++k) {
    in_turn.masks.push_back(list.masks[list.period[k]]);
    in_turn.follows.emplace_back(k, (k + 1) % list.period.size());
  }
  return in_turn;
}

Mask masks_as_powers(const MaskList& list) {
  Mask all = list.masks.front();
  mpz_class end = all.first[0] + all.sizes[0];
  for (const Mask& mask : list.masks) {
    all.first[0] = std::min(all.first[0], mask.first[0]);
    end = std::max(end, mpz_class(mask.first[0] + mask.sizes[0]));
  }
  const std::size_t square = all.components * all.components;
  const mpz_class points = end - all.first[0];
  require(points * square <= most_entries, "the masks of a list have more than 1000 entries together");
  all.sizes = {points.get_ui()};
  all.powers = list.masks.size();
  all.divisor.assign(all.powers, 1);
  Rationals entries(all.powers * all.sizes[0] * square);
  for (std::size_t p = 0; p < all.powers; ++p) {
    const Mask& mask = list.masks[p];
    const mpz_class skipped = mask.first[0] - all.first[0];
    const std::size_t begin = (p * all.sizes[0] + skipped.get_ui()) * square;
    for (std::size_t i = 0; i < mask.points(); ++i) entries[begin + i] = ratio(mask.coefficients[i], mask.denominator);
  }
  Family cleared = clear_denominators(1, entries);
  all.coefficients = std::move(cleared.entries);
  all.denominator = std::move(cleared.denominator);
  return all;
}

Vector product_of_symbols(const Vector& symbol, const Vector& factor, std::size_t step, Arithmetic& arithmetic) {
  Vector result(symbol.size() + step * (factor.size() - 1));
  for (std::size_t i = 0; i < symbol.size(); ++i)
    for (std::size_t j = 0; j < factor.size(); ++j) arithmetic.add_product(result[i + step * j], symbol[i], factor[j]);
  return result;
}

Mask masks_in_one(const MaskList& list, const std::vector<std::size_t>& sequence, Arithmetic& arithmetic) {
  std::size_t points = 1;
  for (const std::size_t k : sequence) points = list.arity * (points - 1) + list.masks[k].points();
  require(points <= 1000, "the masks of a period have more than 1000 coefficients together");
  Mask one = list.masks[sequence.front()];
  for (std::size_t level = 1; level < sequence.size(); ++level) {
    const Mask& next = list.masks[sequence[level]];
    one.coefficients = product_of_symbols(next.coefficients, one.coefficients, list.arity, arithmetic);
    one.denominator *= next.denominator;
  }
  one.sizes = {one.coefficients.size()};
  return one;
}

unsigned arity_in_one(const MaskList& list, std::size_t levels) {
  unsigned classes = 1;
  for (std::size_t level = 0; level < levels; ++level)
    require((classes *= list.arity) <= most_classes, "a longer period than the checker allows");
  return classes;
}

void check_stability(const MaskList& list, const std::vector<std::size_t>& product, std::size_t sum_rules,
                     Arithmetic& arithmetic) {
  std::vector<std::size_t> sequence;
  for (const std::size_t letter : product)
    sequence.push_back(list.follows.empty() ? letter / list.arity : list.follows[letter / list.arity].second);
  std::size_t period = 1;
  while (sequence.size() % period != 0 ||
         !std::equal(sequence.begin() + static_cast<std::ptrdiff_t>(period), sequence.end(), sequence.begin()))
    ++period;
  sequence.resize(period);
  const unsigned arity = arity_in_one(list, sequence.size());
  check_stability(masks_in_one(list, sequence, arithmetic), arity, sum_rules, Range{}, 0, arithmetic);
}

void check_constants(const MaskList& list) {
  for (const Mask& mask : list.masks)
    for (unsigned r = 0; r < list.arity; ++r)
      require(class_sum(mask, r, list.arity) == mask.denominator, "a mask of the list does not keep constant data");
}

Family list_family(const MaskList& list, std::size_t sum_rules) {
  std::vector<Family> families;
  std::size_t width = 1;
  for (const Mask& mask : list.masks) width = std::max(width, transition_family(mask, list.arity, sum_rules).size);
  mpz_class common = 1;
  for (const Mask& mask : list.masks) {
    families.push_back(transition_family(mask, list.arity, sum_rules, width));
    common = lcm(common, families.back().denominator);
  }
  for (Family& family : families)
    for (mpz_class& x : family.entries) x *= common / family.denominator;
  for (Family& family : families) family.denominator = common;
  return along_pairs(list, families);
}

Family along(const MaskList& list, const Family& by_powers) {
  const std::size_t masks = list.masks.size();
  std::vector<Family> families(masks, Family{by_powers.size, {}, by_powers.denominator});
  for (std::size_t k = 0; k < by_powers.count(); ++k) {
    const auto matrix = by_powers.matrix(k);
    Vector& entries = families[k % masks].entries;
    entries.insert(entries.end(), matrix.begin(), matrix.end());
  }
  return along_pairs(list, families);
}

Family each_point_family(const Mask& mask, unsigned arity, const Range& range, std::size_t sum_rules,
                         Arithmetic& arithmetic) {
  const auto [low, added] = ends_of(mask, range);
  check_one_place(low, arity, sum_rules, arithmetic);
  const Family at_low = transition_family(low, arity, sum_rules);
  const Vector e = divided_by_classes(added, arity, sum_rules);
  Vector differences{1};
  for (std::size_t k = 0; k < sum_rules; ++k) differences = product_of_symbols(differences, {1, -1}, 1, arithmetic);
  const std::size_t size = at_low.size;
  Family result{size, {}, at_low.denominator};
  for (std::size_t t = 0; t < arity; ++t) {
    std::vector<std::size_t> free;  // the new points t - back that depend on the parameter
    for (std::size_t back = 0; back < size + sum_rules; ++back) {
      bool depends = false;
      for (std::size_t i = (t + arity * back - back) % arity; i < e.size(); i += arity) depends |= e[i] != 0;
      if (depends) free.push_back(back);
    }
    require(free.size() <= 10 && result.count() + (std::size_t{1} << free.size()) <= most_choices,
            "more choices of ends than the checker allows");
    require((result.count() + (std::size_t{1} << free.size())) * size * size <= std::size_t{1} << 22, too_much_work);
    for (std::size_t choice = 0; choice < std::size_t{1} << free.size(); ++choice) {
      Vector matrix(at_low.matrix(t).begin(), at_low.matrix(t).end());
      for (std::size_t f = 0; f < free.size(); ++f)
        for (std::size_t j = 0; (choice >> f & 1) != 0 && j <= std::min(sum_rules, free[f]); ++j) {
          const std::size_t k = free[f] - j;
          for (std::size_t i = 0; k < size && i < size; ++i)
            if (arity * i + t >= free[f] && arity * i + t - free[f] < e.size())
              arithmetic.add_product(matrix[k * size + i], differences[j], e[arity * i + t - free[f]]);
        }
      result.entries.insert(result.entries.end(), matrix.begin(), matrix.end());
    }
  }
  return result;
}

}  // namespace subcert_check
