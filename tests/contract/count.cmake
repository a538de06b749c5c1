# Fails where the build has fewer tests than NKW_TESTS_LEAST: a test is left out where its tool is missing (sollya,
# valgrind, objdump, another compiler), and a run without it looks the same. Each preset states its number as a cache
# variable. To be included after all tests were added.
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
message(STATUS "nakawari: ${count} tests")
if(count LESS NKW_TESTS_LEAST)
  list(JOIN tests "\n  " names)
  message(FATAL_ERROR "This build has ${count} tests, its preset states ${NKW_TESTS_LEAST} (NKW_TESTS_LEAST). A tool is "
    "missing, as the messages above say, or the number is to be changed. The tests:\n  ${names}")
endif()
