#include "least_absolute.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>

namespace subcert_check {
namespace {

constexpr std::size_t most_points = 16, most_arity = 16, most_steps = 8;
constexpr std::size_t most_starts = 256;            // arity^steps
constexpr std::uint64_t most_patterns = 1UL << 18;  // subsets of degree + 1 places, with signs of the others
constexpr std::size_t most_values = 4096;           // of a level of an orbit
constexpr std::size_t most_kept = 1UL << 22;        // multipliers of the leaves of a start

std::uint64_t binomial(std::uint64_t n, std::uint64_t k) {
  std::uint64_t result = 1;
  for (std::uint64_t i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

using Places = std::vector<std::size_t>;

/// The product of x - place over the places but one.
std::int64_t product_of_distances(std::int64_t x, const Places& places, std::size_t but) {
  std::int64_t result = 1;
  for (const std::size_t place : places)
    if (place != but) result *= x - static_cast<std::int64_t>(place);
  return result;
}

/// The vertices of U, of which a character tells each coordinate: + for 1, - for -1, 0 for what lies between.
class Vertices {
 public:
  Vertices(const L1Rule& rule, Arithmetic& arithmetic) : rule_(rule) {
    const std::size_t inner = rule.degree + 1, outer = rule.points - inner;
    arithmetic.spend(binomial(rule.points, inner) << outer << 6);
    std::string chosen(rule.points, '1');
    std::fill_n(chosen.begin(), outer, '0');
    do {
      Places basis, others;
      for (std::size_t r = 0; r < rule.points; ++r) (chosen[r] == '1' ? basis : others).push_back(r);
      add(basis, others);
    } while (std::next_permutation(chosen.begin(), chosen.end()));
  }

  /// In the order of their characters.
  std::vector<std::string> list() const { return {signs_.begin(), signs_.end()}; }

 private:
  /// Those with given signs at the other places, if the coordinates of the basis are at most 1 in modulus.
  void add(const Places& basis, const Places& others) {
    std::vector<std::int64_t> bottom;
    std::vector<std::vector<std::int64_t>> tops;  // u_b = - sum of sign * top / bottom
    for (const std::size_t b : basis) {
      bottom.push_back(product_of_distances(static_cast<std::int64_t>(b), basis, b));
      tops.emplace_back();
      for (const std::size_t r : others)
        tops.back().push_back(product_of_distances(static_cast<std::int64_t>(r), basis, b));
    }
    for (std::uint64_t signs = 0; signs >> others.size() == 0; ++signs) {
      std::string text(rule_.points, '0');
      for (std::size_t k = 0; k < others.size(); ++k) text[others[k]] = (signs >> k & 1) != 0 ? '-' : '+';
      bool inside = true;
      for (std::size_t i = 0; inside && i < basis.size(); ++i) {
        std::int64_t top = 0;
        for (std::size_t k = 0; k < others.size(); ++k) top += (signs >> k & 1) != 0 ? tops[i][k] : -tops[i][k];
        inside = std::abs(top) <= std::abs(bottom[i]);
        if (top == bottom[i]) text[basis[i]] = '+';
        if (top == -bottom[i]) text[basis[i]] = '-';
      }
      if (inside) signs_.insert(text);
    }
  }

  const L1Rule& rule_;
  std::set<std::string> signs_;
};

/// It has degree + 1 places with 0.
bool is_full(const L1Rule& rule, const std::string& vertex) {
  return static_cast<std::size_t>(std::count(vertex.begin(), vertex.end(), '0')) == rule.degree + 1;
}

/// Place r of a window, and output number e of it, from its centre in units of the spacing over twice the arity.
mpz_class position(const L1Rule& rule, std::size_t r) {
  return mpz_class(2 * rule.arity * r) - mpz_class(rule.arity * (rule.points - 1));
}
mpz_class output(const L1Rule& rule, std::size_t e) { return mpz_class(2 * e + 1) - mpz_class(rule.arity); }

/// At a position: the polynomial through the data where the vertex is 0, and through data plus 1 at the first other
/// places that it needs.
mpq_class fitted(const L1Rule& rule, const std::string& vertex, const Rationals& data, const mpz_class& x,
                 Arithmetic& arithmetic) {
  std::vector<std::pair<mpz_class, mpq_class>> nodes;
  for (const bool zero : {true, false})
    for (std::size_t r = 0; r < vertex.size() && nodes.size() <= rule.degree; ++r)
      if ((vertex[r] == '0') == zero) nodes.emplace_back(position(rule, r), data[r] + (zero ? 0 : 1));
  mpq_class result = 0;
  for (const auto& [at, value] : nodes) {
    arithmetic.spend((4000 + bits(value.get_num()) + bits(value.get_den())) * nodes.size());
    mpq_class term = value;
    for (const auto& [other, unused] : nodes)
      if (other != at) term *= ratio(x - other, at - other);
    result += term;
  }
  return result;
}

/// A fit of one window of a level: of the data begin, begin + 1, ... , and the vertices that are possible for it.
struct Window {
  std::size_t level = 0, begin = 0;
  std::vector<const std::string*> vertices = {};
  std::vector<bool> plus = {}, minus = {};  // at each place, whether some of these have the sign

  void take(std::vector<const std::string*> possible) {
    vertices = std::move(possible);
    const std::size_t points = vertices[0]->size();
    plus.assign(points, false);
    minus.assign(points, false);
    for (const std::string* vertex : vertices)
      for (std::size_t r = 0; r < points; ++r) {
        if ((*vertex)[r] == '+') plus[r] = true;
        if ((*vertex)[r] == '-') minus[r] = true;
      }
  }

  const std::string* only_vertex() const { return vertices.size() == 1 ? vertices[0] : nullptr; }
};

/// Multipliers of residuals that are not zero, by window and place: window * points + place.
using Multipliers = std::vector<std::pair<std::size_t, mpz_class>>;

/// What bounds one difference of the data after the steps.
class Start {
 public:
  Start(const L1Rule& rule, const std::vector<std::string>& vertices, const Contraction& contraction, std::size_t j,
        Reader& reader, Arithmetic& arithmetic)
      : rule_(rule),
        contraction_(contraction),
        reader_(reader),
        arithmetic_(arithmetic),
        target_(j),
        firsts_(contraction.steps),
        lasts_(contraction.steps) {
    for (std::size_t low = j, high = j + contraction.order, level = contraction.steps; level-- > 0;) {
      firsts_[level] = low /= rule.arity;
      lasts_[level] = high /= rule.arity;
      high += rule.points - 1;
    }
    for (std::size_t level = 0; level < contraction.steps; ++level)
      for (std::size_t begin = firsts_[level]; begin <= lasts_[level]; ++begin) windows_.push_back({level, begin});
    std::vector<const std::string*> all;
    for (const std::string& vertex : vertices) all.push_back(&vertex);
    for (Window& window : windows_) window.take(all);
    all_full_ = std::all_of(vertices.begin(), vertices.end(), [&rule](const auto& v) { return is_full(rule, v); });
  }

  /// A node of the tree, and all that is below it.
  void read_node() {
    if (reader_.at("side"))
      read_side();
    else if (reader_.at("split"))
      read_split();
    else if (reader_.at("again"))
      read_again();
    else if (reader_.at("thin"))
      read_thin();
    else
      read_leaf();
  }

 private:
  Window& window_of(std::string_view number) { return windows_[parse_size(number, 0, windows_.size() - 1)]; }

  /// What follows holds of a window with these vertices.
  void read_part(Window& window, std::vector<const std::string*> possible) {
    arithmetic_.spend(possible.size() * rule_.points);
    window.take(std::move(possible));
    read_node();
  }

  /// The vertices with one of some signs at a place, then the others.
  void read_side() {
    const Fields fields = reader_.take("side", 3, 3);
    Window& window = window_of(fields[0]);
    const std::size_t place = parse_size(fields[1], 0, rule_.points - 1);
    const std::string signs(fields[2]);
    require(signs == "+" || signs == "-" || signs == "0" || signs == "+-" || signs == "+0" || signs == "-0",
            "signs are +, -, 0 or two of these, in this order");
    const std::vector<const std::string*> all = window.vertices;
    std::vector<const std::string*> first, second;
    for (const std::string* vertex : all)
      (signs.find((*vertex)[place]) != std::string::npos ? first : second).push_back(vertex);
    require(!first.empty() && !second.empty(), "a side without a vertex");
    read_part(window, std::move(first));
    read_part(window, std::move(second));
    window.take(all);
  }

  void read_split() {
    Window& window = window_of(reader_.take("split", 1, 1)[0]);
    require(!window.only_vertex(), "a window is split that has one vertex");
    const std::vector<const std::string*> all = window.vertices;
    for (const std::string* vertex : all) read_part(window, {vertex});
    window.take(all);
  }

  void read_again() {
    const mpz_class number = parse_integer(reader_.take("again", 1, 1)[0]);
    require(number >= 0 && number < leaves_.size(), "there is no leaf of that number yet");
    check_signs(leaves_[number.get_ui()]);
  }

  void read_leaf() {
    const std::size_t count = windows_.size() * rule_.points;
    const Fields fields = reader_.take("leaf", count + 1, count + 1);
    const mpz_class scale = parse_integer(fields[0]);
    require(scale > 0, "a denominator must be positive");
    Multipliers multipliers = read_multipliers(fields, 1);
    kept_ += multipliers.size();
    require(kept_ <= most_kept, too_much_work);
    check_signs(multipliers);
    Vector sums = carried_to_data(multipliers, scale);
    for (std::size_t i = 0; i < contraction_.order; ++i)
      for (std::size_t m = 1; m < sums.size(); ++m) sums[m] += sums[m - 1];
    mpz_class norm = 0;
    for (const mpz_class& c : sums) norm += abs(c);
    require(norm <= contraction_.bound * scale, "the multipliers of a leaf do not prove the bound");
    leaves_.push_back(std::move(multipliers));
  }

  void read_thin() {
    const std::size_t count = windows_.size() * rule_.points;
    const Multipliers multipliers = read_multipliers(reader_.take("thin", count, count), 0);
    check_signs(multipliers);
    for (const mpz_class& c : carried_to_data(multipliers, 0))
      require(c == 0, "the residuals of a thin cell do not sum to 0");
    const auto level_of = [this](const auto& one) { return windows_[one.first / rule_.points].level; };
    require(all_full_ || std::all_of(multipliers.begin(), multipliers.end(),
                                     [&](const auto& one) { return level_of(one) <= 1; }),
            "a cell that is thin from level 2 on, and a degenerate vertex");
    const auto on_data = [&](const auto& one) { return level_of(one) == 0 && is_strict(one.first); };
    require(std::any_of(multipliers.begin(), multipliers.end(), on_data) || has_residual(multipliers),
            "no inequality of a thin cell is shown to be one");
  }

  Multipliers read_multipliers(const Fields& fields, std::size_t from) {
    arithmetic_.spend(20 * fields.size());
    Multipliers result;
    for (std::size_t i = from; i < fields.size(); ++i)
      if (fields[i] != "0") result.emplace_back(i - from, parse_integer(fields[i]));
    return result;
  }

  /// The only vertex of the window of this place has + or - there.
  bool is_strict(std::size_t place) const {
    const std::string* vertex = windows_[place / rule_.points].only_vertex();
    return vertex && (*vertex)[place % rule_.points] != '0';
  }

  /// A multiple of a residual that is not negative is not negative.
  void check_signs(const Multipliers& multipliers) {
    arithmetic_.spend(20 + 20 * multipliers.size());
    for (const auto& [place, value] : multipliers) {
      const Window& window = windows_[place / rule_.points];
      require(!(value > 0 ? window.minus : window.plus)[place % rule_.points], "a multiplier has the wrong sign");
    }
  }

  /// What is left of the data's coefficients once the fits are gone: of the form that is bounded, times the scale.
  Vector carried_to_data(const Multipliers& multipliers, const mpz_class& scale) {
    std::size_t level = contraction_.steps;
    const std::size_t arity = rule_.arity;
    Vector values(arity * (lasts_[level - 1] - firsts_[level - 1] + 1));
    for (std::size_t i = 0; i <= contraction_.order; ++i)
      values[target_ + i - arity * firsts_[level - 1]] = ((contraction_.order - i) % 2 == 0 ? scale
                                                                                            : mpz_class(-scale)) *
                                                         binomial(contraction_.order, i);
    std::size_t end = multipliers.size(), window = windows_.size();
    while (true) {
      --level;
      const std::size_t first = firsts_[level], last = lasts_[level];
      window -= last - first + 1;
      Vector data(last - first + rule_.points);
      std::vector<Vector> moments(last - first + 1, Vector(rule_.degree + 1));
      for (; end > 0 && multipliers[end - 1].first >= window * rule_.points; --end) {
        const auto& [place, value] = multipliers[end - 1];
        const std::size_t i = place / rule_.points - window, r = place % rule_.points;
        data[i + r] += value;
        mpz_class power = 1;
        for (mpz_class& moment : moments[i]) {
          arithmetic_.add_product(moment, value, power);
          power *= position(rule_, r);
        }
      }
      for (std::size_t i = 0; i < moments.size(); ++i) {
        for (std::size_t e = 0; e < arity; ++e) {
          mpz_class power = 1;
          for (mpz_class& moment : moments[i]) {
            arithmetic_.spend(20);
            moment -= values[arity * i + e] * power;
            power *= output(rule_, e);
          }
        }
        for (const mpz_class& moment : moments[i])
          require(moment == 0, "the multipliers of a window do not take its fit away");
      }
      if (level == 0) return data;
      values = Vector(arity * (lasts_[level - 1] - firsts_[level - 1] + 1));
      for (std::size_t m = 0; m < data.size(); ++m) values[first + m - arity * firsts_[level - 1]] = data[m];
    }
  }

  // ---- a residual that is not zero at one point of the space of the equalities ----

  /// Whether there is a multiplier of a residual with a sign, of a window with a full vertex, that is not zero at the
  /// point of Theorem 36.
  bool has_residual(const Multipliers& multipliers) {
    std::size_t first = firsts_[0];  // of the values, which are known as far as the windows that make them were split
    std::vector<std::optional<mpq_class>> values(lasts_[0] - first + rule_.points);
    mpq_class datum = 1;
    for (auto& value : values) {
      value = datum;
      datum *= 1009;
    }
    for (std::size_t level = 0, window = 0; level < contraction_.steps; ++level) {
      std::vector<std::optional<mpq_class>> next;
      for (std::size_t begin = firsts_[level]; begin <= lasts_[level]; ++begin, ++window) {
        const auto from = values.begin() + static_cast<std::ptrdiff_t>(begin - first);
        const auto to = from + static_cast<std::ptrdiff_t>(rule_.points);
        next.resize(next.size() + rule_.arity);
        const std::string* vertex = windows_[window].only_vertex();
        if (!vertex || std::find(from, to, std::nullopt) != to) continue;
        Rationals data;
        for (auto value = from; value != to; ++value) data.push_back(**value);
        for (const auto& [place, value] : multipliers)
          if (const std::size_t r = place % rule_.points;
              place / rule_.points == window && is_strict(place) && is_full(rule_, *vertex) &&
              fitted(rule_, *vertex, data, position(rule_, r), arithmetic_) != data[r])
            return true;
        for (std::size_t e = 0; e < rule_.arity; ++e)
          next[next.size() - rule_.arity + e] = fitted(rule_, *vertex, data, output(rule_, e), arithmetic_);
      }
      values = std::move(next);
      first = rule_.arity * firsts_[level];
    }
    return false;
  }

  const L1Rule& rule_;
  const Contraction& contraction_;
  Reader& reader_;
  Arithmetic& arithmetic_;
  std::size_t target_;
  std::vector<std::size_t> firsts_, lasts_;  // windows of the levels
  std::vector<Window> windows_;
  bool all_full_;  // the vertices
  std::vector<Multipliers> leaves_;
  std::size_t kept_ = 0;
};

/// The fits of a level of an orbit, which the line says by their vertices; the next level.
Rationals refined(const L1Rule& rule, const std::vector<std::string>& vertices, const Rationals& values, Reader& reader,
                  Arithmetic& arithmetic) {
  const std::size_t count = values.size() - rule.points + 1;
  require(2 * count <= most_values, too_much_work);
  Rationals next;
  const Fields fields = reader.take("fits", count, count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string vertex(fields[i]);
    require(std::binary_search(vertices.begin(), vertices.end(), vertex) && is_full(rule, vertex),
            "a fit is not that of a full vertex");
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i);
    const Rationals data(begin, begin + static_cast<std::ptrdiff_t>(rule.points));
    for (std::size_t r = 0; r < rule.points; ++r) {
      const int sign = vertex[r] == '0' ? 0 : vertex[r] == '+' ? 1 : -1;
      require(sgn(mpq_class(data[r] - fitted(rule, vertex, data, position(rule, r), arithmetic))) * sign >= 0,
              "a residual has not the sign of the vertex");
    }
    for (const int x : {-1, 1}) next.push_back(fitted(rule, vertex, data, x, arithmetic));
  }
  return next;
}

/// Whether so many values of one sign follow each other.
bool has_run(const Rationals& values, std::size_t length) {
  std::size_t positive = 0, negative = 0;
  for (const mpq_class& value : values) {
    positive = value > 0 ? positive + 1 : 0;
    negative = value < 0 ? negative + 1 : 0;
    if (positive == length || negative == length) return true;
  }
  return false;
}

/// Differences to be bounded: the others are shifts of these.
std::size_t starts_of(const L1Rule& rule, std::size_t steps) {
  std::size_t starts = 1;
  for (std::size_t i = 0; i < steps && starts <= most_starts; ++i) starts *= rule.arity;
  return starts;
}

}  // namespace

L1Rule parse_l1_rule(std::string_view text) {
  const Fields fields = split(text, ",");
  require(fields.size() == 2 || fields.size() == 3,
          "a rule of least absolute deviations is N,DEGREE or N,DEGREE,ARITY");
  L1Rule rule;
  rule.points = parse_size(fields[0], 2, most_points);
  rule.degree = parse_size(fields[1], 0, rule.points - 2);
  require(binomial(rule.points, rule.degree + 1) << (rule.points - rule.degree - 1) <= most_patterns,
          "a rule with more signs than the checker allows");
  if (fields.size() == 3) rule.arity = parse_size(fields[2], 3, most_arity);
  return rule;
}

Contraction parse_contraction(const Fields& fields, const L1Rule& rule) {
  require(fields.size() == 3, "a contraction is STEPS, ORDER and BOUND");
  Contraction result;
  result.steps = parse_size(fields[0], 1, most_steps);
  result.order = parse_size(fields[1], 1, rule.degree + 1);
  require(starts_of(rule, result.steps) <= most_starts, "more steps than the checker allows");
  result.bound = parse_rational(fields[2]);
  require(result.bound >= 0, "the bound of a contraction is negative");
  return result;
}

Contraction read_contraction(const L1Rule& rule, Reader& reader, Arithmetic& arithmetic) {
  Contraction contraction = parse_contraction(reader.take("contraction", 3, 3), rule);
  const std::vector<std::string> vertices = Vertices(rule, arithmetic).list();
  const std::size_t starts = starts_of(rule, contraction.steps);
  const std::size_t levels = (starts - 1) / (rule.arity - 1);  // 1 + A + ... + A^(K-1)
  for (std::size_t j = 0; j < starts; ++j) {
    // the difference that reversed data have here; all sums are modulo the number of starts
    const std::size_t back = (rule.arity * (rule.points - 2) + 1) * levels + contraction.order + j;
    const std::size_t mirror = (starts - back % starts) % starts;
    if (j > mirror) continue;
    reader.take("start " + std::to_string(j), 0, 0);
    Start(rule, vertices, contraction, j, reader, arithmetic).read_node();
  }
  return contraction;
}

L1Orbit read_orbit(const L1Rule& rule, Reader& reader, Arithmetic& arithmetic) {
  require(rule.degree <= 1, "an orbit of fits of a degree above 1 proves nothing");
  require(rule.arity == 2, "an orbit of a rule that is not binary proves nothing");
  const std::size_t shortest = 2 * rule.points - 1;
  const Fields fields = reader.take("orbit", 3 + shortest, 3 + most_values);
  L1Orbit orbit{parse_size(fields[0], 1, most_steps), parse_rational(fields[2])};
  std::size_t place = parse_size(fields[1], 0, most_values);  // where the values are met again
  require(abs(orbit.factor.get_num()) != 1 || mpz_popcount(orbit.factor.get_den_mpz_t()) != 1,
          "the factor of an orbit is a power of 1/2");
  std::vector<Rationals> levels(1);
  for (std::size_t i = 3; i < fields.size(); ++i) levels[0].emplace_back(parse_integer(fields[i]));
  const std::vector<std::string> vertices = Vertices(rule, arithmetic).list();
  for (std::size_t level = 1; level <= orbit.steps || reader.at("fits"); ++level) {
    levels.push_back(refined(rule, vertices, levels.back(), reader, arithmetic));
    if (level < orbit.steps) continue;
    const Rationals &before = levels[level - orbit.steps], &now = levels[level];
    require(place + before.size() <= now.size(), "the values of an orbit are met again outside of what is known");
    for (std::size_t i = 0; i < before.size(); ++i)
      require(now[place + i] == orbit.factor * before[i], "the values of an orbit are not met again");
    place *= 2;
  }
  require(has_run(levels.back(), shortest), "an orbit has too few values of one sign next to each other");
  return orbit;
}

}  // namespace subcert_check
