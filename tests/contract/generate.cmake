cmake_minimum_required(VERSION 3.22)
# The committed table is what its generator prints. GENERATOR is a Sollya script or a C program.
if(GENERATOR MATCHES "\\.c$")
  execute_process(COMMAND "${CC}" -std=c99 -O2 "${GENERATOR}" -o "${WORK}" -lm COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${WORK}" OUTPUT_VARIABLE made COMMAND_ERROR_IS_FATAL ANY)
else()
  # Sollya's exit status also speaks of roundings on the way.
  execute_process(COMMAND "${SOLLYA}" "${GENERATOR}" OUTPUT_VARIABLE made)
endif()
file(READ "${TABLE}" committed)
if(NOT made STREQUAL committed)
  file(WRITE "${WORK}.made" "${made}")
  message(FATAL_ERROR "${TABLE} is not what ${GENERATOR} prints: see ${WORK}.made")
endif()
