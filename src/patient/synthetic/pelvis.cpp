#include "patient/synthetic/pelvis.h"

#include <array>

namespace bodkin::patient {

using shapes::blend;
using shapes::Rod;

// The sacrum tapers to about half its size over 80 mm; sizes beyond the endplate are our choice within what atlases
// show.
Sacrum::Sacrum(const SpineSizes& sizes, double scale) : sizes_(sizes), scale_(scale) {
  const double s = scale;
  const auto rod = [&](const Vec3& a, const Vec3& b, const Vec3& radii_a, const Vec3& radii_b) {
    rods_.push_back({a * s, b * s, radii_a * s, radii_b * s});
  };
  const double joint = 5.4 * sizes.facet_scale;
  const double canal_middle = (canal_front(0.0) + 0.5 * canal_depth(0.0)) / s;
  // Wing: from the side of the body to the joint with the ilium.
  rod({17.0, 2.0, -13.0}, {46.0, 10.0, -20.0}, {11.0, 12.0, 11.0}, {10.0, 15.0, 15.0});
  rod({46.0, 10.0, -20.0}, {34.0, 16.0, -62.0}, {10.0, 15.0, 15.0}, {8.0, 10.0, 14.0});
  rod({17.0, 4.0, -30.0}, {24.0, 8.0, -66.0}, {12.0, 9.0, 12.0}, {12.0, 8.0, 12.0});
  rod({22.0, canal_middle, -15.0}, {27.0, canal_middle + 3.0, -56.0}, {8.5, 8.0, 9.0}, {8.0, 7.0, 12.0});
  // Upper articular process.
  const Vec3 normal(shapes::cosine(sizes.sacral_facet_angle), -shapes::sine(sizes.sacral_facet_angle), 0.0);
  const Vec3 facet(sizes.sacral_facet_half_distance / s, canal_middle + 4.0, 2.0);
  rod({24.0, canal_middle + 2.0, -14.0}, facet + 0.8 * joint * normal + Vec3(0.0, 0.0, 5.0), {7.0, 6.0, 8.0},
      {joint, joint, 1.1 * joint});
  // Roof of the canal on either side of the crest, S1 and below. It leaves the window of L5/S1 open.
  rod({21.0, canal_middle + 5.0, -19.0}, {0.0, canal_middle + 9.5, -23.0}, {4.5, 3.4, 9.0}, {3.4, 3.4, 8.0});
  rod({15.0, canal_middle + 5.0, -38.0}, {0.0, canal_middle + 5.5, -40.0}, {4.0, 3.2, 14.0}, {3.2, 3.2, 14.0});
  rod({15.0, canal_middle + 2.0, -60.0}, {0.0, canal_middle + 1.0, -62.0}, {4.0, 3.2, 14.0}, {3.2, 3.2, 14.0});
}

double Sacrum::canal_front(double z) const {
  return 0.5 * sizes_.sacrum_depth - 0.5 * scale_ + 0.13 * std::min(z, 0.0);
}
double Sacrum::canal_depth(double z) const {
  return std::max(sizes_.sacral_canal_depth + 0.09 * std::min(z, 0.0), 5.0 * scale_);
}
double Sacrum::canal_half_width(double z) const {
  return std::max(0.5 * sizes_.sacral_canal_width + 0.09 * std::min(z, 0.0), 5.0 * scale_);
}
double Sacrum::crest_back(double z) const {
  return canal_front(z) + canal_depth(z) + 12.0 * scale_ + 0.06 * std::min(z, 0.0);
}

double Sacrum::process_outline(const Vec3& p) const {
  const double top = p.z() + 17.0 * scale_;
  const double back = p.y() - crest_back(p.z());
  const double front = canal_front(p.z()) + canal_depth(p.z()) - p.y();
  return shapes::rounded_intersection(top, std::max(back, front), 4.0);
}

double Sacrum::body_section(const Vec3& p) const {
  const double taper = 1.0 + 0.0075 * std::clamp(p.z() / scale_, -90.0, 0.0);
  const double hollow = 0.0012 * p.z() * (p.z() + 90.0 * scale_) / scale_;  // the front of the sacrum is concave
  return shapes::superellipse(p.x(), p.y() + hollow, 0.5 * sizes_.sacrum_width * taper,
                              0.5 * sizes_.sacrum_depth * taper);
}

double Sacrum::distance(const Vec3& p) const {
  const double u = 2.0 * p.x() / sizes_.sacrum_width, v = 2.0 * p.y() / sizes_.sacrum_depth;
  const double endplate = p.z() + 1.0 * std::max(0.0, 1.0 - u * u - v * v);
  double result = shapes::rounded_intersection(body_section(p), endplate, 2.0);
  const Vec3 mirrored(std::abs(p.x()), p.y(), p.z());
  double rods = 1e3;
  for (const Rod& rod : rods_) rods = blend(rods, shapes::distance(rod, mirrored), 4.0);
  const double crest = shapes::rounded_intersection(process_outline(p), mirrored.x() - 3.4 * scale_, 2.0);
  result = blend(result, rods, 4.0);
  return blend(result, crest, 3.0);
}

double Ilium::distance(const Vec3& p) const {
  const Vec3 q(std::abs(p.x()) / scale_, p.y() / scale_, p.z() / scale_);
  // The plate's course seen from above, at the height of the endplate of S1: posterior superior spine, sacroiliac
  // joint, crest, anterior superior spine; with the height of its upper border and half its thickness there.
  struct Station {
    double x, y, crest, half;
  };
  static constexpr std::array<Station, 6> kStations = {{{44.0, 48.0, -22.0, 7.0},
                                                        {58.0, 36.0, 8.0, 7.0},
                                                        {82.0, 16.0, 31.0, 4.5},
                                                        {107.0, -10.0, 40.0, 3.5},
                                                        {121.0, -40.0, 34.0, 4.5},
                                                        {121.0, -72.0, 2.0, 6.5}}};
  double best = 1e6;
  for (std::size_t i = 0; i + 1 < kStations.size(); ++i) {
    const Station &a = kStations[i], &b = kStations[i + 1];
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double flare = 0.22 * q.z();  // the wing flares outwards above
    const double t = std::clamp(((q.x() - flare - a.x) * dx + (q.y() - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    const double ex = q.x() - flare - a.x - t * dx, ey = q.y() - a.y - t * dy;
    const double half = a.half + t * (b.half - a.half);
    const double smooth = t * t * (3.0 - 2.0 * t);
    const double crest = a.crest + smooth * (b.crest - a.crest);
    // The border is thicker than the wing below it.
    const double lip = 2.5 * std::max(0.0, 1.0 - std::abs(q.z() - crest + 6.0) / 14.0);
    const double side = std::sqrt(ex * ex + ey * ey) - half - lip;
    best = std::min(best, shapes::rounded_intersection(side, q.z() - crest, 4.0));
  }
  return best * scale_;
}

}  // namespace bodkin::patient
