# SPDX-License-Identifier: GPL-3.0-or-later
# The studio's page: built by npm where there is a Node.js that fits, into share/fretwork/studio.html beside the
# program's own folder, where the program looks for it. Without it the studio says how to get it.

# fretwork_add_studio_page(<source folder>): the target fretwork_studio_page, part of `all`.
function(fretwork_add_studio_page source)
  include(GNUInstallDirs)
  if(FRETWORK_STUDIO_PAGE)  # built before, where there is a network
    install(FILES "${FRETWORK_STUDIO_PAGE}" DESTINATION "${CMAKE_INSTALL_DATADIR}/fretwork" RENAME studio.html)
    return()
  endif()
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
  install(FILES "${page}" DESTINATION "${CMAKE_INSTALL_DATADIR}/fretwork" OPTIONAL)
endfunction()

# fretwork_add_page_tests(<source folder> <built folder>): the page in a real browser, where there is Chromium. Tests that
# take minutes, and the page's own checks, are long tests.
function(fretwork_add_page_tests source work)
  find_program(FRETWORK_CHROMIUM NAMES chromium chromium-browser)
  if(NOT FRETWORK_NODE OR NOT FRETWORK_NPM OR NOT FRETWORK_CHROMIUM)
    message(STATUS "No Chromium, or no Node.js: the studio is not tested in a browser")
    return()
  endif()
  add_test(NAME studio_page.copy COMMAND "${CMAKE_COMMAND}" -E copy_directory "${source}/tests" "${work}/tests")
  set_tests_properties(studio_page.copy PROPERTIES FIXTURES_SETUP studio_page)
  set(names first_minute)
  if(FRETWORK_LONG_TESTS)
    list(APPEND names studio tools painting files manners loads safety access layouts folders pictures everybody making design looks material parametric retile examples storm)
    add_test(NAME studio_page.checks COMMAND "${FRETWORK_NPM}" run --silent check WORKING_DIRECTORY "${work}")
    set_tests_properties(studio_page.checks PROPERTIES FIXTURES_REQUIRED studio_page TIMEOUT 600)
  endif()
  foreach(name IN LISTS names)
    add_test(NAME studio_page.${name} COMMAND "${CMAKE_COMMAND}" -E env "FRETWORK_PROGRAM=$<TARGET_FILE:fretwork>"
             "FRETWORK_PAGE=${PROJECT_BINARY_DIR}/apps/share/fretwork/studio.html" "FRETWORK_REPOSITORY=${PROJECT_SOURCE_DIR}"
             "FRETWORK_PICTURES=${work}/pictures" "CHROMIUM=${FRETWORK_CHROMIUM}"
             "${FRETWORK_NODE}" "${work}/tests/browser/run.mjs" "${name}.test.mjs")
    set_tests_properties(studio_page.${name} PROPERTIES FIXTURES_REQUIRED studio_page SKIP_RETURN_CODE 77 TIMEOUT 900)
    # The storm lasts ten minutes, and mostly waits: it starts first, and other tests run beside it. Some print times, or record
    # what a page draws in a time: they run alone. Of all others, one runs at a time.
    if(name STREQUAL storm)
      set_tests_properties(studio_page.${name} PROPERTIES COST 1000)
    elseif(name MATCHES "^(first_minute|studio|pictures)$")
      set_tests_properties(studio_page.${name} PROPERTIES RUN_SERIAL ON)
    else()
      set_tests_properties(studio_page.${name} PROPERTIES RESOURCE_LOCK studio_page COST 500)
    endif()
  endforeach()
endfunction()
