#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/cmake/catch.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace subcert;

TEST_CASE("every piece of work is done once") {
  for (const std::size_t count : {0, 1, 2, 7, 1000})
    for (const int jobs : {1, 2, 5, 40}) {
      CAPTURE(count, jobs);
      std::vector<std::atomic<int>> calls(count);
      parallel_for_each(count, jobs, [&](std::size_t i) { ++calls[i]; });
      for (const std::size_t ranges : {0, 1, 3, 100})
        parallel_ranges(count, ranges, jobs, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) ++calls[i];
        });
      for (const auto& one : calls) CHECK(one == 5);
    }
}

TEST_CASE("the first exception comes out, and no work is begun after it") {
  for (const int jobs : {1, 3}) {
    std::atomic<std::size_t> begun = 0;
    std::string message;
    try {
      parallel_for_each(100'000, jobs, [&](std::size_t i) {
        ++begun;
        if (i == 5) throw std::runtime_error("five");
        // Or the others do all that is left while the one that throws waits for its turn.
        std::this_thread::sleep_for(std::chrono::microseconds(20));
      });
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    CHECK(message == "five");
    CHECK(begun < 100'000);
  }
}

TEST_CASE("a flag ends the deadlines of its scope, on other threads too, and no others") {
  const Deadline before = Deadline::in(1000), endless;
  StopFlag flag;
  {
    const StopScope scope(&flag);
    StopFlag inner;
    const Deadline inside = Deadline::in(1000), unlimited, later = inside.after(0.5);
    std::vector<Deadline> elsewhere(3);
    parallel_for_each(3, 3, [&](std::size_t i) { elsewhere[i] = Deadline::in(1000); });
    {
      const StopScope inner_scope(&inner);
      elsewhere.emplace_back();  // the outer flag ends it, too
    }
    CHECK_FALSE(inside.expired());
    flag.set();
    CHECK(inside.expired());
    CHECK(inside.remaining() == 0);
    CHECK(unlimited.expired());
    CHECK(later.expired());
    CHECK(Deadline::in(1000).expired());
    CHECK(std::all_of(elsewhere.begin(), elsewhere.end(), [](const Deadline& d) { return d.expired(); }));
  }
  CHECK_FALSE(before.expired());
  CHECK_FALSE(endless.expired());
  CHECK_FALSE(Deadline::in(1000).expired());
}
