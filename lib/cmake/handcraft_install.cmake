# Installs what is used outside this tree: the runtime (libraries, header, CMake package, pkg-config
# file), the command and the shipped models. Nothing installed names the folder it was built in or
# installed to, so that the prefix may be moved.
#
#   cmake --install BUILD --prefix PREFIX [--component runtime]
include(CMakePackageConfigHelpers)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/handcraft")
set(generated "${PROJECT_BINARY_DIR}/package")

install(TARGETS handcraft_runtime_shared handcraft_runtime_static
  EXPORT handcraft-targets
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime)
install(FILES "${PROJECT_SOURCE_DIR}/lib/runtime/handcraft_runtime.h"
  DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/handcraft" COMPONENT runtime)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT runtime)

# find_package(handcraft 0.1) gives handcraft::runtime (shared) and handcraft::runtime_static.
install(EXPORT handcraft-targets NAMESPACE handcraft::
  DESTINATION "${package_folder}" COMPONENT runtime)
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/handcraft-config.cmake.in"
  "${generated}/handcraft-config.cmake" INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${generated}/handcraft-config-version.cmake"
  COMPATIBILITY SameMajorVersion)
install(FILES "${generated}/handcraft-config.cmake" "${generated}/handcraft-config-version.cmake"
  DESTINATION "${package_folder}" COMPONENT runtime)

# ${pcfiledir} is where pkg-config finds the file; the prefix is written relative to it.
file(RELATIVE_PATH HANDCRAFT_PREFIX_FROM_PC "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" HANDCRAFT_PREFIX_FROM_PC "${HANDCRAFT_PREFIX_FROM_PC}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/handcraft_runtime.pc.in"
  "${generated}/handcraft_runtime.pc" @ONLY)
install(FILES "${generated}/handcraft_runtime.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT runtime)

if(TARGET handcraft)
  install(TARGETS handcraft RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT tools)
endif()
if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/models")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/models/"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/handcraft/models" COMPONENT models)
endif()
