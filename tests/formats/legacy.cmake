drt_add_test(test_formats_legacy
  SOURCES legacy_fixture.cpp legacy_example_test.cpp legacy_map_test.cpp legacy_error_test.cpp legacy_table_test.cpp legacy_yaml_test.cpp
  ROOMS formats scene base)
target_compile_definitions(test_formats_legacy PRIVATE
  DRT_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data" DRT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
