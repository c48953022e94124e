# handcraft_add_test(PATH LINKS own... [THIRD third...])
#
# Builds tests/PATH.cc (PATH ends in _test) against GoogleTest and registers it under its path, so
# `ctest -R lib/core` runs a folder. The executable runs in tests/ and finds its data below data/.
function(handcraft_add_test path)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINKS;THIRD")
  string(REPLACE "/" "_" target ${path})
  add_executable(${target} "${PROJECT_SOURCE_DIR}/tests/${path}.cc")
  list(TRANSFORM arg_LINKS PREPEND handcraft::)
  target_link_libraries(${target} PRIVATE handcraft_build_options handcraft_warnings
    handcraft_test_support ${arg_LINKS} ${arg_THIRD} GTest::gmock_main)
  target_compile_definitions(${target} PRIVATE
    HANDCRAFT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_test(NAME ${path} COMMAND ${target} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}/tests")
endfunction()
