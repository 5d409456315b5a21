#pragma once

// The C library in SLEEF's place: Debian has SLEEF for arm64 only on arm64 machines. The images do not depend on the
// last bit of an elementary function.
#include <cmath>

inline double Sleef_cinz_sind1_u10purec(double x) {
  return std::sin(x);
}
inline double Sleef_cinz_cosd1_u10purec(double x) {
  return std::cos(x);
}
inline double Sleef_cinz_tand1_u10purec(double x) {
  return std::tan(x);
}
inline double Sleef_cinz_asind1_u10purec(double x) {
  return std::asin(x);
}
inline double Sleef_cinz_acosd1_u10purec(double x) {
  return std::acos(x);
}
inline double Sleef_cinz_atan2d1_u10purec(double y, double x) {
  return std::atan2(y, x);
}
inline double Sleef_cinz_expd1_u10purec(double x) {
  return std::exp(x);
}
inline double Sleef_cinz_expm1d1_u10purec(double x) {
  return std::expm1(x);
}
inline double Sleef_cinz_logd1_u10purec(double x) {
  return std::log(x);
}
inline double Sleef_cinz_powd1_u10purec(double x, double y) {
  return std::pow(x, y);
}
inline double Sleef_cinz_coshd1_u10purec(double x) {
  return std::cosh(x);
}
inline double Sleef_cinz_sinhd1_u10purec(double x) {
  return std::sinh(x);
}
inline double Sleef_cinz_acoshd1_u10purec(double x) {
  return std::acosh(x);
}
inline double Sleef_cinz_cbrtd1_u10purec(double x) {
  return std::cbrt(x);
}
inline double Sleef_cinz_hypotd1_u05purec(double x, double y) {
  return std::hypot(x, y);
}
