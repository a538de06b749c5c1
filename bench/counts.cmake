cmake_minimum_required(VERSION 3.22)
# Counts the instructions of counts.c under callgrind, and fails where one of them is more than 3 % from counts.txt: a
# count above is a loss; one below is a gain, which the next loss could use up unseen until it is in the table.
#
#     cmake -DPROGRAM=... -DVALGRIND=... -DCOMPILER="GNU 12.2.0 Release" -DTABLE=bench/counts.txt -DWORK=folder
#           [-DWRITE=1] -P counts.cmake
#
# Counts belong to a compiler and the build type, which stand in the first line of counts.txt: with another one the
# test fails. Leave out its label, counts, there.
# A count that is to change changes counts.txt in the same commit, which says why: the target counts_write writes it.
file(STRINGS "${TABLE}" table)
list(POP_FRONT table compiler)
if(NOT WRITE AND NOT compiler STREQUAL "# ${COMPILER}")
  message(FATAL_ERROR "${TABLE} has the counts of '${compiler}', this is ${COMPILER}: leave out the label counts, or "
    "build counts_write and commit the table")
endif()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
execute_process(COMMAND "${VALGRIND}" --tool=callgrind -q "--callgrind-out-file=${WORK}/counts" "${PROGRAM}"
  RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE said)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "callgrind gave ${code}: ${said}")
endif()

# counts.1, counts.2 ...: one for each name, in the order in which they were counted.
file(GLOB dumps "${WORK}/counts.*")
list(SORT dumps COMPARE NATURAL)
set(counted "")
set(bad 0)
foreach(dump IN LISTS dumps)
  file(STRINGS "${dump}" lines REGEX "^(desc: Trigger|totals:|summary:)")
  if(NOT lines MATCHES "Client Request: ([^;]+).*(totals|summary): ([0-9]+)")
    continue()
  endif()
  set(name "${CMAKE_MATCH_1}")
  set(count "${CMAKE_MATCH_3}")
  string(APPEND counted "${count} ${name}\n")
  set(before "${table}")
  list(FILTER before INCLUDE REGEX "^[0-9]+ ${name}$")
  if(WRITE)
    continue()
  elseif(NOT before)
    message("${name}: not in the table, ${count} now")
    math(EXPR bad "${bad} + 1")
    continue()
  endif()
  string(REGEX REPLACE " .*" "" before "${before}")
  list(FILTER table EXCLUDE REGEX "^[0-9]+ ${name}$")
  math(EXPR least "${before} * 97 / 100")
  math(EXPR most "${before} * 103 / 100")
  if(count GREATER most)
    message("${name}: ${count} instructions, ${before} in the table")
    math(EXPR bad "${bad} + 1")
  elseif(count LESS least)
    message("${name}: ${count} instructions, fewer than the ${before} in the table: build counts_write")
    math(EXPR bad "${bad} + 1")
  endif()
endforeach()

if(WRITE)
  file(WRITE "${TABLE}" "# ${COMPILER}\n${counted}")
elseif(bad)
  message(FATAL_ERROR "${bad} counts are more than 3 % from ${TABLE}")
elseif(table)
  # AVX2 loops are counted where the processor has them.
  list(FILTER table EXCLUDE REGEX " avx2 ")
  if(table)
    message(FATAL_ERROR "not counted: ${table}")
  endif()
endif()
