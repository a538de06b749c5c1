cmake_minimum_required(VERSION 3.22)
# Every loop of every instruction set works on whole vectors: its code has packed arithmetic of that set's registers. A
# loop that silently stops vectorising fails here. Loops that only move or unpack data have none and are named.
# Those of skinning call functions nkwi_skin_... that have it.
# Columns of 4x4 matrices, one or two at a time on every set.
set(fours palette_4x4 palette_3x4 models_from_locals)
set(packed_fours "v?(mul|add)ps .*%[xy]mm")
# Eight lanes at a time, on AVX-512 too.
set(eights models_from_pose models_from_records)
set(moves vec3_unpack vec3_pack quat_unpack quat_pack mat4_unpack mat4_pack
  pose_from_trs trs_from_pose
  clip_hold skin_linear skin_dual_quat crowd_from_poses crowd_to_matrices)
set(packed_generic "(mul|add|sub|div|sqrt)p[sd] .*%xmm")
set(packed_avx2 "v(mul|add|sub|div|sqrt)p[sd] .*%ymm")
set(packed_avx512 "v(mul|add|sub|div|sqrt)p[sd] .*%zmm")

execute_process(COMMAND "${OBJDUMP}" -t "${LIBRARY}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "," ";" ISAS "${ISAS}")
set(checked 0)
foreach(isa IN LISTS ISAS)
  string(REGEX MATCHALL "nkwi?_[a-z0-9_]+_${isa}\n" loops "${symbols}")
  list(REMOVE_DUPLICATES loops)
  foreach(loop IN LISTS loops)
    string(REGEX REPLACE "\n" "" loop "${loop}")
    string(REGEX REPLACE "^nkwi?_|(_n)?_${isa}$" "" name "${loop}")
    if(name IN_LIST moves)
      continue()
    endif()
    execute_process(COMMAND "${OBJDUMP}" -d --no-show-raw-insn "--disassemble=${loop}" "${LIBRARY}"
      OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
    set(packed "${packed_${isa}}")
    if(name IN_LIST fours)
      set(packed "${packed_fours}")
    endif()
    if(name IN_LIST eights AND isa STREQUAL "avx512")
      set(packed "${packed_avx2}")
    endif()
    if(NOT code MATCHES "${packed}")
      message(SEND_ERROR "packed: ${name} is not vectorised for ${isa}")
    endif()
    math(EXPR checked "${checked} + 1")
  endforeach()
endforeach()
message(STATUS "packed: ${checked} loops")
if(checked LESS 50)
  message(SEND_ERROR "packed: too few loops found in ${LIBRARY}")
endif()
