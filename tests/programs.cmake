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
planum_program_test(cli/real_scans cli python3 ${cli}/real_scans.py $<TARGET_FILE:planum> ${PROJECT_SOURCE_DIR}/../shared/data)
planum_program_test(cli/kill_import cli python3 ${cli}/kill_import.py $<TARGET_FILE:planum> 10)
planum_program_test(slow/kill_import_200 slow python3 ${cli}/kill_import.py $<TARGET_FILE:planum> 200)
planum_program_test(cli/scan_trouble cli python3 ${cli}/scan_trouble.py $<TARGET_FILE:planum>)
if(NOT PLANUM_SANITIZE)
  set(programs $<TARGET_FILE:planum>)
  if(TARGET planum-desktop)
    list(APPEND programs $<TARGET_FILE:planum-desktop>)
  endif()
  planum_program_test(architecture/linked_libraries unit
    ${PROJECT_SOURCE_DIR}/tests/support/linked_libraries.sh ${programs})
endif()
planum_program_test(gui/verbs_in_table gui python3 ${PROJECT_SOURCE_DIR}/tests/gui/verbs_in_table.py $<TARGET_FILE:planum>
  ${PROJECT_SOURCE_DIR}/docs/desktop.md)
if(TARGET planum-desktop AND NOT PLANUM_SANITIZE)
  planum_program_test(gui/without_opengl gui ${PROJECT_SOURCE_DIR}/tests/gui/without_opengl.sh $<TARGET_FILE:planum>
    $<TARGET_FILE:planum-desktop>)
  planum_program_test(gui/flight gui ${PROJECT_SOURCE_DIR}/tests/gui/flight.sh $<TARGET_FILE:planum> $<TARGET_FILE:planum-desktop>
    ${PROJECT_SOURCE_DIR}/schema/json)
  # Two that look for a free display at once find the same one.
  set_tests_properties(gui/without_opengl gui/flight PROPERTIES RESOURCE_LOCK display)
endif()
find_program(PLANUM_LUPDATE lupdate HINTS /usr/lib/qt6/bin)
if(PLANUM_LUPDATE)
  planum_program_test(gui/translations gui python3 ${PROJECT_SOURCE_DIR}/tests/gui/translations.py ${PROJECT_SOURCE_DIR} ${PLANUM_LUPDATE})
endif()
