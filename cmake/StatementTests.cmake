# subcert_statement_tests(PROGRAM): each statement of the registry as a test of its own, with the label `statements`.
# The ids come from
# the program once it is built.
set(SUBCERT_WRITE_STATEMENT_TESTS "${CMAKE_CURRENT_LIST_DIR}/write_statement_tests.cmake")

function(subcert_statement_tests program)
  set(tests "${CMAKE_CURRENT_BINARY_DIR}/statement_tests.cmake")
  add_custom_command(TARGET ${program} POST_BUILD
    COMMAND "${CMAKE_COMMAND}" -D "PROGRAM=$<TARGET_FILE:${program}>" -D "OUTPUT=${tests}"
      -P "${SUBCERT_WRITE_STATEMENT_TESTS}" VERBATIM)
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${tests}")
endfunction()
