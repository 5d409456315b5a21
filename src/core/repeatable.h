#pragma once

// Elementary functions with the same bits on every processor. Those of the C library choose their code by processor:
// glibc 2.36 differs in the last bit, with and without fused multiply-add, in one of about 1,500 arguments of exp,
// sin, cos, pow or atan2, and a session would then not replay on an older machine. These are SLEEF's, correct within
// one unit in the last place, at two to six times the cost of the C library's. Everything that decides a force or
// a motion calls them (a test of the layout sees to it). What is only shown need not, and neither need what makes
// patients, which are kept in files. The square root and std::fma are exact anyway.
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
