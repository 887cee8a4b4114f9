# For tests under MPIRUN with RANKS ranks in the folder WORK: ${mpirun}, and run(OUT CODE COMMAND...), which expects the
# exit code and sets OUT and ${errors}.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
set(ENV{ASAN_OPTIONS} "detect_leaks=0")  # leaks inside MPI are not ours
set(mpirun "${MPIRUN}" -np ${RANKS})
execute_process(COMMAND "${MPIRUN}" --version OUTPUT_VARIABLE version ERROR_VARIABLE version)
if(version MATCHES "Open MPI|OpenRTE|open-mpi")
  list(APPEND mpirun --oversubscribe --allow-run-as-root)
endif()

function(run out_variable expected)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE err RESULT_VARIABLE code TIMEOUT 60)
  if(NOT code EQUAL expected)
    message(FATAL_ERROR "${ARGN}: exit ${code}, expected ${expected}\n${out}\n${err}")
  endif()
  set(${out_variable} "${out}" PARENT_SCOPE)
  set(errors "${err}" PARENT_SCOPE)
endfunction()

