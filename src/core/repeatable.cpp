#include "core/repeatable.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <sleef.h>

// "cinz": the same result on every platform; "purec": no instructions beyond plain C, and no fused multiply-add.
// SLEEF's functions compute with twice the digits throughout, which is noticeable in a tick. For the functions and
// arguments that are frequent in ticks, the textbook method is used here instead: the argument is reduced, and a
// Taylor series evaluates the rest to below a hundredth of the last digit. The largest term is added last; its
// rounding error is added to the others. Only + - * / and integers, so the result is the same on every processor,
// too.
namespace bodkin::repeatable {
namespace {

constexpr double shift = 0x1.8p52;  // x + shift: the nearest whole number to x, in the last bits

struct Power {
  double value;
  double lacks;  // the relative error of `value`
};

// 2^(i/32)
constexpr std::array<Power, 32> powers = {{
    {1.0, 0.0},
    {0x1.059b0d3158574p+0, 0x1.cd2523567f613p-55},
    {0x1.0b5586cf9890fp+0, 0x1.79aa65d837b6dp-54},
    {0x1.11301d0125b51p+0, -0x1.556522a2fbd0ep-54},
    {0x1.172b83c7d517bp+0, -0x1.01b15eaa59348p-55},
    {0x1.1d4873168b9aap+0, 0x1.aecf73e3a2f60p-54},
    {0x1.2387a6e756238p+0, 0x1.68efde3a8a894p-54},
    {0x1.29e9df51fdee1p+0, 0x1.2f7e16d09ab31p-55},
    {0x1.306fe0a31b715p+0, 0x1.34d754db0abb6p-55},
    {0x1.371a7373aa9cbp+0, -0x1.24aedcc4b5068p-54},
    {0x1.3dea64c123422p+0, 0x1.59f48a72a4c6dp-55},
    {0x1.44e086061892dp+0, 0x1.363ed60c2ac11p-59},
    {0x1.4bfdad5362a27p+0, 0x1.690cebb7aafb0p-56},
    {0x1.5342b569d4f82p+0, -0x1.8dec6bd0f385fp-56},
    {0x1.5ab07dd485429p+0, 0x1.063e1e21c5409p-54},
    {0x1.6247eb03a5585p+0, -0x1.c33c53bef4da8p-55},
    {0x1.6a09e667f3bcdp+0, -0x1.3b3efbf5e2228p-54},
    {0x1.71f75e8ec5f74p+0, -0x1.81f647e5a3ecfp-56},
    {0x1.7a11473eb0187p+0, -0x1.b32dcb94da51dp-56},
    {0x1.82589994cce13p+0, -0x1.369b6f13b3734p-54},
    {0x1.8ace5422aa0dbp+0, 0x1.db72fc1f0eab4p-55},
    {0x1.93737b0cdc5e5p+0, -0x1.da9b88b6c1e29p-58},
    {0x1.9c49182a3f090p+0, 0x1.1affc2b91ce27p-56},
    {0x1.a5503b23e255dp+0, -0x1.1bbd1d3bcbb15p-54},
    {0x1.ae89f995ad3adp+0, 0x1.c1a7792cb3387p-55},
    {0x1.b7f76f2fb5e47p+0, -0x1.8d6f438ad9334p-57},
    {0x1.c199bdd85529cp+0, 0x1.36eae30af0cb3p-56},
    {0x1.cb720dcef9069p+0, 0x1.76b2c6c921968p-57},
    {0x1.d5818dcfba487p+0, 0x1.4a385a63d07a7p-56},
    {0x1.dfc97337b9b5fp+0, -0x1.2d52107b43e1fp-55},
    {0x1.ea4afa2a490dap+0, -0x1.ff7128fd391f0p-55},
    {0x1.f50765b6e4540p+0, 0x1.a64a931d185eep-55},
}};

// x = k ln(2)/32 + r, |r| <= ln(2)/64; exp(x) = scale + scale * more
struct Exponential {
  double scale, more;
};

Exponential exponential(double x) noexcept {
  const double shifted = x * 0x1.71547652b82fep+5 + shift, k = shifted - shift;
  // The first part of ln(2)/32 has 33 bits, so that its product is exact.
  const double r = (x - k * 0x1.62e42fefp-6) - k * 0x1.473de6af278edp-39, s = r * r;
  const double series = r + s * ((0.5 + r * (1.0 / 6)) + s * ((1.0 / 24 + r * (1.0 / 120)) + s * (1.0 / 720)));
  const std::uint64_t whole = std::bit_cast<std::uint64_t>(shifted);
  const Power& power = powers[whole % 32];
  return {std::bit_cast<double>(std::bit_cast<std::uint64_t>(power.value) + (whole / 32 << 52)),
          power.lacks + series};
}

// x = quarter pi/2 + value + lacks, |value| <= pi/4
struct Reduced {
  double value, lacks;
  std::uint64_t quarter;
};

constexpr double largest_turn = 1000.0;  // beyond it, pi/2 would need more digits

Reduced reduced(double x) noexcept {
  if (std::abs(x) <= 0.785) return {x, 0.0, 0};
  const double shifted = x * 0x1.45f306dc9c883p-1 + shift, k = shifted - shift;
  // The first two parts of pi/2 have 33 bits, so that their products are exact.
  const double first = x - k * 0x1.921fb544p+0, second = k * 0x1.0b4611a6p-34, value = first - second;
  // The rounding error of the subtraction, and the rest of pi/2.
  const double taken = first - value;
  const double lost = (first - (value + taken)) - (second - taken);
  return {value, lost - k * 0x1.3198a2e037073p-69, std::bit_cast<std::uint64_t>(shifted)};
}

double sine(double x, double lacks) noexcept {
  const double s = x * x, q = s * s;
  const double series =
      (-1.0 / 6 + s * (1.0 / 120)) +
      q * ((-1.0 / 5040 + s * (1.0 / 362880)) + q * ((-1.0 / 39916800 + s * (1.0 / 6227020800)) +
                                                     q * (-1.0 / 1307674368000 + s * (1.0 / 355687428096000))));
  return x + (x * (s * series) + lacks * (1.0 - 0.5 * s));
}

double cosine(double x, double lacks) noexcept {
  const double s = x * x, q = s * s, half = 0.5 * s, rough = 1.0 - half;
  const double series =
      (1.0 / 24 - s * (1.0 / 720)) +
      q * ((1.0 / 40320 - s * (1.0 / 3628800)) + q * ((1.0 / 479001600 - s * (1.0 / 87178291200)) +
                                                      q * (1.0 / 20922789888000 - s * (1.0 / 6402373705728000))));
  return rough + (((1.0 - rough) - half) + (q * series - x * lacks));
}

double by_quarter(const Reduced& x, std::uint64_t quarter) noexcept {
  const double size = quarter % 2 == 0 ? sine(x.value, x.lacks) : cosine(x.value, x.lacks);
  return quarter % 4 < 2 ? size : -size;
}

// The upper half of the digits: products of two such halves are exact.
double upper(double x) noexcept {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0x7ffffff});
}

// |y| <= x/4
double small_angle(double y, double x) noexcept {
  const double t = y / x, s = t * t, q = s * s;
  const double series = ((-1.0 / 3 + s * (1.0 / 5)) + q * (-1.0 / 7 + s * (1.0 / 9))) +
                        q * q *
                            (((-1.0 / 11 + s * (1.0 / 13)) + q * (-1.0 / 15 + s * (1.0 / 17))) +
                             q * q * ((-1.0 / 19 + s * (1.0 / 21)) + q * (-1.0 / 23 + s * (1.0 / 25))));
  // The rounding error of the division.
  const double x1 = upper(x), x2 = x - x1, t1 = upper(t), t2 = t - t1;
  const double rest = ((y - t1 * x1) - (t1 * x2 + t2 * x1)) - t2 * x2;
  return t + (rest * (1.0 / x) + t * (s * series));
}

}  // namespace

double sin(double x) noexcept {
  if (!(std::abs(x) <= largest_turn)) return Sleef_cinz_sind1_u10purec(x);
  const Reduced small = reduced(x);
  return by_quarter(small, small.quarter);
}
double cos(double x) noexcept {
  if (!(std::abs(x) <= largest_turn)) return Sleef_cinz_cosd1_u10purec(x);
  const Reduced small = reduced(x);
  return by_quarter(small, small.quarter + 1);
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
  if (std::abs(y) <= 0.25 * x && std::abs(y) > 1e-100 && x < 1e100) return small_angle(y, x);
  return Sleef_cinz_atan2d1_u10purec(y, x);
}
double exp(double x) noexcept {
  if (!(std::abs(x) < 700.0)) return Sleef_cinz_expd1_u10purec(x);
  const auto [scale, more] = exponential(x);
  return scale + scale * more;
}
double expm1(double x) noexcept {
  if (std::abs(x) <= 0.25) {
    const double s = x * x, q = s * s;
    const double series = ((1.0 / 6 + x * (1.0 / 24)) + s * (1.0 / 120 + x * (1.0 / 720))) +
                          q * (((1.0 / 5040 + x * (1.0 / 40320)) + s * (1.0 / 362880 + x * (1.0 / 3628800))) +
                               q * ((1.0 / 39916800 + x * (1.0 / 479001600)) + s * (1.0 / 6227020800)));
    return x + s * (0.5 + x * series);
  }
  if (!(std::abs(x) < 700.0)) return Sleef_cinz_expm1d1_u10purec(x);
  const auto [scale, more] = exponential(x);
  const double less = scale - 1.0;
  const double lost = scale > 1.0 ? (scale - less) - 1.0 : scale - (less + 1.0);
  return less + (lost + scale * more);
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
