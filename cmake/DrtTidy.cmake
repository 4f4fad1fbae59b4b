# The target `tidy`: clang-tidy over the library and the programs (docs/building.md). Other releases than 14 have other checks.
find_program(DRT_RUN_CLANG_TIDY NAMES run-clang-tidy-14)
if(DRT_RUN_CLANG_TIDY)
  add_custom_target(tidy
    COMMAND ${DRT_RUN_CLANG_TIDY} -quiet -p ${PROJECT_BINARY_DIR} "^${PROJECT_SOURCE_DIR}/(libdrt|apps)/"
    COMMENT "clang-tidy over libdrt and apps" USES_TERMINAL VERBATIM)
endif()
