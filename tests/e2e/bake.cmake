drt_add_test(test_e2e_bake SOURCES bake_program_test.cpp bake_stop_test.cpp render_physics_test.cpp render_programs.cpp
  ROOMS image formats LIBRARIES drt_apps test_process OpenEXR::OpenEXR)
target_compile_definitions(test_e2e_bake PRIVATE
  DRT_RENDER="$<TARGET_FILE:drt-render>" DRT_CONVERT="$<TARGET_FILE:drt-convert>" DRT_BAKE="$<TARGET_FILE:drt-bake>"
  DRT_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
add_dependencies(test_e2e_bake drt-render drt-bake drt-convert)
