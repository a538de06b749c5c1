cmake_minimum_required(VERSION 3.22)
# The page names the table's SHA-256. With -DWRITE=ON it is put right instead.
#     cmake -DPAGE=docs/determinism.md -DTABLE=tests/golden/golden.txt -P tests/golden/page.cmake
file(SHA256 "${TABLE}" hash)
file(READ "${PAGE}" page)
string(REGEX MATCH "SHA-256 is\n`([0-9a-f]*)`" said "${page}")
if(NOT said)
  message(FATAL_ERROR "${PAGE} does not say what the table's SHA-256 is")
elseif(WRITE)
  string(REPLACE "`${CMAKE_MATCH_1}`" "`${hash}`" page "${page}")
  file(WRITE "${PAGE}" "${page}")
elseif(NOT CMAKE_MATCH_1 STREQUAL hash)
  message(FATAL_ERROR "${PAGE} says ${CMAKE_MATCH_1}; the table has ${hash}: build the target golden_write")
endif()
