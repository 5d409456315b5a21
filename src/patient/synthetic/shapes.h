#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry.h"

// Implicit shapes from which the synthetic patient is built: functions of position that are negative inside, positive
// outside and near the surface about the distance to it in mm. Only + - * / and square roots are used, which IEEE 754
// rounds identically everywhere, so that the same parameters give the same voxels on every machine.
namespace bodkin::patient::shapes {

// sin and cos by their series (Taylor to the 15th and 16th power; error below 1e-12 for |angle| <= 1.6 rad). Those of
// the mathematical library differ in the last bit from machine to machine.
inline double sine(double angle) {
  const double square = angle * angle;
  double sum = 0.0, term = angle;
  for (int n = 1; n <= 15; n += 2) {
    sum += term;
    term *= -square / ((n + 1) * (n + 2));
  }
  return sum;
}
inline double cosine(double angle) {
  const double square = angle * angle;
  double sum = 0.0, term = 1.0;
  for (int n = 0; n <= 16; n += 2) {
    sum += term;
    term *= -square / ((n + 1) * (n + 2));
  }
  return sum;
}
constexpr double degrees = 3.14159265358979323846 / 180.0;

// Rotation about the patient's x (left), y (posterior) or z (superior) axis, rad.
inline Mat3 rotation(int axis, double angle) {
  const double c = cosine(angle), s = sine(angle);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  Mat3 matrix = Mat3::Identity();
  matrix(a, a) = c;
  matrix(b, b) = c;
  matrix(a, b) = -s;
  matrix(b, a) = s;
  return matrix;
}

// Union whose crease is filled with a fillet of about k mm; symmetric in a and b.
inline double blend(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - 0.25 * h * h * k;
}

// Intersection of two half spaces with an edge rounded to radius r.
inline double rounded_intersection(double a, double b, double r) {
  const double x = a + r, y = b + r;
  return std::min(std::max(x, y), 0.0) +
         std::sqrt(std::max(x, 0.0) * std::max(x, 0.0) + std::max(y, 0.0) * std::max(y, 0.0)) - r;
}

// Ellipse about the origin with half axes a and b.
inline double ellipse(double x, double y, double a, double b) {
  const double u = x / a, v = y / b;
  const double k0 = std::sqrt(u * u + v * v);
  const double k1 = std::sqrt(u * u / (a * a) + v * v / (b * b));
  return k1 > 1e-9 ? k0 * (k0 - 1.0) / k1 : -std::min(a, b);
}

// Superellipse |x/a|^2.5 + |y/b|^2.5 = 1: between an ellipse and a rectangle, as torsos and vertebral bodies are.
inline double superellipse(double x, double y, double a, double b) {
  const double u = std::abs(x) / a, v = std::abs(y) / b;
  const double u15 = u * std::sqrt(u), v15 = v * std::sqrt(v);
  const double gu = 2.5 * u15 / a, gv = 2.5 * v15 / b;
  const double gradient = std::sqrt(gu * gu + gv * gv);
  const double value = u15 * u + v15 * v - 1.0;
  return gradient > 1e-4 ? std::max(value / gradient, -std::min(a, b)) : -std::min(a, b);
}

inline double ellipsoid(const Vec3& p, const Vec3& radii) {
  const Vec3 q = p.cwiseQuotient(radii);
  const double k0 = q.norm(), k1 = q.cwiseQuotient(radii).norm();
  return k1 > 1e-9 ? k0 * (k0 - 1.0) / k1 : -radii.minCoeff();
}

// An ellipsoid swept from `a` to `b` while its half axes change from `radii_a` to `radii_b`.
struct Rod {
  Vec3 a, b;
  Vec3 radii_a, radii_b;
};

inline double distance(const Rod& rod, const Vec3& p) {
  const Vec3 axis = rod.b - rod.a;
  const double t = std::clamp((p - rod.a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return ellipsoid(p - rod.a - t * axis, rod.radii_a + t * (rod.radii_b - rod.radii_a));
}

}  // namespace bodkin::patient::shapes
