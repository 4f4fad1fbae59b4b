# cmake -DBUILD_DIR=... -DPROGRAM_DIR=... -DWORK_DIR=... -DCOMPILER=... -DGENERATOR=... [-DSANITIZE=...] -P check_package.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message("${text}")
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
file(GLOB programs ${WORK_DIR}/prefix/bin/*)
foreach(program IN LISTS programs)
  run(${program} --version)
endforeach()

set(flags "")
if(SANITIZE)
  set(flags -fsanitize=${SANITIZE})
endif()
run(${CMAKE_COMMAND} -S ${PROGRAM_DIR} -B ${WORK_DIR}/build -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/program)
if(NOT output MATCHES "falls to -4\\.90")
  message(FATAL_ERROR "The program's ball fell elsewhere: ${output}")
endif()
# A ball that fills the picture's middle under a light at the camera: k_d times the light there, where n and l agree.
if(NOT output MATCHES "middle 0\\.4[89]|middle 0\\.50")
  message(FATAL_ERROR "The program rendered something else: ${output}")
endif()

# Physics is the business of a library that is loaded when it is needed; without it that is said.
file(WRITE ${WORK_DIR}/physics.yaml "drt: 1\nambient_light: 1\nmaterials: [{name: grey}]\ncameras: [{video_end: 1}]\n"
  "bodies: [{type: sphere, material: grey, physics: {}}]\n")
set(render ${WORK_DIR}/prefix/bin/drt-render --explain --no-bake-cache ${WORK_DIR}/physics.yaml)
run(${render})
file(GLOB_RECURSE loaded ${WORK_DIR}/prefix/libdrt-bullet.so)
file(REMOVE ${loaded})
execute_process(COMMAND ${render} RESULT_VARIABLE result ERROR_VARIABLE text)
if(NOT result EQUAL 4 OR NOT text MATCHES "libdrt-bullet\\.so.*${WORK_DIR}/prefix/bin/\\.\\./lib")
  message(FATAL_ERROR "Without libdrt-bullet.so: (${result}) ${text}")
endif()
file(REMOVE_RECURSE ${WORK_DIR})
