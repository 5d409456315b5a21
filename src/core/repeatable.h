#pragma once

// Elementary functions with the same bits on every processor. The C library chooses its code by processor: glibc 2.36
// differs in the last bit, with and without fused multiply-add, for one of about 1,500 arguments of exp, sin, cos,
// pow or atan2, and a session would then not replay on an older machine. These functions are correct within one unit
// in the last place. sin, cos, exp, expm1, and atan2 up to a ratio of 1/4 are about as fast as the C library's; the
// others are SLEEF's, at two to six times the cost. Code that determines a force or a motion must call them (a test
// of the layout checks it). Display code need not, and neither need code that generates patients, which are stored in
// files. The square root and std::fma are exact anyway.
namespace bodkin::repeatable {

double sin(double x) noexcept;
double cos(double x) noexcept;
double tan(double x) noexcept;
double asin(double x) noexcept;
double acos(double x) noexcept;
double atan2(double y, double x) noexcept;
double exp(double x) noexcept;
double expm1(double x) noexcept;
double log(double x) noexcept;
double pow(double x, double exponent) noexcept;
double cosh(double x) noexcept;
double sinh(double x) noexcept;
double acosh(double x) noexcept;
double cbrt(double x) noexcept;
double hypot(double x, double y) noexcept;

}  // namespace bodkin::repeatable
