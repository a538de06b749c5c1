# Draws the figures into the fresh folder OUT by PROGRAM; fails unless COMMITTED holds the same files with the same bytes
# (but for line ends), each below 150 kB.
file(REMOVE_RECURSE "${OUT}")
file(MAKE_DIRECTORY "${OUT}")
execute_process(COMMAND "${PROGRAM}" "${OUT}" COMMAND_ERROR_IS_FATAL ANY)

file(GLOB drawn RELATIVE "${OUT}" "${OUT}/*.svg")
file(GLOB committed RELATIVE "${COMMITTED}" "${COMMITTED}/*.svg")
list(FILTER committed EXCLUDE REGEX "^(command|coursework|joints|performance)-")
if(NOT drawn STREQUAL committed)
  message(FATAL_ERROR "drawn: ${drawn}\ncommitted: ${committed}")
endif()
foreach(name IN LISTS drawn)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E compare_files --ignore-eol "${OUT}/${name}" "${COMMITTED}/${name}"
    RESULT_VARIABLE differ)
  file(SIZE "${OUT}/${name}" size)
  if(differ OR size GREATER 150000)
    message(SEND_ERROR "${name} (${size} bytes) is stale or too large: build the target `figures` and look at it")
  endif()
endforeach()
