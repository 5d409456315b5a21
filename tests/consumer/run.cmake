# cmake -DBUILD=... -DSOURCE=... -DWORK=... -P run.cmake: installs Bodkin's build BUILD below WORK and builds SOURCE with it.
function(must)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "failed (${code}): ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
must(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/installed")
must(${CMAKE_COMMAND} -S "${SOURCE}" -B "${WORK}/build" -DCMAKE_PREFIX_PATH=${WORK}/installed -DCMAKE_BUILD_TYPE=Release)
must(${CMAKE_COMMAND} --build "${WORK}/build")
must(${CMAKE_COMMAND} -E chdir "${WORK}/build" "${WORK}/build/consumer")
must("${WORK}/installed/bin/bodkin" --version)
