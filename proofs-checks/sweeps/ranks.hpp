#pragma once
/// The processes that work on one sweep: this one alone, or those that mpirun started. Rank 0 hands out cases; the
/// other ranks ask for one whenever they are free. Built with MPI or without (ranks_mpi.cpp, ranks_single.cpp).

#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>

namespace subcert::sweeps {

/// What became of a case: the text of its JSON value or, where it failed, the message.
struct CaseOutcome {
  bool failed = false;
  std::string text;
};

using NextCase = std::function<std::optional<std::size_t>()>;
using FinishCase = std::function<void(std::size_t, const CaseOutcome&)>;
using ComputeCase = std::function<CaseOutcome(std::size_t)>;

/// 1 without mpirun. Errors: throws a usage error where a launcher started several processes of a program that
/// was built without MPI, or with another MPI.
int rank_count();
/// From 0 to rank_count() - 1.
int own_rank();

/// Called on all ranks: rank 0 says whether the sweep begins, and `plan` names its cases; all get rank 0's word.
/// Errors: throws a usage error where this rank has another plan than rank 0.
bool sweep_begins(bool ready, const std::string& plan);

/// On rank 0, from the thread that called sweep_begins: gives the other ranks what `next` gives, and what they made of
/// it to `finish`, until `next` has nothing left and all of them have ended. `next` and `finish` must not throw.
void serve_ranks(const NextCase& next, const FinishCase& finish);

/// On the other ranks: computes cases for rank 0 on `jobs` threads until there are none left.
void work_for_first_rank(int jobs, const ComputeCase& compute);

/// Ends all ranks at once, after an error that the others cannot know of.
[[noreturn]] void abandon_ranks(const std::string& message);

/// The number of processes of the job as Open MPI's and MPICH's mpirun and Slurm's srun with PMI state it; 0 where no
/// launcher states one.
inline int launched_processes() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* text = std::getenv(name)) return std::atoi(text);
  return 0;
}

/// Whether an MPI launcher started this process, also one that states no number (srun with PMIx).
inline bool is_launched() { return launched_processes() > 0 || std::getenv("PMIX_RANK") != nullptr; }

}  // namespace subcert::sweeps
