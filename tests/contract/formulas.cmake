cmake_minimum_required(VERSION 3.25)
# A formula has one text, and docs/formulas.md lists it: under the heading of each formula here a row
#
#     | `FUNCTION`[, `FUNCTION` ...] | [PATH](../PATH) | PRECISION | WHY |
#
# for every function of src/ and include/ that evaluates it. A function evaluates a formula if its code has one of the
# formula's fingerprints, below: the forms of the library, and those of textbooks, which a second text would have. So
# the list is complete, and a function that is written, changed or renamed changes the list.
#
# For its own test: SOURCE may be a copy with a planted text.

# ---- The normal text of code ----

# Without spaces, casts and suffixes of numbers; s->x is s.x, s[i] is s@i, a semicolon $, and nkw_mul(a, b) is a * b. Of
# parentheses those remain that matter, as ` and ': of calls, and of sums that are a factor or are subtracted.
function(normal_text text out)
  string(REGEX REPLACE "[(](float|double)[)]" "" text "$${text}$")
  string(REGEX REPLACE "([a-zA-Z0-9_])[ \n]+([a-zA-Z0-9_])" "\\1$\\2" text "${text}")
  string(REGEX REPLACE "[ \n]+" "" text "${text}")
  string(REPLACE "->" "." text "${text}")
  string(REGEX REPLACE "([0-9])[.]0*[fFL]?([^0-9a-zA-Z])" "\\1\\2" text "${text}")
  string(REGEX REPLACE "([0-9])[fFL]([^a-zA-Z0-9_])" "\\1\\2" text "${text}")
  set(before "")
  while(NOT before STREQUAL text)
    set(before "${text}")
    string(REGEX REPLACE "nkw_(mul|product|f32x[48]_mul|f32x[48]_scale)[(]([^(),]*),([^(),]*)[)]" "(\\2)*(\\3)" text
      "${text}")
    string(REGEX REPLACE "([a-zA-Z0-9_])[(]([^()]*)[)]" "\\1`\\2'" text "${text}")
    string(REGEX REPLACE "([^a-zA-Z0-9_])[(]([^()+-]*)[)]" "\\1\\2" text "${text}")
    string(REGEX REPLACE "([=+{,?:$(`])[(]([^()]*)[)]([^*/])" "\\1\\2\\3" text "${text}")
    if(before STREQUAL text)
      string(REGEX REPLACE "([^a-zA-Z0-9_])[(]([^()]*)[)]" "\\1`\\2'" text "${text}")
    endif()
  endwhile()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

# Appends "PATH NAME TEXT" to `units` for each function and macro of a file. A function begins with a line { and ends
# with a line }, as the formatter writes it; what is outside of functions has the name -.
macro(add_unit name text)
  if("${text}" MATCHES "[*/+]|mul|cross|normalize|scale") # otherwise it computes nothing
    normal_text("${text}" unit)
    list(APPEND units "${path} ${name} ${unit}")
  endif()
endmacro()

function(read_units path)
  file(READ "${SOURCE}/${path}" text)
  string(REPLACE "\r" "" text "${text}")
  string(REPLACE ";" "$" text "${text}")
  string(REPLACE "[" "@" text "${text}")
  string(REPLACE "]" "" text "${text}")
  string(REGEX REPLACE "/[*][^*]*[*]+([^/*][^*]*[*]+)*/" " " text "${text}")
  string(REGEX REPLACE "'([^'\\\\]|\\\\.)'" "0" text "${text}")
  string(REGEX REPLACE "\"([^\"\\\\\n]|\\\\.)*\"" "0" text "${text}")
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REPLACE "\\\n" " " text "${text}")
  string(REGEX REPLACE "[\\\\\t]" " " text "${text}")
  string(REPLACE "\n}" ";" text "\n${text}")
  foreach(part IN LISTS text)
    set(body "")
    string(FIND "${part}" "\n{" at)
    if(at GREATER -1)
      string(SUBSTRING "${part}" ${at} -1 body)
      string(SUBSTRING "${part}" 0 ${at} part)
      string(REGEX REPLACE "\n#[^\n]*" "" body "${body}")
    endif()
    string(REGEX MATCHALL "\n# *define [^\n]*" macros "${part}")
    foreach(macro IN LISTS macros)
      if(macro MATCHES "define ([A-Za-z0-9_]+)(.+)")
        add_unit("${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}")
      endif()
    endforeach()
    string(REGEX REPLACE "\n#[^\n]*" "" part "${part}")
    if(body STREQUAL "")
      add_unit("-" "${part}")
      continue()
    endif()
    # The last line that begins with a letter is the head; what is before it is outside.
    string(REGEX MATCH "\n[A-Za-z][^\n]*(\n[ (][^\n]*)*$" head "${part}")
    string(REGEX REPLACE "\n[A-Za-z][^\n]*(\n[ (][^\n]*)*$" "" part "${part}")
    set(name "-")
    if(head MATCHES "^\nNKW_LOOP[(]([A-Za-z0-9_]+)[)]")
      set(name "${CMAKE_MATCH_1}")
    elseif(head MATCHES "[ *]([A-Za-z0-9_]+)[(]")
      set(name "${CMAKE_MATCH_1}")
    endif()
    add_unit("${name}" "${body}")
    add_unit("-" "${part}")
  endforeach()
  set(units "${units}" PARENT_SCOPE)
endfunction()

set(units "")
file(GLOB_RECURSE paths RELATIVE "${SOURCE}" "${SOURCE}/src/*.[ch]" "${SOURCE}/src/*.cpp" "${SOURCE}/include/*.h")
foreach(path IN LISTS paths)
  read_units("${path}")
endforeach()
list(LENGTH units unit_count)

# ---- Fingerprints ----

# A fingerprint is an expression of C; several that the code must all have are joined by &. A capital letter is
# any operand, the same one each time; X Y Z W are any operands whose names end with x 0, y 1, z 2, w 3; ~ is
# any text within a statement. Factors have the order that is written: other orders are other fingerprints.

# The regular expression of a part, in which each capital letter is a group; the letters in their order.
function(regex_of part out letters)
  string(REPLACE " " "" part "${part}")
  string(REPLACE "[" "@" part "${part}")
  string(REPLACE "]" "" part "${part}")
  normal_text("${part}" part)
  string(REGEX REPLACE "^[$]|[$]$" "" part "${part}")
  string(REPLACE "(" "`" part "${part}") # of a call whose arguments do not matter
  string(REGEX MATCHALL "[A-Za-z_0-9]+|[.@][a-z0-9_]+|." tokens "${part}")
  set(regex "")
  set(names "")
  set(begins "[^A-Za-z0-9_.@*/]") # before an operand of which nothing before says where it begins
  set(ends "")
  set(is_operand FALSE)
  set(after "[^A-Za-z0-9_.@`]") # after the last operand
  if(part MATCHES "[+-]")
    set(after "[^A-Za-z0-9_.@`*]") # a term ends
  endif()
  foreach(token IN LISTS tokens)
    set(ends "${after}")
    if(token MATCHES "^[XYZW]$")
      string(TOLOWER "${token}" small)
      string(FIND "XYZW" "${token}" digit)
      string(APPEND regex "${begins}[A-Za-z0-9_.@]*[${small}${digit}]")
    elseif(token MATCHES "^[A-Z]$")
      string(APPEND regex "${begins}([A-Za-z_][A-Za-z0-9_.@]*)")
      list(APPEND names "${token}")
    elseif(token MATCHES "^[0-9]")
      string(APPEND regex "${begins}${token}")
    elseif(token STREQUAL "!") # the operand that a letter before stood for
      set(is_operand TRUE)
      continue()
    elseif(token MATCHES "^[A-Za-z_]" AND is_operand)
      string(APPEND regex "${begins}${token}")
    elseif(token MATCHES "^[A-Za-z_]") # also the end of a name: cross( is lane_f64_vec3_cross( too
      string(APPEND regex "${token}")
      set(ends "")
    elseif(token STREQUAL "~")
      string(APPEND regex "[^$=]*")
      set(begins "[^A-Za-z0-9_.@]")
      set(ends "")
      continue()
    else()
      if(NOT token MATCHES "^[.@].")
        set(ends "")
      endif()
      string(REGEX REPLACE "([][+.*()^?|\\$])" "\\\\\\1" token "${token}")
      string(APPEND regex "${token}")
    endif()
    set(begins "")
    set(is_operand FALSE)
  endforeach()
  set(${out} "${regex}${ends}" PARENT_SCOPE)
  set(${letters} "${names}" PARENT_SCOPE)
endfunction()

# Whether text has all parts, the same letter being the same operand.
function(has_parts text out)
  set(${out} FALSE PARENT_SCOPE)
  set(parts ${ARGN})
  if(NOT parts)
    set(${out} TRUE PARENT_SCOPE)
    return()
  endif()
  list(POP_FRONT parts part)
  regex_of("${part}" regex letters)
  string(REGEX MATCHALL "${regex}" matches "${text}")
  foreach(match IN LISTS matches)
    string(REGEX MATCH "${regex}" unused "${match}")
    set(rest "${parts}")
    set(known "")
    set(is_same TRUE)
    set(number 0)
    foreach(letter IN LISTS letters)
      math(EXPR number "${number} + 1")
      set(operand "${CMAKE_MATCH_${number}}")
      if(letter IN_LIST known AND NOT operand STREQUAL value_${letter})
        set(is_same FALSE)
      endif()
      list(APPEND known ${letter})
      set(value_${letter} "${operand}")
    endforeach()
    if(NOT is_same)
      continue()
    endif()
    list(REMOVE_DUPLICATES known)
    foreach(letter IN LISTS known)
      string(REGEX REPLACE "(^|[^A-Za-z0-9_])${letter}([^A-Za-z0-9_]|$)" "\\1!${value_${letter}}\\2" rest "${rest}")
      string(REGEX REPLACE "(^|[^A-Za-z0-9_])${letter}([^A-Za-z0-9_]|$)" "\\1!${value_${letter}}\\2" rest "${rest}")
    endforeach()
    has_parts("${text}" is_found ${rest})
    if(is_found)
      set(${out} TRUE PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

set(found "")
set(formulas "")
set(fingerprint_count 0)
function(formula name)
  foreach(fingerprint IN LISTS ARGN)
    string(REPLACE "&" ";" parts "${fingerprint}")
    set(some "${units}")
    foreach(part IN LISTS parts)
      regex_of("${part}" regex letters)
      list(FILTER some INCLUDE REGEX "${regex}")
    endforeach()
    foreach(unit IN LISTS some)
      has_parts("${unit}" is_found ${parts})
      if(is_found AND unit MATCHES "^([^ ]+) ([^ ]+) ")
        list(APPEND found "${name}|${CMAKE_MATCH_1}|${CMAKE_MATCH_2}")
      endif()
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES found)
  list(LENGTH ARGN count)
  math(EXPR fingerprint_count "${fingerprint_count} + ${count}")
  set(fingerprint_count ${fingerprint_count} PARENT_SCOPE)
  set(found "${found}" PARENT_SCOPE)
  list(APPEND formulas "${name}")
  set(formulas "${formulas}" PARENT_SCOPE)
endfunction()

# The library begins at the end nearer to t; `back` and `nearer` are the distance from it and its value.
formula("Linear interpolation"
  "A + T*(B - A)" "A + (B - A)*T" "(B - A)*T + A" "T*(B - A) + A" "(1 - T)*A + T*B" "(1 - T)*A + B*T" "A*(1 - T) + B*T"
  "A*(1 - T) + T*B" "T*B + (1 - T)*A" "B*T + A*(1 - T)" "S = 1 - T & S*A + T*B" "S = 1 - T & A*S + B*T"
  "add_scaled(A, ~sub(B, A)" "add(~scale(A, 1 - T)" "S = 1 - T & add(~scale(A, S), ~scale(B, T)" "back*(B - A)"
  "nearer + T*(B - A)")

formula("Inverse of linear interpolation" "(T - A)/(B - A)" "D = B - A & (T - A)/D")

formula("Smooth step"
  "T*T*(3 - 2*T)" "T*T*(3 - (T + T))" "T*T*(3 - T*2)" "(3 - 2*T)*T*T" "3*T*T - 2*T*T*T" "T*T*(1 + 2*~)"
  "U = T*T & U*(3 - 2*T)" "U = T*T & 3*U - 2*U*T" "U = T*T & V = U*T & 3*U - 2*V")

# s (v0 - f) - t (v1 - f), of registers too; the coefficients of u^2 and u^3.
formula("Hermite, value"
  "S*(A - F) - T*(B - F)" "~*(~ - F) - ~*(~ - F)" "3*D - 2*M - N & M + N - 2*D" "2*(A - B) + M + N" "2*A - 2*B + M + N")

formula("Hermite, weights"
  "2*T*T*T - 3*T*T + 1" "1 - 3*T*T + 2*T*T*T" "2*A - 3*B + 1 & B = T*T" "1 - 3*B + 2*A & B = T*T" "(1 + 2*T)*S*S"
  "(2*T + 1)*S*S" "(1 + 2*T)*(1 - T)" "T*T*T - 2*T*T + T" "A - 2*B + T & B = T*T" "T*T*(3 - 2*T) & T*S*S"
  "T*(1 - T)*(1 - T)" "T*(T - 1)*(T - 1)" "T*T*(T - 1)")

# The polynomials of Bernstein; the triangle of de Casteljau.
formula("Bézier"
  "3*T*S*S" "3*S*S*T" "3*(1 - T)*(1 - T)*T" "3*T*(1 - T)*(1 - T)" "3*T*T*(1 - T)" "Q = S*S & 3*T*Q" "Q = S*S & 3*Q*T"
  "S = 1 - T & Q = S*S & 3*~*Q*T" "S*A + T*B & S*B + T*C & S = 1 - T" "A + T*(B - A) & B + T*(C - B)"
  "S = 1 - T & T*(S*A + T*B)" "S = 1 - T & S*(S*A + T*B)")

# The weights, times 6; (a + 4 b + c)/6, the ends; s^3 h + t^3 m; the sums of weights.
formula("B-spline"
  "3*~*(T - 2)" "3*T*T*T - 6*T*T + 4" "4 - 6*T*T + 3*T*T*T" "3*T*T*T + 3*T*T + 3*T + 1" "1 + 3*T + 3*T*T - 3*T*T*T"
  "A + 4*B + C" "add_scaled(~, 4)" "S*~*H + T*~*M & H = F + ~ & ~/6" "3 + T*(3 - 2*T)")

formula("Catmull-Rom, value"
  "S*H + T*M & H = F + ~ & 0.5*~" "(1 - T)*H + T*M & H = F + ~" "1 + T - 1.5*~" "2*A - 5*B + 4*C - D"
  "3*B - A - 3*C + D" "3*T*T*T - 5*T*T + 2" "2*T*T - T*T*T - T" "-T*T*T + 2*T*T - T")

# Half the difference of the neighbours; the slope of the parabola through three points at any times.
formula("Catmull-Rom, tangent"
  "(A*U + B*V)/(U + V)" "(A*U + B*V)/(V + U)" "(A*w0 + B*w1)/" "(1 - C)*A + (1 + C)*B" "0.5*(Q.x - P.x)"
  "(Q.x - P.x)*0.5" "(Q.x - P.x)/2" "scale(~sub(A, B), 0.5)" "0.5*(P[I + 1] - P[I - 1])" "(P[I + 1] - P[I - 1])*0.5"
  "(P[I + 1] - P[I - 1])/2" "D = B - A & E = C - B & 0.5*(D + E)")

formula("Cubics, derivatives"
  "6*T*S" "6*T*(1 - T)" "6*T*T - 6*T" "6*T - 6*T*T" "3*T*T - 4*T + 1" "3*T*T - 2*T" "1 - 4*T + 3*T*T"
  "S - 2*T & S = 1 - T" "6 - 12*T" "12*T - 6" "6*T - 4" "3*C*T + 2*B" "A*R*R + 2*B*R*S" "-0.5*S*S" "0.5*T*(10*S"
  "3*T - 2" "9*T - 5" "6 - 18*T")

# The terms w1 x2 and x1 w2 of one component; w1 w2 - v1.v2.
formula("Quaternion product" "W*X + X*W" "X*W + W*X" "X*W ~+ W*X" "W*X ~+ X*W" "W*W - ~dot(")

# v + 2 w (u x v) + 2 u x (u x v); q v q*.
formula("Rotation of a vector"
  "C = ~cross(A, V) & cross(A, C)" "C = ~cross(A, V) & D = ~add(C, C) & cross(A, D)" "cross(A, ~cross(A"
  "C = ~scale(~cross(A, V), 2) & cross(A, C)" "C = ~cross(A, V) & D = ~scale(C, 2) & cross(A, D)"
  "mul(~mul(Q, ~), ~conjugate(Q)" "2*~dot(U, V) & W*W - ~dot(U, U)")

formula("Quaternion to matrix"
  "1 - (A + B) & 1 - (C + B) & 1 - (C + A) & P + Q & P - Q" "1 - 2*(Y*Y" "1 - 2*Y*Y"
  "1 - 2*(A + B) & 2*(C + D) & 2*(C - D)" "2*(X*Y + W*Z)" "2*(X*Y - W*Z)" "2*X*Y + 2*W*Z" "W*W + X*X - Y*Y - Z*Z"
  "ww - yy" "W*W - ~(A, A,")

# The diagonal of the matrix K; the trace.
formula("Matrix to quaternion"
  "1 + A - B - C & 1 - A + B - C" "A - B - C + 1" "1 + A + B + C & 1 + A - B - C" "A + B + C + 1"
  "1 + ~flip(~ + ~flip(~ + ~flip(" "M[0] + M[4] + M[8]" "M[0] + M[5] + M[10]")

formula("Axis and angle to quaternion" "A.x*H.s, A.y*H.s" "S = ~sin~(~ & X*S & Y*S & Z*S" "A.x*~sin~(")

formula("Euler angles to quaternion"
  "A*B*C + E*D*F*G & P*Q*R - E*S*T*U" "A*B*C + D*E*F & A*B*C - D*E*F" "A*B*C + D*E*F & P*Q*R - S*T*U")

formula("Euler angles to matrix" "D*E + A*B*C & P*Q - R*S*T" "A*B*C + D*E & P*Q*R - S*T")

formula("Rotation to Euler angles"
  "three_arcs(y," "atan2~(2*~, 1 - 2*~" "asin(2*" "asinf(2*" "atan2~(-~,~sqrt~(" "atan2~(M[" "asin(M[" "asin(-M["
  "asinf(-M[")

# (1 - t) a + t b, to be divided by its length; the angle of that sum.
formula("nlerp"
  "normalize(~lerp(" "normalize(~add(~scale(" "add(part, ~scale(" "part + T*U" "part.x + ~*C.x"
  "(1 - T)*A + P*C & atan2~(" "S = 1 - T & S*A.w + T*B.w" "(1 - T)*A.w + T*B.w")

# sin((1 - t) h)/sin h: a polynomial in a measure of the angle, a point of the great circle, or sines.
formula("slerp"
  "/(~ + ~*LANE_SLERP_BEND)" "arc_at(~arc, ~*" "S*A.w + T*B.w" "sin(~)/" "sinf(~)/" "sin64(~)/" "S = ~sin(~ & sin(~/S"
  "S = ~sinf(~ & sinf(~/S" "H = ~acos(~ & sin(~H" "H = ~acosf(~ & sinf(~H")

formula("Logarithm of a quaternion"
  "N = ~length(~ & atan2~(N, ~w" "S = ~sqrt~(~ & atan2~(S, ~w)" "atan2~(~length(~, ~w" "acos(~w" "acosf(~w")

formula("Exponential of a quaternion"
  "from_axis_half(~normalize(" "T = ~length(~ & sin(T) & cos(T)" "T = ~length(~ & sinf(T) & cosf(T)")

formula("Matrix product"
  "A[I]*K[0] + B[I]*K[1]" "A[I]*K[0] + A[3 + I]*K[1]" "A[I]*K[0] + A[4 + I]*K[1]" "P[I]*U + (P[3 + I])*V" "xy + M[2]*~"
  "mul(M[0], ~) + ~mul(M[1]," "+= A[4*~]*B[4*~]" "+= A[3*~]*B[3*~]" "+= A[I*4 + ~]*B[J*4 + ~]"
  "+= A[I*3 + ~]*B[J*3 + ~]" "+= A[I][K]*B[K][J]")

formula("Point by a matrix"
  "A[0]*X + A[4]*Y" "A[0]*X + A[3]*Y + A[6]*Z" "A[3]*X + A[7]*Y" "A[I]*x + A[3 + I]*y" "A[I]*x + A[4 + I]*y"
  "A[0]*X + A[1]*Y + A[2]*Z & A[4]*X + A[5]*Y" "x*P.x + y*P.y")

formula("Cofactors"
  "cross(B, C) & cross(C, A) & cross(A, B)" "P[0]*Q[1] - P[1]*Q[0] & P[0]*Q[2]" "a1*b2 - a2*b1" "M[4]*M[8] - M[5]*M[7]"
  "M[4]*M[8] - M[7]*M[5]" "M[5]*M[10] - M[9]*M[6]" "M[5]*M[10] - M[6]*M[9]")

formula("TRS to matrix"
  "from_quat(~ & ~*S.x & ~*S.y" "rotation(~ & R[0]*S" "nkw_mat3_from_quat_scale(~ & from_mat3(" "*scale[")

# The matrix, or rotation, of the parent times the local one.
formula("Model matrices of a hierarchy"
  "parents & mul~(" "parent & mul_affine(" "mul~(parent_of(" "mul~(~models[parent]" "mul~(parent, local")

formula("Weighted sum of joint matrices" "load~(~entry~*w" "M[I] += K*~.m[I]" "M[I] += ~.m[I]*K" "M.m[I] += K*~.m[I]")

formula("Translation of a dual quaternion"
  "A.x*B.w - A.w*B.x" "-A.w*B.x + A.x*B.w" "scale(A, D.real.w) & cross(" "mul(~dual, ~conjugate(~real")

formula("Exponential decay" "exp2_64(-" "exp2_64(~LANE_LOG2_E" "exp2_64(~690" "exp(-" "expf(-" "exp2f(-" "exp2(-")

formula("Spring" "D*(A.c + Y*A.s)" "A*B - C*D & ~ = 0.5*lane_decay64(" "stiffness*~ - ~damping*")

formula("Law of cosines" "(M - R)*(M + R) & (R - L)*(R + L)" "/(2*A*B)" "(A*A + B*B - C*C)/")

# ---- What docs/formulas.md lists ----

set(page docs/formulas.md)
file(STRINGS "${SOURCE}/${page}" lines ENCODING UTF-8 REGEX "^(## |[|] `)")
set(listed "")
set(headings "")
foreach(line IN LISTS lines)
  if(line MATCHES "^## (.*)$")
    set(name "${CMAKE_MATCH_1}")
    list(APPEND headings "${name}")
  elseif(line MATCHES "^[|] (`[^|]*`) [|] .([a-z0-9_./]+).[(][.][.]/([a-z0-9_./]+)[)] [|] binary(32|64) [|] [^|]+ [|]$"
      AND CMAKE_MATCH_2 STREQUAL CMAKE_MATCH_3)
    set(path "${CMAKE_MATCH_2}")
    string(REGEX MATCHALL "[A-Za-z0-9_]+" functions "${CMAKE_MATCH_1}")
    list(TRANSFORM functions PREPEND "${name}|${path}|")
    list(APPEND listed ${functions})
  else()
    message(SEND_ERROR "formulas: ${page} has a row of another form: ${line}")
  endif()
endforeach()
if(NOT headings STREQUAL formulas)
  message(SEND_ERROR "formulas: the headings of ${page} are not the formulas of this test: ${headings}")
endif()

set(missing "${found}")
list(REMOVE_ITEM missing ${listed})
foreach(item IN LISTS missing)
  string(REPLACE "|" ";" item "${item}")
  list(GET item 0 name)
  list(GET item 1 path)
  list(GET item 2 function)
  string(REPLACE "-" "outside of functions" function "${function}")
  message(SEND_ERROR "formulas: a second text of ${name}: ${path}: ${function}. Call one that ${page} lists, or list "
    "it there with the reason.")
endforeach()
set(gone "${listed}")
list(REMOVE_ITEM gone ${found})
foreach(item IN LISTS gone)
  string(REPLACE "|" ";" item "${item}")
  list(GET item 0 name)
  list(GET item 1 path)
  list(GET item 2 function)
  message(SEND_ERROR "formulas: ${page} lists ${path}: ${function} under ${name}: it is not there, "
    "or evaluates it no more")
endforeach()

list(LENGTH formulas formula_count)
list(LENGTH found found_count)
message(STATUS "formulas: ${formula_count} formulas, ${fingerprint_count} fingerprints, ${found_count} texts in "
  "${unit_count} functions")
if(unit_count LESS 2500 OR found_count LESS 100)
  message(SEND_ERROR "formulas: too little found under ${SOURCE}")
endif()
