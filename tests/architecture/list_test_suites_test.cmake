# SPDX-License-Identifier: GPL-3.0-or-later
# The suites of a test program, as CTest finds them in builds with sanitizers: plain ones, those with a prefix, and those of types, whose
# names may hold a dot. Usage: cmake -D LISTER=list_test_suites.cmake -D FOLDER=FOLDER -P list_test_suites_test.cmake
set(program "${FOLDER}/listed_tests.sh")
set(list "${FOLDER}/listed_tests.cmake")

# list_suites(TEXT RESULT): what the lister makes of a program that prints the text.
function(list_suites text result)
  file(WRITE "${program}" "#!/bin/sh\ncat <<'END'\n${text}END\n")
  file(CHMOD "${program}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  file(REMOVE "${list}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -D "PROGRAM=${program}" -D "LIST=${list}" -D LABEL=stage -D ENVIRONMENT=A=b -D "FOLDER=${FOLDER}" -P "${LISTER}"
                  RESULT_VARIABLE code ERROR_QUIET)
  set(${result} ${code} PARENT_SCOPE)
endfunction()

list_suites([==[
Running main() from ./googletest/src/gtest_main.cc
file.cc:12: a line that is no suite
Plain.
  Law
Fuzz/Readers.
  TakeExamples/0  # GetParam() = "a.b; [c"
Typed/0.  # TypeParam = std::pair<a.b, c>
  Law
Version/2.5.  # TypeParam = int
  Law
]==] code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "a list with suites is refused")
endif()
file(STRINGS "${list}" tests REGEX "^add_test")
set(expected "")
foreach(suite Plain Fuzz/Readers Typed/0 Version/2.5)
  list(APPEND expected "add_test([==[stage.${suite}]==] [==[${program}]==] [==[--gtest_filter=${suite}.*]==])")
endforeach()
string(REPLACE ";" "\n" tests "${tests}")
string(REPLACE ";" "\n" expected "${expected}")
if(NOT tests STREQUAL expected)
  message(FATAL_ERROR "listed:\n${tests}\nexpected:\n${expected}")
endif()

list_suites("Running main()\n" code)
if(code EQUAL 0)
  message(FATAL_ERROR "a program without tests is taken")
endif()
