# handcraft_add_library(NAME SOURCES file... [LINKS own...] [PUBLIC third...] [PRIVATE third...])
#
# Makes the static library handcraft_NAME, alias handcraft::NAME, one per folder, and refuses a
# link that the table below does not allow. Data flows one way:
#   datasets -> features -> trainers -> models -> runtime -> experiments
# The same table is checked against the #include lines by tests/integration/link_rules.

set(HANDCRAFT_MAY_LINK_core "")
set(HANDCRAFT_MAY_LINK_features core)
set(HANDCRAFT_MAY_LINK_runtime core features)
set(HANDCRAFT_MAY_LINK_structured_text core)
set(HANDCRAFT_MAY_LINK_perception core features)
set(HANDCRAFT_MAY_LINK_model_io core features runtime)
set(HANDCRAFT_MAY_LINK_linear_algebra core)
set(HANDCRAFT_MAY_LINK_robot core features structured_text)
set(HANDCRAFT_MAY_LINK_datasets core features perception structured_text)
set(HANDCRAFT_MAY_LINK_trainer core features linear_algebra model_io)
set(HANDCRAFT_MAY_LINK_experiments
    core features linear_algebra perception model_io robot runtime structured_text datasets trainer)
set(HANDCRAFT_MAY_LINK_tools
    core features linear_algebra perception model_io robot runtime datasets trainer experiments)

set(HANDCRAFT_THIRD_PARTY_core Eigen3::Eigen Threads::Threads)
set(HANDCRAFT_THIRD_PARTY_features hwy_headers)
set(HANDCRAFT_THIRD_PARTY_runtime "")
set(HANDCRAFT_THIRD_PARTY_structured_text
    fmt::fmt tinyxml2::tinyxml2 tomlplusplus::tomlplusplus)
set(HANDCRAFT_THIRD_PARTY_robot fmt::fmt hwy_headers orocos_kdl tomlplusplus::tomlplusplus)
set(HANDCRAFT_THIRD_PARTY_perception
    Eigen3::Eigen opencv_core opencv_imgproc opencv_imgcodecs opencv_calib3d)
set(HANDCRAFT_THIRD_PARTY_model_io nlohmann_json::nlohmann_json)
set(HANDCRAFT_THIRD_PARTY_linear_algebra BLAS::BLAS LAPACK::LAPACK fmt::fmt)
set(HANDCRAFT_THIRD_PARTY_datasets
    Eigen3::Eigen embree fmt::fmt nlohmann_json::nlohmann_json opencv_core opencv_imgproc
    opencv_imgcodecs tomlplusplus::tomlplusplus ZLIB::ZLIB)
set(HANDCRAFT_THIRD_PARTY_trainer Eigen3::Eigen fmt::fmt BLAS::BLAS LAPACK::LAPACK)
set(HANDCRAFT_THIRD_PARTY_experiments
    fmt::fmt nlohmann_json::nlohmann_json opencv_core opencv_imgproc opencv_imgcodecs opencv_ml BLAS::BLAS
    benchmark::benchmark Eigen3::Eigen tomlplusplus::tomlplusplus pcl_filters pcl_segmentation)
set(HANDCRAFT_THIRD_PARTY_tools CLI11::CLI11 fmt::fmt nlohmann_json::nlohmann_json)

# The layer of a library: every folder below trainers/ is a "trainer"; one trainer never links another.
function(handcraft_layer_of name out)
  if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/trainers/${name}")
    set(${out} trainer PARENT_SCOPE)
  else()
    set(${out} ${name} PARENT_SCOPE)
  endif()
endfunction()

function(handcraft_check_links name own third)
  handcraft_layer_of(${name} layer)
  if(NOT DEFINED HANDCRAFT_MAY_LINK_${layer})
    message(FATAL_ERROR "${name} has no row in the link table "
                        "(lib/cmake/handcraft_add_library.cmake)")
  endif()
  foreach(dependency IN LISTS own)
    handcraft_layer_of(${dependency} dependency_layer)
    if(NOT dependency_layer IN_LIST HANDCRAFT_MAY_LINK_${layer})
      message(FATAL_ERROR "${name} may not link ${dependency}: layer ${layer} may link only "
                          "'${HANDCRAFT_MAY_LINK_${layer}}' (lib/cmake/handcraft_add_library.cmake)")
    endif()
  endforeach()
  foreach(dependency IN LISTS third)
    if(NOT dependency IN_LIST HANDCRAFT_THIRD_PARTY_${layer})
      message(FATAL_ERROR "${name} may not use ${dependency}: layer ${layer} may use only "
                          "'${HANDCRAFT_THIRD_PARTY_${layer}}' (lib/cmake/handcraft_add_library.cmake)")
    endif()
  endforeach()
endfunction()

function(handcraft_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINKS;PUBLIC;PRIVATE")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "handcraft_add_library(${name}): unknown argument '${arg_UNPARSED_ARGUMENTS}'")
  endif()
  set(third_party ${arg_PUBLIC} ${arg_PRIVATE})
  handcraft_check_links(${name} "${arg_LINKS}" "${third_party}")
  add_library(handcraft_${name} STATIC ${arg_SOURCES})
  add_library(handcraft::${name} ALIAS handcraft_${name})
  list(TRANSFORM arg_LINKS PREPEND handcraft::)
  target_link_libraries(handcraft_${name}
    PUBLIC handcraft_build_options ${arg_LINKS} ${arg_PUBLIC}
    PRIVATE handcraft_warnings ${arg_PRIVATE})
  handcraft_require_mirror_tests("${arg_SOURCES}")
endfunction()

# Every source has its test at the mirrored path: lib/core/rng.cc -> tests/lib/core/rng_test.cc.
function(handcraft_require_mirror_tests sources)
  if(NOT HANDCRAFT_DEVELOPER)
    return()
  endif()
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE OUTPUT_VARIABLE path)
    cmake_path(RELATIVE_PATH path BASE_DIRECTORY "${PROJECT_SOURCE_DIR}")
    cmake_path(REMOVE_EXTENSION path OUTPUT_VARIABLE stem)
    set(test "tests/${stem}_test.cc")
    if(path MATCHES "\\.cc$" AND NOT EXISTS "${PROJECT_SOURCE_DIR}/${test}")
      message(FATAL_ERROR "${path} has no test: expected ${test}")
    endif()
  endforeach()
endfunction()
