# subcert_floor(NAME [QUICK] SOURCES ... HEADERS ... DEPENDS ... PRIVATE ...)
# One static library for a floor of the house: alias subcert::NAME, exported, with its public headers installed
# below include/subcert under their path in the source tree. QUICK: compiled quickly, for a floor that only calls others.
function(subcert_floor name)
  cmake_parse_arguments(PARSE_ARGV 1 floor "QUICK" "" "SOURCES;HEADERS;DEPENDS;PRIVATE")
  add_library(subcert_${name} STATIC ${floor_SOURCES} ${floor_HEADERS})
  add_library(subcert::${name} ALIAS subcert_${name})
  set_target_properties(subcert_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(subcert_${name} PUBLIC cxx_std_20)
  target_include_directories(subcert_${name} SYSTEM PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_link_libraries(subcert_${name} PUBLIC ${floor_DEPENDS})
  foreach(library IN LISTS floor_PRIVATE)
    target_link_libraries(subcert_${name} PRIVATE ${library})
  endforeach()
  subcert_warnings(subcert_${name})
  if(floor_QUICK)
    target_compile_options(subcert_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  else()
    subcert_precompiled(subcert_${name} floors)
  endif()
  file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
  foreach(header IN LISTS floor_HEADERS)
    get_filename_component(inside "${header}" DIRECTORY)
    install(FILES "${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/subcert/${folder}/${inside}")
  endforeach()
  install(TARGETS subcert_${name} EXPORT subcertTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  if(SUBCERT_BUILD_TESTS)
    subcert_headers_compile_alone(${name} ${floor_HEADERS})
  endif()
endfunction()

# subcert_precompiled(TARGET KIND): what almost every source reads is parsed once for all targets of a kind, which have
# the same options.
#   floors    optimised, position independent
#   programs  tests, examples, reports: compiled quickly
function(subcert_precompiled target kind)
  if(kind STREQUAL "programs")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(NOT TARGET subcert_precompiled_${kind})
    set(headers "${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp")
    if(kind STREQUAL "programs" AND SUBCERT_BUILD_TESTS)
      list(APPEND headers "${PROJECT_SOURCE_DIR}/cmake/catch.hpp")
    endif()
    set(source "${PROJECT_BINARY_DIR}/precompiled_${kind}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "")
    add_library(subcert_precompiled_${kind} OBJECT "${source}")
    target_compile_features(subcert_precompiled_${kind} PRIVATE cxx_std_20)
    target_link_libraries(subcert_precompiled_${kind} PRIVATE Boost::headers fmt::fmt)
    get_target_property(options ${target} COMPILE_OPTIONS)
    get_target_property(independent ${target} POSITION_INDEPENDENT_CODE)
    set_target_properties(subcert_precompiled_${kind} PROPERTIES COMPILE_OPTIONS "${options}"
      POSITION_INDEPENDENT_CODE "${independent}")
    target_precompile_headers(subcert_precompiled_${kind} PRIVATE ${headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM subcert_precompiled_${kind})
endfunction()

# subcert_joined(TARGET COUNT): compiles COUNT sources at a time, so that the headers' functions are compiled less often.
# Names in their unnamed namespaces have to differ.
function(subcert_joined target count)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${count})
endfunction()

function(subcert_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    # GCC 12 warns wrongly about joined strings (its bug 105651), with precompiled headers in three ways.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>)
endfunction()

# Each public header compiles as a source of its own, so that it needs no other include before it: a long test a floor.
function(subcert_headers_compile_alone name)
  set(sources)
  foreach(header IN LISTS ARGN)
    string(REPLACE "/" "_" flat "${header}")
    set(source "${CMAKE_CURRENT_BINARY_DIR}/alone/${flat}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "#include \"${CMAKE_CURRENT_SOURCE_DIR}/${header}\"\n")
    list(APPEND sources "${source}")
  endforeach()
  add_library(subcert_${name}_headers_alone OBJECT EXCLUDE_FROM_ALL ${sources})
  target_link_libraries(subcert_${name}_headers_alone PRIVATE subcert::${name})
  add_test(NAME "headers alone: ${name}"
    COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}" --target subcert_${name}_headers_alone)
  set_tests_properties("headers alone: ${name}" PROPERTIES LABELS long TIMEOUT 900 RUN_SERIAL ON)
endfunction()

# subcert_test(NAME [LONG] SOURCES ... DEPENDS ...): one Catch2 program, its cases registered one by one. LONG: it has cases
# with the tag [long], which get the label `long`.
function(subcert_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test "LONG" "" "SOURCES;DEPENDS")
  add_executable(${name} ${test_SOURCES})
  target_link_libraries(${name} PRIVATE ${test_DEPENDS} Boost::headers Catch2::Catch2WithMain)
  subcert_warnings(${name})
  subcert_precompiled(${name} programs)
  catch_discover_tests(${name} TEST_SPEC "~[long]" TEST_PREFIX "${name}: " PROPERTIES LABELS quick TIMEOUT 300)
  if(test_LONG)
    catch_discover_tests(${name} TEST_SPEC "[long]" TEST_PREFIX "${name}: " PROPERTIES LABELS long TIMEOUT 900)
  endif()
endfunction()
