# Flags shared by every target of this project, carried by two INTERFACE targets and linked
# PRIVATE, so that a consumer of the installed package sees none of them.

add_library(handcraft_build_options INTERFACE)
target_compile_features(handcraft_build_options INTERFACE cxx_std_20)
target_include_directories(handcraft_build_options INTERFACE "${PROJECT_SOURCE_DIR}")
# One rounding per written operation: fused multiply-adds appear only where the code asks for them.
target_compile_options(handcraft_build_options INTERFACE -ffp-contract=off)

add_library(handcraft_warnings INTERFACE)
target_compile_options(handcraft_warnings INTERFACE
  -Wall -Wextra -Wconversion -Wshadow $<$<BOOL:${HANDCRAFT_WARNINGS_AS_ERRORS}>:-Werror>)
# GCC 12 warns falsely about `"text" + std::string` at -O3 (gcc.gnu.org/PR105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(handcraft_warnings INTERFACE -Wno-restrict)
  # And about std::regex and std::function where the sanitizers' code stands in between
  # (gcc.gnu.org/PR105562); builds without them still look.
  if(HANDCRAFT_SANITIZE)
    target_compile_options(handcraft_warnings INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  message(STATUS "No build type given: taking Release (set CMAKE_BUILD_TYPE to choose)")
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

if(HANDCRAFT_SANITIZE)
  target_compile_options(handcraft_build_options INTERFACE
    -fsanitize=${HANDCRAFT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(handcraft_build_options INTERFACE -fsanitize=${HANDCRAFT_SANITIZE})
endif()

# Every library is instrumented for libFuzzer; the targets are in tests/fuzz.
if(HANDCRAFT_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "HANDCRAFT_FUZZ needs clang: configure with the preset fuzz")
  endif()
  target_compile_options(handcraft_build_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
