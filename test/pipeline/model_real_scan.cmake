# SPDX-License-Identifier: BSD-3-Clause
# Models a scan of the folder SEDR_DATA, if it is there: cmake -DSEDR= -DSCAN= -DMODEL= -P
set(scan $ENV{SEDR_DATA}/${SCAN}.pcd)
file(REMOVE_RECURSE ${MODEL})
if(NOT SCAN MATCHES "^(apartment|stepped_room)$")
  set(options --no-mesh)
endif()
if(EXISTS ${scan})
  execute_process(COMMAND ${SEDR} ${scan} ${MODEL} ${options} RESULT_VARIABLE result)
  if(result)
    message(FATAL_ERROR "${scan}: ${result}")
  endif()
endif()
