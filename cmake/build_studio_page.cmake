# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the page in a folder of the build tree: cmake -D NPM=.. -D SOURCE=.. -D WORK=.. -D PAGE=.. -P this file
# A machine that cannot reach npm's registry gets a message and no page; the program itself is built all the same.
file(REMOVE_RECURSE "${WORK}/src")
file(COPY "${SOURCE}/" DESTINATION "${WORK}" PATTERN node_modules EXCLUDE PATTERN dist EXCLUDE PATTERN tests EXCLUDE)

set(installed "${WORK}/node_modules/.package-lock.json")
if(NOT EXISTS "${installed}" OR "${SOURCE}/package-lock.json" IS_NEWER_THAN "${installed}")
  execute_process(COMMAND "${NPM}" ci --no-audit --no-fund --prefer-offline --fetch-retries=1 --loglevel=error
                  WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE result OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(NOT result EQUAL 0)
    message(WARNING "npm could not install what the studio's page is built with; the studio will say that its page is "
                    "missing. npm said:\n${log}")
    return()
  endif()
endif()

execute_process(COMMAND "${NPM}" run --silent build WORKING_DIRECTORY "${WORK}"
                RESULT_VARIABLE result OUTPUT_VARIABLE log ERROR_VARIABLE log)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the studio's page could not be built:\n${log}")
endif()
get_filename_component(folder "${PAGE}" DIRECTORY)
file(MAKE_DIRECTORY "${folder}")
configure_file("${WORK}/dist/index.html" "${PAGE}" COPYONLY)
file(TOUCH "${PAGE}")
