# Fails when clang-format would change a source file; prints SKIPPED where the project's release of it is missing, for
# another release lays the same code out differently.
#
#   cmake -DSOURCE_DIR=<repository> -P check_format.cmake
cmake_minimum_required(VERSION 3.25)
set(release 14)

find_program(clang_format NAMES clang-format-${release} clang-format)
if(clang_format)
  execute_process(COMMAND ${clang_format} --version OUTPUT_VARIABLE version)
endif()
if(NOT clang_format OR NOT version MATCHES "version ${release}\\.")
  message("SKIPPED: clang-format ${release} is not installed")
  return()
endif()

set(files "")
foreach(folder libdrt apps tests benchmarks)
  file(GLOB_RECURSE found ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.cpp)
  list(APPEND files ${found})
endforeach()
execute_process(COMMAND ${clang_format} --dry-run -Werror --style=file ${files} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "Run: ${clang_format} -i <the files above>")
endif()
