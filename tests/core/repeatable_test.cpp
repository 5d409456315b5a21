// Elementary functions that have the same bits on every processor: correct within one unit in the last place of
// arithmetic with 64 bits of mantissa, which is the processor's own or the emulator's.
#include "core/repeatable.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {
namespace {

struct Function {
  std::string name;
  std::function<double(double)> ours;
  std::function<long double(long double)> reference;
  double low, high;
};

// Units in the last place of a double.
double units_apart(double value, long double reference) {
  const double rounded = static_cast<double>(reference);
  const double unit = std::nextafter(std::abs(rounded), std::numeric_limits<double>::infinity()) - std::abs(rounded);
  return static_cast<double>(std::abs(static_cast<long double>(value) - reference)) / unit;
}

TEST(Repeatable, functions_are_correct_within_one_unit_in_the_last_place) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is no more than double here";
  using namespace repeatable;
  const std::vector<Function> functions = {
      {"sin", [](double x) { return sin(x); }, [](long double x) { return sinl(x); }, -10.0, 10.0},
      {"cos", [](double x) { return cos(x); }, [](long double x) { return cosl(x); }, -10.0, 10.0},
      {"tan", [](double x) { return tan(x); }, [](long double x) { return tanl(x); }, -10.0, 10.0},
      {"asin", [](double x) { return asin(x); }, [](long double x) { return asinl(x); }, -1.0, 1.0},
      {"acos", [](double x) { return acos(x); }, [](long double x) { return acosl(x); }, -1.0, 1.0},
      {"atan2", [](double x) { return atan2(x, 0.7); }, [](long double x) { return atan2l(x, 0.7); }, -5.0, 5.0},
      {"exp", [](double x) { return exp(x); }, [](long double x) { return expl(x); }, -40.0, 40.0},
      {"expm1", [](double x) { return expm1(x); }, [](long double x) { return expm1l(x); }, -5.0, 5.0},
      {"sin, where it needs no reduction", [](double x) { return sin(x); }, [](long double x) { return sinl(x); },
       -0.8, 0.8},
      {"sin of many turns", [](double x) { return sin(x); }, [](long double x) { return sinl(x); }, -1100.0, 1100.0},
      {"cos, where it needs no reduction", [](double x) { return cos(x); }, [](long double x) { return cosl(x); },
       -0.8, 0.8},
      {"cos of many turns", [](double x) { return cos(x); }, [](long double x) { return cosl(x); }, -1100.0, 1100.0},
      {"atan2 of small angles", [](double x) { return atan2(x, 0.7); }, [](long double x) { return atan2l(x, 0.7); },
       -0.2, 0.2},
      {"exp of small numbers", [](double x) { return exp(x); }, [](long double x) { return expl(x); }, -0.1, 0.1},
      {"exp of large numbers", [](double x) { return exp(x); }, [](long double x) { return expl(x); }, -705.0, 705.0},
      {"expm1 of small numbers", [](double x) { return expm1(x); }, [](long double x) { return expm1l(x); }, -0.3,
       0.3},
      {"expm1 of large numbers", [](double x) { return expm1(x); }, [](long double x) { return expm1l(x); }, -705.0,
       705.0},
      {"log", [](double x) { return log(x); }, [](long double x) { return logl(x); }, 1e-9, 1e3},
      {"pow", [](double x) { return pow(x, 1.7); }, [](long double x) { return powl(x, 1.7); }, 1e-6, 1e3},
      {"cosh", [](double x) { return cosh(x); }, [](long double x) { return coshl(x); }, -10.0, 10.0},
      {"sinh", [](double x) { return sinh(x); }, [](long double x) { return sinhl(x); }, -10.0, 10.0},
      {"acosh", [](double x) { return acosh(x); }, [](long double x) { return acoshl(x); }, 1.0, 1e4},
      {"cbrt", [](double x) { return cbrt(x); }, [](long double x) { return cbrtl(x); }, -1e3, 1e3},
      {"hypot", [](double x) { return hypot(x, 0.3); }, [](long double x) { return hypotl(x, 0.3); }, -5.0, 5.0},
  };
  Random random(3);
  for (const Function& function : functions) {
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
      const double x = function.low + (function.high - function.low) * random.uniform();
      worst = std::max(worst, units_apart(function.ours(x), function.reference(x)));
    }
    EXPECT_LE(worst, 1.0) << function.name;
    EXPECT_GT(worst, 0.3) << function.name << ": the reference is not finer than a double";
  }
}

// Where the reduction by quarters of a turn loses the most digits.
TEST(Repeatable, sine_and_cosine_are_correct_next_to_whole_quarters_of_a_turn) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is no more than double here";
  for (int quarter = 1; quarter < 700; ++quarter) {
    const double nearest = quarter * 0.5 * std::numbers::pi;
    for (const double x : {std::nextafter(nearest, 0.0), nearest, std::nextafter(nearest, 1e9)}) {
      EXPECT_LE(units_apart(repeatable::sin(x), sinl(x)), 1.0) << x;
      EXPECT_LE(units_apart(repeatable::cos(x), cosl(x)), 1.0) << x;
    }
  }
}

TEST(Repeatable, ends_of_their_ranges_are_the_c_librarys) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(repeatable::exp(-infinity), 0.0);
  EXPECT_EQ(repeatable::exp(-1e4), 0.0);
  EXPECT_EQ(repeatable::exp(1e4), infinity);
  EXPECT_EQ(repeatable::expm1(-1e-300), -1e-300);
  EXPECT_EQ(repeatable::expm1(-infinity), -1.0);
  EXPECT_EQ(repeatable::log(0.0), -infinity);
  EXPECT_EQ(repeatable::pow(0.0, 0.5), 0.0);
  EXPECT_EQ(repeatable::pow(2.0, 10.0), 1024.0);
  EXPECT_EQ(repeatable::acos(1.0), 0.0);
  EXPECT_EQ(repeatable::acosh(1.0), 0.0);
  EXPECT_EQ(repeatable::sin(0.0), 0.0);
  EXPECT_EQ(repeatable::cos(0.0), 1.0);
  EXPECT_EQ(repeatable::atan2(0.0, -1.0), std::acos(-1.0));
  EXPECT_EQ(repeatable::atan2(0.0, 0.0), 0.0);
  EXPECT_TRUE(std::isnan(repeatable::acos(1.5)));
  EXPECT_TRUE(std::isnan(repeatable::exp(std::nan(""))));
}

}  // namespace
}  // namespace bodkin
