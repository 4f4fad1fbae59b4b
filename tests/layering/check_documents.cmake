# Fails unless README.md shows every command of .ci/run as a line of its own: what CI does is what a reader is told.
#
#   cmake -DSOURCE_DIR=<repository> -P check_documents.cmake
cmake_minimum_required(VERSION 3.25)
set(wrong "")

file(STRINGS ${SOURCE_DIR}/.ci/run commands REGEX "^[^#]")
list(FILTER commands EXCLUDE REGEX "^(set|cd) ")
if(NOT commands)
  message(FATAL_ERROR ".ci/run has no commands")
endif()
file(STRINGS ${SOURCE_DIR}/README.md lines)
foreach(command IN LISTS commands)
  if(NOT command IN_LIST lines)
    list(APPEND wrong "README.md lacks the line of .ci/run: ${command}")
  endif()
endforeach()

if(wrong)
  list(JOIN wrong "\n" wrong)
  message("${wrong}")
  message(FATAL_ERROR "The documents are out of step")
endif()
