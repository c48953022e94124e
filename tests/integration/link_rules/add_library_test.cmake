# Configures tiny projects that use handcraft_add_library, and expects the one that keeps the rules
# to pass and each that breaks one to be refused with the message that names the rule.

# Configures a project with the folders lib/core, lib/features, trainers/lda and trainers/pca whose
# CMakeLists.txt ends in CALL. Sets `result` and `output`.
function(configure call)
  file(REMOVE_RECURSE "${WORK}")
  foreach(stem lib/core/error lib/features/moments trainers/lda/lda trainers/pca/pca)
    file(WRITE "${WORK}/${stem}.cc" "")
    file(WRITE "${WORK}/tests/${stem}_test.cc" "")
  endforeach()
  file(WRITE "${WORK}/lib/core/untested.cc" "")
  file(WRITE "${WORK}/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.25)
project(tiny LANGUAGES CXX)
set(HANDCRAFT_DEVELOPER ON)
include(${ROOT}/lib/cmake/handcraft_add_library.cmake)
add_library(handcraft_build_options INTERFACE)
add_library(handcraft_warnings INTERFACE)
handcraft_add_library(core SOURCES lib/core/error.cc)
${call}\n")
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${WORK}" -B "${WORK}/build" -G "${GENERATOR}"
            "-DCMAKE_CXX_COMPILER=${CXX}" -DCMAKE_CXX_COMPILER_WORKS=ON
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  # CMake wraps its messages: one space for each run of white space.
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  set(result "${result}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_accepted call)
  configure("${call}")
  if(NOT result EQUAL 0)
    message(SEND_ERROR "'${call}' keeps the rules and was refused:\n${output}")
  endif()
endfunction()

function(expect_refused call message)
  configure("${call}")
  string(FIND "${output}" "${message}" position)
  if(result EQUAL 0)
    message(SEND_ERROR "'${call}' was accepted; expected: ${message}")
  elseif(position EQUAL -1)
    message(SEND_ERROR "'${call}' was refused for another reason than '${message}':\n${output}")
  endif()
endfunction()

expect_accepted("handcraft_add_library(features SOURCES lib/features/moments.cc LINKS core)")
expect_accepted("handcraft_add_library(lda SOURCES trainers/lda/lda.cc LINKS core)")

expect_refused("handcraft_add_library(features SOURCES lib/features/moments.cc LINKS tools)"
               "features may not link tools: layer features may link only 'core'")
expect_refused("handcraft_add_library(lda SOURCES trainers/lda/lda.cc LINKS pca)"
               "lda may not link pca: layer trainer may link only")
expect_refused("handcraft_add_library(features SOURCES lib/features/moments.cc PUBLIC opencv_core)"
               "features may not use opencv_core: layer features may use only 'hwy_headers'")
expect_refused("handcraft_add_library(lda SOURCES trainers/lda/lda.cc PRIVATE foo::foo)"
               "lda may not use foo::foo: layer trainer may use only")
expect_refused("handcraft_add_library(features SOURCES lib/core/untested.cc)"
               "lib/core/untested.cc has no test: expected tests/lib/core/untested_test.cc")
expect_refused("handcraft_add_library(utils SOURCES lib/core/error.cc)"
               "utils has no row in the link table")
expect_refused("handcraft_add_library(features SOURCE lib/features/moments.cc)"
               "handcraft_add_library(features): unknown argument 'SOURCE;lib/features/moments.cc'")
