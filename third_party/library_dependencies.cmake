# What the library itself stands on. Installed with the CMake package, so that a program that links drt::drt finds the
# same libraries with the same messages. Least versions are those of Debian 12, the oldest release that drt is built on.

drt_require(embree 3.13 APT libembree-dev)
drt_require(OpenEXR 3.1 APT libopenexr-dev)
drt_require(TBB 2021.8 APT libtbb-dev)
drt_require(yaml-cpp 0.7 APT libyaml-cpp-dev)
drt_require(fmt 9 APT libfmt-dev)
drt_require(xxhash 0 APT libxxhash-dev HEADER xxhash.h LIBRARY xxhash)

# The CMake package of libopenimageio-dev stops with an error when the programs of openimageio-tools are absent.
find_program(DRT_MAKETX maketx)
mark_as_advanced(DRT_MAKETX)
if(DRT_MAKETX)
  drt_require(OpenImageIO 2.4 APT libopenimageio-dev)
else()
  set_property(GLOBAL APPEND PROPERTY DRT_MISSING_TEXT "OpenImageIO 2.4 or later: no program maketx")
  set_property(GLOBAL APPEND PROPERTY DRT_MISSING_APT libopenimageio-dev openimageio-tools)
endif()

# Debian 12's OpenImageIO exports OpenCV's include folder, which libopenimageio-dev does not install; CMake refuses
# to generate with a folder that does not exist.
if(TARGET OpenImageIO::OpenImageIO)
  get_target_property(_drt_oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
  list(FILTER _drt_oiio_includes EXCLUDE REGEX "opencv")
  set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${_drt_oiio_includes}")
endif()

# Bullet in double precision: Debian ships it beside the float one, without a CMake target.
find_path(DRT_bullet_INCLUDE_DIR btBulletDynamicsCommon.h PATH_SUFFIXES bullet)
set(_drt_bullet_libraries "")
foreach(part BulletDynamics BulletCollision LinearMath)
  find_library(DRT_bullet_${part} ${part}-float64)
  mark_as_advanced(DRT_bullet_${part})
  if(DRT_bullet_${part})
    list(APPEND _drt_bullet_libraries ${DRT_bullet_${part}})
  endif()
endforeach()
mark_as_advanced(DRT_bullet_INCLUDE_DIR)
list(LENGTH _drt_bullet_libraries _drt_bullet_parts)
if(DRT_bullet_INCLUDE_DIR AND _drt_bullet_parts EQUAL 3)
  if(NOT TARGET bullet::float64)
    add_library(bullet::float64 INTERFACE IMPORTED)
    target_include_directories(bullet::float64 INTERFACE ${DRT_bullet_INCLUDE_DIR})
    target_compile_definitions(bullet::float64 INTERFACE BT_USE_DOUBLE_PRECISION)
    target_link_libraries(bullet::float64 INTERFACE ${_drt_bullet_libraries})
  endif()
else()
  set_property(GLOBAL APPEND PROPERTY DRT_MISSING_TEXT "bullet: no float64 libraries or no header <bullet/btBulletDynamicsCommon.h>")
  set_property(GLOBAL APPEND PROPERTY DRT_MISSING_APT libbullet-dev)
endif()

# yaml-cpp 0.8 renamed its target.
if(TARGET yaml-cpp AND NOT TARGET yaml-cpp::yaml-cpp)
  add_library(yaml-cpp::yaml-cpp INTERFACE IMPORTED)
  target_link_libraries(yaml-cpp::yaml-cpp INTERFACE yaml-cpp)
endif()

# Embree 3 and 4 differ in include folder and in how a query is told its context; who links embree must know which.
if(TARGET embree)
  string(REGEX MATCH "^[0-9]+" DRT_EMBREE_MAJOR "${DRT_embree_VERSION}")
  set_property(TARGET embree APPEND PROPERTY INTERFACE_COMPILE_DEFINITIONS DRT_EMBREE_MAJOR=${DRT_EMBREE_MAJOR})
endif()
