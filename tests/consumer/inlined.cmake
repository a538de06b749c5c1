cmake_minimum_required(VERSION 3.22)
# Compiles inlined.c by CC with FLAGS, and once more so that it calls LIBRARY; then links both with the comparison and
# runs it. The inputs must not depend on the flags.
file(MAKE_DIRECTORY "${WORK}")
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
set(here "${SOURCE}/tests/consumer")
set(support "${SOURCE}/tests/support")
function(compile name file)
  execute_process(COMMAND ${ARGN} "-I${SOURCE}/include" "-I${support}" -c "${file}" -o "${WORK}/${name}.o"
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()
compile(inlined "${here}/inlined.c" "${CC}" ${flags})
compile(called "${here}/inlined.c" "${PLAIN}" -std=c99 -ffp-contract=off -DNKW_NO_INLINE)
compile(main "${here}/inlined_main.c" "${PLAIN}" -std=c99 -ffp-contract=off)
compile(random "${support}/random.c" "${PLAIN}" -std=c99 -ffp-contract=off)
execute_process(COMMAND "${PLAIN}" "${WORK}/called.o" "${WORK}/inlined.o" "${WORK}/main.o" "${WORK}/random.o" "${LIBRARY}"
  -o "${WORK}/inlined.exe" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${EMULATOR} "${WORK}/inlined.exe" COMMAND_ERROR_IS_FATAL ANY)
