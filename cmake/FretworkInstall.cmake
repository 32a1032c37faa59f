# SPDX-License-Identifier: GPL-3.0-or-later
# The files of `cmake --install`, so that find_package(fretwork) gives the targets fretwork::<stage>.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(stages GLOBAL PROPERTY FRETWORK_STAGES)
install(TARGETS ${stages} EXPORT fretworkTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} FILE_SET HEADERS)
if(TARGET fretwork)
  install(TARGETS fretwork RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fretwork)
install(EXPORT fretworkTargets NAMESPACE fretwork:: DESTINATION ${config_dir})
configure_package_config_file(cmake/fretworkConfig.cmake.in "${PROJECT_BINARY_DIR}/fretworkConfig.cmake"
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file("${PROJECT_BINARY_DIR}/fretworkConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/fretworkConfig.cmake" "${PROJECT_BINARY_DIR}/fretworkConfigVersion.cmake"
              cmake/Dependencies.cmake cmake/FindCHOLMOD.cmake
        DESTINATION ${config_dir})
