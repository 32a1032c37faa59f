# SPDX-License-Identifier: GPL-3.0-or-later
# Write the file LIST, in which CTest finds each suite of the test program PROGRAM as a test LABEL.SUITE.
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests WORKING_DIRECTORY "${FOLDER}"
                OUTPUT_VARIABLE lines COMMAND_ERROR_IS_FATAL ANY)
# A suite is a line by itself, from its start to a dot at its end; tests are indented. Types and parameters stand behind two spaces and a #.
string(REGEX REPLACE "  # [^\n]*" "" lines "${lines}")
string(REGEX MATCHALL "(^|\n)[^ \n]+\\.\n" suites "${lines}")
if(NOT suites)
  message(FATAL_ERROR "${PROGRAM} lists no suites of tests")
endif()
set(tests "")
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  set(test "[==[${LABEL}.${suite}]==]")
  string(REPLACE ".]==]" "]==]" test "${test}")
  string(APPEND tests "add_test(${test} [==[${PROGRAM}]==] [==[--gtest_filter=${suite}*]==])\n"
                      "set_tests_properties(${test} PROPERTIES LABELS ${LABEL} WORKING_DIRECTORY [==[${FOLDER}]==]"
                      " ENVIRONMENT [==[${ENVIRONMENT}]==])\n")
endforeach()
file(WRITE "${LIST}" "${tests}")
