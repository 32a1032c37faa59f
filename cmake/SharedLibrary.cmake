# SPDX-License-Identifier: GPL-3.0-or-later
# All stages as one shared library, for packages: whoever links it needs the headers and Eigen, and no other library.
# The program and the Python module keep their own archives: to load what only calibration needs (pagmo) takes 20 ms.

# Until version 1 any minor version may break what is compiled against it, so the soname has both numbers (docs/reference/versions.md).
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(FRETWORK_SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
else()
  set(FRETWORK_SOVERSION "${PROJECT_VERSION_MAJOR}")
endif()

# fretwork_add_shared_library(<stages..>): the target fretwork_shared, and for each stage fretwork_shared_<stage>, which stands for
# it where the library is installed.
function(fretwork_add_shared_library)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/shared_library.cpp" CONTENT "// The shared library holds the objects of all stages.\n")
  add_library(fretwork_shared SHARED "${PROJECT_BINARY_DIR}/shared_library.cpp")
  set_target_properties(fretwork_shared PROPERTIES
    OUTPUT_NAME fretwork EXPORT_NAME fretwork VERSION "${PROJECT_VERSION}" SOVERSION "${FRETWORK_SOVERSION}"
    FRETWORK_IS_MODULE ON LINKER_LANGUAGE CXX)
  target_link_options(fretwork_shared PRIVATE -Wl,--as-needed -Wl,--no-undefined)
  target_compile_features(fretwork_shared INTERFACE cxx_std_20)
  target_link_libraries(fretwork_shared INTERFACE Eigen3::Eigen)
  foreach(stage IN LISTS ARGN)
    target_sources(fretwork_shared PRIVATE $<TARGET_OBJECTS:${stage}>)
    target_link_libraries(fretwork_shared PRIVATE ${stage})
    string(REPLACE fretwork_ "" name ${stage})
    add_library(fretwork_shared_${name} INTERFACE)
    set_target_properties(fretwork_shared_${name} PROPERTIES EXPORT_NAME ${name})
    target_link_libraries(fretwork_shared_${name} INTERFACE fretwork_shared)
    install(TARGETS fretwork_shared_${name} EXPORT fretworkTargets)
  endforeach()
  install(TARGETS fretwork_shared EXPORT fretworkTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()
