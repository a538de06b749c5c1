cmake_minimum_required(VERSION 3.22)
# Joins the Markdown parts that the accuracy programs wrote into one page.
set(page "# Accuracy

The worst error of every function, as `cmake --workflow --preset accuracy` measured it. The same programs run in the
tests with fewer samples and a shorter search, and fail where a measurement exceeds the `Error` line of the function's
header. Some lines (sums of products, reflections, slerp, rotations by quaternions and what is composed of them) are well
above their rows: they cover larger errors that longer searches found.

Functions without a row: those that copy, select or compare; those that round one sum, difference, product or quotient
of each component (a tangent per second made one per segment among them); and those that give the numbers of another
function, of each component, in another place or on arrays, whose row is theirs.

Units: a ULP is the distance of neighbouring floats at the exact result, so 0.5 ULP is correct rounding. 1 u is 2^-24
of the magnitude that the header names: the norm of a vector, quaternion or matrix, the product of the norms for sums
of products, the largest control value of a curve. The oracle of floor 1 is the C library's binary64 functions, that of
floors 2 to 6 binary128. Rows marked *noted* are measured by another yardstick than the header's line, or outside the
range it speaks of. The witness is the input of the worst case; where two whole numbers stand in its place, they are
the seed that the case was drawn from, or the climb to it.

The errors of floors 2 to 6 are the worst that a search found, not proven bounds, except where a header says so. The
search starts at the worst of 300 samples. One of the numbers that the sample is drawn from is changed at a time: by 1 to
2^20 last places, to fewer bits, in one of its highest bits, or to any other number. The change stays where the error did
not decrease. After 3000 changes without gain the search starts again from other samples. Samples and rms are those
before the search; noted rows are not searched.
")
foreach(stem IN ITEMS scalar vec quat mat euler transform dual curve orient track clip skeleton blend palette skin)
  if(NOT EXISTS "${PARTS}/${stem}.md")
    message(FATAL_ERROR "no ${PARTS}/${stem}.md: run the accuracy tests first")
  endif()
  file(READ "${PARTS}/${stem}.md" rows)
  string(APPEND page "\n## ${stem}.h\n\n| function | region | worst | rms | unit | witness | samples |\n|---|---|--:|--:|---|---|--:|\n${rows}")
endforeach()
file(WRITE "${PAGE}" "${page}")
message(STATUS "written: ${PAGE}")
