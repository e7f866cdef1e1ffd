# Run by ctest: adds one test for each case of WEFT_PROGRAM.
if(NOT EXISTS ${WEFT_PROGRAM})
  add_test("${WEFT_PREFIX}.NOT_BUILT" ${WEFT_PROGRAM})  # fails: a missing program is no passed test
  return()
endif()
execute_process(COMMAND ${WEFT_PROGRAM} --list-test-cases --no-version --no-intro
  OUTPUT_VARIABLE listing RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  add_test("${WEFT_PREFIX}.NOT_LISTED" ${WEFT_PROGRAM} --list-test-cases)
  return()
endif()
string(REPLACE ";" "\\;" listing "${listing}")
string(REPLACE "\n" ";" listing "${listing}")
foreach(case IN LISTS listing)
  if(case MATCHES "^(\\[doctest\\]|===)" OR case STREQUAL "")
    continue()
  endif()
  string(REPLACE "," "\\," filter "${case}")
  add_test("${WEFT_PREFIX}: ${case}" ${WEFT_PROGRAM} "--test-case=${filter}" --no-version --no-intro)
  set(labels "short")
  set(limit 1200)  # s; ends a hang and says nothing else
  if(case MATCHES "^long:")
    set(labels "long")
    set(limit 12000)
  endif()
  set_tests_properties("${WEFT_PREFIX}: ${case}" PROPERTIES TIMEOUT ${limit} LABELS "${labels}"
    ENVIRONMENT "${WEFT_ENVIRONMENT}" FAIL_REGULAR_EXPRESSION "test cases: +0 ")
endforeach()
