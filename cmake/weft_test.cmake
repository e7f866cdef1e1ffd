# weft_test(NAME SOURCES ... [APART ...] IMPORTS rooms... LIBRARIES others... [GPU [DRIVERS lavapipe]])
#
# Sources are compiled six at a time: most of the time goes into headers that they share. Those APART are not, since
# they have file-local names that others of the program have too.
#
# One doctest program for a room; the cases of a file become a ctest test. A GPU program is registered twice, once for
# each software Vulkan driver that ./dev installs: "lavapipe.NAME: FILE" and "swiftshader.NAME: FILE".
# A case whose name begins with "long:" is a ctest test of its own, which ./dev test --long runs (label "long").
add_library(weft_source_path STATIC ${CMAKE_SOURCE_DIR}/tests/source_path.cpp)
target_compile_definitions(weft_source_path PRIVATE WEFT_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
target_include_directories(weft_source_path PUBLIC ${CMAKE_SOURCE_DIR}/tests)
add_library(weft_test_main STATIC ${CMAKE_SOURCE_DIR}/tests/main.cpp)
target_link_libraries(weft_test_main PUBLIC doctest::doctest weft_source_path)
# Compiling the tests takes longer than running the half of them: their own code is not what must be fast, and an
# assertion is a call. The rooms that they use keep their flags.
target_compile_options(weft_test_main INTERFACE $<$<CONFIG:Release>:-O1>)
target_compile_definitions(weft_test_main PUBLIC DOCTEST_CONFIG_SUPER_FAST_ASSERTS)

set(WEFT_ICD_lavapipe /usr/share/vulkan/icd.d/lvp_icd.x86_64.json)
set(WEFT_ICD_swiftshader /usr/lib/chromium/vk_swiftshader_icd.json)

function(weft_test NAME)
  cmake_parse_arguments(TEST "GPU" "" "SOURCES;APART;IMPORTS;LIBRARIES;DRIVERS" ${ARGN})
  if(NOT TEST_DRIVERS)
    set(TEST_DRIVERS lavapipe swiftshader)
  endif()
  list(TRANSFORM TEST_IMPORTS PREPEND weft_)
  add_executable(test_${NAME} ${TEST_SOURCES} ${TEST_APART})
  target_link_libraries(test_${NAME} PRIVATE ${TEST_IMPORTS} ${TEST_LIBRARIES} weft_test_main)
  set_target_properties(test_${NAME} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
  if(TEST_APART)
    set_source_files_properties(${TEST_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  if(TEST_GPU)
    foreach(driver ${TEST_DRIVERS})
      # lavapipe without threads of its own: ctest runs as many programs as there are cores.
      weft_discover(${NAME} ${driver}.
        "VK_DRIVER_FILES=${WEFT_ICD_${driver}};VK_ICD_FILENAMES=${WEFT_ICD_${driver}};LP_NUM_THREADS=0")
    endforeach()
  else()
    weft_discover(${NAME} "" "")
  endif()
endfunction()

# Asks the program for its cases when ctest starts, so that a test list is never older than the program.
function(weft_discover NAME PREFIX ENVIRONMENT)
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${PREFIX}${NAME}_tests.cmake)
  file(WRITE ${script} "set(WEFT_PROGRAM \"${CMAKE_BINARY_DIR}/test_${NAME}\")
set(WEFT_PREFIX \"${PREFIX}${NAME}\")
set(WEFT_ENVIRONMENT \"${ENVIRONMENT}\")
include(\"${CMAKE_SOURCE_DIR}/cmake/weft_list_tests.cmake\")
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${script})
endfunction()
