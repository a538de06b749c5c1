# The example programs as tests; run.cmake says how. Included by docs/CMakeLists.txt.
set(run -P "${CMAKE_CURRENT_SOURCE_DIR}/examples/run.cmake")

# PROGRAM draws FILES and PICTURES into a folder of its own; PICTURES have the very bytes of the committed ones, whose
# names begin with PREFIX.
function(example_draws program prefix)
  cmake_parse_arguments(arg "" "" "FILES;PICTURES;ARGUMENTS" ${ARGN})
  set(out "${CMAKE_CURRENT_BINARY_DIR}/${program}")
  list(TRANSFORM arg_PICTURES APPEND ".svg" OUTPUT_VARIABLE pictures)
  list(APPEND arg_FILES ${pictures})
  add_test(NAME example_${program} COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:nakawari-${program}>"
    "-DARGUMENTS=${arg_ARGUMENTS}" "-DOUT=${out}" "-DFILES=${arg_FILES}" ${run})
  set_tests_properties(example_${program} PROPERTIES LABELS unit FIXTURES_SETUP ${program}_files)
  foreach(picture IN LISTS arg_PICTURES)
    add_test(NAME example_${program}_figure_${picture} COMMAND "${CMAKE_COMMAND}" -E compare_files --ignore-eol
      "${out}/${picture}.svg" "${CMAKE_CURRENT_SOURCE_DIR}/figures/${prefix}${picture}.svg")
    set_tests_properties(example_${program}_figure_${picture} PROPERTIES
      LABELS golden FIXTURES_REQUIRED ${program}_files)
  endforeach()
endfunction()

# What is asked, the exit code, and what is said about it.
function(example_says program name code text)
  add_test(NAME example_${program}_${name} COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:nakawari-${program}>"
    "-DARGUMENTS=${ARGN}" "-DCODE=${code}" "-DTEXT=${text}" ${run})
  set_tests_properties(example_${program}_${name} PROPERTIES LABELS unit)
endfunction()

# The page shows the very output.
function(example_page program page text)
  add_test(NAME example_${program}_page COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:nakawari-${program}>"
    "-DARGUMENTS=${ARGN}" -DCODE=0 "-DTEXT=${text}" "-DPAGE=${CMAKE_CURRENT_SOURCE_DIR}/${page}.md" ${run})
  set_tests_properties(example_${program}_page PROPERTIES LABELS golden)
endfunction()

set(nowhere "${CMAKE_CURRENT_BINARY_DIR}/no/such/folder")

# ---- nakawari-coursework ----

example_draws(coursework coursework- FILES scene1_exercise.csv scene1_library.csv index.html PICTURES ${coursework_pictures})
example_page(coursework coursework matrix --trace 3.25 --position hermite --orientation quat)

# The pages' links to lines of the source. Put right by the command in the script's head.
foreach(page IN ITEMS coursework ja/coursework textbook ja/textbook)
  string(REPLACE "/" "_" name "example_${page}_lines")
  add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" "-DPAGE=${CMAKE_CURRENT_SOURCE_DIR}/${page}.md"
    "-DROOT=${PROJECT_SOURCE_DIR}" -P "${CMAKE_CURRENT_SOURCE_DIR}/generate/lines.cmake")
  set_tests_properties(${name} PROPERTIES LABELS golden)
endforeach()

# The Japanese pages are in step with the English ones.
add_test(NAME docs/ja COMMAND "${CMAKE_COMMAND}" "-DDOCS=${CMAKE_CURRENT_SOURCE_DIR}"
  -P "${CMAKE_CURRENT_SOURCE_DIR}/generate/ja.cmake")
set_tests_properties(docs/ja PROPERTIES LABELS golden)

example_says(coursework help 0 "^usage: nakawari-coursework" --help)
example_says(coursework trace 0 "segment 1, from key 1 to key 2" --trace 1.25)
example_says(coursework unknown_option 2 "unknown option: --nonsense" --nonsense)
example_says(coursework missing_value 2 "value missing after: --out" --out)
example_says(coursework bad_number 2 "not a number in range: fast" --step fast)
example_says(coursework bad_scene 2 "not a number in range: 3" --scene 3)
example_says(coursework bad_method 2 "no such method: cubic" --trace 1 --position cubic)
example_says(coursework bad_rule 2 "no such method: mine" --rule mine)
example_says(coursework rule 0 "segment 2, from key 2 to key 3" --trace 2 --rule library)
example_says(coursework rule_of_the_exercise 0 "segment 1, from key 1 to key 2" --trace 2)
# 10 rows of Bezier beyond the keys and 44 on or after keys, 5 in both.
example_says(coursework tables 0 "69 of their 852 rows differ: .*docs/coursework.md#where-this-library-differs"
  --out "${CMAKE_CURRENT_BINARY_DIR}")
example_says(coursework too_many_keys 2 "fewer keys" --scene 2 --keys 3)
example_says(coursework unwritable_folder 1 "cannot write .*/no/such/folder/scene1_exercise.csv" --out "${nowhere}")

add_test(NAME example_coursework_with_joints COMMAND "${CMAKE_COMMAND}"
  "-DPROGRAM=$<TARGET_FILE:nakawari-coursework>" -DARGUMENTS=--joints
  "-DOUT=${CMAKE_CURRENT_BINARY_DIR}/coursework-with-joints" -DFILES=index.html
  "-DSHOWN=joints-sheet.svg.*joints-compare.svg" ${run})
set_tests_properties(example_coursework_with_joints PROPERTIES LABELS unit)
add_test(NAME example_coursework_with_character COMMAND "${CMAKE_COMMAND}"
  "-DPROGRAM=$<TARGET_FILE:nakawari-coursework>" -DARGUMENTS=--character
  "-DOUT=${CMAKE_CURRENT_BINARY_DIR}/coursework-with-character" -DFILES=index.html
  -DSHOWN=hop.apng ${run})
set_tests_properties(example_coursework_with_character PROPERTIES LABELS unit)
add_test(NAME example_coursework_with_page COMMAND "${CMAKE_COMMAND}"
  "-DPROGRAM=$<TARGET_FILE:nakawari-coursework>" "-DARGUMENTS=--joints;--page;PAGE;--docs;DOCS"
  "-DOUT=${CMAKE_CURRENT_BINARY_DIR}/coursework-with-page" -DFILES=index.html
  "-DSHOWN=href=\"DOCS/coursework.md#where-this-library-differs\".*href=\"PAGE\".*href=\"PAGE#exercise.*href=\"PAGE#rotations\".*href=\"PAGE#twist\"" ${run})
set_tests_properties(example_coursework_with_page PROPERTIES LABELS unit)
example_says(coursework summary 0 "1.5   -1.00  0.75  0.50  -0.96  0.92  0.44  -0.88  0.68  0.38  -0.98  0.74  0.48"
  --out "${CMAKE_CURRENT_BINARY_DIR}")

# ---- nakawari-joints ----

example_draws(joints "" FILES joints-frame-000.svg joints-frame-007.svg PICTURES ${joints_pictures})
example_page(joints joints "joint matrix" --trace 1)
example_says(joints help 0 "^usage: nakawari-joints" --help)
example_says(joints key_time 0 "joint 1.*0\\.877583 -0\\.479426  1\\.000000" --trace 1)
example_says(joints unknown_option 2 "unknown option: --nonsense" --nonsense)
example_says(joints missing_value 2 "value missing after: --obj" --obj)
example_says(joints bad_number 2 "not a number in range: soon" --trace soon)
example_says(joints no_frames 2 "not a number in range: 0" --frames 0)
example_says(joints part_of_a_frame 2 "not a whole number: 1.5" --frames 1.5)
example_says(joints unwritable_folder 1 "cannot write .*/no/such/folder/joints-frame-000.svg" --out "${nowhere}")
example_says(joints no_file 1 "cannot read .*/no/such/folder: " --obj "${nowhere}")

# All forms of corners, by numbers forwards and backwards, with and without normals; faces of four and five corners.
set(obj "${CMAKE_CURRENT_BINARY_DIR}/obj")
file(CONFIGURE OUTPUT "${obj}/prism.obj" @ONLY CONTENT [[# a prism
o prism
v 1 0 0
v 0.309 0 0.951
v -0.809 0 0.588
v -0.809 0 -0.588
v 0.309 0 -0.951 1.0
v 1 2 0
v 0.309 2 0.951
v -0.809 2 0.588
v -0.809 2 -0.588
v 0.309 2 -0.951
vt 0 0
vn 0 3 0
usemtl none
f 1 2 3 4 5
f 10//1 9//1 8//1 7//1 6//-1
f 2/1 1/1 6/1 7/1
f 3/1 2/1 -4 -3
f -7 -8 -3 -2
f -6 -7 -2/1 -1/1
f	1 5 10	6
]])
example_says(joints obj 0 "a vertex at .*it goes to .*it goes to" --trace 2 --obj "${obj}/prism.obj")
example_says(joints obj_pictures 0 "wrote .*/obj/joints-compare.svg"
  --dual --frames 2 --out "${obj}" --obj "${obj}/prism.obj")

# A file that says LINE after three vertices and a normal fails there.
function(joints_refuses name text)
  list(JOIN ARGN "\n" lines)
  file(CONFIGURE OUTPUT "${obj}/${name}.obj" CONTENT "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n${lines}\n" @ONLY)
  example_says(joints obj_${name} 1 "/${name}\\.obj:${text}" --trace 0 --obj "${obj}/${name}.obj")
endfunction()
joints_refuses(two_corners "5: a face has fewer than three corners" "f 1 2")
joints_refuses(beyond "5: no such vertex or normal so far" "f 1 2 4")
joints_refuses(before "5: no such vertex or normal so far" "f 1 2 -4")
joints_refuses(zero "6: no such vertex or normal so far" "f 1 2 3" "f 1 2 0")
joints_refuses(bad_normal "5: no such vertex or normal so far" "f 1//1 2//2 3//1")
joints_refuses(word "5: a corner's number was expected" "f 1 2 three")
joints_refuses(tail "5: a corner's number was expected" "f 1 2 3x")
joints_refuses(short_vector "5: three numbers were expected" "v 1 2")
joints_refuses(infinite "5: a number is too large" "v 1 2 1e99")
joints_refuses(no_faces " there are no faces" "# nothing")

file(CONFIGURE OUTPUT "${obj}/flat.obj" CONTENT "v 0 1 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\n" @ONLY)
example_says(joints obj_flat 1 "the mesh has no height" --obj "${obj}/flat.obj")
if(EXISTS "${NKW_DATA_DIR}/obj/capsule_3m.obj")
  example_says(joints obj_capsule 0 "joint 3.*-0\\.122417.*it goes to" --trace 1 --obj "${NKW_DATA_DIR}/obj/capsule_3m.obj")
endif()

# ---- nakawari-character ----

# The committed file has the very bytes. To renew it: nakawari-character --out docs/examples/character.glb
set(character "${CMAKE_CURRENT_BINARY_DIR}/character.glb")
example_says(character write 0 "wrote .*character.glb" --out "${character}")
set_tests_properties(example_character_write PROPERTIES FIXTURES_SETUP character_file)
add_test(NAME example_character_bytes COMMAND "${CMAKE_COMMAND}" -E compare_files "${character}"
  "${CMAKE_CURRENT_SOURCE_DIR}/examples/character.glb")
set_tests_properties(example_character_bytes PROPERTIES LABELS golden FIXTURES_REQUIRED character_file)
example_says(character help 0 "^usage: nakawari-character" --help)
example_says(character unknown_option 2 "unknown option: --nonsense" --nonsense)
example_says(character unwritable 1 "cannot write .*/no/such/folder" --out "${nowhere}/character.glb")

# ---- nakawari-play ----

# The boxes of a mannequin that walks, then waves, and of a fox; import_character compares their vertices.
if(TARGET nakawari-play)
  example_says(play mannequin 0 "0.50 s: -0.3873 -0.0132 -0.3485 to 0.3970 1.7650 0.2373.*2.00 s: -0.6604"
    "${CMAKE_CURRENT_SOURCE_DIR}/examples/character.glb")
  example_says(play no_file 1 "usage: nakawari-play FILE.glb" "${nowhere}/no.glb")
  if(EXISTS "${NKW_DATA_DIR}/gltf/Fox.glb")
    example_says(play fox 0 "0.00 s: -29.8998 -0.1307 -84.3404 to 11.5953 74.6421 56.6528.*2.00 s: -12.6704"
      "${NKW_DATA_DIR}/gltf/Fox.glb")
  endif()
endif()

# ---- nakawari-crowd ----

if(TARGET nakawari-crowd)
  example_says(crowd help 0 "^usage: nakawari-crowd" --help)
  # Sizes that fill neither pieces nor threads. The hash is the same on every machine.
  example_says(crowd small 0 "37 characters of 11 joints.*3  .*9a3e9a0466c5d916.*out of the lanes"
    --characters 37 --joints 11 --threads 3 --seconds 0.001)
  example_says(crowd least 0 "1 characters of 1 joints" --characters 1 --joints 1 --threads 2 --seconds 0.001)
  example_says(crowd unknown_option 2 "unknown option: --nonsense" --nonsense)
  example_says(crowd missing_value 2 "value missing after: --joints" --joints)
  example_says(crowd no_characters 2 "not a number in range: 0" --characters 0)
  example_says(crowd half_a_thread 2 "not a whole number: 1.5" --threads 1.5)
endif()
