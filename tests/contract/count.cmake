# Fails where the build does not have exactly NKW_TEST_COUNT tests: a test is left out where its tool is missing (sollya,
# valgrind, objdump, another compiler, the models' data), and a run without it looks the same. A preset states its count
# as a cache variable; a new test changes it in the same commit. To be included after all tests were added.
function(nkw_tests_below directory out)
  get_property(tests DIRECTORY "${directory}" PROPERTY TESTS)
  get_property(subdirectories DIRECTORY "${directory}" PROPERTY SUBDIRECTORIES)
  foreach(subdirectory IN LISTS subdirectories)
    nkw_tests_below("${subdirectory}" more)
    list(APPEND tests ${more})
  endforeach()
  set(${out} ${tests} PARENT_SCOPE)
endfunction()

nkw_tests_below("${PROJECT_SOURCE_DIR}" tests)
list(LENGTH tests count)
if(NOT count EQUAL NKW_TEST_COUNT)
  list(JOIN tests "\n  " names)
  message(FATAL_ERROR "This build has ${count} tests, its preset states ${NKW_TEST_COUNT} (NKW_TEST_COUNT). Is a tool "
    "missing, or is the number to be changed? The tests:\n  ${names}")
endif()
