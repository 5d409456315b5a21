#include "core/repeatable.h"

#include <sleef.h>

// "cinz": the same result on every platform; "purec": no instructions beyond plain C, and no fused multiply-add.
namespace bodkin::repeatable {

double sin(double x) noexcept {
  return Sleef_cinz_sind1_u10purec(x);
}
double cos(double x) noexcept {
  return Sleef_cinz_cosd1_u10purec(x);
}
double tan(double x) noexcept {
  return Sleef_cinz_tand1_u10purec(x);
}
double asin(double x) noexcept {
  return Sleef_cinz_asind1_u10purec(x);
}
double acos(double x) noexcept {
  return Sleef_cinz_acosd1_u10purec(x);
}
double atan2(double y, double x) noexcept {
  return Sleef_cinz_atan2d1_u10purec(y, x);
}
double exp(double x) noexcept {
  return Sleef_cinz_expd1_u10purec(x);
}
double expm1(double x) noexcept {
  return Sleef_cinz_expm1d1_u10purec(x);
}
double log(double x) noexcept {
  return Sleef_cinz_logd1_u10purec(x);
}
double pow(double x, double exponent) noexcept {
  return Sleef_cinz_powd1_u10purec(x, exponent);
}
double cosh(double x) noexcept {
  return Sleef_cinz_coshd1_u10purec(x);
}
double sinh(double x) noexcept {
  return Sleef_cinz_sinhd1_u10purec(x);
}
double acosh(double x) noexcept {
  return Sleef_cinz_acoshd1_u10purec(x);
}
double cbrt(double x) noexcept {
  return Sleef_cinz_cbrtd1_u10purec(x);
}
double hypot(double x, double y) noexcept {
  return Sleef_cinz_hypotd1_u05purec(x, y);
}

}  // namespace bodkin::repeatable
