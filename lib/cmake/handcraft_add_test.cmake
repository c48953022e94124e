# Links a test in a quarter of the time that GNU ld takes. (lld is as quick, but what lld 14 links
# aborts where an exception leaves the cold part of a function that GCC has split.)
find_program(HANDCRAFT_GOLD ld.gold)

# handcraft_add_test(PATH LINKS own... [THIRD third...])
#
# Builds tests/PATH.cc (PATH ends in _test) against GoogleTest and registers it under its path, so
# `ctest -R lib/core` runs a folder. The executable runs in tests/ and finds its data below data/.
# A test carries its folder as label (lib/core, trainers/logistic_irls, datasets, ...), and target
# lib_core_tests and its like build a folder's tests: the sanitizer presets pick theirs by name. A test
# whose source asks for threads carries the label "threads" besides, and target threads_tests builds
# it: the thread sanitizer has nothing to look for in the others.
function(handcraft_add_test path)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINKS;THIRD")
  string(REPLACE "/" "_" target ${path})
  add_executable(${target} "${PROJECT_SOURCE_DIR}/tests/${path}.cc")
  list(TRANSFORM arg_LINKS PREPEND handcraft::)
  target_link_libraries(${target} PRIVATE handcraft_build_options handcraft_warnings
    handcraft_test_support ${arg_LINKS} ${arg_THIRD} GTest::gmock_main)
  if(HANDCRAFT_GOLD)
    target_link_options(${target} PRIVATE -fuse-ld=gold)
  endif()
  target_compile_options(${target} PRIVATE -Og)  # quicker to compile; what is tested keeps its flags
  # Seen from tests/, so that the compiler cache serves every clone.
  target_compile_definitions(${target} PRIVATE HANDCRAFT_SOURCE_DIR="..")
  add_test(NAME ${path} COMMAND ${target} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}/tests")
  handcraft_label_test(${path} ${target})
endfunction()

# Gives test PATH its folder's label and makes the folder's target build TARGET; the same with threads.
function(handcraft_label_test path target)
  string(REGEX MATCH "^((lib|trainers)/)?[^/]+" labels ${path})
  if(path MATCHES "^trainers/")
    list(APPEND labels trainers)  # all methods together, for the sanitizers
  endif()
  set(source "${PROJECT_SOURCE_DIR}/tests/${path}.cc")
  if(EXISTS "${source}")
    file(STRINGS "${source}" uses_threads LIMIT_COUNT 1 REGEX "num_threads|std::j?thread|ParallelFor")
    if(uses_threads AND NOT path MATCHES "^tools/")  # those start none of their own
      list(APPEND labels threads)
    endif()
  endif()
  foreach(label IN LISTS labels)
    set_property(TEST ${path} APPEND PROPERTY LABELS ${label})
    string(REPLACE "/" "_" label_target ${label}_tests)
    if(NOT TARGET ${label_target})
      add_custom_target(${label_target})
    endif()
    add_dependencies(${label_target} ${target})
  endforeach()
endfunction()
