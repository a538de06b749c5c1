cmake_minimum_required(VERSION 3.22)
# Builds for systems that are not here: clang-cl for Windows, and Clang for macOS with one and with two architectures.
# Three files of each are compiled with the flags that CMake has for them, warnings being errors. Of the C library they
# need what is written here.
unset(ENV{CMAKE_C_COMPILER_LAUNCHER}) # ccache does not know the objects of clang-cl
set(sdk "${WORK}/sdk/usr/include")
file(MAKE_DIRECTORY "${sdk}" "${WORK}/bin")
file(WRITE "${sdk}/math.h" "float sqrtf(float);\nfloat fabsf(float);\ndouble sqrt(double);\n"
  "#define INFINITY __builtin_inff()\n#define NAN __builtin_nanf(\"\")\n")
file(WRITE "${sdk}/string.h" "#include <stddef.h>\nvoid *memcpy(void *, const void *, size_t);\n"
  "void *memmove(void *, const void *, size_t);\nvoid *memset(void *, int, size_t);\n"
  "int memcmp(const void *, const void *, size_t);\nsize_t strlen(const char *);\n")
file(WRITE "${sdk}/stdlib.h" "#include <stddef.h>\nvoid *malloc(size_t);\nvoid free(void *);\n"
  "int posix_memalign(void **, size_t, size_t);\n")
# Clang joins the objects of two architectures by a program of this name.
file(CREATE_LINK "${NKW_llvm_lipo}" "${WORK}/bin/lipo" SYMBOLIC)
set(ENV{PATH} "${WORK}/bin:$ENV{PATH}")

# Configures with the arguments, and returns the log of compiling the files whose objects match a pattern.
function(compile name pattern)
  set(build "${WORK}/${name}")
  file(REMOVE_RECURSE "${build}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${build}" -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
    -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY -DNKW_BUILD_TESTS=OFF -DNKW_BUILD_EXAMPLES=OFF -DNKW_IMPORT=OFF
    -DNKW_COMMAND=OFF -DNKW_WARNINGS_AS_ERRORS=ON ${ARGN} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(READ "${build}/compile_commands.json" commands)
  string(JSON count LENGTH "${commands}")
  math(EXPR last "${count} - 1")
  set(compiled 0)
  foreach(i RANGE ${last})
    string(JSON command GET "${commands}" ${i} command)
    string(JSON folder GET "${commands}" ${i} directory)
    if(command MATCHES "${pattern}")
      execute_process(COMMAND sh -c "${command}" WORKING_DIRECTORY "${folder}" RESULT_VARIABLE result
        OUTPUT_VARIABLE log ERROR_VARIABLE log)
      if(NOT result EQUAL 0 OR NOT log STREQUAL "")
        message(SEND_ERROR "toolchains: ${name}: ${command}\n${log}")
      endif()
      math(EXPR compiled "${compiled} + 1")
    endif()
  endforeach()
  set(compiled ${compiled} PARENT_SCOPE)
endfunction()

function(expect name number)
  if(NOT compiled EQUAL number)
    message(SEND_ERROR "toolchains: ${name}: ${compiled} files were compiled, not ${number}")
  endif()
endfunction()

# The number of lines with 256-bit registers in the part of an object for an architecture.
function(wide name architecture out)
  set(object "${WORK}/${name}/src/CMakeFiles/nakawari_avx2.dir/kernel/batch/vec.c.o")
  execute_process(COMMAND "${NKW_llvm_objdump}" -d "--arch=${architecture}" "${object}" OUTPUT_VARIABLE text
    ERROR_VARIABLE ignored RESULT_VARIABLE result)
  string(REGEX MATCHALL "%ymm[0-9]" found "${text}")
  list(LENGTH found count)
  if(NOT text MATCHES "nkw_")
    message(SEND_ERROR "toolchains: ${name} has no part for ${architecture}")
  endif()
  set(${out} ${count} PARENT_SCOPE)
endfunction()

set(files "(batch.vec|clip_build|simd.vec)\\.c( |$)")
compile(clang-cl "${files}" -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_SYSTEM_PROCESSOR=AMD64 "-DCMAKE_C_COMPILER=${NKW_clang_cl}"
  -DCMAKE_C_COMPILER_TARGET=x86_64-pc-windows-msvc "-DCMAKE_AR=${NKW_llvm_lib}" "-DCMAKE_LINKER=${NKW_llvm_lib}"
  "-DCMAKE_MT=${CMAKE_COMMAND}" "-DCMAKE_C_FLAGS=/clang:-isystem${sdk}")
expect(clang-cl 5) # the loops three times

set(apple -DCMAKE_SYSTEM_NAME=Darwin -DCMAKE_SYSTEM_PROCESSOR=x86_64 "-DCMAKE_C_COMPILER=${NKW_clang}"
  -DCMAKE_C_COMPILER_TARGET=x86_64-apple-macos11 "-DCMAKE_OSX_SYSROOT=${WORK}/sdk" "-DCMAKE_AR=${NKW_llvm_ar}"
  "-DCMAKE_RANLIB=${NKW_llvm_ranlib}")
compile(macos-arm64 "${files}" ${apple} -DCMAKE_OSX_ARCHITECTURES=arm64)
expect(macos-arm64 3) # the baseline alone
compile(macos-both "${files}" ${apple} "-DCMAKE_OSX_ARCHITECTURES=x86_64\\;arm64")
expect(macos-both 5)
wide(macos-both x86_64 count)
if(count EQUAL 0)
  message(SEND_ERROR "toolchains: the x86-64 part has no AVX2 loops")
endif()
wide(macos-both arm64 count)
if(count GREATER 0)
  message(SEND_ERROR "toolchains: the arm64 part has AVX2 instructions")
endif()
