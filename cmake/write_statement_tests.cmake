# Writes OUTPUT with one test for each line that `PROGRAM statements list --ids` prints.
execute_process(COMMAND "${PROGRAM}" statements list --ids OUTPUT_VARIABLE ids RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} statements list --ids: exit code ${code}")
endif()
string(STRIP "${ids}" ids)
string(REPLACE "\n" ";" ids "${ids}")
set(content "")
foreach(id IN LISTS ids)
  string(APPEND content "add_test(\"statement: ${id}\" \"${PROGRAM}\" statements check ${id})\n"
    "set_tests_properties(\"statement: ${id}\" PROPERTIES LABELS \"quick;statements\" TIMEOUT 300)\n")
endforeach()
file(WRITE "${OUTPUT}" "${content}")
