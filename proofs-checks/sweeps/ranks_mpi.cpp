// The ranks of a sweep with MPI.
//
// Each thread of a worker is a client of rank 0: it sends a request, which carries the outcome of its last case, and
// receives a case or the word that there is none. A worker whose threads have all ended says so once.

#include "ranks.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <mpi.h>

#include <chrono>
#include <iostream>
#include <stdexcept>
#include <thread>

namespace subcert::sweeps {
namespace {

constexpr int leave_tag = 1, request_tag = 2, first_answer_tag = 3;
constexpr long no_case = -1;

/// MPI from the first question for ranks to the end of the process; not begun at all without a launcher.
class Session {
 public:
  static const Session& get() {
    static const Session session;
    return session;
  }

  int count = 1;
  int own = 0;
  bool threads_may_send = false;

 private:
  Session() {
    if (!is_launched()) return;
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &provided);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    MPI_Comm_rank(MPI_COMM_WORLD, &own);
    threads_may_send = provided == MPI_THREAD_MULTIPLE;
    begun_ = true;
  }
  ~Session() {
    if (begun_) MPI_Finalize();
  }

  bool begun_ = false;
};

/// The outcome of a case, and which thread asks for the next one.
struct Request {
  long thread = 0;
  long finished_case = no_case;
  CaseOutcome outcome;

  std::string packed() const {
    const long head[3] = {thread, finished_case, outcome.failed ? 1L : 0L};
    return std::string(reinterpret_cast<const char*>(head), sizeof head) + outcome.text;
  }

  static Request unpacked(const std::string& text) {
    long head[3];
    if (text.size() < sizeof head) throw std::logic_error("a request between ranks is too short");
    std::copy_n(text.data(), sizeof head, reinterpret_cast<char*>(head));
    return {head[0], head[1], {head[2] != 0, text.substr(sizeof head)}};
  }
};

void work(int thread, const ComputeCase& compute) {
  Request request{thread, no_case, {}};
  for (;;) {
    const std::string text = request.packed();
    MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, request_tag, MPI_COMM_WORLD);
    MPI_Recv(&request.finished_case, 1, MPI_LONG, 0, first_answer_tag + thread, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (request.finished_case == no_case) return;
    request.outcome = compute(static_cast<std::size_t>(request.finished_case));
  }
}

}  // namespace

int rank_count() {
  const Session& session = Session::get();
  if (launched_processes() > 0 && launched_processes() != session.count)
    fail(ErrorKind::usage,
         "the launcher started {} processes, but MPI knows {}: mpirun belongs to another MPI than this program",
         launched_processes(), session.count);
  return session.count;
}

int own_rank() { return Session::get().own; }

bool sweep_begins(bool ready, const std::string& plan) {
  if (rank_count() == 1) return ready;
  std::string first_plan = plan;
  unsigned long head[2] = {ready ? 1UL : 0UL, plan.size()};
  MPI_Bcast(head, 2, MPI_UNSIGNED_LONG, 0, MPI_COMM_WORLD);
  first_plan.resize(head[1]);
  MPI_Bcast(first_plan.data(), static_cast<int>(head[1]), MPI_CHAR, 0, MPI_COMM_WORLD);
  if (head[0] != 0 && first_plan != plan)
    fail(ErrorKind::usage, "rank {} has other cases than rank 0: all ranks need the same program and arguments",
         own_rank());
  return head[0] != 0;
}

void serve_ranks(const NextCase& next, const FinishCase& finish) {
  constexpr auto pause = std::chrono::microseconds(300);
  for (int working = rank_count() - 1; working > 0;) {
    int arrived = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &arrived, &status);
    if (!arrived) {
      std::this_thread::sleep_for(pause);
      continue;
    }
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    std::string text(static_cast<std::size_t>(size), '\0');
    MPI_Recv(text.data(), size, MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (status.MPI_TAG == leave_tag) {
      --working;
      continue;
    }
    const Request request = Request::unpacked(text);
    const std::optional<std::size_t> chosen = next();
    const long answer = chosen ? static_cast<long>(*chosen) : no_case;
    MPI_Send(&answer, 1, MPI_LONG, status.MPI_SOURCE, first_answer_tag + static_cast<int>(request.thread),
             MPI_COMM_WORLD);
    if (request.finished_case != no_case) finish(static_cast<std::size_t>(request.finished_case), request.outcome);
  }
}

void work_for_first_rank(int jobs, const ComputeCase& compute) {
  if (jobs == 1 || !Session::get().threads_may_send)
    work(0, compute);
  else
    parallel_for_each(static_cast<std::size_t>(jobs), jobs,
                      [&](std::size_t thread) { work(static_cast<int>(thread), compute); });
  MPI_Send("", 0, MPI_CHAR, 0, leave_tag, MPI_COMM_WORLD);
}

void abandon_ranks(const std::string& message) {
  std::cerr << "subcert: " << message << std::endl;
  MPI_Abort(MPI_COMM_WORLD, 70);
  std::abort();
}

}  // namespace subcert::sweeps
