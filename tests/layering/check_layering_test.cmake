# Plants one violation of every rule in a small tree (and one in a copy of the real one) and expects the check to name it.
#
#   cmake -DSOURCE_DIR=<repository> -DRECORDS=<layering.txt> -DWORK_DIR=<scratch> -P check_layering_test.cmake
cmake_minimum_required(VERSION 3.25)
set(here ${CMAKE_CURRENT_LIST_DIR})
set(failures 0)

function(run_check source_dir records out_result out_text)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -DSOURCE_DIR=${source_dir} -DRECORDS=${records} -DHEADERS=${here}/headers.txt
      -P ${here}/check_layering.cmake
    RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  set(${out_result} ${result} PARENT_SCOPE)
  set(${out_text} "${text}" PARENT_SCOPE)
endfunction()

function(fresh_tree)
  file(REMOVE_RECURSE ${WORK_DIR})
  file(WRITE ${WORK_DIR}/records.txt
    "room base floor=0 depends= libraries=\n"
    "room scene floor=1 depends=base libraries=fmt::fmt\n"
    "room plan floor=3 depends=scene libraries=\n"
    "folder apps rooms=base,scene\n")
  file(WRITE ${WORK_DIR}/libdrt/drt/base/vec.h "#include <array>\n#include <experimental/simd>\n")
  file(WRITE ${WORK_DIR}/libdrt/drt/scene/scene.h "#include \"drt/base/vec.h\"\n")
  file(WRITE ${WORK_DIR}/libdrt/drt/scene/scene.cpp
    "#include \"drt/scene/scene.h\"\n#include <fmt/format.h>\n#include <unistd.h>\n")
  file(WRITE ${WORK_DIR}/libdrt/drt/plan/plan.h "#include \"drt/scene/scene.h\"\n")
  file(WRITE ${WORK_DIR}/apps/render/main.cpp "#include \"drt/scene/scene.h\"\n#include \"local.h\"\n")
endfunction()

# expect(<expected message> <file> <line to append>)
function(expect message file line)
  fresh_tree()
  file(APPEND ${WORK_DIR}/${file} "${line}\n")
  run_check(${WORK_DIR} ${WORK_DIR}/records.txt result text)
  string(FIND "${text}" "${message}" position)
  if(result EQUAL 0 OR position EQUAL -1)
    message("${line}\nin ${file}: expected '${message}', got (${result}):\n${text}")
    math(EXPR failures "${failures} + 1")
    set(failures ${failures} PARENT_SCOPE)
  endif()
endfunction()

fresh_tree()
run_check(${WORK_DIR} ${WORK_DIR}/records.txt result text)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "A tree without fault was refused:\n${text}")
endif()

expect("libdrt/drt/base/vec.h:3: \"drt/scene/scene.h\": room base does not name scene under DEPENDS"
  libdrt/drt/base/vec.h "#include \"drt/scene/scene.h\"")
# plan reaches base through scene, but did not name it
expect("libdrt/drt/plan/plan.h:2: \"drt/base/vec.h\": room plan does not name base under DEPENDS"
  libdrt/drt/plan/plan.h "  #  include   \"drt/base/vec.h\"")
expect("rooms include drt's headers by their full path" libdrt/drt/scene/scene.cpp "#include \"scene.h\"")
expect("rooms include drt's headers by their full path" libdrt/drt/scene/scene.cpp "#include \"../base/vec.h\"")
expect("<fmt/format.h> in a room's header" libdrt/drt/scene/scene.h "#include <fmt/format.h>")
expect("room scene does not name embree under LIBRARIES" libdrt/drt/scene/scene.cpp "#include <embree3/rtcore.h>")
expect("<boost/any.hpp> is unknown" libdrt/drt/scene/scene.cpp "#include <boost/any.hpp>")
expect("nothing built in apps links room plan" apps/render/main.cpp "#include \"drt/plan/plan.h\"")
expect("room low (floor 0) depends on scene (floor 1): nothing points up" records.txt
  "room low floor=0 depends=scene libraries=")
expect("room left depends on right, which is not declared before it" records.txt
  "room left floor=1 depends=right libraries=\nroom right floor=1 depends=left libraries=")
expect("libdrt/drt/stray: no drt_add_room(stray ...)" libdrt/drt/stray/stray.h "")

# The real tree, with its floor 0 including a room of floor 1.
file(REMOVE_RECURSE ${WORK_DIR})
file(COPY ${SOURCE_DIR}/libdrt ${SOURCE_DIR}/apps DESTINATION ${WORK_DIR})
file(APPEND ${WORK_DIR}/libdrt/drt/base/vec.h "#include \"drt/scene/scene_desc.h\"\n")
run_check(${WORK_DIR} ${RECORDS} result text)
if(result EQUAL 0 OR NOT text MATCHES "room base does not name scene under DEPENDS")
  message("A climbing include in the real tree went unnoticed (${result}):\n${text}")
  math(EXPR failures "${failures} + 1")
endif()
file(REMOVE_RECURSE ${WORK_DIR})

if(failures)
  message(FATAL_ERROR "${failures} planted violations were not reported as expected")
endif()
