# The quick reference of core. The comment at the top of each header of core ends in a part `Example`: the declarations of
# its variables, then one line for each function, a statement of C and a few words:
#
#     Example  nkw_quat a, b, r;
#
#         r = nkw_quat_mul(a, b);    turns by b, then by a
#
# nkw_reference_code writes these statements as C files. As a script, with SOURCE, it compares docs/reference.md
# with the headers, and writes it if WRITE is set; a function of core without a line is an error.
include("${CMAKE_CURRENT_LIST_DIR}/../../src/subjects.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/text.cmake")
get_filename_component(NKW_HEADERS "${CMAKE_CURRENT_LIST_DIR}/../../include/nakawari" ABSOLUTE)

# Stores the declarations of a header's Example, and its lines, in the characters of read_code.
function(nkw_read_examples stem declarations lines)
  read_text("${NKW_HEADERS}/${stem}.h" "<" ">" "$" "@" content)
  set(${declarations} "" PARENT_SCOPE)
  set(${lines} "" PARENT_SCOPE)
  string(FIND "${content}" "\n * Example  " start)
  string(FIND "${content}" "\n */" end)
  if(start EQUAL -1 OR start GREATER end)
    return()
  endif()
  math(EXPR length "${end} - ${start}")
  string(SUBSTRING "${content}" ${start} ${length} part)
  string(REGEX REPLACE "\n [*] ?" ";" part "${part}")
  set(declared "")
  set(found "")
  foreach(line IN LISTS part)
    if(line MATCHES "^(Example|       )  ([a-z].*)")
      string(APPEND declared " ${CMAKE_MATCH_2}")
    elseif(line MATCHES "^    ([a-z].*)")
      list(APPEND found "${CMAKE_MATCH_1}")
    endif()
  endforeach()
  string(STRIP "${declared}" declared)
  set(${declarations} "${declared}" PARENT_SCOPE)
  set(${lines} "${found}" PARENT_SCOPE)
endfunction()

# Writes a C file reference_STEM.c for each header with lines: its declarations, and a function with its statements, each
# in a block.
function(nkw_reference_code directory files)
  foreach(stem IN LISTS NKW_CORE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${NKW_HEADERS}/${stem}.h")
    nkw_read_examples(${stem} declarations lines)
    if(NOT lines)
      continue()
    endif()
    string(REPLACE "$ " "$\nstatic " declarations "static ${declarations}")
    set(code "${declarations}\n\nvoid reference_${stem}(void)\n{\n")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "[$]  +.*" "$" line "${line}")
      string(APPEND code "    {\n        ${line}\n    }\n")
    endforeach()
    restore_code("${code}}\n" code)
    set(file "${directory}/reference_${stem}.c")
    file(CONFIGURE OUTPUT "${file}" CONTENT "#include <nakawari/core.h>\n\n${code}" @ONLY)
    list(APPEND ${files} "${file}")
  endforeach()
  set(${files} "${${files}}" PARENT_SCOPE)
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE)
  return()
endif()

# ---- the page ----

set(page "# Core on two pages

[`core.h`](../include/nakawari/core.h) goes from key frames to skinned vertices. This page has one line for each of its
functions, in the order of its headers: an example that compiles, and what it does. The headers have the whole: ranges,
degenerate cases, errors, sources. `contract/reference` compares this page with them.
")
file(READ "${NKW_HEADERS}/core.h" core)
set(functions 0)
foreach(stem IN LISTS NKW_CORE)
  nkw_read_examples(${stem} declarations lines)
  read_code("${NKW_HEADERS}/${stem}.h" code)
  prototypes_of("${code}" prototypes)
  foreach(prototype IN LISTS prototypes)
    string(REGEX MATCH "nkw_[a-z0-9_]+[(]" name "${prototype}")
    string(FIND "${lines}" "${name}" at)
    math(EXPR functions "${functions} + 1")
    if(at EQUAL -1)
      message(SEND_ERROR "reference: ${stem}.h: ${name}) has no line in Example")
    endif()
  endforeach()
  if(NOT lines)
    continue()
  endif()
  string(REGEX MATCH "#include \"${stem}.h\" /[*] ([^*]+) [*]/" title "${core}")
  string(APPEND page "\n## ${CMAKE_MATCH_1}\n\n[`${stem}.h`](../include/nakawari/${stem}.h)\n\n```c\n${declarations}\n")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "[$]  +" "$ // " line "${line}")
    string(APPEND page "${line}\n")
  endforeach()
  string(APPEND page "```\n")
endforeach()
restore_code("${page}" page)

set(path "${CMAKE_CURRENT_LIST_DIR}/../reference.md")
if(WRITE)
  file(WRITE "${path}" "${page}")
endif()
file(READ "${path}" committed)
if(NOT committed STREQUAL page)
  message(SEND_ERROR "reference: docs/reference.md differs from the headers; write it with -DWRITE=ON")
endif()
message(STATUS "reference: ${functions} functions of core")
