# cmake -DSOURCE=... -DWORK=... -DHERE=... [-DLAUNCHER=...] -P run.cmake: builds SOURCE for arm64 below WORK, takes the
# pictures there under the emulator and with the program HERE on this processor, and compares them.
foreach(tool aarch64-linux-gnu-g++ ninja qemu-aarch64)
  find_program(found_${tool} ${tool})
  if(NOT found_${tool})
    message(FATAL_ERROR "the program '${tool}' is missing: apt-get install g++-aarch64-linux-gnu ninja-build qemu-user")
  endif()
endforeach()

function(must)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "failed (${code}): ${ARGN}")
  endif()
endfunction()

must(${CMAKE_COMMAND} -G Ninja -S "${SOURCE}" -B "${WORK}" --toolchain "${SOURCE}/toolchain.cmake"
     -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0
     "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}")
must(${CMAKE_COMMAND} --build "${WORK}" --parallel 2)
message("arm64")
must(qemu-aarch64 "${WORK}/ultrasound_pictures" "${WORK}/arm64.pictures")
message("here")
must("${HERE}" "${WORK}/here.pictures")
must("${HERE}" "${WORK}/here.pictures" "${WORK}/arm64.pictures")
