// toy_sweep CASES MILLISECONDS JOURNAL [SHARD] [JOBS]: a sweep of toy cases, printed as a JSON array.
// Case i waits as long as asked and gives a rational number and a string; with CASES = -1 the journal is held forever.

#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/proofs-checks/sweeps/sweep.hpp>

#include <chrono>
#include <iostream>
#include <thread>

int main(int argc, char** argv) {
  using namespace subcert;
  using namespace subcert::sweeps;
  if (argc < 4) return 64;
  const long count = std::atol(argv[1]);
  const auto pause = std::chrono::milliseconds(std::atol(argv[2]));
  try {
    if (count < 0) {
      const Journal held(argv[3]);
      std::cout << "held" << std::endl;
      for (;;) std::this_thread::sleep_for(pause);
    }
    std::vector<SweepCase> cases;
    for (long i = 0; i < count; ++i) cases.push_back({"toy n=" + std::to_string(i), static_cast<double>(i % 7)});
    SweepOptions options;
    options.journal = argv[3];
    options.version = "toy 1";
    if (argc > 4) options.shard = parse_shard(argv[4]);
    if (argc > 5) options.jobs = std::atoi(argv[5]);
    options.warn = [](const std::string& line) { std::cerr << line << "\n"; };
    const auto compute = [&](std::size_t i) -> Json {
      std::this_thread::sleep_for(pause);
      if (std::getenv("TOY_FAILS") && i % 5 == 3) throw std::runtime_error("three of five");
      const Rational value = power(Rational(static_cast<long>(i) + 1, 7), 5);
      return {{"n", i}, {"value", to_text(value)}, {"long", std::string(i % 11 == 0 ? 100000 : 3, 'x')}};
    };
    const auto results = run_sweep(cases, compute, options);
    if (!results) return 0;
    Json all = Json::array();
    for (const auto& value : results->values) all.push_back(value ? *value : Json());
    std::cout << all.dump(1) << "\n";
    std::cerr << "computed " << results->computed << ", from the journal " << results->from_journal << "\n";
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
