cmake_minimum_required(VERSION 3.22)
# Clang's MSVC mode has rules of its own for inline functions: there too, algebra.c defines each function of the small
# algebra that the headers declare, in a static and in a shared library. No header of Windows is needed: of the C
# library algebra.c needs what follows. There is no vector type: functions of NKW_ALGEBRA_F32X4 are in other files.
file(MAKE_DIRECTORY "${WORK}/include")
file(WRITE "${WORK}/include/math.h" "float sqrtf(float);\n")
file(WRITE "${WORK}/include/string.h" "#include <stddef.h>\nvoid *memcpy(void *, const void *, size_t);\n")

file(GLOB headers "${SOURCE}/include/nakawari/*.h")
set(declared "")
foreach(header IN LISTS headers)
  file(STRINGS "${header}" lines REGEX "^NKW_ALGEBRA(_ROOT)? ")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "(nkw_[a-z0-9_]+)\\(" match "${line}")
    list(APPEND declared "${CMAKE_MATCH_1}")
  endforeach()
endforeach()
list(LENGTH declared count)
if(count LESS 60)
  message(SEND_ERROR "msvc: too few prototypes of the small algebra found")
endif()

foreach(kind IN ITEMS NKW_STATIC NKW_SHARED)
  set(object "${WORK}/${kind}.obj")
  execute_process(COMMAND "${CLANG}" --target=x86_64-pc-windows-msvc -std=c99 -ffreestanding -O2 -Wall -Wextra -Werror
    -DNKW_BUILD "-D${kind}" "-I${WORK}/include" "-I${SOURCE}/src/kernel" "-I${SOURCE}/include" -c "${SOURCE}/src/curve/algebra.c"
    -o "${object}" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${NM}" -g --defined-only "${object}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  foreach(name IN LISTS declared)
    if(NOT symbols MATCHES " T ${name}\n")
      message(SEND_ERROR "msvc: ${kind}: ${name} has a prototype but no symbol")
    endif()
  endforeach()
endforeach()
