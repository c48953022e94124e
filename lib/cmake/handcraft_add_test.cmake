# handcraft_add_test(PATH LINKS own... [THIRD third...])
#
# Builds tests/PATH.cc (PATH ends in _test) against GoogleTest and registers it under its path, so
# `ctest -R lib/core` runs a folder. The executable runs in tests/ and finds its data below data/.
# A test carries its folder as label (lib/core, trainers/logistic_irls, datasets, ...), and target
# lib_core_tests and its like build a folder's tests: the sanitizer presets pick theirs by name.
find_program(HANDCRAFT_LLD ld.lld)  # links a test in an eighth of the time that GNU ld takes

function(handcraft_add_test path)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINKS;THIRD")
  string(REPLACE "/" "_" target ${path})
  add_executable(${target} "${PROJECT_SOURCE_DIR}/tests/${path}.cc")
  list(TRANSFORM arg_LINKS PREPEND handcraft::)
  target_link_libraries(${target} PRIVATE handcraft_build_options handcraft_warnings
    handcraft_test_support ${arg_LINKS} ${arg_THIRD} GTest::gmock_main)
  if(HANDCRAFT_LLD)
    target_link_options(${target} PRIVATE -fuse-ld=lld)
  endif()
  target_compile_definitions(${target} PRIVATE
    HANDCRAFT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_test(NAME ${path} COMMAND ${target} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}/tests")
  handcraft_label_test(${path} ${target})
endfunction()

# Gives test PATH its folder's label and makes the folder's target build TARGET.
function(handcraft_label_test path target)
  string(REGEX MATCH "^((lib|trainers)/)?[^/]+" folder ${path})
  set_property(TEST ${path} APPEND PROPERTY LABELS ${folder})
  string(REPLACE "/" "_" folder_target ${folder}_tests)
  if(NOT TARGET ${folder_target})
    add_custom_target(${folder_target})
  endif()
  add_dependencies(${folder_target} ${target})
endfunction()
