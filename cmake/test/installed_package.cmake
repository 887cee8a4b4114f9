cmake_minimum_required(VERSION 3.25)
# BUILD: a finished build tree; CONSUMER: a project to build against the installed package; WORK: a folder to use;
# PKG_CONFIG: that program, or what is false. Also: what the program needs beside itself is installed.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
run("${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${WORK}/build" -G Ninja "-DCMAKE_PREFIX_PATH=${WORK}/prefix"
  "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_FLAGS=${FLAGS}")
run("${CMAKE_COMMAND}" --build "${WORK}/build")
function(try program)
  run("${program}")
  if(NOT output MATCHES "\\[1,3,3,1\\]/4@-2 is C\\^1, phi\\(0\\) = 1/2")
    message(FATAL_ERROR "${program} printed: ${output}")
  endif()
endfunction()
try("${WORK}/build/consumer")

if(PKG_CONFIG)
  file(GLOB_RECURSE pc "${WORK}/prefix/subcert.pc")
  run("${PKG_CONFIG}" --cflags --libs "${pc}")
  separate_arguments(flags UNIX_COMMAND "${FLAGS} ${output}")
  run("${CXX}" -std=c++20 "${CONSUMER}/consumer.cpp" ${flags} -o "${WORK}/by_pkg_config")
  try("${WORK}/by_pkg_config")
endif()

foreach(file IN ITEMS man/man1/subcert.1 man/man1/subcert-range.1 bash-completion/completions/subcert
    zsh/site-functions/_subcert fish/vendor_completions.d/subcert.fish)
  if(NOT EXISTS "${WORK}/prefix/share/${file}")
    message(FATAL_ERROR "share/${file} is not installed")
  endif()
endforeach()
