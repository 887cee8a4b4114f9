# Read by cpack for each kind of package: what is different in them. All have the atlas: it is made, or finished, first.
cmake_policy(VERSION 3.25)
execute_process(COMMAND "${CPACK_SUBCERT_BUILD}/subcert" atlas build "${CPACK_SUBCERT_SOURCE}/docs/examples/atlas.toml"
  --atlas "${CPACK_SUBCERT_BUILD}/atlas.sqlite" RESULT_VARIABLE result)
if(NOT result MATCHES "^[02]$")  # 2: a mask without an answer is left out, and named
  message(FATAL_ERROR "the atlas is not made: ${result}")
endif()
if(CPACK_GENERATOR STREQUAL "DEB")
  set(CPACK_PRE_BUILD_SCRIPTS "${CPACK_SUBCERT_SOURCE}/cmake/debian_files.cmake")
else()
  set(CPACK_COMPONENTS_ALL program libraries)
  set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
  set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
  set(CPACK_PACKAGING_INSTALL_PREFIX "")
  set(CPACK_ARCHIVE_FILE_NAME "${CPACK_PACKAGE_FILE_NAME}")
endif()
