#pragma once
/// What an MPI launcher tells its processes in their environment.

#include <cstdlib>
#include <initializer_list>

namespace subcert::sweeps {

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
