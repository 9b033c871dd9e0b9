# Every header compiles alone. One with a source file of its own proves it there, because that file includes it
# first (unit/architecture holds that); for the others there is one tiny file each, compiled, never linked.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
  ${PROJECT_SOURCE_DIR}/core/*.hpp ${PROJECT_SOURCE_DIR}/strat/*.hpp ${PROJECT_SOURCE_DIR}/scans/*.hpp
  ${PROJECT_SOURCE_DIR}/app/*.hpp ${PROJECT_SOURCE_DIR}/paint/*.hpp ${PROJECT_SOURCE_DIR}/cli/*.hpp)
if(PLANUM_GUI)
  file(GLOB_RECURSE gui_headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/gui/*.hpp)
  list(APPEND headers ${gui_headers})
endif()
set(header_sources "")
foreach(header IN LISTS headers)
  string(REGEX REPLACE "\\.hpp$" ".cpp" own_source ${header})
  if(EXISTS ${PROJECT_SOURCE_DIR}/${own_source})
    continue()
  endif()
  string(MAKE_C_IDENTIFIER ${header} id)
  set(source ${PROJECT_BINARY_DIR}/headers/${id}.cpp)
  if(NOT EXISTS ${source})
    file(WRITE ${source} "#include \"${header}\"\n")
  endif()
  list(APPEND header_sources ${source})
endforeach()
add_library(planum_headers_alone OBJECT ${header_sources})
target_link_libraries(planum_headers_alone PRIVATE planum_flags planum_third_fmt planum_third_eigen
  planum_third_qtgui planum_third_json)
if(PLANUM_GUI)
  target_link_libraries(planum_headers_alone PRIVATE planum_third_qtwidgets)
endif()
# Only whether they compile is asked, so do not spend time on code.
target_compile_options(planum_headers_alone PRIVATE -O0)
