cmake_minimum_required(VERSION 3.22)
# Counts the instructions and the mispredicted branches of programs under callgrind, and fails where one of them is too
# far from counts.txt: instructions by more than 3 %, branches by more than 3 % and 32, of 1024 elements: the simulated
# predictor goes by addresses, and the same code at another address has up to 20 more. A count above is a loss; one below
# is a gain, which the next loss could use up unseen until it is in the table.
#
#     cmake "-DPROGRAMS=a|b" -DVALGRIND=... -DCOMPILER="GNU 12.2.0 Release" -DTABLE=bench/counts.txt -DWORK=folder
#           [-DWRITE=1] -P counts.cmake
#
# A line of the table: instructions, mispredicted branches, name. callgrind predicts branches as cachegrind does
# (--branch-sim=yes), the same on every processor. Counts belong to a compiler and the build type, which stand in the
# first line: with another one the test fails. Leave out its label, counts, there.
# A count that is to change changes counts.txt in the same commit, which says why: the target counts_write writes it.
string(REPLACE "|" ";" PROGRAMS "${PROGRAMS}")
file(STRINGS "${TABLE}" table)
list(POP_FRONT table compiler)
if(NOT WRITE AND NOT compiler STREQUAL "# ${COMPILER}")
  message(FATAL_ERROR "${TABLE} has the counts of '${compiler}', this is ${COMPILER}: leave out the label counts, or "
    "build counts_write and commit the table")
endif()

file(REMOVE_RECURSE "${WORK}")
foreach(program IN LISTS PROGRAMS)
  cmake_path(GET program FILENAME name)
  file(MAKE_DIRECTORY "${WORK}/${name}")
endforeach()
# counts.1, counts.2 ...: one for each name, in the order in which they were counted.
set(dumps "")
foreach(program IN LISTS PROGRAMS)
  cmake_path(GET program FILENAME name)
  execute_process(COMMAND "${VALGRIND}" --tool=callgrind --branch-sim=yes -q
    "--callgrind-out-file=${WORK}/${name}/counts" "${program}"
    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "callgrind gave ${code}: ${said}")
  endif()
  file(GLOB new "${WORK}/${name}/counts.*")
  list(SORT new COMPARE NATURAL)
  list(APPEND dumps ${new})
endforeach()

# Where `count` is above or below `before` by more than 3 % and `more`.
function(compare name what count before more)
  math(EXPR least "${before} * 97 / 100 - ${more}")
  math(EXPR most "${before} * 103 / 100 + ${more}")
  if(count GREATER most)
    message("${name}: ${count} ${what}, ${before} in the table")
  elseif(count LESS least)
    message("${name}: ${count} ${what}, fewer than the ${before} in the table: build counts_write")
  else()
    return()
  endif()
  math(EXPR bad "${bad} + 1")
  set(bad "${bad}" PARENT_SCOPE)
endfunction()

set(counted "")
set(bad 0)
foreach(dump IN LISTS dumps)
  file(STRINGS "${dump}" lines REGEX "^(desc: Trigger|totals:|summary:)")
  # Ir Bc Bcm Bi Bim; zeros at the end are left out.
  if(NOT lines MATCHES "Client Request: ([^;]+).*(totals|summary): ([0-9]+)( [0-9]+)?( [0-9]+)?( [0-9]+)?( [0-9]+)?")
    continue()
  endif()
  set(name "${CMAKE_MATCH_1}")
  set(count "${CMAKE_MATCH_3}")
  string(STRIP "${CMAKE_MATCH_5}" conditional)
  string(STRIP "${CMAKE_MATCH_7}" indirect)
  math(EXPR misses "0 + 0${conditional} + 0${indirect}" OUTPUT_FORMAT DECIMAL)
  string(APPEND counted "${count} ${misses} ${name}\n")
  if(WRITE)
    continue()
  endif()
  string(REPLACE "+" "[+]" pattern "${name}")
  set(before "${table}")
  list(FILTER before INCLUDE REGEX "^[0-9]+ [0-9]+ ${pattern}$")
  if(NOT before MATCHES "^([0-9]+) ([0-9]+) ")
    message("${name}: not in the table, ${count} and ${misses} now")
    math(EXPR bad "${bad} + 1")
    continue()
  endif()
  set(before "${CMAKE_MATCH_1}")
  set(before_misses "${CMAKE_MATCH_2}")
  list(FILTER table EXCLUDE REGEX "^[0-9]+ [0-9]+ ${pattern}$")
  compare("${name}" "instructions" ${count} ${before} 0)
  compare("${name}" "mispredicted branches" ${misses} ${before_misses} 32)
endforeach()

if(WRITE)
  file(WRITE "${TABLE}" "# ${COMPILER}\n${counted}")
elseif(bad)
  message(FATAL_ERROR "${bad} counts are too far from ${TABLE}")
elseif(table)
  # AVX2 loops are counted where the processor has them.
  list(FILTER table EXCLUDE REGEX " avx2 ")
  if(table)
    message(FATAL_ERROR "not counted: ${table}")
  endif()
endif()
