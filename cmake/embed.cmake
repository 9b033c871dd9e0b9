# Puts the numbered migrations of schema/sql into the program, so that one file is all it needs.
function(planum_embed_sql FOLDER OUTPUT)
  file(GLOB files CONFIGURE_DEPENDS ${FOLDER}/*.sql)
  list(SORT files)
  add_custom_command(
    OUTPUT ${OUTPUT}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${OUTPUT} "-DFILES=${files}" -P ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake
    VERBATIM)
  set(PLANUM_EMBEDDED_SCHEMA ${OUTPUT} PARENT_SCOPE)
endfunction()
