# What users of an installed subcert find it by: CMake's package files, a pkg-config file; and the Debian packages.
include(CMakePackageConfigHelpers)
configure_package_config_file(cmake/subcertConfig.cmake.in "${PROJECT_BINARY_DIR}/subcertConfig.cmake"
  INSTALL_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/subcert")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/subcertConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/subcertConfig.cmake" "${PROJECT_BINARY_DIR}/subcertConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindFLINT.cmake" DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/subcert")
install(EXPORT subcertTargets NAMESPACE subcert:: DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/subcert")

# A floor is linked before those below it, and they were made from below. The prefix is found from the file itself, so
# that an installed tree can be moved.
get_property(floors GLOBAL PROPERTY SUBCERT_FLOORS)
list(REVERSE floors)
list(TRANSFORM floors PREPEND -l)
list(JOIN floors " " floors)
set(flint -lflint)
if(ARB_LIBRARY)
  get_filename_component(arb "${ARB_LIBRARY}" NAME_WE)
  string(REGEX REPLACE "^lib" "-l" arb "${arb}")
  set(flint "${arb} -lflint")
endif()
file(RELATIVE_PATH prefix_from_pc "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
string(REGEX REPLACE "/$" "" prefix_from_pc "${prefix_from_pc}")
configure_file(cmake/subcert.pc.in "${PROJECT_BINARY_DIR}/subcert.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/subcert.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

if(NOT PROJECT_IS_TOP_LEVEL OR NOT SUBCERT_BUILD_CLI)
  return()
endif()

# What is installed may bring its libraries: those of an archive in lib/subcert, those of a wheel in lib beside the
# module. A DT_RPATH, as that holds for the libraries of libraries, too.
foreach(target IN ITEMS subcert subcert-check subcert_python)
  if(TARGET ${target})
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/subcert:$ORIGIN/lib")
    target_link_options(${target} PRIVATE LINKER:--disable-new-dtags)
  endif()
endforeach()
function(subcert_bring_libraries kind target component folder)
  install(CODE "set(KIND ${kind})\nset(FILE \"$<TARGET_FILE:${target}>\")\nset(FOLDER ${folder})"
    COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(SCRIPT "${PROJECT_SOURCE_DIR}/cmake/bring_libraries.cmake" COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()
subcert_bring_libraries(EXECUTABLES subcert libraries lib/subcert)
if(TARGET subcert_python)
  subcert_bring_libraries(MODULES subcert_python python subcert/lib)
  subcert_bring_libraries(EXECUTABLES subcert python subcert/lib)
endif()
install(FILES LICENSE CHANGELOG.md DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT libraries EXCLUDE_FROM_ALL)
# What README names stands beside it, so that its links and commands hold in an archive.
install(FILES README.md LICENSE CHANGELOG.md CITATION.cff CONTRIBUTING.md SECURITY.md DESTINATION .
  COMPONENT libraries EXCLUDE_FROM_ALL)
install(DIRECTORY docs DESTINATION . COMPONENT libraries EXCLUDE_FROM_ALL
  FILES_MATCHING REGEX "\\.(md|png|svg|csv|toml|yml|json)$" PATTERN site EXCLUDE)
foreach(part .github/workflows cmake/test/consumer proofs-checks/certificates/SPEC.md proofs-checks/checker-js
    python/notebooks)
  get_filename_component(beside ${part} DIRECTORY)
  if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/${part}")
    install(DIRECTORY ${part} DESTINATION ${beside} COMPONENT libraries EXCLUDE_FROM_ALL PATTERN test EXCLUDE)
  else()
    install(FILES ${part} DESTINATION ${beside} COMPONENT libraries EXCLUDE_FROM_ALL)
  endif()
endforeach()

# cpack -G TGZ: an archive that runs where it is unpacked. cpack -G DEB: subcert, with the program, the checker, pages
# and completions; libsubcert-dev, with the libraries.
set(SUBCERT_PACKAGE_CONTACT "The subcert developers" CACHE STRING
  "Who maintains the Debian packages: name and <address>")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "${SUBCERT_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_SOURCE_DIR}/cmake/cpack_generator.cmake")
set(CPACK_PACKAGE_FILE_NAME "subcert-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_SUBCERT_SOURCE "${PROJECT_SOURCE_DIR}")
set(CPACK_SUBCERT_BUILD "${PROJECT_BINARY_DIR}")
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME subcert)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "certified analysis of subdivision schemes
Given a subdivision scheme, subcert finds its exact mask, proofs of convergence
and smoothness, its Hoelder exponent with a certificate, and exact values of
the limit function and of the variance curve. Results are rational numbers or
enclosures rounded outward.

The certificates are checked by subcert-check, a small program that shares no
code with the one that makes them. Published tables and statements about least
squares and l1 regression schemes are recomputed with a verdict each.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsubcert-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
string(JOIN ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libboost-dev (>= 1.74)" "libeigen3-dev (>= 3.4)" libflint-dev
  libfmt-dev libgmp-dev libmpfr-dev)
if(ARB_LIBRARY)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libflint-arb-dev")
endif()
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "certified analysis of subdivision schemes (development files)
Static libraries and headers for programs in C++20 that use what subcert knows:
symbols and masks, convergence, regularity, limit functions, variance, schemes
by name, refinement and smoothing of data.

CMake finds them by find_package(subcert), other tools by pkg-config.")
include(CPack)
