# A room is one folder of libdrt/drt with one purpose, built as one static library.
#
#   drt_floor(<number>)
#   drt_add_room(<name> DEPENDS <rooms it may include> [LIBRARIES <third-party targets>] [LOADED_BY <room>])
#
# Sources are found by globbing the room's folder. DEPENDS is the layering: the ctest `layering` compares it with the
# #include lines (tests/layering). Third-party libraries are PRIVATE: only a room's .cpp files see them.
# A room may depend only on rooms declared before it, so there are no cycles.
# A room that is LOADED_BY another is a library of its own, lib/drt/libdrt-<name>.so, which that room opens when it first
# needs it; so programs that do not need it pay nothing for its libraries. It links nothing of drt: of the rooms that it
# depends on it may use what their headers hold.
define_property(GLOBAL PROPERTY DRT_ROOMS BRIEF_DOCS "Names of all rooms, in order of declaration")
define_property(GLOBAL PROPERTY DRT_ROOM_RECORDS BRIEF_DOCS "What each room declared, for the layering check")

# In the build tree and where drt is installed, loaded libraries are in this folder below the prefix.
set(DRT_LOADED_LIBRARY_DIR ${CMAKE_INSTALL_LIBDIR}/drt)
# For all of the build tree's programs; cmake --install takes it out again (an rpath given to the linker would stay).
set(CMAKE_BUILD_RPATH ${PROJECT_BINARY_DIR}/${DRT_LOADED_LIBRARY_DIR})

# Whatever links the installed <loader> is told where to seek it: in an rpath, which the dynamic linker knows at run time.
macro(_drt_add_loaded_library name loader)
  add_library(drt_${name} MODULE ${sources})
  set_target_properties(drt_${name} PROPERTIES OUTPUT_NAME drt-${name} CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${DRT_LOADED_LIBRARY_DIR})
  target_link_libraries(drt_${name} PRIVATE drt_build_flags ${ARG_LIBRARIES})
  add_dependencies(drt_${loader} drt_${name})
  target_link_options(drt_${loader} INTERFACE
    $<INSTALL_INTERFACE:LINKER:-rpath,$<INSTALL_PREFIX>/${DRT_LOADED_LIBRARY_DIR}>)
  set_property(GLOBAL APPEND PROPERTY DRT_LOADED_LIBRARIES drt_${name})
endmacro()

# The rooms that follow are on this floor: nothing points up.
function(drt_floor number)
  set_property(GLOBAL PROPERTY DRT_FLOOR ${number})
endfunction()

function(drt_add_room name)
  cmake_parse_arguments(ARG "" "LOADED_BY" "DEPENDS;LIBRARIES" ${ARGN})
  get_property(rooms GLOBAL PROPERTY DRT_ROOMS)
  foreach(room IN LISTS ARG_DEPENDS)
    if(NOT room IN_LIST rooms)
      message(FATAL_ERROR "Room ${name} depends on ${room}, which is not declared before it")
    endif()
  endforeach()
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/drt/${name}/*.cpp)
  list(TRANSFORM ARG_DEPENDS PREPEND drt_ OUTPUT_VARIABLE deps)
  if(ARG_LOADED_BY)
    _drt_add_loaded_library(${name} ${ARG_LOADED_BY})
    set(deps "")
    set(scope PRIVATE)
  elseif(sources)
    add_library(drt_${name} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(drt_${name} PRIVATE $<BUILD_INTERFACE:drt_build_flags> ${ARG_LIBRARIES})
  else()
    add_library(drt_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  if(NOT ARG_LOADED_BY)
    add_library(drt::${name} ALIAS drt_${name})
    set_target_properties(drt_${name} PROPERTIES EXPORT_NAME ${name})
    set_property(GLOBAL APPEND PROPERTY DRT_LINKED_ROOMS ${name})
  endif()
  target_include_directories(drt_${name} ${scope} $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>)
  target_link_libraries(drt_${name} ${scope} drt_flags ${deps})

  set_property(GLOBAL APPEND PROPERTY DRT_ROOMS ${name})
  get_property(floor GLOBAL PROPERTY DRT_FLOOR)
  list(JOIN ARG_DEPENDS "," depends)
  list(JOIN ARG_LIBRARIES "," libraries)
  set_property(GLOBAL APPEND PROPERTY DRT_ROOM_RECORDS "room ${name} floor=${floor} depends=${depends} libraries=${libraries}")
endfunction()

#   drt_add_test(<name> SOURCES <files> ROOMS <rooms> [LIBRARIES <targets>] [LABELS <labels>])
#
# One GoogleTest executable per room; every TEST becomes a ctest case.
function(drt_add_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;ROOMS;LIBRARIES;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  list(TRANSFORM ARG_ROOMS PREPEND drt_ OUTPUT_VARIABLE rooms)
  target_link_libraries(${name} PRIVATE drt_build_flags ${rooms} ${ARG_LIBRARIES} GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS "${ARG_LABELS}")
endfunction()
