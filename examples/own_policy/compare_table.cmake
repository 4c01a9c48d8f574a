# Runs PROGRAM on SCENARIO and compares what it prints with the file TABLE.
execute_process(COMMAND ${PROGRAM} ${SCENARIO} OUTPUT_VARIABLE printed RESULT_VARIABLE code)
file(READ ${TABLE} expected)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${code}")
elseif(NOT printed STREQUAL expected)
  message(FATAL_ERROR "printed:\n${printed}\nexpected, as in ${TABLE}:\n${expected}")
endif()
