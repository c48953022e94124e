# cmake -DROOT=... -DOUT=... -P print_link_table.cmake: writes the table of
# lib/cmake/handcraft_add_library.cmake as "NAME=a;b;c" lines, so that the include check reads the
# rules from where they are enforced.
include("${ROOT}/lib/cmake/handcraft_add_library.cmake")
get_cmake_property(names VARIABLES)
set(table "")
foreach(name IN LISTS names)
  if(name MATCHES "^HANDCRAFT_(MAY_LINK|THIRD_PARTY)_")
    string(APPEND table "${name}=${${name}}\n")
  endif()
endforeach()
file(WRITE "${OUT}" "${table}")
