# All public headers in a file that included others before them: those of the system where they are found, and names
# that others define as macros, as a token that no declaration can hold.
set(object_like
  # windows.h
  near far NEAR FAR cdecl CDECL pascal PASCAL huge small hyper interface IN OUT OPTIONAL CONST VOID TRUE FALSE ERROR
  NO_ERROR DELETE INFINITE THIS PURE STRICT UNICODE CALLBACK WINAPI APIENTRY ABSOLUTE RELATIVE DIFFERENCE TRANSPARENT
  OPAQUE INPUT BOOLEAN CreateWindow DrawText GetMessage GetObject LoadImage SendMessage Yield environ grp1 frm1 rad1
  psh1 edt1 lst1 cmb1 ctl1 rct1 stc1 ico1 scr1 s_addr s_host s_net h_addr
  # Qt
  slots signals emit foreach forever
  # X11
  None Bool Status Success True False Always Above Below Unsorted Convex Complex Nonconvex CursorShape KeyPress
  KeyRelease FocusIn FocusOut Expose GrayScale GrabModeSync Button1 ControlMask ShiftMask LockMask Opposite Color
  # complex.h
  I complex imaginary _Imaginary_I
  # curses
  ERR OK LINES COLS TABSIZE stdscr curscr newscr ttytype acs_map
  # Arduino and the registers of AVR
  B0 B1 B00 B01 B10 B11 B000 B111 F_CPU HIGH LOW PI HALF_PI TWO_PI DEG_TO_RAD RAD_TO_DEG EULER SERIAL DISPLAY CHANGE
  RISING FALLING DEFAULT EXTERNAL INTERNAL LSBFIRST MSBFIRST PORTB DDRB PINB SP SREG
  # macOS, Objective-C, AltiVec, iso646.h, math.h, termios.h, and systems by their names
  nil Nil YES NO vector pixel bool and or not xor compl bitand bitor M_PI M_E HUGE DOMAIN SING OVERFLOW UNDERFLOW
  MAXFLOAT ECHO B50 B110 unix linux sun mips sparc arm vax hpux sgi i386 current st_mtime st_atime)
set(function_like
  # windows.h, Qt, Arduino
  min max SIGNAL SLOT TEXT abs round sq bit constrain radians degrees interrupts noInterrupts lowByte highByte bitRead
  bitSet bitClear bitWrite word map F
  # sys/sysmacros.h, macOS, tgmath.h, stdlib.h
  major minor makedev check verify require assert_param sqrt sin cos tan pow exp log floor ceil trunc fabs fmin fmax
  remainder real imag swap countof alloca index rindex
  # curses
  addch box border clear color_set delay erase filter getch getyx getmaxyx hline vline inch insch instr meta mouse move
  refresh scroll scrl setscrreg standout timeout touchwin attron attroff attrset beep flash)
set(macros "")
foreach(name IN LISTS object_like)
  string(APPEND macros "#undef ${name}\n#define ${name} @ ${name} is a macro of others @\n")
endforeach()
foreach(name IN LISTS function_like)
  string(APPEND macros "#undef ${name}\n#define ${name}(...) @ ${name} is a macro of others @\n")
endforeach()
set(real "")
foreach(header IN ITEMS windows.h X11/Xlib.h X11/Xutil.h curses.h complex.h sys/sysmacros.h termios.h)
  string(APPEND real "#if __has_include(<${header}>)\n#include <${header}>\n#endif\n")
endforeach()
set(all "")
foreach(header IN LISTS headers)
  if(NOT header MATCHES "/inline/") # they come with the others, where NKW_INLINE lets them
    string(APPEND all "#include <${header}>\n")
  endif()
endforeach()
# The headers of the compiler come first. In C++ some of the names are keywords.
set(before "#include <float.h>\n#include <math.h>\n#include <stddef.h>\n#include <stdint.h>\n#include <string.h>\n")
string(REGEX REPLACE "#undef (and|or|not|xor|compl|bitand|bitor|bool)\n#define [^\n]*\n" "" macros_cxx "${macros}")
set(sources "")
foreach(branch IN ITEMS NKW_USUAL NKW_PLAIN NKW_NO_INLINE)
  set(begin "#define ${branch}\n")
  set(base "${CMAKE_CURRENT_BINARY_DIR}/others/${branch}")
  file(CONFIGURE OUTPUT "${base}_names.c" CONTENT "${begin}${before}${macros}${all}" @ONLY)
  file(CONFIGURE OUTPUT "${base}_names.cpp" CONTENT "${begin}${before}${macros_cxx}${all}" @ONLY)
  set(sources ${sources} "${base}_names.c" "${base}_names.cpp")
  if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
    file(CONFIGURE OUTPUT "${base}_real.c" CONTENT "${begin}${real}${all}" @ONLY)
    string(REPLACE "#if __has_include(<complex.h>)\n#include <complex.h>\n#endif\n" "" real_cxx "${real}")
    file(CONFIGURE OUTPUT "${base}_real.cpp" CONTENT "${begin}${real_cxx}${all}" @ONLY)
    set(sources ${sources} "${base}_real.c" "${base}_real.cpp")
  endif()
endforeach()
nkw_compile(nakawari_headers_after_others 11 ${sources})
