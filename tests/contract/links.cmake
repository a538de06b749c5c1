cmake_minimum_required(VERSION 3.22)
# A program of one call, linked with --gc-sections, has no function whose name matches OTHER: the loops of the way that it
# does not use. CONTROL has both ways, so that the name is one of the library's.
foreach(program IN ITEMS "${PROGRAM}" "${CONTROL}")
  execute_process(COMMAND "${NM}" --defined-only "${program}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "nkwi?_[a-z0-9_]*${OTHER}[a-z0-9_]*" found "${symbols}")
  if(found AND program STREQUAL PROGRAM)
    message(SEND_ERROR "links: ${CALL} links ${found}")
  elseif(NOT found AND program STREQUAL CONTROL)
    message(SEND_ERROR "links: no function is named ${OTHER}")
  endif()
endforeach()
