# Runs at every build: writes core/version.h, and leaves it untouched (so nothing is rebuilt) while the commit is the same.
set(NUNO_COMMIT "unknown")
execute_process(
    COMMAND git -c safe.directory=* -C ${NUNO_SOURCE_DIR} describe --always --dirty --abbrev=12 --exclude=*
    OUTPUT_VARIABLE described
    OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET
    RESULT_VARIABLE failed)
if(failed STREQUAL "0" AND described)
    set(NUNO_COMMIT ${described})
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/version.h.in ${NUNO_OUTPUT} @ONLY)
