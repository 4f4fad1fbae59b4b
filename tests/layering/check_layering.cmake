# Compares the #include lines of the sources with what the rooms declared (drt_add_room).
#
#   cmake -DSOURCE_DIR=<repository> -DRECORDS=<layering.txt> -DHEADERS=<headers.txt> -P check_layering.cmake
#
# Every violation is printed as file:line: message; any makes the script fail. The records are lines such as
#   room scene floor=1 depends=base libraries=fmt::fmt
#   folder apps rooms=base,scene
# Rules:
#  - a room includes only itself and the rooms it names under DEPENDS; what those depend on does not count;
#  - DEPENDS never names a room declared later (so there is no cycle) nor one of a higher floor;
#  - in rooms "..." is for drt's headers, by their full path, and <...> for all others;
#  - <...> in a room's header is the standard library's or allowed by name; in its sources, of a library it declared;
#  - programs and tests include only rooms that they link.
cmake_minimum_required(VERSION 3.25)

set(violations "")
macro(violation text)
  list(APPEND violations "${text}")
endmacro()

# ---- what was declared
file(STRINGS ${RECORDS} records)
set(rooms "")
set(folders "")
foreach(record IN LISTS records)
  if(record MATCHES "^room ([^ ]+) floor=([^ ]*) depends=([^ ]*) libraries=([^ ]*)$")
    set(room ${CMAKE_MATCH_1})
    set(floor_${room} ${CMAKE_MATCH_2})
    string(REPLACE "," ";" depends_${room} "${CMAKE_MATCH_3}")
    string(REPLACE "," ";" libraries_${room} "${CMAKE_MATCH_4}")
    foreach(other IN LISTS depends_${room})
      if(NOT other IN_LIST rooms)
        violation("libdrt/CMakeLists.txt: room ${room} depends on ${other}, which is not declared before it")
      elseif(floor_${other} GREATER floor_${room})
        violation("libdrt/CMakeLists.txt: room ${room} (floor ${floor_${room}}) depends on ${other} (floor ${floor_${other}}): nothing points up")
      endif()
    endforeach()
    list(APPEND rooms ${room})
  elseif(record MATCHES "^folder ([^ ]+) rooms=([^ ]*)$")
    list(APPEND folders ${CMAKE_MATCH_1})
    string(REPLACE "," ";" rooms_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
  else()
    message(FATAL_ERROR "${RECORDS}: cannot read '${record}'")
  endif()
endforeach()

file(STRINGS ${HEADERS} header_lines REGEX "^[^#]")
set(header_patterns "")
set(header_owners "")
foreach(line IN LISTS header_lines)
  if(NOT line MATCHES "^([^ ]+) +([^ ]+)$")
    message(FATAL_ERROR "${HEADERS}: cannot read '${line}'")
  endif()
  list(APPEND header_patterns "${CMAKE_MATCH_1}")
  list(APPEND header_owners "${CMAKE_MATCH_2}")
endforeach()

# ---- what is included

# The included headers of <file>, each with its opening < or ", as a list.
function(read_includes file out)
  file(STRINGS ${SOURCE_DIR}/${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]")
  list(TRANSFORM lines REPLACE "^[ \t]*#[ \t]*include[ \t]*([<\"][^>\"]+).*" "\\1")
  set(${out} "${lines}" PARENT_SCOPE)
endfunction()

macro(include_violation text)
  file(READ ${SOURCE_DIR}/${file} content)
  string(FIND "${content}" "${header}" position)
  string(SUBSTRING "${content}" 0 ${position} before)
  string(REGEX MATCHALL "\n" newlines "${before}")
  list(LENGTH newlines line)
  math(EXPR line "${line} + 1")
  violation("${file}:${line}: ${text}")
endmacro()

# <header> in angle brackets, in a file of <room>.
macro(check_system_header room file header)
  set(owner "")
  foreach(pattern candidate IN ZIP_LISTS header_patterns header_owners)
    if("${header}" MATCHES "${pattern}")
      set(owner ${candidate})
      break()
    endif()
  endforeach()
  if("${header}" MATCHES "^[a-z0-9_]+$" OR owner STREQUAL "anywhere")
    # the standard library's, or as good as
  elseif(NOT owner)
    include_violation("<${header}> is unknown: say in tests/layering/headers.txt whose it is")
  elseif("${file}" MATCHES "\\.h$")
    include_violation("<${header}> in a room's header: third-party headers belong in .cpp files")
  elseif(NOT owner STREQUAL "sources" AND NOT owner IN_LIST libraries_${room})
    include_violation("<${header}>: room ${room} does not name ${owner} under LIBRARIES")
  endif()
endmacro()

foreach(room IN LISTS rooms)
  file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/libdrt/drt/${room}/*.h ${SOURCE_DIR}/libdrt/drt/${room}/*.cpp)
  foreach(file IN LISTS files)
    read_includes(${file} includes)
    foreach(include IN LISTS includes)
      string(SUBSTRING "${include}" 1 -1 header)
      if(include MATCHES "^<")
        check_system_header(${room} ${file} "${header}")
      elseif(NOT header MATCHES "^drt/([^/]+)/")
        include_violation("\"${header}\": rooms include drt's headers by their full path, \"drt/<room>/<file>\"")
      elseif(NOT CMAKE_MATCH_1 STREQUAL room AND NOT CMAKE_MATCH_1 IN_LIST depends_${room})
        include_violation("\"${header}\": room ${room} does not name ${CMAKE_MATCH_1} under DEPENDS")
      endif()
    endforeach()
  endforeach()
endforeach()

foreach(folder IN LISTS folders)
  file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.cpp)
  foreach(file IN LISTS files)
    read_includes(${file} includes)
    foreach(include IN LISTS includes)
      string(SUBSTRING "${include}" 1 -1 header)
      if(header MATCHES "^drt/([^/]+)/" AND NOT CMAKE_MATCH_1 IN_LIST rooms_${folder})
        include_violation("\"${header}\": nothing built in ${folder} links room ${CMAKE_MATCH_1}")
      endif()
    endforeach()
  endforeach()
endforeach()

# Every room's folder was declared.
file(GLOB room_folders RELATIVE ${SOURCE_DIR}/libdrt/drt ${SOURCE_DIR}/libdrt/drt/*)
foreach(room IN LISTS room_folders)
  if(NOT room IN_LIST rooms)
    violation("libdrt/drt/${room}: no drt_add_room(${room} ...) in libdrt/CMakeLists.txt")
  endif()
endforeach()

if(violations)
  list(JOIN violations "\n" text)
  message("${text}")
  list(LENGTH violations count)
  message(FATAL_ERROR "The layering is violated in ${count} places")
endif()
list(LENGTH rooms room_count)
message(STATUS "layering holds: ${room_count} rooms")
