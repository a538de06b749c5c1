# The table of the one file of results that the run has left.
file(GLOB csv "${RESULTS}/*.csv")
execute_process(COMMAND "${TABLE}" "${csv}" COMMAND_ERROR_IS_FATAL ANY)
message("The results are in ${csv}")
