#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "study/fitting/fit.h"
#include <gtest/gtest.h>

#include "io/run_program.h"

namespace bodkin {

// Curves computed from the papers' equations by a script in another language (measured_by_others.py).
class CurvesOfOthers : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("python3 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "python3 is not installed here";
  }
  static study::MeasuredCurve curve_of(const std::vector<std::string>& what) {
    std::vector<std::string> command = {"python3", BODKIN_REPOSITORY "/tests/study/fitting/measured_by_others.py"};
    command.insert(command.end(), what.begin(), what.end());
    return study::parse_measured_curve(io::run_program(command, "", "python3").output, what.front() + ".csv");
  }
};

inline bool within(const study::CurveFit& fit, const std::string& name, double truth) {
  const study::FittedParameter& one = *fit.find(name);
  return one.low <= truth && truth <= one.high;
}

}  // namespace bodkin
