# bodkin_precompiled(TARGET): TARGET starts from the standard library, Eigen, fmt, GoogleTest and JSON already parsed.
# The first target compiles the header, the others reuse it, so all of them must have the same compiler options.
include_guard(GLOBAL)

function(bodkin_precompiled target)
  get_property(owner GLOBAL PROPERTY bodkin_precompiled)
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
    return()
  endif()
  set_property(GLOBAL PROPERTY bodkin_precompiled ${target})
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <atomic> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory>
    <optional> <random> <regex> <sstream> <stdexcept> <string> <thread> <utility> <variant> <vector>
    <Eigen/Dense> <fmt/format.h> <nlohmann/json.hpp> <gtest/gtest.h> <gmock/gmock.h>)
endfunction()
