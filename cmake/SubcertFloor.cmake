# subcert_floor(NAME SOURCES ... HEADERS ... DEPENDS ... PRIVATE ...)
# One static library for a floor of the house: alias subcert::NAME, exported, with its public headers installed
# below include/subcert under their path in the source tree.
function(subcert_floor name)
  cmake_parse_arguments(PARSE_ARGV 1 floor "" "" "SOURCES;HEADERS;DEPENDS;PRIVATE")
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

function(subcert_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)  # GCC 12 warns wrongly about joined strings (its bug 105651)
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

# subcert_test(NAME SOURCES ... DEPENDS ...): one Catch2 program, its cases registered one by one.
function(subcert_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test "" "" "SOURCES;DEPENDS")
  add_executable(${name} ${test_SOURCES})
  target_link_libraries(${name} PRIVATE ${test_DEPENDS} Catch2::Catch2WithMain)
  subcert_warnings(${name})
  # What is tested is optimised; the tests themselves are compiled quickly.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  catch_discover_tests(${name} TEST_PREFIX "${name}: " PROPERTIES LABELS quick TIMEOUT 300)
endfunction()
