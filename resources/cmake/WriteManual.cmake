# cmake -DPROGRAM=... -DFRAME=pellucida.1.in -DMANUAL=pellucida.1 -DPROJECT_VERSION=... -P WriteManual.cmake
execute_process(COMMAND ${PROGRAM} --manual-of-commands OUTPUT_VARIABLE PELLUCIDA_MANUAL_OF_COMMANDS
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(TIMESTAMP date "%Y-%m-%d" UTC)
configure_file(${FRAME} ${MANUAL} @ONLY)
