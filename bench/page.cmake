cmake_minimum_required(VERSION 3.22)
# Generates docs/performance.md and docs/figures/performance-*.svg from results and from page.md.
#
#     cmake -DTABLE=... -DPLOT=... -DROOT=repository [-DRESULTS=folder -DFILTER=...] [-DCHECK=folder] -P page.cmake
#
# RESULTS  takes the one file of a run of all benchmarks into bench/results first
# CHECK    draws into this folder instead, and fails unless the repository has the same
if(RESULTS)
  file(GLOB csv "${RESULTS}/*.csv")
  if(NOT csv)
    message(FATAL_ERROR "no results in ${RESULTS}")
  endif()
  if(NOT FILTER STREQUAL ".")
    message(FATAL_ERROR "only some benchmarks were run: NKW_BENCH_FILTER is ${FILTER}")
  endif()
  file(COPY "${csv}" DESTINATION "${ROOT}/bench/results")
  cmake_path(GET csv STEM processor)
else()
  file(STRINGS "${ROOT}/docs/performance.md" named REGEX "bench/results/[^ ]+\\.csv`" LIMIT_COUNT 1)
  string(REGEX REPLACE ".*bench/results/([^`]+)\\.csv`.*" "\\1" processor "${named}")
endif()
set(csv "${ROOT}/bench/results/${processor}.csv")
set(docs "${ROOT}/docs")
if(CHECK)
  set(docs "${CHECK}")
  file(REMOVE_RECURSE "${CHECK}")
  file(MAKE_DIRECTORY "${CHECK}/figures")
endif()

file(READ "${CMAKE_CURRENT_LIST_DIR}/page.md" page)
string(REPLACE "@PROCESSOR@" "${processor}" page "${page}")
foreach(build IN ITEMS x86-64 x86-64-v3 x86-64-v4)
  execute_process(COMMAND "${TABLE}" --markdown "${csv}" ${build} OUTPUT_VARIABLE tables COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "@TABLES ${build}@" "${tables}" page "${page}")
endforeach()
execute_process(COMMAND "${TABLE}" --losses "${csv}" "${CMAKE_CURRENT_LIST_DIR}/losses.txt" OUTPUT_VARIABLE tables
  COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "@LOSSES@" "${tables}" page "${page}")
execute_process(COMMAND "${TABLE}" --growth "${csv}" x86-64-v3 OUTPUT_VARIABLE tables COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "@GROWTH@" "${tables}" page "${page}")
file(WRITE "${docs}/performance.md" "${page}")
execute_process(COMMAND "${PLOT}" "${csv}" "${docs}/figures" COMMAND_ERROR_IS_FATAL ANY)
if(NOT CHECK)
  return()
endif()

file(GLOB drawn RELATIVE "${CHECK}" "${CHECK}/figures/*.svg")
foreach(name IN LISTS drawn ITEMS performance.md)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E compare_files --ignore-eol "${CHECK}/${name}" "${ROOT}/docs/${name}"
    RESULT_VARIABLE differ)
  if(differ)
    message(SEND_ERROR "docs/${name} differs from ${csv} and page.md: build the target bench_page")
  endif()
endforeach()
