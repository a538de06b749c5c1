cmake_minimum_required(VERSION 3.22)
# HOW install: installs the library of BUILD, and moves the installed tree to INSTALLED. HOW compile: compiles it before,
# as KIND with the definitions LIBRARY. Another HOW: configures, builds and runs the project beside this file, which comes
# to the library in that way.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
set(shared OFF)
if(KIND STREQUAL "shared")
  set(shared ON)
endif()

string(REPLACE "," ";" library "${LIBRARY}")

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

if(HOW STREQUAL "compile")
  set(BUILD "${WORK}/library")
  run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BUILD}" "-DCMAKE_C_COMPILER=${CC}" "-DBUILD_SHARED_LIBS=${shared}"
    -DNKW_BUILD_TESTS=OFF -DNKW_BUILD_EXAMPLES=OFF ${library})
  run("${CMAKE_COMMAND}" --build "${BUILD}")
  if(shared AND NM AND OBJDUMP)
    run("${CMAKE_COMMAND}" "-DLIBRARY=${BUILD}/src/libnakawari.so" "-DNM=${NM}" "-DOBJDUMP=${OBJDUMP}"
      "-DHEADERS=${SOURCE}/include/nakawari" -P "${SOURCE}/tests/contract/symbols.cmake")
  endif()
endif()
if(HOW MATCHES "^(install|compile)$")
  run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/installed")
  file(REMOVE_RECURSE "${INSTALLED}")
  file(RENAME "${WORK}/installed" "${INSTALLED}")
  return()
endif()

if(HOW STREQUAL "pkg_config")
  file(GLOB_RECURSE pc "${INSTALLED}/*/nakawari.pc")
  cmake_path(GET pc PARENT_PATH pc_folder)
  cmake_path(GET pc_folder PARENT_PATH lib)
  set(ENV{PKG_CONFIG_PATH} "${pc_folder}")
  set(ENV{LD_LIBRARY_PATH} "${lib}")
endif()
run("${CMAKE_COMMAND}" -S "${SOURCE}/tests/consumer/project" -B "${WORK}/project" "-DHOW=${HOW}" "-DSOURCE=${SOURCE}"
  "-DCMAKE_C_COMPILER=${CC}" "-DCMAKE_CXX_COMPILER=${CXX}" "-DBUILD_SHARED_LIBS=${shared}" ${library} "-DVERSION=${VERSION}"
  "-DCMAKE_PREFIX_PATH=${INSTALLED}" "-DSHARED=${shared}")
run("${CMAKE_COMMAND}" --build "${WORK}/project")
foreach(program IN ITEMS in_c in_cxx)
  execute_process(COMMAND "${WORK}/project/${program}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
