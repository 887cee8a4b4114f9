#include "transition.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace subcert_check {
namespace {

constexpr std::size_t max_steps = 1000, max_places = 1UL << 20;

/// The places where continuous solutions may have values.
class Places {
 public:
  explicit Places(const Transition& operators) : operators_(operators) {
    for (const auto& [place, value] : operators.mask()) operators.entry(pattern_, place) = 1;
  }

  Sequence inner() {
    const Sequence all = support();
    Sequence inner = all;
    for (std::size_t v = 0; v < operators_.variables(); ++v)
      for (const std::int64_t sign : {-1, 1}) {
        Point e{};
        e[v] = sign;
        const Sequence seen = approached(all, e);
        std::erase_if(inner, [&](const auto& value) { return !seen.contains(value.first); });
      }
    return inner;
  }

 private:
  /// Bounds the coordinates of the points j for which a solution of compact support may not vanish at x' + j.
  std::int64_t reach() {
    std::int64_t farthest = 0;
    for (const auto& [place, value] : operators_.mask())
      for (const std::int64_t c : combine(place.point, -1, operators_.digits()[0]))
        farthest = std::max(farthest, std::abs(c));
    Vector inverse, power;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i) {
        inverse.emplace_back(operators_.adjugate()[i][j]);
        power.emplace_back(i == j);
      }
    mpq_class sum = 0, norm = 1;
    for (mpz_class scale = 1; norm > mpq_class(1, 2); sum += norm) {
      power = operators_.arithmetic().multiply(inverse, power, 3);
      scale *= operators_.classes();
      mpz_class largest = 0;
      for (std::size_t i = 0; i < operators_.variables(); ++i)
        largest = std::max(largest, mpz_class(abs(power[i]) + abs(power[3 + i]) + abs(power[6 + i])));
      norm = ratio(largest, scale);
    }
    sum *= 2 * mpz_class(farthest);
    const mpz_class result = sum.get_num() / sum.get_den();  // rounded down, as coordinates are integers
    mpz_class places = operators_.components();
    for (std::size_t v = 0; v < operators_.variables(); ++v) places *= 2 * result + 1;
    require(places <= max_places, too_much_work);
    return result.get_si();
  }

  /// The places from which the operator of the first digit leads to one of these, with values 1.
  Sequence led_to(const Sequence& places) {
    Sequence result = std::move(operators_.of(pattern_, places)[0]);
    for (auto& [place, value] : result) value = 1;
    return result;
  }

  /// All places that may not vanish in v(x'), with values 1.
  Sequence support() {
    Point radius{};
    std::fill_n(radius.begin(), operators_.variables(), reach());
    Sequence places, next;
    for (Point p = combine({}, -1, radius);;) {
      for (std::size_t c = 0; c < operators_.components(); ++c) operators_.entry(next, {p, c}) = 1;
      std::size_t v = 0;
      for (; v < operators_.variables() && ++p[v] > radius[v]; ++v) p[v] = -radius[v];
      if (v == operators_.variables()) break;
    }
    for (std::size_t step = 0; next != places; ++step) {
      require(step < max_steps, too_much_work);
      places = std::exchange(next, led_to(next));
    }
    return places;
  }

  /// Of these, those that may not vanish in the limit of v(x' + M^-n e) either.
  Sequence approached(const Sequence& support, const Point& e) {
    std::vector<Sequence> sets(1);
    for (const auto& [place, value] : support)
      operators_.entry(sets[0], {combine(place.point, -1, e), place.component}) = 1;
    for (;;) {
      Sequence next = led_to(sets.back());
      const auto again = std::find(sets.begin(), sets.end(), next);
      if (again == sets.end()) {
        require(sets.size() < max_steps, too_much_work);
        sets.push_back(std::move(next));
        continue;
      }
      for (auto at = again; at != sets.end(); ++at)
        std::erase_if(next, [&](const auto& value) { return !at->contains(value.first); });
      return next;
    }
  }

  const Transition& operators_;
  Sequence pattern_;  // 1 where the mask is not 0
};

}  // namespace

std::vector<Vector> read_functionals(const Transition& operators, const Sequence& values, const Rationals& integral,
                                     Reader& reader, const mpz_class* root) {
  const std::size_t size = operators.components();
  Arithmetic& arithmetic = operators.arithmetic();
  // q |det M| (B - 1), row by row, q the denominator of the mask
  Vector rest(size * size);
  for (const auto& [place, value] : operators.mask()) rest[place.component] += value;
  for (std::size_t c = 0; c < size; ++c) rest[c * size + c] -= operators.denominator() * operators.classes();
  const auto product = [&](const Vector& x, const mpz_class* y, std::size_t step) {
    mpz_class sum = 0;
    for (std::size_t c = 0; c < size; ++c) arithmetic.add_product(sum, x[c], y[c * step]);
    return sum;
  };
  Vector goal = clear_denominators(1, integral).entries;
  for (std::size_t r = 0; r < size; ++r)
    require(product(goal, &rest[r * size], 1) == 0, "the integral is none of a solution");
  Vector sums(size);
  for (const auto& [place, value] : values) sums[place.component] += value;
  std::vector<Row> span;
  const Elimination modulo(operators, true);
  const auto add = [&](const Vector& row) {
    Sequence one;
    for (std::size_t c = 0; c < size; ++c)
      if (row[c] != 0) operators.entry(one, {{}, c}) = row[c];
    modulo.add(span, std::move(one));
  };
  for (std::size_t r = 0; r < size; ++r) add({&rest[r * size], &rest[r * size] + size});
  std::vector<Vector> result;
  mpz_class of_sums = 0, of_goal = 0;  // under the first functional that is not 0 at the integral
  const auto take = [&](const Vector& functional) {
    result.push_back(functional);
    add(functional);
    Vector image = functional;
    for (std::size_t n = 0; n < size; ++n) {
      Vector next;
      for (std::size_t c = 0; c < size; ++c) next.push_back(product(image, &rest[c], size));
      image = std::move(next);
    }
    require(std::ranges::all_of(image, [](const mpz_class& x) { return x == 0; }),
            "a functional does not tell integrals");
    const mpz_class sum = product(functional, sums.data(), 1), value = product(functional, goal.data(), 1);
    if (of_goal == 0) std::tie(of_sums, of_goal) = std::pair(sum, value);
    require(of_goal == 0 ? sum == 0 : sum * of_goal == value * of_sums, "the values are not those of this integral");
  };
  do {
    Vector functional;
    for (const std::string_view field : reader.take("functional", size, size))
      functional.push_back(parse_integer(field));
    take(functional);
    if (!root) continue;
    std::rotate(functional.begin(), functional.begin() + static_cast<std::ptrdiff_t>(size / 2), functional.end());
    for (std::size_t c = size / 2; c < size; ++c) functional[c] *= *root;
    take(functional);
  } while (reader.at("functional"));
  require(of_sums != 0, "the values are of the integral 0");
  require(span.size() >= size, "the functionals do not tell all of an integral");
  return result;
}

void check_unique(const Transition& operators, const std::vector<Vector>& functionals, std::size_t solutions) {
  const Sequence inner = Places(operators).inner();
  const Elimination modulo(operators, true);
  std::vector<Row> rows;
  for (const auto& [place, value] : inner) {
    Sequence image = std::move(operators.of({{place, 1}})[0]);
    operators.entry(image, place) -= operators.denominator();
    for (std::size_t i = 0; i < functionals.size(); ++i)  // at places that no sequence has
      if (const mpz_class& reading = functionals[i][place.component]; reading != 0)
        operators.entry(image, {{}, operators.components() + i}) = reading;
    modulo.add(rows, std::move(image));
  }
  require(rows.size() + (functionals.empty() ? solutions : 0) >= inner.size(),
          "the refinement equation may have several continuous solutions");
}

}  // namespace subcert_check
