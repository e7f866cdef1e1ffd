# Run by ctest: adds one test for the short cases of each file of WEFT_PROGRAM, which share a device and what it has
# compiled, and one for each case that is "long:".
if(NOT EXISTS ${WEFT_PROGRAM})
  add_test("${WEFT_PREFIX}.NOT_BUILT" ${WEFT_PROGRAM})  # fails: a missing program is no passed test
  return()
endif()
execute_process(COMMAND ${WEFT_PROGRAM} --list-test-cases --reporters=xml
  OUTPUT_VARIABLE listing RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  add_test("${WEFT_PREFIX}.NOT_LISTED" ${WEFT_PROGRAM} --list-test-cases)
  return()
endif()

# A limit ends a hang and says nothing else [s].
function(weft_add_cases NAME LABELS LIMIT)
  add_test("${NAME}" ${WEFT_PROGRAM} ${ARGN} --no-version --no-intro)
  set_tests_properties("${NAME}" PROPERTIES TIMEOUT ${LIMIT} LABELS "${LABELS}"
    ENVIRONMENT "${WEFT_ENVIRONMENT}" FAIL_REGULAR_EXPRESSION "test cases: +0 ")
endfunction()

string(MD5 hash "${WEFT_PREFIX}")
string(SUBSTRING ${hash} 0 6 hash)
math(EXPR part "0x${hash} % 10")
set(files "")
string(REPLACE ";" "\\;" listing "${listing}")
string(REGEX MATCHALL "<TestCase [^\n]*" cases "${listing}")
foreach(row IN LISTS cases)
  string(REGEX REPLACE ".* name=\"([^\"]*)\".*" "\\1" case "${row}")
  string(REGEX REPLACE ".* filename=\"([^\"]*)\".*" "\\1" file "${row}")
  if(NOT case MATCHES "^long:")
    list(APPEND files ${file})
    continue()
  endif()
  foreach(escape "&quot;=\"" "&lt;=<" "&gt;=>" "&amp;=&")
    string(REGEX MATCH "^(.*;)=(.)$" matched "${escape}")
    string(REPLACE "${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}" case "${case}")
  endforeach()
  # One of ten parts, which .ci/run takes in turn: a program's cases, which take alike long, go to one after the other.
  math(EXPR part "(${part} + 1) % 10")
  string(REPLACE "," "\\," filter "${case}")
  weft_add_cases("${WEFT_PREFIX}: ${case}" "long;part${part}" 12000 "--test-case=${filter}")
endforeach()
list(REMOVE_DUPLICATES files)
foreach(file IN LISTS files)
  string(REGEX REPLACE ".*/test_([^/]*)\\.cpp$" "\\1" name ${file})
  weft_add_cases("${WEFT_PREFIX}: ${name}" short 6000 "--source-file=${file}" "--test-case-exclude=long:*")
endforeach()
