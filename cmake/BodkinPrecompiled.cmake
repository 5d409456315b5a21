# bodkin_precompiled(TARGET [TESTS]): TARGET uses precompiled headers: the standard library, Eigen and fmt; with TESTS
# also GoogleTest and JSON. Each kind is compiled once, by a target of its own, so all targets of a kind must have the
# same compiler options and link fmt.
include_guard(GLOBAL)

function(bodkin_precompiled target)
  cmake_parse_arguments(ARG "TESTS" "" "" ${ARGN})
  set(owner bodkin_precompiled_modules)
  set(headers <algorithm> <array> <atomic> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory>
              <optional> <random> <regex> <sstream> <stdexcept> <string> <thread> <utility> <variant> <vector>
              <Eigen/Dense> <fmt/format.h>)
  if(ARG_TESTS)
    set(owner bodkin_precompiled_tests)
    list(APPEND headers <nlohmann/json.hpp> <gtest/gtest.h> <gmock/gmock.h>)
  endif()
  if(NOT TARGET ${owner})
    if(ARG_TESTS)  # a program, so that it is compiled like the tests
      file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/${owner}.cpp" CONTENT "int main() {}\n")
      add_executable(${owner} "${CMAKE_BINARY_DIR}/${owner}.cpp")
    else()
      file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/${owner}.cpp" CONTENT "")
      add_library(${owner} OBJECT "${CMAKE_BINARY_DIR}/${owner}.cpp")
    endif()
    bodkin_settings(${owner})
    if(ARG_TESTS AND NOT BODKIN_SANITIZERS)
      target_compile_options(${owner} PRIVATE -O1)
    endif()
    target_link_libraries(${owner} PRIVATE Eigen3::Eigen fmt::fmt Threads::Threads)
    if(ARG_TESTS)
      target_link_libraries(${owner} PRIVATE GTest::gmock nlohmann_json::nlohmann_json)
    endif()
    target_precompile_headers(${owner} PRIVATE ${headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
  target_compile_definitions(${target} PRIVATE FMT_SHARED)  # as when fmt was precompiled
endfunction()
