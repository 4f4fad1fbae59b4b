# Finds what drt is built from, or says in one message what is missing and how to get it.
include(${CMAKE_CURRENT_LIST_DIR}/require.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/library_dependencies.cmake)

# For the programs.
drt_require(CLI11 2.1 APT libcli11-dev)
drt_require(osmium 0 APT libosmium2-dev HEADER osmium/util/progress_bar.hpp)
if(DRT_BUILD_TESTS)
  drt_require(GTest 1.12 APT libgtest-dev)
endif()

drt_report_missing(_drt_missing)
if(_drt_missing)
  message(FATAL_ERROR "${_drt_missing}")
endif()
