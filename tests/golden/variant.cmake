cmake_minimum_required(VERSION 3.22)
# Compiles the library's sources by CC with STD and FLAGS. Then, for each of DRIVERS, compiles golden.c by it with FLAGS,
# links, runs, and compares the hashes with TABLE. A driver that is not CC compiles golden.c as C++.
# The inputs must not depend on the flags: those files are compiled without contraction. LINK and EMULATOR: another system's.
file(MAKE_DIRECTORY "${WORK}")
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
separate_arguments(link UNIX_COMMAND "${LINK}")
file(GLOB sources RELATIVE "${SOURCE}" "${SOURCE}/src/*.c" "${SOURCE}/src/batch/*.c" "${SOURCE}/src/simd/*.c")
file(GLOB inputs RELATIVE "${SOURCE}" "${SOURCE}/tests/support/data_*.c" "${SOURCE}/tests/support/random*.c"
  "${SOURCE}/docs/examples/joint_local.c" "${SOURCE}/docs/examples/matrix_stack.c")
set(objects "")
foreach(source IN LISTS sources inputs)
  string(REPLACE "/" "_" name "${source}")
  set(object "${WORK}/${name}.o")
  list(APPEND objects "${object}")
  set(steady "")
  if(source IN_LIST inputs)
    set(steady -ffp-contract=off)
  endif()
  execute_process(COMMAND "${CC}" "-std=${STD}" ${flags} ${steady} -DNKW_BUILD "-I${SOURCE}/include" "-I${SOURCE}/src" -c "${SOURCE}/${source}" -o "${object}"
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
string(REPLACE "," ";" drivers "${DRIVERS}")
foreach(driver IN LISTS drivers)
  set(language -x c++)
  if(driver STREQUAL CC)
    set(language "-std=${STD}")
  endif()
  execute_process(COMMAND "${driver}" ${flags} "-I${SOURCE}/include" ${language} "${SOURCE}/tests/golden/golden.c" -x none
    ${objects} ${link} -lm -o "${WORK}/golden.exe" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${EMULATOR} "${WORK}/golden.exe" "${TABLE}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
