#include "patient/whole_body/body_shape.h"

#include <array>
#include <cmath>
#include <string>

#include "patient/synthetic/shapes.h"

#include "core/error.h"

namespace bodkin::patient {
namespace {

using shapes::blend;

constexpr double drawn_height = 1720.0;
constexpr double abduction = 33.0 * shapes::degrees;
constexpr double away = 400.0;  // a part too far away to matter

double ball(const Vec3& q, double x, double y, double z, double rx, double ry, double rz) {
  return shapes::ellipsoid(q - Vec3(x, y, z), Vec3(rx, ry, rz));
}

double rod(const Vec3& q, const Vec3& a, const Vec3& b, double ra, double rb) {
  const Vec3 axis = b - a;
  const double t = std::clamp((q - a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return (q - a - t * axis).norm() - (ra + t * (rb - ra));
}

void require(double value, double from, double to, const char* name, const char* unit) {
  if (value >= from && value <= to) return;
  std::string sentence = "synthetic body: ";
  sentence.append(name).append(" is ").append(std::to_string(value)).append(", expected ");
  sentence.append(std::to_string(from)).append(" to ").append(std::to_string(to)).append(" ").append(unit);
  throw InputError(sentence);
}

}  // namespace

void check_body(const BodyParameters& parameters) {
  require(parameters.height, 1.40, 2.05, "height", "m");
  require(parameters.weight, 40.0, 160.0, "weight", "kg");
  const double index = parameters.weight / (parameters.height * parameters.height);
  require(index, 15.0, 45.0, "weight over the square of height", "kg/m^2");
}

void Tube::add(double w, double at_a, double at_b, double radius_a, double radius_b) {
  centre_a.add(w, at_a);
  centre_b.add(w, at_b);
  half_a.add(w, radius_a);
  half_b.add(w, radius_b);
}

double Tube::distance(double a, double b, double w) const {
  const double end = std::max(from - w, w - to);
  if (end > 60.0) return away;
  const double at = std::clamp(w, from, to);
  const double x = a - centre_a(at), y = b - centre_b(at), rx = half_a(at), ry = half_b(at);
  const double side = squarish ? shapes::superellipse(x, y, rx, ry) : shapes::ellipse(x, y, rx, ry);
  return shapes::rounded_intersection(side, end, rounding);
}

BodyShape::BodyShape(const BodyParameters& parameters)
    : parameters_(parameters),
      scale_(1000.0 * parameters.height / drawn_height),
      girth_(std::sqrt(parameters.weight / (23.0 * parameters.height * parameters.height))),
      limb_girth_(1.0 + 0.6 * (girth_ - 1.0)),
      shoulder_width_(parameters.sex == Sex::female ? 0.94 : 1.0) {
  const bool female = parameters.sex == Sex::female;
  const double g = girth_, pelvis = female ? 1.05 : 1.0;
  // Height, half width, front, back.
  struct Section {
    double z, half_width, front, back;
  };
  const std::array<Section, 11> sections = {{{830.0, 165.0 * pelvis, -72.0, 105.0},
                                             {900.0, 172.0 * pelvis, -96.0, 112.0},
                                             {960.0, 166.0 * pelvis, -106.0, 104.0},
                                             {1018.0, 148.0, -112.0, 95.0},
                                             {1090.0, 140.0, -108.0, 92.0},
                                             {1194.0, 152.0, -112.0, 103.0},
                                             {1290.0, 163.0, -112.0, 112.0},
                                             {1345.0, 160.0, -92.0, 108.0},
                                             {1385.0, 140.0, -62.0, 96.0},
                                             {1410.0, 100.0, -42.0, 84.0},
                                             {1435.0, 70.0, -30.0, 74.0}}};
  for (const Section& s : sections) {
    // Above the ribs, bone sets the width: girth counts half there.
    const double grown = s.z > 1150.0 ? 1.0 + 0.5 * (g - 1.0) : g;
    const double front = s.front * (s.z < 1300.0 ? grown : 1.0), back = s.back * (1.0 + 0.5 * (grown - 1.0));
    trunk_.add(s.z, 0.0, 0.5 * (front + back), s.half_width * grown, 0.5 * (back - front));
  }
  trunk_.from = 842.0;
  trunk_.to = 1432.0;
  trunk_.rounding = 14.0;
  trunk_.squarish = true;

  const double n = 1.0 + 0.4 * (g - 1.0);
  neck_.add(1370.0, 0.0, 36.0, 64.0 * n, 58.0 * n);
  neck_.add(1440.0, 0.0, 30.0, 57.0 * n, 56.0 * n);
  neck_.add(1500.0, 0.0, 24.0, 55.0 * n, 56.0 * n);
  neck_.add(1570.0, 0.0, 24.0, 57.0 * n, 62.0 * n);
  neck_.from = 1375.0;
  neck_.to = 1582.0;
  neck_.rounding = 24.0;

  const double a = limb_girth_;
  arm_.add(-10.0, 0.0, 0.0, 46.0 * a, 50.0 * a);
  arm_.add(60.0, 2.0, 0.0, 48.0 * a, 50.0 * a);
  arm_.add(110.0, 0.0, 2.0, 44.0 * a, 47.0 * a);
  arm_.add(200.0, 0.0, 3.0, 42.0 * a, 46.0 * a);
  arm_.add(280.0, 0.0, 0.0, 42.0 * a, 37.0 * a);
  arm_.add(elbow, 0.0, 0.0, 42.0 * a, 36.0 * a);
  arm_.add(345.0, 0.0, 0.0, 44.0 * a, 38.0 * a);
  arm_.add(440.0, 0.0, 0.0, 36.0 * a, 30.0 * a);
  arm_.add(520.0, 0.0, 0.0, 29.0 * a, 21.0 * a);
  arm_.add(wrist, 0.0, 0.0, 29.0, 19.0);
  arm_.add(580.0, 0.0, 0.0, 34.0, 17.0);
  arm_.add(620.0, 0.0, 0.0, 41.0, 15.0);
  arm_.add(655.0, 0.0, 0.0, 41.0, 12.0);
  arm_.from = -12.0;
  arm_.to = 655.0;
  arm_.rounding = 9.0;

  leg_.add(880.0, 96.0, 12.0, 86.0 * a, 86.0 * a);
  leg_.add(800.0, 98.0, 12.0, 86.0 * a, 88.0 * a);
  leg_.add(700.0, 96.0, 10.0, 79.0 * a, 83.0 * a);
  leg_.add(600.0, 92.0, 8.0, 67.0 * a, 70.0 * a);
  leg_.add(505.0, 88.0, 6.0, 57.0 * a, 59.0 * a);
  leg_.add(450.0, 86.0, 8.0, 54.0 * a, 57.0 * a);
  leg_.add(410.0, 85.0, 14.0, 53.0 * a, 57.0 * a);
  leg_.add(335.0, 84.0, 22.0, 54.0 * a, 58.0 * a);
  leg_.add(250.0, 82.0, 24.0, 43.0 * a, 46.0 * a);
  leg_.add(150.0, 80.0, 26.0, 32.0 * a, 37.0 * a);
  leg_.add(95.0, 80.0, 28.0, 31.0, 37.0);
  leg_.add(40.0, 80.0, 30.0, 32.0, 40.0);
  leg_.from = 40.0;
  leg_.to = 890.0;

  shoulder_ = Vec3(181.0 * shoulder_width_ + 20.0 * (limb_girth_ - 1.0), 20.0, 1370.0);
  const double s = shapes::sine(abduction), c = shapes::cosine(abduction);
  arm_axes_.col(0) = Vec3(c, 0.0, s);       // to the thumb
  arm_axes_.col(1) = Vec3(0.0, -1.0, 0.0);  // to the palm
  arm_axes_.col(2) = Vec3(s, 0.0, -c);      // to the hand
}

double BodyShape::trunk_distance(const Vec3& q) const {
  if (q.z() < 760.0 || q.z() > 1500.0) return away;
  double d = trunk_.distance(q.x(), q.y(), q.z());
  // Buttocks, and the slope from the neck to the shoulder.
  d = blend(d, ball(q, 76.0, 62.0 * girth_, 878.0, 84.0, 70.0, 76.0), 24.0);
  d = blend(d, rod(q, Vec3(30.0, 34.0, 1420.0), Vec3(shoulder_.x() - 14.0, 24.0, 1388.0), 36.0, 34.0), 24.0);
  if (parameters_.sex == Sex::female) d = blend(d, ball(q, 88.0, -92.0, 1268.0, 58.0, 48.0, 52.0 * girth_), 26.0);
  return d;
}

double BodyShape::head_distance(const Vec3& q, bool with_ears) const {
  double d = ball(q, 0.0, 8.0, 1628.0, 75.0, 97.0, 92.0);
  d = blend(d, ball(q, 0.0, -30.0, 1568.0, 60.0, 62.0, 70.0), 28.0);
  d = blend(d, rod(q, Vec3(0.0, -86.0, 1612.0), Vec3(0.0, -100.0, 1580.0), 6.0, 12.0), 8.0);
  d = blend(d, ball(q, 0.0, -86.0, 1555.0, 26.0, 12.0, 8.0), 8.0);    // lips
  d = blend(d, ball(q, 0.0, -68.0, 1520.0, 26.0, 22.0, 18.0), 26.0);  // chin
  d = blend(d, neck_.distance(q.x(), q.y(), q.z()), 22.0);
  if (with_ears) d = blend(d, ball(q, 77.0, 20.0, 1592.0, 8.0, 17.0, 31.0), 4.0);
  return d;
}

double BodyShape::arm_distance(const Vec3& q) const {
  const Vec3 p = in_arm(q);
  if (p.z() < -90.0 || p.head<2>().norm() > 190.0) return std::max(60.0, p.head<2>().norm() - 120.0);
  double d = arm_.distance(p.x(), p.y(), p.z());
  if (p.z() > 240.0 && p.z() < 340.0) {
    d = blend(d, ball(p, 0.0, -30.0, elbow + 2.0, 13.0, 11.0, 16.0), 12.0);
    d = blend(d, ball(p, 38.0, -4.0, elbow - 8.0, 10.0, 12.0, 14.0), 12.0);
    d = blend(d, ball(p, -39.0, -4.0, elbow - 8.0, 11.0, 12.0, 14.0), 12.0);
  }
  if (p.z() > 520.0) {
    // Styloid processes, the four fingers, and the thumb.
    d = blend(d, ball(p, -26.0, -10.0, wrist - 8.0, 8.0, 9.0, 10.0), 8.0);
    static constexpr std::array<double, 4> base = {30.0, 10.0, -10.5, -30.0}, tip = {36.0, 11.0, -13.0, -37.0},
                                           length = {82.0, 90.0, 83.0, 66.0}, radius = {9.5, 9.8, 9.3, 8.2};
    for (std::size_t i = 0; i < base.size(); ++i) {
      const double r = radius[i];
      d = blend(
          d,
          rod(p, Vec3(base[i], 0.0, knuckles - 8.0), Vec3(tip[i], 0.0, knuckles + length[i] - r + 1.0), r, r - 1.5),
          3.0);
    }
    const double thumb = std::min(rod(p, Vec3(26.0, 8.0, 575.0), Vec3(58.0, 14.0, 622.0), 16.0, 12.5),
                                  rod(p, Vec3(58.0, 14.0, 622.0), Vec3(76.0, 16.0, 676.0), 11.5, 9.5));
    d = blend(d, thumb, 8.0);
  }
  return d;
}

double BodyShape::foot_distance(const Vec3& q) const {
  if (q.z() > 190.0) return away;
  double d = ball(q, 78.0, 52.0, 40.0, 31.0, 40.0, 42.0);  // heel
  const Vec3 instep(78.0, 10.0, 50.0), ball_of_foot(90.0, -98.0, 20.0);
  const double t =
      std::clamp((q - instep).dot(ball_of_foot - instep) / (ball_of_foot - instep).squaredNorm(), 0.0, 1.0);
  const Vec3 radii = Vec3(34.0, 40.0, 50.0) + t * (Vec3(46.0, 26.0, 20.0) - Vec3(34.0, 40.0, 50.0));
  d = blend(d, shapes::ellipsoid(q - instep - t * (ball_of_foot - instep), radii), 20.0);
  // Toes: x and y of the base, y of the tip, radius. The great toe is on the inner side.
  struct Toe {
    double base_x, base_y, tip_x, tip_y, radius;
  };
  static constexpr std::array<Toe, 5> toes = {{{58.0, -108.0, 60.0, -168.0, 12.5},
                                               {83.0, -112.0, 84.0, -166.0, 8.5},
                                               {101.0, -108.0, 102.0, -156.0, 8.0},
                                               {117.0, -99.0, 119.0, -143.0, 7.6},
                                               {131.0, -86.0, 134.0, -126.0, 7.4}}};
  for (const Toe& toe : toes) {
    const Vec3 a(toe.base_x, toe.base_y, toe.radius + 4.0), b(toe.tip_x, toe.tip_y + toe.radius, toe.radius);
    d = blend(d, rod(q, a, b, toe.radius + 1.0, toe.radius), 4.0);
  }
  d = blend(d, ball(q, 111.0, 34.0, 66.0, 9.0, 13.0, 17.0), 8.0);  // outer ankle
  d = blend(d, ball(q, 49.0, 24.0, 75.0, 9.0, 14.0, 17.0), 8.0);   // inner ankle
  return d;
}

double BodyShape::leg_distance(const Vec3& q) const {
  if (q.z() > 960.0) return away;
  double d = leg_.distance(q.x(), q.y(), q.z());
  if (q.z() > 420.0 && q.z() < 530.0) d = blend(d, ball(q, 87.0, -50.0, 474.0, 21.0, 9.0, 25.0), 12.0);
  if (q.z() < 190.0) d = blend(d, foot_distance(q), 18.0);
  return d;
}

double BodyShape::drawn_distance(const Vec3& q, bool with_ears) const {
  const Vec3 p(std::abs(q.x()), q.y(), q.z());
  // Bounding boxes skip the far parts.
  double d = away;
  if (p.x() < 300.0 && p.z() > 700.0 && p.z() < 1560.0) d = trunk_distance(p);
  if (p.z() < 980.0) d = blend(d, leg_distance(p), 40.0);
  if (p.z() > 1340.0) d = blend(d, head_distance(p, with_ears), 18.0);
  if (p.x() > 60.0 && p.z() > 560.0 && p.z() < 1500.0) d = blend(d, arm_distance(p), 20.0);
  return std::max(d, -p.z());  // the soles are flat
}

Vec3 BodyShape::normal(const Vec3& p) const {
  constexpr double step = 0.5;
  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 shift = step * Vec3::Unit(axis);
    gradient[axis] = drawn_distance((p + shift) / scale_, false) - drawn_distance((p - shift) / scale_, false);
  }
  const double length = gradient.norm();
  return length > 1e-9 ? Vec3(gradient / length) : Vec3(0.0, -1.0, 0.0);
}

Vec3 BodyShape::nearest_skin(const Vec3& p) const {
  Vec3 here = p;
  for (int i = 0; i < 60; ++i) {
    const double d = scale_ * drawn_distance(here / scale_, false);
    if (std::abs(d) < 1e-3) break;
    here -= 0.8 * d * normal(here);
  }
  return here;
}

}  // namespace bodkin::patient
