drt_add_test(test_render_app SOURCES render_frames_test.cpp render_options_test.cpp LIBRARIES drt_render_app)

drt_add_test(test_e2e_render
  SOURCES render_contact_test.cpp render_frame_files_test.cpp render_output_test.cpp render_picture_test.cpp render_programs.cpp
    render_scene_errors_test.cpp render_stop_test.cpp render_terminal_test.cpp render_time_test.cpp render_usage_test.cpp
  ROOMS image LIBRARIES drt_apps test_process OpenEXR::OpenEXR)
target_compile_definitions(test_e2e_render PRIVATE
  DRT_RENDER="$<TARGET_FILE:drt-render>" DRT_CONVERT="$<TARGET_FILE:drt-convert>"
  DRT_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
add_dependencies(test_e2e_render drt-render drt-convert)

drt_add_test(test_e2e_million SOURCES render_million_test.cpp render_programs.cpp
  ROOMS image LIBRARIES drt_apps test_process OpenEXR::OpenEXR LABELS long)
target_compile_definitions(test_e2e_million PRIVATE
  DRT_RENDER="$<TARGET_FILE:drt-render>" DRT_CONVERT="$<TARGET_FILE:drt-convert>")
add_dependencies(test_e2e_million drt-render)

# Every scene of the repository is read, simulated and checked without a word. (*-common.yaml and bodies.yaml are parts of
# others.)
file(GLOB scenes CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/scenes/*.yaml
  ${PROJECT_SOURCE_DIR}/scenes/legacy/*.txt ${PROJECT_SOURCE_DIR}/benchmarks/mitsuba/scenes/*.yaml)
list(FILTER scenes EXCLUDE REGEX "-common\\.yaml$|/bodies\\.yaml$")
foreach(scene IN LISTS scenes)
  add_test(NAME check:${scene} COMMAND drt-render --check --explain --no-bake-cache ${scene}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(check:${scene} PROPERTIES FAIL_REGULAR_EXPRESSION "warning:|error:")
endforeach()
# The manual's own example has no light, as drt says.
set_tests_properties(check:scenes/legacy/manual-example.txt PROPERTIES
  FAIL_REGULAR_EXPRESSION "error:" PASS_REGULAR_EXPRESSION "warning: the scene has no lights")
