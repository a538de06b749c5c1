cmake_minimum_required(VERSION 3.22)
# Joins the Markdown parts that the accuracy programs write into one page.
set(page "# Accuracy

The largest error of every function, measured by `cmake --workflow --preset accuracy`. The same programs run in the
tests with fewer samples and a shorter search. A test fails if a measured error exceeds the `Error` line of the
function's header. Some lines are well above their rows (sums of products, reflections, slerp, rotations by quaternions,
and functions composed of them): they include larger errors that longer searches found.

Functions without a row:

- functions that copy, select or compare;
- functions that round one sum, difference, product or quotient of each component;
- functions that evaluate another function for each component or on arrays: the row of that function applies.

Units: 1 ULP is the distance of neighbouring floats at the exact result, so 0.5 ULP is correct rounding. 1 u is 2^-24 of
the magnitude that the header names: the norm of a vector, quaternion or matrix, the product of the norms for sums of
products, or the largest control value of a curve. The reference is binary64 functions of the C library for `scalar.h`, and
binary128 for the others. A row marked *noted* has another measure than the header's line, or arguments outside its
range. The witness is the input with the largest error. Two integers are a seed: of the random case, or of the case from
which the search started.

The errors of the others are the largest that a search found, not proven bounds, unless a header states a bound. The
search starts at the worst of 300 samples. It changes one of the random numbers that the sample is computed from: by 1
to 2^20 units in the last place, to fewer bits, in one of its highest bits, by whole exponents about the middle of its
range, to one equal or opposite to another, or to any other number. It keeps the change if the error does not decrease.
After 3000 changes without an increase it starts again from other samples. The columns samples and rms do not include
the search. Noted rows are not searched. A row may be of an earlier run that found more, if the function is the same.
")
include("${CMAKE_CURRENT_LIST_DIR}/../../src/subjects.cmake")
foreach(stem IN LISTS NKW_STEMS)
  if(NOT EXISTS "${CMAKE_CURRENT_LIST_DIR}/accuracy_${stem}.c")
    continue()
  endif()
  if(NOT EXISTS "${PARTS}/${stem}.md")
    message(FATAL_ERROR "no ${PARTS}/${stem}.md: run the accuracy tests first")
  endif()
  file(READ "${PARTS}/${stem}.md" rows)
  string(APPEND page "\n## ${stem}.h\n\n| function | region | worst | rms | unit | witness | samples |\n|---|---|--:|--:|---|---|--:|\n${rows}")
endforeach()
file(WRITE "${PAGE}" "${page}")
message(STATUS "written: ${PAGE}")
