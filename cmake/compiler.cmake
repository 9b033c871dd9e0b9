# Flags every target of ours gets through planum_flags. No -ffast-math: heights and areas must be
# the same on every machine.
add_library(planum_flags INTERFACE)
target_include_directories(planum_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_definitions(planum_flags INTERFACE
  EIGEN_DONT_PARALLELIZE
  PLANUM_VERSION="${PROJECT_VERSION}")
target_compile_options(planum_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wnon-virtual-dtor
  -Woverloaded-virtual -Wcast-align -Wold-style-cast -Wimplicit-fallthrough)
if(PLANUM_WERROR)
  target_compile_options(planum_flags INTERFACE -Werror)
endif()
if(PLANUM_SANITIZE)
  add_compile_options(-fsanitize=${PLANUM_SANITIZE} -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${PLANUM_SANITIZE})
endif()
if(PLANUM_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

find_program(PLANUM_LINKER NAMES mold ld.lld-16 ld.lld)
if(PLANUM_LINKER MATCHES "mold")
  add_link_options(-fuse-ld=mold)
endif()
