# SPDX-License-Identifier: GPL-3.0-or-later
# The studio's page: built by npm where there is a Node.js that fits, into share/fretwork/studio.html beside the
# program's own folder, where the program looks for it. Without it the studio says how to get it.

# fretwork_add_studio_page(<source folder>): the target fretwork_studio_page, part of `all`.
function(fretwork_add_studio_page source)
  find_program(FRETWORK_NODE NAMES node nodejs)
  find_program(FRETWORK_NPM npm)
  if(NOT FRETWORK_NODE OR NOT FRETWORK_NPM)
    message(STATUS "No Node.js with npm: the studio's page is not built (make studio installs them)")
    return()
  endif()
  execute_process(COMMAND "${FRETWORK_NODE}" --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REGEX REPLACE "^v" "" version "${version}")
  if(version VERSION_LESS 18.18)
    message(STATUS "Node.js ${version} is older than 18.18: the studio's page is not built")
    return()
  endif()
  set(work "${CMAKE_CURRENT_BINARY_DIR}/page")
  set(page "${PROJECT_BINARY_DIR}/apps/share/fretwork/studio.html")
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${source}/src/*")
  list(APPEND files "${source}/index.html" "${source}/package.json" "${source}/package-lock.json"
       "${source}/tsconfig.json" "${source}/vite.config.ts")
  add_custom_command(OUTPUT "${page}"
    COMMAND "${CMAKE_COMMAND}" -D "NPM=${FRETWORK_NPM}" -D "SOURCE=${source}" -D "WORK=${work}" -D "PAGE=${page}"
            -P "${PROJECT_SOURCE_DIR}/cmake/build_studio_page.cmake"
    DEPENDS ${files} "${PROJECT_SOURCE_DIR}/cmake/build_studio_page.cmake"
    COMMENT "Building the studio's page" VERBATIM)
  add_custom_target(fretwork_studio_page ALL DEPENDS "${page}")
  include(GNUInstallDirs)
  install(FILES "${page}" DESTINATION "${CMAKE_INSTALL_DATADIR}/fretwork" OPTIONAL)
endfunction()
