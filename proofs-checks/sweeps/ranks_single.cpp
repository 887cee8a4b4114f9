// The ranks of a sweep in a program that was built without MPI: one.

#include "ranks.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <cstdlib>
#include <iostream>

namespace subcert::sweeps {

int rank_count() {
  if (launched_processes() > 1)
    fail(ErrorKind::usage, "started as one of several processes by an MPI launcher, but built without MPI");
  return 1;
}

int own_rank() { return 0; }

bool sweep_begins(bool ready, const std::string&) { return ready; }

void serve_ranks(const NextCase&, const FinishCase&) {}

void work_for_first_rank(int, const ComputeCase&) {}

void abandon_ranks(const std::string& message) {
  std::cerr << "subcert: " << message << "\n";
  std::exit(70);
}

}  // namespace subcert::sweeps
