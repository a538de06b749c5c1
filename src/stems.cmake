# The subjects of the library, floor by floor: the one list of them. A new stem is registered here and in nakawari.h.
# Files are found by name: include/nakawari/STEM.h, and STEM.c and STEM_*.c in src, src/batch, src/simd, tests (test_),
# tests/accuracy (accuracy_) and bench (bench_).
set(NKW_FLOOR_0
  base
)
set(NKW_FLOOR_1
  scalar
)
set(NKW_FLOOR_2
  types
  vec
  quat
  mat
  euler
  axes
  transform
  dual
  box
)
set(NKW_FLOOR_3
  curve
  curve_point
  handle
  ease
  orient
  rotation
  limit
  spring
  inertia
)
set(NKW_FLOOR_4
  segment
  fcurve
  spline
  nurbs
  polycurve
  keyframe
  track
  dialect
  edit
  fit
  playback
  timecode
  pose
  clip
  reduce
  clip_reduce
)
set(NKW_FLOOR_5
  skeleton
  blend
  transition
  root
  ik
  foot
  retarget
  blendspace
)
set(NKW_FLOOR_6
  palette
  skin
  morph
  bounds
  partition
  crowd
)
set(NKW_STEMS ${NKW_FLOOR_0} ${NKW_FLOOR_1} ${NKW_FLOOR_2} ${NKW_FLOOR_3} ${NKW_FLOOR_4} ${NKW_FLOOR_5} ${NKW_FLOOR_6})

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
  file(GLOB files RELATIVE "${folder}" CONFIGURE_DEPENDS "${folder}/${prefix}*${suffix}")
  foreach(file IN LISTS files)
    string(LENGTH "${prefix}" begin)
    string(SUBSTRING "${file}" ${begin} -1 name)
    string(REPLACE "${suffix}" "" name "${name}")
    if(name IN_LIST ARGN)
      continue()
    endif()
    nkw_stem_of("${name}" stem)
    if(stem STREQUAL "")
      message(FATAL_ERROR "${folder}/${file}: the stem of '${name}' is not in the list of src/stems.cmake")
    endif()
    list(APPEND names_of_${stem} "${name}")
  endforeach()
  set(names "")
  foreach(stem IN LISTS NKW_STEMS)
    list(APPEND names ${names_of_${stem}})
  endforeach()
  set(${out} "${names}" PARENT_SCOPE)
endfunction()
