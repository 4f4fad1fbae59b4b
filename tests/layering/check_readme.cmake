# Fails unless README.md shows, as a line of its own, every command of .ci/run: what CI does is what a reader is told.
#
#   cmake -DSOURCE_DIR=<repository> -P check_readme.cmake
cmake_minimum_required(VERSION 3.25)
file(STRINGS ${SOURCE_DIR}/.ci/run commands REGEX "^[^#]")
list(FILTER commands EXCLUDE REGEX "^(set|cd) ")
if(NOT commands)
  message(FATAL_ERROR ".ci/run has no commands")
endif()
file(STRINGS ${SOURCE_DIR}/README.md lines)
foreach(command IN LISTS commands)
  if(NOT command IN_LIST lines)
    message(FATAL_ERROR "README.md lacks the line of .ci/run: ${command}")
  endif()
endforeach()
