# Every switch a builder may want, in one place.
option(DRT_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(DRT_BUILD_BENCHMARKS "Build the benchmarks" OFF)
option(DRT_WARNINGS_AS_ERRORS "Treat compiler warnings as errors (CI does)" OFF)
option(DRT_CCACHE "Compile through ccache when it is installed" ON)
option(DRT_BARE "Leave out lens, time, textures and scatter, only to measure that scenes without them pay nothing" OFF)
set(DRT_ARCH native CACHE STRING
  "Instruction set: 'native' (tuned to this machine) or a -march value such as x86-64-v2 (portable), x86-64-v3, x86-64-v4")
set(DRT_SANITIZE "" CACHE STRING "Sanitizers, as for -fsanitize=, for example 'address,undefined' or 'thread'")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
# The build for development: optimised enough to render with, assertions on (the standard library's as well).
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g -D_GLIBCXX_ASSERTIONS")

if(DRT_CCACHE)
  find_program(DRT_CCACHE_PROGRAM ccache)
  if(DRT_CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${DRT_CCACHE_PROGRAM})
  endif()
endif()

# Flags that the whole library and everything that includes its SIMD headers must agree on
# (lane width follows from -march, so mixing widths would break the one-definition rule).
add_library(drt_flags INTERFACE)
add_library(drt::flags ALIAS drt_flags)
target_compile_features(drt_flags INTERFACE cxx_std_20)
# -fno-math-errno/-fno-trapping-math let GCC vectorise sqrt and comparisons; NaN and infinity keep
# their IEEE meaning (no -ffast-math, no -ffinite-math-only).
# -Wno-psabi: vector types in signatures change the ABI between ISAs; all of drt is one ISA.
target_compile_options(drt_flags INTERFACE -march=${DRT_ARCH} -fno-math-errno -fno-trapping-math -Wno-psabi)
if(DRT_BARE)
  target_compile_definitions(drt_flags INTERFACE DRT_BARE)
endif()

add_library(drt_build_flags INTERFACE)  # for our own sources only, never exported
target_link_libraries(drt_build_flags INTERFACE drt_flags)
target_compile_options(drt_build_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow)
# GCC 12 takes the deliberately undefined pass-through operand of its own AVX-512 intrinsics for a bug
# (gcc.gnu.org/PR105593), in every use of stdx::simd's sqrt and conversions.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(drt_build_flags INTERFACE -Wno-uninitialized -Wno-maybe-uninitialized)
endif()
if(DRT_WARNINGS_AS_ERRORS)
  target_compile_options(drt_build_flags INTERFACE -Werror)
endif()
if(DRT_SANITIZE)
  # -O1 and line numbers only: the lanes' files compile in less than half the time of -O2 -g (GCC 12).
  add_compile_options(-fsanitize=${DRT_SANITIZE} -fno-omit-frame-pointer -O1 -g1)
  add_link_options(-fsanitize=${DRT_SANITIZE})
  if(DRT_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize-recover=undefined)
  endif()
endif()
