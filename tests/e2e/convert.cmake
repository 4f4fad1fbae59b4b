drt_add_test(test_e2e_convert SOURCES convert_test.cpp convert_exit_codes_test.cpp
  ROOMS formats LIBRARIES drt_apps test_process)
target_compile_definitions(test_e2e_convert PRIVATE
  DRT_CONVERT="$<TARGET_FILE:drt-convert>" DRT_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
add_dependencies(test_e2e_convert drt-convert)
