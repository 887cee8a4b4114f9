#include "sweep.hpp"

#include "ranks.hpp"

#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <algorithm>
#include <charconv>
#include <exception>
#include <map>
#include <mutex>
#include <numeric>
#include <set>

namespace subcert::sweeps {
namespace {

std::optional<std::size_t> parse_count(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The cases still to do and those done; called from several threads.
class Ledger {
 public:
  Ledger(const std::vector<SweepCase>& cases, const std::vector<std::string>& ids, const SweepOptions& options)
      : cases_(cases), options_(options) {
    results_.values.resize(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i)
      is_ours_.push_back(options.shard.contains(i) && (!options.is_wanted || options.is_wanted(i)));
    if (!options.journal.empty()) {
      journal_.emplace(options.journal);
      read_journal_entries(ids);
    }
    for (std::size_t i = 0; i < cases.size(); ++i)
      if (is_ours_[i] && !results_.values[i]) waiting_.push_back(i);
    std::stable_sort(waiting_.begin(), waiting_.end(),
                     [&](std::size_t a, std::size_t b) { return cases[a].effort > cases[b].effort; });
    tell_in_order();
    report_progress();
  }

  std::size_t waiting() const { return waiting_.size(); }

  /// The next case to compute; nothing after the last one and after the journal failed.
  std::optional<std::size_t> next() {
    const std::lock_guard lock(mutex_);
    if (failure_ || begun_ == waiting_.size()) return std::nullopt;
    return waiting_[begun_++];
  }

  void finish(std::size_t i, const CaseOutcome& outcome) {
    const std::lock_guard lock(mutex_);
    try {
      if (outcome.failed) {
        if (failed_++ == 0) first_failed_ = "case '" + cases_[i].specification + "': " + outcome.text;
        without_.insert(i);
        return tell_in_order();
      }
      Json value = Json::parse(outcome.text);
      if (journal_) journal_->append({options_.version, cases_[i].specification, value});
      results_.values[i] = std::move(value);
      ++results_.computed;
      if (options_.finished) options_.finished(i, *results_.values[i]);
      tell_in_order();
      report_progress();
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
    }
  }

  SweepResults results() {
    if (failure_) std::rethrow_exception(failure_);
    if (failed_ > 1) first_failed_ += " (and " + std::to_string(failed_ - 1) + " more cases failed)";
    if (failed_ > 0) throw std::runtime_error(first_failed_);
    return std::move(results_);
  }

 private:
  void read_journal_entries(const std::vector<std::string>& ids) {
    if (options_.warn)
      for (const std::string& report :
           damage_reports(options_.journal, journal_->content(), "its case is computed again where it is needed"))
        options_.warn(report);
    std::map<std::string, Json> known;
    for (JournalEntry& entry : journal_->take_entries()) known.emplace(entry.id(), std::move(entry.result));
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (const auto found = known.find(ids[i]); is_ours_[i] && found != known.end()) {
        results_.values[i] = std::move(found->second);
        ++results_.from_journal;
        if (options_.finished) options_.finished(i, *results_.values[i]);
      }
  }

  void tell_in_order() {
    if (!options_.in_order) return;
    for (; told_ < cases_.size(); ++told_) {
      if (!is_ours_[told_] || without_.contains(told_)) continue;
      std::optional<Json>& value = results_.values[told_];
      if (!value) return;
      options_.in_order(told_, *value);
      value.reset();
    }
  }

  void report_progress() const {
    if (!options_.progress) return;
    const std::size_t done = results_.computed + results_.from_journal, all = results_.from_journal + waiting_.size();
    std::string line = std::to_string(done) + " of " + std::to_string(all) + " cases";
    if (results_.from_journal > 0) line += ", " + std::to_string(results_.from_journal) + " of them from the journal";
    options_.progress(line);
  }

  const std::vector<SweepCase>& cases_;
  const SweepOptions& options_;
  std::optional<Journal> journal_;
  std::mutex mutex_;
  std::vector<bool> is_ours_;
  std::vector<std::size_t> waiting_;
  std::size_t begun_ = 0, told_ = 0;
  std::set<std::size_t> without_;  ///< a result, as they failed
  SweepResults results_;
  std::exception_ptr failure_;
  std::size_t failed_ = 0;
  std::string first_failed_;
};

}  // namespace

Shard parse_shard(std::string_view text) {
  constexpr std::size_t most = 1000000;
  const std::string expected = "I/N with 1 <= I <= N <= 1000000 (shards are counted from 1), as in 1/8";
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto number = parse_count(text.substr(0, slash));
  const auto count = slash < text.size() ? parse_count(text.substr(slash + 1)) : std::nullopt;
  if (!number || !count || *number < 1 || *number > *count || *count > most)
    throw ParseError("shard", text, 1, expected);
  return {*number, *count};
}

std::optional<SweepResults> run_sweep(const std::vector<SweepCase>& cases,
                                      const std::function<Json(std::size_t)>& compute, const SweepOptions& options) {
  std::vector<std::string> ids;
  for (const SweepCase& one : cases) ids.push_back(case_id(options.version, one.specification));
  std::vector<std::string> sorted = ids;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    throw std::logic_error("run_sweep: need distinct cases");
  const std::string plan = case_id(options.version, std::accumulate(ids.begin(), ids.end(), std::string()));

  const ComputeCase outcome_of = [&](std::size_t i) -> CaseOutcome {
    try {
      return {false, compute(i).dump()};
    } catch (const std::exception& error) {
      return {true, error.what()};
    }
  };
  const int ranks = rank_count();
  const int jobs = options.jobs > 0 ? options.jobs : ranks > 1 ? 1 : all_cores();
  if (own_rank() > 0) {
    try {
      if (sweep_begins(false, plan)) work_for_first_rank(jobs, outcome_of);
    } catch (const std::exception& error) {
      abandon_ranks(error.what());
    }
    return std::nullopt;
  }

  std::optional<Ledger> ledger;
  try {
    ledger.emplace(cases, ids, options);
  } catch (...) {
    static_cast<void>(sweep_begins(false, plan));
    throw;
  }
  static_cast<void>(sweep_begins(true, plan));
  const NextCase next = [&] { return ledger->next(); };
  const FinishCase finish = [&](std::size_t i, const CaseOutcome& outcome) { ledger->finish(i, outcome); };
  const auto own_share = [&] {
    parallel_tasks(ledger->waiting(), jobs, [&](std::size_t) {
      if (const auto i = next()) finish(*i, outcome_of(*i));
    });
  };
  if (ranks == 1) {
    own_share();
  } else {
    const std::jthread own = on_own_thread(own_share);  // joined at the end of the block
    serve_ranks(next, finish);
  }
  return ledger->results();
}

}  // namespace subcert::sweeps
