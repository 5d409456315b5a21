# bodkin_precompiled(TARGET [TESTS]): TARGET starts from headers that are already parsed: the standard library, Eigen and fmt;
# with TESTS GoogleTest and JSON too. The first target of each kind compiles them, the others reuse them, so all of one kind
# must have the same compiler options.
include_guard(GLOBAL)

function(bodkin_precompiled target)
  cmake_parse_arguments(ARG "TESTS" "" "" ${ARGN})
  if(ARG_TESTS)
    set(kind tests)
    set(more <fmt/format.h> <nlohmann/json.hpp> <gtest/gtest.h> <gmock/gmock.h>)
  else()
    set(kind modules)
    set(more "")
  endif()
  get_property(owner GLOBAL PROPERTY bodkin_precompiled_${kind})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
    return()
  endif()
  set_property(GLOBAL PROPERTY bodkin_precompiled_${kind} ${target})
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <atomic> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory>
    <optional> <random> <regex> <sstream> <stdexcept> <string> <thread> <utility> <variant> <vector> <Eigen/Dense> ${more})
endfunction()
