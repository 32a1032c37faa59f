# SPDX-License-Identifier: GPL-3.0-or-later
# The files of `cmake --install`, so that find_package(fretwork) gives the targets fretwork::<stage>.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(stages GLOBAL PROPERTY FRETWORK_STAGES)
if(FRETWORK_SHARED_LIBRARY)
  include(SharedLibrary)
  fretwork_add_shared_library(${stages})
  install(TARGETS ${stages} ARCHIVE EXCLUDE_FROM_ALL COMPONENT archives FILE_SET HEADERS)
else()
  install(TARGETS ${stages} EXPORT fretworkTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} FILE_SET HEADERS)
endif()
if(TARGET fretwork)
  install(TARGETS fretwork RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY docs/schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/fretwork FILES_MATCHING PATTERN "*.schema.json")
endif()

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fretwork)
install(EXPORT fretworkTargets NAMESPACE fretwork:: DESTINATION ${config_dir})
configure_package_config_file(cmake/fretworkConfig.cmake.in "${PROJECT_BINARY_DIR}/fretworkConfig.cmake"
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file("${PROJECT_BINARY_DIR}/fretworkConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/fretworkConfig.cmake" "${PROJECT_BINARY_DIR}/fretworkConfigVersion.cmake"
        DESTINATION ${config_dir})
if(NOT FRETWORK_SHARED_LIBRARY)
  install(FILES cmake/Dependencies.cmake cmake/FindCHOLMOD.cmake DESTINATION ${config_dir})
endif()
