// subcert limit SCHEME

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/commands/level_values.hpp>
#include <subcert/cli/pages/limit_page.hpp>
#include <subcert/reports/facts/regularity_facts.hpp>

#include <charconv>
#include <numeric>
#include <sstream>

namespace subcert::cli {
namespace {

constexpr int usual_level = 8, usual_level_of_surfaces = 2;
constexpr long most_derivatives = 1000;
constexpr int proof_levels = 16;  // of norms that prove convergence

struct LimitCommandOptions : LimitPageOptions {
  std::string scheme;
  std::string derivative;
  bool range = false;
  LevelOptions level_options;
};

/// The order in each variable; zeros where none is given.
LatticePoint derivative_orders(const std::string& text, std::size_t variables) {
  if (text.empty()) return LatticePoint(variables, 0);
  LatticePoint orders;
  std::istringstream parts(text + ",");
  for (std::string part; std::getline(parts, part, ',');) {
    long order = -1;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), order);
    if (error != std::errc() || end != part.data() + part.size() || order < 0 || order > most_derivatives)
      fail(ErrorKind::usage, "--derivative: expected orders from 0 to {}, got '{}'", most_derivatives, part);
    orders.push_back(order);
  }
  if (orders.size() != variables)
    fail(ErrorKind::usage, "--derivative: need {}, got '{}'",
         variables == 1   ? "one order for a scheme of one variable"
         : variables == 2 ? "an order for each of 2 variables, as 1,0"
                          : "an order for each of 3 variables, as 1,0,0",
         text);
  return orders;
}

/// The values at lattice points. Refuses vectors of functions that are not proved to have continuous derivatives of
/// this order.
LatticeSequence vector_at_lattice_points(const Scheme& scheme, const LatticePoint& orders,
                                         const LimitCommandOptions& options) {
  if (options.range) fail(ErrorKind::usage, "--range: need a mask of numbers, got {}", scheme.specification);
  const MultivariateRegularity found = vector_regularity(scheme.mask, scheme.quadratic, {Deadline::in(options.budget)},
                                                         {.integral = scheme.integral});
  const FunctionVector& vector = *found.vector;
  if (vector.continuous.is_no())
    throw NoLimit(
        fmt::format("{}: there is no continuous solution; {}", scheme.specification, vector.continuous.reason),
        {vector.continuous});
  if (vector.solutions > 1) fail(ErrorKind::usage, "{}: need {}", scheme.specification, facts::needed_solution(vector));
  const long total = std::accumulate(orders.begin(), orders.end(), 0L);
  if (!vector.continuous.is_yes() || (total > 0 && !(*found.exponent.lower > total)))
    fail(ErrorKind::undecided, "{}: continuous derivatives of order {} are not proved", scheme.specification, total);
  return *vector.values;
}

/// Of masks that come again in the end.
ExitCode run_levels(const LevelDependentScheme& scheme, const LimitCommandOptions& options) {
  const LatticePoint orders{0};
  const Scheme again = period_of(scheme);
  if (scheme.form) {
    const LatticeSequence values = limit_values(scheme.masks, vector_at_lattice_points(again, orders, options),
                                                options.level);
    const Scheme first{.specification = scheme.specification, .title = "", .mask = scheme.masks.at(0)};
    return print_vector_values(first, by_points(values, first.mask.components(), 0), orders, options);
  }
  const Deadline deadline = Deadline::in(options.budget);
  require_derivative(scheme.specification, again.mask, orders, {proof_levels, deadline});
  return print_limit_values(scheme.specification, limit_values(scheme.masks, options.level, deadline), options);
}

/// Of masks that change from level to level.
ExitCode run_levels(const std::variant<LevelDependentScheme, FollowedFamily>& levels, LimitCommandOptions options) {
  if (options.range || !options.derivative.empty())
    fail(ErrorKind::usage, "--{}: cannot be asked for with masks that change from level to level",
         options.range ? "range" : "derivative");
  if (options.level < 0) options.level = usual_level;
  if (const auto* scheme = std::get_if<LevelDependentScheme>(&levels)) return run_levels(*scheme, options);
  const auto& family = std::get<FollowedFamily>(levels);
  return print_limit_values(family.specification,
                            limit_values(family.family.mask, family.recurrence, family.start, options.level), options);
}

ExitCode run(LimitCommandOptions options) {
  require_one_form(options, options.form);
  if (const auto levels = read_levels(options.scheme, options.level_options)) return run_levels(*levels, options);
  const Scheme scheme = make_refinable_scheme(options.scheme);
  const int dimension = scheme.mask.dimension();
  const LatticePoint orders = derivative_orders(options.derivative, static_cast<std::size_t>(dimension));
  if (options.range && (!options.derivative.empty() || options.level >= 0))
    fail(ErrorKind::usage, "--range: takes neither --level nor --derivative");
  if (options.level < 0) options.level = dimension > 1 ? usual_level_of_surfaces : usual_level;
  if (scheme.form) {
    const LatticeSequence values = vector_at_lattice_points(scheme, orders, options);
    return print_vector_values(scheme, limit_values(scheme.mask, scheme.quadratic, values, options.level, orders),
                               orders, options);
  }
  const Deadline deadline = Deadline::in(options.budget);
  require_derivative(scheme.specification, scheme.mask, orders, {proof_levels, deadline});
  return options.range ? print_limit_range(scheme, options, deadline)
                       : print_limit_values(scheme, orders, options, deadline);
}

}  // namespace

void add_limit(Command& app) {
  auto options = std::make_shared<LimitCommandOptions>();
  Command command = add_command(app, "limit", "Exact values of the basic limit function, or bounds for all of them",
                                "subcert limit primal:n=2 --level 3", options, [=] { return run(*options); });
  command
      .option("--level", options->level,
              "Values at the points i / arity^LEVEL, 8 if not given; of surfaces at M^-LEVEL i, 2 if not given")
      .within(0, 60);
  command.option("--derivative", options->derivative, "Order of the derivative; of surfaces in each variable, as 1,0");
  command.flag("--range", options->range, "Maximum, minimum and sign of the function instead, with proof");
  command.option("--width", options->width, "Relative width of the enclosures of --range, p or p/q")
      .exact_number()
      .with_default();
  command
      .option("--budget", options->budget, "Seconds of processor time, for the proof of convergence and what follows")
      .within(0.001, 1e6)
      .with_default();
  add_level_options(command, options->level_options);
  add_scheme(command, options->scheme, true);
  add_paper_form(command, options->form, "The table in LaTeX", "The table in Markdown");
}

}  // namespace subcert::cli
