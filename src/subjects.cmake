# The subjects of the library, in their order, and their stems: the one list of them. Each subject uses those before it,
# and the kernel. A new stem is registered here and in nakawari.h, one of core also in core.h. Files are found by name: include/nakawari/STEM.h;
# STEM.c and STEM_*.c in src/SUBJECT, src/kernel/batch, src/kernel/simd, tests/SUBJECT (test_), tests/accuracy
# (accuracy_) and bench (bench_).
set(NKW_SUBJECTS math curve motion track pose clip skin)
set(NKW_STEMS_math base types scalar vec quat mat euler axes transform arrays dual box)
set(NKW_STEMS_curve curve handle ease orient rotation segment spline nurbs polycurve)
set(NKW_STEMS_motion spring inertia)
set(NKW_STEMS_track playback timecode keyframe track fcurve dialect edit fit reduce)
set(NKW_STEMS_pose pose skeleton blend mirror layer transition root limit ik foot retarget blendspace)
set(NKW_STEMS_clip clip clip_reduce clip_motion records mixer fingerprint chunk)
set(NKW_STEMS_skin palette skin morph character bounds partition mesh crowd)
# Core is from key frames to skinned vertices, and what core.h includes; every other stem is a kit.
set(NKW_CORE base types scalar vec quat mat euler transform curve orient segment playback keyframe track
  pose skeleton blend clip mixer palette skin)
set(NKW_STEMS "")
foreach(subject IN LISTS NKW_SUBJECTS)
  list(APPEND NKW_STEMS ${NKW_STEMS_${subject}})
endforeach()

# Where the library's files find headers: of the kernel, "lane/quat.h"; of another subject, "track/track_keys.h".
set(NKW_FOLDERS "${CMAKE_CURRENT_LIST_DIR}/kernel" "${CMAKE_CURRENT_LIST_DIR}" "${CMAKE_CURRENT_LIST_DIR}/../include")

# Stores the stem of a file's name in `out`: the longest one that the name is, or begins with before a `_`; or "".
function(nkw_stem_of name out)
  set(found "")
  foreach(stem IN LISTS NKW_STEMS)
    if("${name}_" MATCHES "^${stem}_" AND stem MATCHES "^${found}")
      set(found "${stem}")
    endif()
  endforeach()
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# Stores in `out` the names NAME of the files PREFIX<NAME>SUFFIX of a folder in the order of the stems. A file whose
# stem is not in the list is an error, except those named after SUFFIX, which are left out.
function(nkw_stem_files out folder prefix suffix)
  set(depends CONFIGURE_DEPENDS)
  if(CMAKE_SCRIPT_MODE_FILE)
    set(depends "")
  endif()
  file(GLOB files RELATIVE "${folder}" ${depends} "${folder}/${prefix}*${suffix}")
  foreach(file IN LISTS files)
    string(LENGTH "${prefix}" begin)
    string(SUBSTRING "${file}" ${begin} -1 name)
    string(REPLACE "${suffix}" "" name "${name}")
    if(name IN_LIST ARGN)
      continue()
    endif()
    nkw_stem_of("${name}" stem)
    if(stem STREQUAL "")
      message(FATAL_ERROR "${folder}/${file}: the stem of '${name}' is not in the list of src/subjects.cmake")
    endif()
    list(APPEND names_of_${stem} "${name}")
  endforeach()
  set(names "")
  foreach(stem IN LISTS NKW_STEMS)
    list(APPEND names ${names_of_${stem}})
  endforeach()
  set(${out} "${names}" PARENT_SCOPE)
endfunction()

# Stores in `out` the names of nkw_stem_files of each subject's folder below `folder`, as SUBJECT/NAME.
function(nkw_subject_files out folder prefix suffix)
  set(names "")
  foreach(subject IN LISTS NKW_SUBJECTS)
    nkw_stem_files(files "${folder}/${subject}" "${prefix}" "${suffix}" ${ARGN})
    list(TRANSFORM files PREPEND "${subject}/")
    list(APPEND names ${files})
  endforeach()
  set(${out} "${names}" PARENT_SCOPE)
endfunction()

# Stores the files of the library, relative to src: of single calls, of the choice of loops, and of loops.
function(nkw_library_files sources dispatch loops)
  nkw_subject_files(names "${CMAKE_CURRENT_FUNCTION_LIST_DIR}" "" .c algebra)
  nkw_stem_files(chosen "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/kernel/simd" "" .c)
  nkw_stem_files(looped "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/kernel/batch" "" .c)
  list(TRANSFORM names APPEND .c)
  list(TRANSFORM chosen REPLACE "(.+)" "kernel/simd/\\1.c")
  list(TRANSFORM looped REPLACE "(.+)" "kernel/batch/\\1.c")
  set(${sources} ${names} curve/algebra.c PARENT_SCOPE)
  set(${dispatch} "${chosen}" PARENT_SCOPE)
  set(${loops} "${looped}" PARENT_SCOPE)
endfunction()
