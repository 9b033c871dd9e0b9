# Tests that run the built programs from outside.
add_test(NAME cli/cases COMMAND ${PROJECT_SOURCE_DIR}/tests/cli/run_cases.sh $<TARGET_FILE:planum>)
set_tests_properties(cli/cases PROPERTIES LABELS cli TIMEOUT 600)
add_test(NAME architecture/linked_libraries
  COMMAND ${PROJECT_SOURCE_DIR}/tests/support/linked_libraries.sh $<TARGET_FILE:planum>)
set_tests_properties(architecture/linked_libraries PROPERTIES LABELS unit)
