cmake_minimum_required(VERSION 3.25)
# Installs the library, moves the installed tree, then configures, builds and runs the project beside this file, which
# comes to the library by HOW. For add_subdirectory there is nothing to install.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
set(shared OFF)
if(KIND STREQUAL "shared")
  set(shared ON)
endif()

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

set(prefix "${WORK}/moved")
if(NOT HOW STREQUAL "add_subdirectory")
  run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}/library" "-DCMAKE_C_COMPILER=${CC}"
    "-DBUILD_SHARED_LIBS=${shared}" -DNKW_BUILD_TESTS=OFF -DNKW_BUILD_EXAMPLES=OFF "-DCMAKE_INSTALL_PREFIX=${WORK}/installed")
  run("${CMAKE_COMMAND}" --build "${WORK}/library" --target install)
  file(RENAME "${WORK}/installed" "${prefix}")
endif()

file(GLOB_RECURSE pc "${prefix}/*/nakawari.pc")
if(pc)
  cmake_path(GET pc PARENT_PATH pc_folder)
  set(ENV{PKG_CONFIG_PATH} "${pc_folder}")
endif()
run("${CMAKE_COMMAND}" -S "${SOURCE}/tests/consumer/project" -B "${WORK}/project" "-DHOW=${HOW}" "-DSOURCE=${SOURCE}"
  "-DCMAKE_C_COMPILER=${CC}" "-DCMAKE_CXX_COMPILER=${CXX}" "-DBUILD_SHARED_LIBS=${shared}" "-DVERSION=${VERSION}"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DSHARED=${shared}")
run("${CMAKE_COMMAND}" --build "${WORK}/project")
if(shared AND pc)
  cmake_path(GET pc_folder PARENT_PATH lib)
  set(ENV{LD_LIBRARY_PATH} "${lib}")
endif()
foreach(program IN ITEMS in_c in_cxx)
  execute_process(COMMAND "${WORK}/project/${program}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
