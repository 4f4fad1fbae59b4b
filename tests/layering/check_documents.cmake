# Fails unless README.md shows every command of .ci/run as a line of its own (what CI does is what a reader is told),
# and every relative link in README.md and docs/ leads to a file of the repository.
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

file(GLOB documents RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/README.md ${SOURCE_DIR}/docs/*.md)
foreach(document IN LISTS documents)
  file(READ ${SOURCE_DIR}/${document} text)
  # square brackets and semicolons have a meaning in CMake's lists
  string(REPLACE "](" "\t" text "${text}")
  string(REGEX REPLACE "[][;]" "" text "${text}")
  string(REGEX MATCHALL "\t[^)#: ]+" links "${text}")
  get_filename_component(folder ${SOURCE_DIR}/${document} DIRECTORY)
  foreach(link IN LISTS links)
    string(SUBSTRING "${link}" 1 -1 target)
    if(NOT target MATCHES "^(https?|mailto)$" AND NOT EXISTS ${folder}/${target})
      list(APPEND wrong "${document}: no file ${target}")
    endif()
  endforeach()
endforeach()

if(wrong)
  list(JOIN wrong "\n" wrong)
  message("${wrong}")
  message(FATAL_ERROR "The documents are out of step")
endif()
