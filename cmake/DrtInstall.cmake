# `cmake --install`: the programs, the headers, the static libraries, and a CMake package whose target drt::drt is all
# of it. Each room is there too (drt::scene, ...). The flags of drt_flags travel along: the width of a SIMD lane follows
# from -march and is part of the ABI, so a program that links drt is compiled for the same instruction set.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY DRT_LINKED_ROOMS)
list(TRANSFORM rooms PREPEND drt_)
add_library(drt_drt INTERFACE)
add_library(drt::drt ALIAS drt_drt)
target_link_libraries(drt_drt INTERFACE ${rooms})
set_target_properties(drt_drt PROPERTIES EXPORT_NAME drt)
set_target_properties(drt_flags PROPERTIES EXPORT_NAME flags)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/drt)
install(TARGETS drt_drt drt_flags ${rooms} EXPORT drt
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
get_property(loaded_libraries GLOBAL PROPERTY DRT_LOADED_LIBRARIES)
install(TARGETS ${loaded_libraries} LIBRARY DESTINATION ${DRT_LOADED_LIBRARY_DIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/libdrt/drt DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(EXPORT drt NAMESPACE drt:: FILE drtTargets.cmake DESTINATION ${package_dir})
install(FILES
  ${PROJECT_SOURCE_DIR}/cmake/drtConfig.cmake
  ${PROJECT_SOURCE_DIR}/third_party/require.cmake
  ${PROJECT_SOURCE_DIR}/third_party/library_dependencies.cmake
  DESTINATION ${package_dir})
# Until 1.0 any minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/drtConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/drtConfigVersion.cmake DESTINATION ${package_dir})

# Whatever executable apps/ builds is for users.
function(drt_install_programs folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")
      file(RELATIVE_PATH libraries /${CMAKE_INSTALL_BINDIR} /${DRT_LOADED_LIBRARY_DIR})
      set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries}")
      install(TARGETS ${target} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    endif()
  endforeach()
  get_property(subfolders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder IN LISTS subfolders)
    drt_install_programs(${subfolder})
  endforeach()
endfunction()
drt_install_programs(${PROJECT_SOURCE_DIR}/apps)
