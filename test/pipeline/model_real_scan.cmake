# SPDX-License-Identifier: BSD-3-Clause
# Models a scan of the folder SEDR_DATA, if it is there: cmake -DSEDR= -DSCAN= -DMODEL= -P
# Where that fails, the tests of this model find none; those of the others go on.
set(scan $ENV{SEDR_DATA}/${SCAN}.pcd)
file(REMOVE_RECURSE ${MODEL})
if(NOT SCAN MATCHES "^(apartment|stepped_room)$")
  set(options --no-mesh)
endif()
if(EXISTS ${scan})
  execute_process(COMMAND ${SEDR} ${scan} ${MODEL} ${options} RESULT_VARIABLE result)
  if(result)
    message("${scan}: ${result}")
    file(MAKE_DIRECTORY ${MODEL})
  endif()
endif()
