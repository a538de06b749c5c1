cmake_minimum_required(VERSION 3.22)
# docs/size.md: what a program links of the library, by core and by kits. Without WRITE, it checks that the table has a row
# for each kit and that the functions it names exist. With it, the library is built in WORK and the table is written:
#
#     cmake -DWORK=build/sizes -DWRITE=ON -P docs/generate/sizes.cmake
#
# bytes = .text + .rodata + .data.rel.ro of a program that links the functions, less those of a program without any.
# The program is an empty main; the functions are the roots of the linker's search, as if main called them.
include("${CMAKE_CURRENT_LIST_DIR}/../../src/subjects.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/text.cmake")
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
set(page "${root}/docs/size.md")

# The calls of core, and one of each kit: the first that its users look for.
set(calls_core keyframe:nkw_keyframes_sample track:nkw_track_sample clip:nkw_clip_sample mixer:nkw_mixer_advance
  blend:nkw_pose_blend skeleton:nkw_skeleton_models_from_locals palette:nkw_palette_from_models skin:nkw_skin_linear)
set(calls_kits arrays:nkw_vec3_lerp_n axes:nkw_axes_convert_quat dual:nkw_dual_quat_from_rigid box:nkw_box_transform ease:nkw_ease_evaluate
  handle:nkw_handle_sample rotation:nkw_rotation_from_squad spline:nkw_spline_tangents nurbs:nkw_nurbs_evaluate
  polycurve:nkw_polycurve_measure spring:nkw_vec3_spring_step inertia:nkw_vec3_offset_evaluate
  timecode:nkw_timecode_from_frame fcurve:nkw_fcurve_sample dialect:nkw_track_from_fcurves edit:nkw_track_trim
  fit:nkw_track_fit reduce:nkw_track_reduce mirror:nkw_pose_mirror_rest transition:nkw_pose_inertia_evaluate root:nkw_root_delta
  limit:nkw_limit_apply ik:nkw_ik_two_bone_solve foot:nkw_foot_update retarget:nkw_retarget_apply
  blendspace:nkw_blendspace_weights layer:nkw_skeleton_compose_rotations clip_reduce:nkw_clip_reduce clip_motion:nkw_clip_sample_velocity records:nkw_records_blend
  fingerprint:nkw_pose_fingerprint chunk:nkw_chunks_sample morph:nkw_morph_apply character:nkw_character_build bounds:nkw_box_from_skin
  partition:nkw_partition_build mesh:nkw_mesh_normals crowd:nkw_crowd_sample)

# Stores the functions that the header of a stem declares.
function(functions_of stem out)
  read_code("${root}/include/nakawari/${stem}.h" code)
  prototypes_of("${code}" prototypes)
  set(names "")
  foreach(prototype IN LISTS prototypes)
    string(REGEX MATCH "(nkw_[a-z0-9_]+)\\(" name "${prototype}")
    list(APPEND names "${CMAKE_MATCH_1}")
  endforeach()
  list(REMOVE_DUPLICATES names)
  set(${out} "${names}" PARENT_SCOPE)
endfunction()

set(kits ${NKW_STEMS})
list(REMOVE_ITEM kits ${NKW_CORE})
set(named "")
foreach(call IN LISTS calls_core calls_kits)
  string(REPLACE ":" ";" call "${call}")
  list(GET call 0 stem)
  list(GET call 1 function)
  functions_of(${stem} names)
  if(NOT function IN_LIST names)
    message(FATAL_ERROR "sizes: ${stem}.h declares no ${function}")
  endif()
  list(APPEND named ${stem})
endforeach()
foreach(stem IN LISTS kits)
  if(NOT stem IN_LIST named)
    message(SEND_ERROR "sizes: the kit ${stem} has no call in docs/generate/sizes.cmake; then write the table, as that file says")
  endif()
endforeach()

file(READ "${page}" text)
string(REGEX MATCH "^(.*<!-- sizes -->\n)(.*)(<!-- end of sizes -->.*)$" unused "${text}")
set(before "${CMAKE_MATCH_1}")
set(table "${CMAKE_MATCH_2}")
set(after "${CMAKE_MATCH_3}")
if(NOT WRITE)
  foreach(call IN LISTS calls_core calls_kits)
    string(REGEX REPLACE "(.*):(.*)" "| \\1 | `\\2` | " row "${call}")
    if(NOT table MATCHES "${row}[0-9]")
      message(SEND_ERROR "sizes: docs/size.md has no row '${row}'")
    endif()
  endforeach()
  return()
endif()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result)
    message(FATAL_ERROR "sizes: ${ARGN}:\n${output}")
  endif()
endfunction()

if(NOT CC)
  set(CC gcc)
endif()
get_filename_component(WORK "${WORK}" ABSOLUTE)
file(WRITE "${WORK}/main.c" "int main(void) { return 0; }\n")
set(builds Os O2 scalar)
set(options_Os "-DCMAKE_C_FLAGS_RELEASE=-Os -DNDEBUG")
set(options_O2 "-DCMAKE_C_FLAGS_RELEASE=-O2 -DNDEBUG")
set(options_scalar "${options_Os}" -DNKW_SIMD=scalar)
foreach(build IN LISTS builds)
  run("${CMAKE_COMMAND}" -S "${root}" -B "${WORK}/${build}" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_C_COMPILER=${CC}"
    -DNKW_BUILD_TESTS=OFF -DNKW_BUILD_EXAMPLES=OFF -DNKW_IMPORT=OFF -DNKW_COMMAND=OFF ${options_${build}})
  run("${CMAKE_COMMAND}" --build "${WORK}/${build}" --target nakawari -j 2)
endforeach()

# Stores the bytes of a program that links the functions of ARGN from a build.
function(bytes_of build out)
  list(TRANSFORM ARGN PREPEND "-Wl,--require-defined=" OUTPUT_VARIABLE roots)
  run("${CC}" -Wl,--gc-sections ${roots} "${WORK}/main.c" "${WORK}/${build}/src/libnakawari.a" -lm -o "${WORK}/program")
  execute_process(COMMAND size -A -d "${WORK}/program" OUTPUT_VARIABLE sections COMMAND_ERROR_IS_FATAL ANY)
  set(sum 0)
  foreach(section IN ITEMS text rodata data.rel.ro)
    if(sections MATCHES "\n[.]${section} +([0-9]+)")
      math(EXPR sum "${sum} + ${CMAKE_MATCH_1}")
    endif()
  endforeach()
  set(${out} ${sum} PARENT_SCOPE)
endfunction()

foreach(build IN LISTS builds)
  bytes_of(${build} empty_${build})
endforeach()

# Stores cells of a row: the bytes in each of the builds listed, of the functions of ARGN.
function(cells which out)
  set(row "")
  foreach(build IN LISTS which)
    bytes_of(${build} bytes ${ARGN})
    math(EXPR bytes "${bytes} - ${empty_${build}}")
    string(APPEND row " ${bytes} |")
  endforeach()
  set(${out} "${row}" PARENT_SCOPE)
endfunction()

execute_process(COMMAND "${CC}" --version OUTPUT_VARIABLE compiler COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND uname -m OUTPUT_VARIABLE processor OUTPUT_STRIP_TRAILING_WHITESPACE)
execute_process(COMMAND ld --version OUTPUT_VARIABLE linker COMMAND_ERROR_IS_FATAL ANY)
foreach(tool IN ITEMS compiler linker)
  string(REGEX REPLACE "\n.*" "" ${tool} "${${tool}}")
endforeach()
set(table "${compiler}; ${linker}; ${processor}.\n\n")
string(APPEND table "| header | call | `-Os` | `-O2` | scalar | all of the header, `-Os` | `-O2` |\n"
  "|---|---|--:|--:|--:|--:|--:|\n")
function(row stem call)
  functions_of(${stem} all)
  cells("Os;O2;scalar" one ${call})
  cells("Os;O2" whole ${all})
  set(table "${table}| ${stem} | `${call}` |${one}${whole}\n" PARENT_SCOPE)
endfunction()
function(sum name)
  cells("Os;O2;scalar" one ${ARGN})
  set(table "${table}| | ${name} |${one} | |\n" PARENT_SCOPE)
endfunction()

set(all "")
foreach(stem IN LISTS NKW_CORE)
  functions_of(${stem} names)
  list(APPEND all ${names})
endforeach()
foreach(call IN LISTS calls_core)
  string(REPLACE ":" ";" call "${call}")
  row(${call})
endforeach()
sum("a character: `nkw_clip_sample`, `nkw_pose_blend`, `nkw_skeleton_models_from_locals`, `nkw_palette_from_models`, `nkw_skin_linear`"
  nkw_clip_sample nkw_pose_blend nkw_skeleton_models_from_locals nkw_palette_from_models nkw_skin_linear)
sum("every function of core" ${all})
foreach(call IN LISTS calls_kits)
  string(REPLACE ":" ";" call "${call}")
  row(${call})
endforeach()
foreach(stem IN LISTS kits)
  functions_of(${stem} names)
  list(APPEND all ${names})
endforeach()
sum("every function of the library" ${all})
file(WRITE "${page}" "${before}${table}${after}")
