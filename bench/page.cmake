cmake_minimum_required(VERSION 3.25)
# Takes the results of the last run into the repository: bench/results/<processor>.csv, and docs/performance.md drawn
# from them.
#
#     cmake -DTABLE=... -DRESULTS=folder -DROOT=repository -P page.cmake
file(GLOB csv "${RESULTS}/*.csv")
if(NOT csv)
  message(FATAL_ERROR "no results: cmake --workflow --preset bench comes first")
endif()
cmake_path(GET csv STEM processor)
file(COPY "${csv}" DESTINATION "${ROOT}/bench/results")

file(READ "${CMAKE_CURRENT_LIST_DIR}/page.md" page)
string(REPLACE "@PROCESSOR@" "${processor}" page "${page}")
foreach(build IN ITEMS x86-64 x86-64-v3)
  execute_process(COMMAND "${TABLE}" --markdown "${csv}" ${build} OUTPUT_VARIABLE tables COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "@TABLES ${build}@" "${tables}" page "${page}")
endforeach()
file(WRITE "${ROOT}/docs/performance.md" "${page}")
