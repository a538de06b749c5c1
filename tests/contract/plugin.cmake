cmake_minimum_required(VERSION 3.22)
# A plug-in exports its own functions, and none of the static library that it contains: a second copy in the process
# would take the place of its own.
execute_process(COMMAND "${NM}" -D --defined-only "${PLUGIN}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT symbols MATCHES " T plugin_angle\n")
  message(SEND_ERROR "plugin: it does not export its own function")
endif()
string(REGEX MATCHALL " nkwi?_[a-z0-9_]+" exported "${symbols}")
if(exported)
  message(SEND_ERROR "plugin: it exports${exported}")
endif()
