# The window's languages: gui/translations/planum_XX.ts, released and put into the program. Without Qt's lrelease
# (Debian: qt6-l10n-tools) the program is built all the same and speaks English.
find_program(PLANUM_LRELEASE lrelease HINTS /usr/lib/qt6/bin ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_BINS})

function(planum_add_translations TARGET)
  if(NOT PLANUM_LRELEASE)
    message(STATUS "lrelease not found (qt6-l10n-tools): ${TARGET} speaks English only")
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/gui/translations/*.ts)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_translations)
  file(MAKE_DIRECTORY ${folder})
  set(released)
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    add_custom_command(OUTPUT ${folder}/${name}.qm
      COMMAND ${PLANUM_LRELEASE} -silent -nounfinished ${source} -qm ${folder}/${name}.qm
      DEPENDS ${source} VERBATIM)
    list(APPEND released ${folder}/${name}.qm)
  endforeach()
  string(MAKE_C_IDENTIFIER ${TARGET}_translations resources)
  qt_add_resources(${TARGET} ${resources} PREFIX /translations BASE ${folder} FILES ${released})
endfunction()
