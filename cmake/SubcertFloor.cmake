# How the targets of the house are made.
option(SUBCERT_JOIN "Compile sources of one folder together where their target says so" ON)
set(SUBCERT_TEST_SECONDS 300 CACHE STRING "The longest time of a quick test")

# subcert_floor(NAME [QUICK | PRINTER] SOURCES ... PRINTER_SOURCES ... HEADERS ... DEPENDS ... PRIVATE ...)
# One static library for a floor of the house: alias subcert::NAME, exported. HEADERS are its public ones: they are
# installed below include/subcert under their path in the source tree, and each compiles alone (a long test); headers
# that no user needs are listed nowhere. QUICK and PRINTER: compiled as these kinds of subcert_precompiled(), as are
# PRINTER_SOURCES, which call the others.
function(subcert_floor name)
  cmake_parse_arguments(PARSE_ARGV 1 floor "QUICK;PRINTER" "" "SOURCES;PRINTER_SOURCES;HEADERS;DEPENDS;PRIVATE")
  set(target subcert_${name})
  add_library(${target} STATIC ${floor_SOURCES})
  add_library(subcert::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ${SUBCERT_BUILD_TESTS})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${floor_DEPENDS} PRIVATE ${floor_PRIVATE})
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${SUBCERT_INCLUDE}>")
  foreach(header IN LISTS floor_HEADERS)
    cmake_path(ABSOLUTE_PATH header NORMALIZE)
    cmake_path(RELATIVE_PATH header BASE_DIRECTORY "${PROJECT_SOURCE_DIR}")
    list(APPEND headers "${SUBCERT_INCLUDE}/subcert/${header}")
  endforeach()
  set_property(GLOBAL APPEND PROPERTY SUBCERT_PUBLIC_HEADERS ${headers})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS "${SUBCERT_INCLUDE}" FILES ${headers})
  install(TARGETS ${target} EXPORT subcertTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
  set_property(GLOBAL APPEND PROPERTY SUBCERT_FLOORS ${target})
  subcert_warnings(${target})
  set(kind floors)
  if(floor_PRINTER)
    set(kind printers)
  elseif(floor_QUICK)
    set(kind quick)
  endif()
  subcert_precompiled(${target} ${kind})
  if(floor_PRINTER_SOURCES)
    set(printer ${target}_printer)
    add_library(${printer} OBJECT ${floor_PRINTER_SOURCES})
    target_compile_features(${printer} PRIVATE cxx_std_20)
    target_link_libraries(${printer} PRIVATE ${floor_DEPENDS} ${floor_PRIVATE})
    target_include_directories(${printer} PRIVATE "${SUBCERT_INCLUDE}")
    subcert_warnings(${printer})
    subcert_precompiled(${printer} printers)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${printer}>)
  endif()
endfunction()

# subcert_precompiled(TARGET KIND): what almost every source reads is parsed once for all targets of a kind, which have
# the same options.
#   floors    optimised (-O2)
#   quick     compiled in three quarters of that time (-O1): floors that compute little themselves
#   printers  in half of it (-Og): what only calls others, reports, commands
#   tests     as quick, with Catch2
function(subcert_precompiled target kind)
  # GCC collects its garbage seldom: a tenth of the time for 150 MB more.
  target_compile_options(${target} PRIVATE -fPIC $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=400000>)
  set(floors -O2)
  set(quick -O1)
  set(printers -Og)
  set(tests -O1)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${${kind}}>)
  set(common subcert_precompiled_${kind})
  if(NOT TARGET ${common})
    set(headers "${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp")
    if(kind STREQUAL "tests")
      list(APPEND headers "${PROJECT_SOURCE_DIR}/cmake/catch.hpp")
    elseif(kind STREQUAL "printers" AND TARGET nlohmann_json::nlohmann_json)
      list(APPEND headers <nlohmann/json.hpp>)
    endif()
    set(source "${PROJECT_BINARY_DIR}/precompiled_${kind}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "")
    add_library(${common} OBJECT "${source}")
    target_compile_features(${common} PRIVATE cxx_std_20)
    target_include_directories(${common} PRIVATE "${SUBCERT_INCLUDE}")
    target_link_libraries(${common} PRIVATE fmt::fmt)
    get_target_property(options ${target} COMPILE_OPTIONS)
    set_target_properties(${common} PROPERTIES COMPILE_OPTIONS "${options}")
    target_precompile_headers(${common} PRIVATE ${headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${common})
endfunction()

# subcert_joined(TARGET COUNT): compiles COUNT sources at a time, so that the headers' functions are compiled less
# often.
# Names in their unnamed namespaces have to differ; that they hide each other is no fault, and GCC 12 sees numbers there
# that are not set and are: the preset `dev` warns of both, where sources are compiled one by one.
function(subcert_joined target count)
  if(TARGET ${target}_printer)
    subcert_joined(${target}_printer ${count})
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SUBCERT_JOIN} UNITY_BUILD_BATCH_SIZE ${count})
  if(SUBCERT_JOIN)
    target_compile_options(${target} PRIVATE -Wno-shadow
      $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;-Wno-maybe-uninitialized>)
  endif()
endfunction()

function(subcert_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    # GCC 12 warns wrongly about joined strings (its bug 105651), with precompiled headers in three ways.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>)
endfunction()

# subcert_test(NAME [LONG] SOURCES ... DEPENDS ...): one Catch2 program, its cases registered one by one. LONG: it has
# cases with the tag [long], which get the label `long`.
function(subcert_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test "LONG" "" "SOURCES;DEPENDS")
  add_executable(${name} ${test_SOURCES})
  target_link_libraries(${name} PRIVATE ${test_DEPENDS} fmt::fmt Catch2::Catch2WithMain)
  subcert_warnings(${name})
  subcert_precompiled(${name} tests)
  subcert_joined(${name} 8)
  set(none_fails)  # a name that no case has, as one that a semicolon cuts: an error of later versions by themselves
  if(Catch2_VERSION VERSION_LESS 3)
    set(none_fails EXTRA_ARGS --warn NoTests)
  endif()
  catch_discover_tests(${name} TEST_SPEC "~[long]" TEST_PREFIX "${name}: " ${none_fails}
    PROPERTIES LABELS quick TIMEOUT ${SUBCERT_TEST_SECONDS})
  if(test_LONG)
    catch_discover_tests(${name} TEST_SPEC "[long]" TEST_PREFIX "${name}: " ${none_fails}
      PROPERTIES LABELS long TIMEOUT 900)
  endif()
endfunction()
