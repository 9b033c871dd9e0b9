# Tests that run the built programs from outside.
function(planum_program_test NAME LABEL)
  add_test(NAME ${NAME} COMMAND ${ARGN})
  set_tests_properties(${NAME} PROPERTIES LABELS ${LABEL} TIMEOUT 900 ENVIRONMENT "QT_QPA_PLATFORM=offscreen")
endfunction()

set(cli ${PROJECT_SOURCE_DIR}/tests/cli)
planum_program_test(cli/cases cli ${cli}/run_cases.sh $<TARGET_FILE:planum>)
planum_program_test(cli/json_schemas cli ${cli}/json_schemas.sh $<TARGET_FILE:planum>)
planum_program_test(cli/report_schema cli ${cli}/report_schema.sh $<TARGET_FILE:planum>)
planum_program_test(cli/real_sets cli python3 ${cli}/real_sets.py $<TARGET_FILE:planum> ${PROJECT_SOURCE_DIR}/../shared/data)
planum_program_test(cli/kill_import cli python3 ${cli}/kill_import.py $<TARGET_FILE:planum> 10)
planum_program_test(slow/kill_import_200 slow python3 ${cli}/kill_import.py $<TARGET_FILE:planum> 200)
if(NOT PLANUM_SANITIZE)
  planum_program_test(architecture/linked_libraries unit
    ${PROJECT_SOURCE_DIR}/tests/support/linked_libraries.sh $<TARGET_FILE:planum>)
endif()
