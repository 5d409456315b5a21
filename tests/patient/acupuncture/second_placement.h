#pragma once

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "patient/whole_body/body_landmarks.h"

#include "io/resources.h"

namespace bodkin_test {

using bodkin::Mat3;
using bodkin::Vec3;

// The standard points found a second time, from the rules of docs/acupuncture.md and the tables as text: a reader of
// its own, lengths of its own, and another geometry. Nearest places of the skin are looked for by rays in all
// directions, ways over the skin are stepped with a compass in a plane; nothing follows a gradient.
class SecondPlacement {
 public:
  SecondPlacement(const bodkin::patient::BodyShape& shape, const bodkin::patient::BodyLandmarks& marks)
      : shape_(shape), marks_(marks) {
    std::ifstream file(bodkin::io::shared_file("acupuncture/points.csv"));
    std::vector<std::string> names;
    for (std::string line; std::getline(file, line);) {
      if (line.empty() || line[0] == '#') continue;
      std::vector<std::string> cells(1);
      bool quoted = false;
      for (const char c : line) {
        if (c == '"') {
          quoted = !quoted;
        } else if (c == ',' && !quoted) {
          cells.emplace_back();
        } else {
          cells.back().push_back(c);
        }
      }
      if (names.empty()) {
        names = cells;
        continue;
      }
      std::map<std::string, std::string> row;
      for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells.at(i);
      rows_[row["code"]] = row;
    }
  }

  const std::map<std::string, std::map<std::string, std::string>>& rows() const { return rows_; }

  Vec3 at(const std::string& code) {
    if (!done_.contains(code)) {
      Vec3 p = locate(rows_.at(code));
      if (rows_.at(code).at("side") == "midline") p.x() = 0.0;
      done_[code] = p;
    }
    return done_[code];
  }

 private:
  using Row = std::map<std::string, std::string>;
  static bool in(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }
  bool known(const std::string& name) const { return marks_.find(name) != marks_.end(); }
  const std::vector<Vec3>& mark(const std::string& name) const { return marks_.find(name)->second.places; }
  bool is_line(const std::string& name) const { return known(name) && mark(name).size() > 1; }
  double d(const Vec3& p) const { return shape_.scale() * shape_.drawn_distance(p / shape_.scale(), false); }

  // Where a ray from p meets the skin, found by small steps; `most` if it does not.
  double ray(const Vec3& p, const Vec3& way, double most) const {
    const bool inside = d(p) < 0.0;
    double t = 0.0;
    while (t < most) {
      const double here = d(p + t * way);
      if ((here < 0.0) != inside) break;
      t += std::max(0.15, 0.5 * std::abs(here));
    }
    return t;
  }
  Vec3 look(const Vec3& p, const Vec3& way) const { return p + ray(p, way, 900.0) * way; }
  Vec3 nearest(const Vec3& p) const {
    Vec3 best = p;
    double least = 60.0, width = M_PI;
    Vec3 middle(0.0, 0.0, 1.0);
    for (int round = 0; round < 4; ++round, width *= 0.25) {
      const Vec3 first = middle.unitOrthogonal(), second = middle.cross(first);
      const Vec3 pole = middle;
      for (int n = 0; n < 160; ++n) {
        const double tilt = width * std::sqrt((n + 0.5) / 160.0), turn = 2.399963 * n;
        const Vec3 way = std::cos(tilt) * pole + std::sin(tilt) * (std::cos(turn) * first + std::sin(turn) * second);
        const double t = ray(p, way, least);
        if (t < least) {
          least = t;
          best = p + t * way;
          middle = way;
        }
      }
    }
    return best;
  }
  // `length` mm over the skin from p, in the plane of `way` and the outside there, by the circle that meets the skin.
  Vec3 compass(Vec3 p, Vec3 way, double length, bool upright) const {
    for (double left = length; left > 0.0; left -= 1.5) {
      const double step = std::min(left, 1.5);
      Vec3 out = shape_.normal(p);
      if (upright) out.x() = 0.0;
      out.normalize();
      const Vec3 ahead = (way - way.dot(out) * out).normalized();
      double low = -1.2, high = 1.2;  // rad inwards and outwards
      for (int i = 0; i < 26; ++i) {
        const double angle = 0.5 * (low + high);
        (d(p + step * (std::cos(angle) * ahead + std::sin(angle) * out)) < 0.0 ? low : high) = angle;
      }
      p += step * (std::cos(low) * ahead + std::sin(low) * out);
      if (upright) way = ahead;
    }
    return p;
  }

  double dz(const char* a, const char* b) const { return std::abs(mark(a)[0].z() - mark(b)[0].z()); }
  double along_arm(const char* a, const char* b) const {
    return std::abs((mark(a)[0] - mark(b)[0]).dot(shape_.arm_axes().col(2)));
  }
  // Over the median line from a to b, by chords of points found with rays from the middle of the head.
  double over(const char* a, const char* b) const {
    const Vec3 centre(0.0, 5.0 * shape_.scale(), 1600.0 * shape_.scale());
    const auto angle = [&](const Vec3& p) { return std::atan2(p.z() - centre.z(), -(p.y() - centre.y())); };
    double from = angle(mark(a)[0]), to = angle(mark(b)[0]), length = 0.0;
    if (to < from) to += 2.0 * M_PI;
    Vec3 last = mark(a)[0];
    for (int i = 1; i <= 400; ++i) {
      const double t = from + (to - from) * i / 400.0;
      const Vec3 here = look(centre, Vec3(0.0, -std::cos(t), std::sin(t)));
      length += (here - last).norm();
      last = here;
    }
    return length;
  }
  double finger() const {
    return (mark("middle_finger_pip_crease_radial_end")[0] - mark("middle_finger_dip_crease_radial_end")[0]).norm();
  }
  double cun(const Row& row) const {
    const std::string &region = row.at("region"), &side = row.at("surface"), &from = row.at("from"),
                      &to = row.at("toward");
    if (region == "head" && !in(from, "eyebrow") && !in(from, "canthus"))
      return over("anterior_hairline_midpoint", "posterior_hairline_midpoint") / 12.0;
    if (region == "head" || region == "face" || region == "neck")
      return over("glabella", "anterior_hairline_midpoint") / 3.0;
    if (region == "chest" && to == "anterior") return mark("nipple")[0].x() / 4.0;
    if (region == "chest") return dz("suprasternal_notch", "xiphisternal_junction") / 9.0;
    if (region == "abdomen")
      return in(from + to, "xiphi") ? dz("xiphisternal_junction", "umbilicus") / 8.0
                                    : dz("umbilicus", "pubic_symphysis_superior_border") / 5.0;
    if (region == "upper_arm" || region == "elbow" || region == "shoulder")
      return along_arm(in(side, "posterior") ? "posterior_axillary_fold" : "anterior_axillary_fold",
                       "cubital_crease") /
             9.0;
    if (region == "forearm" || region == "wrist" || region == "hand")
      return along_arm("cubital_crease", in(side, "posterior") ? "wrist_crease_dorsal" : "wrist_crease_palmar") /
             12.0;
    if (region == "thigh" || region == "knee") {
      if (in(side, "posterior")) return dz("gluteal_fold_midpoint", "popliteal_crease") / 14.0;
      if (side == "lateral") return dz("greater_trochanter_prominence", "popliteal_crease") / 19.0;
      return dz("pubic_symphysis_superior_border", "patella_superior_border") / 18.0;
    }
    if (region == "leg")
      return in(side, "medial") ? dz("patella_apex", "medial_malleolus_prominence") / 15.0
                                : dz("popliteal_crease", "lateral_malleolus_prominence") / 16.0;
    return dz("medial_malleolus_prominence", "sole") / 3.0;
  }
  double cun_across(const Row& row) const {
    const std::string& region = row.at("region");
    if (region == "chest" || region == "abdomen") return mark("nipple")[0].x() / 4.0;
    if (in(row.at("from"), "occipital")) return 2.0 * mark("mastoid_process")[0].x() / 9.0;
    if (region == "head" || region == "face") return 2.0 * mark("forehead_hairline_corner")[0].x() / 9.0;
    return 2.0 * mark("medial_border_of_scapula")[0].x() / 6.0;
  }

  static bool arm(const Row& row) {
    const std::string& r = row.at("region");
    return r == "upper_arm" || r == "elbow" || r == "forearm" || r == "wrist" || r == "hand";
  }
  // How far up: against the arm's axis, towards the heel on the foot, else up.
  Vec3 up(const Row& row) const {
    if (arm(row)) return -shape_.arm_axes().col(2);
    return row.at("region") == "foot" ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  }
  double level(const Row& row) {
    const std::string& name = row.at("level_of");
    if (!known(name)) return up(row).dot(at(name));
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : mark(name)) mean += p / static_cast<double>(mark(name).size());
    return up(row).dot(mean);
  }
  // The place of a line at a height, by halving finely divided pieces.
  Vec3 on(const std::string& line, const Vec3& upwards, double height) const {
    Vec3 best = mark(line)[0];
    double least = 1e9;
    for (std::size_t i = 0; i + 1 < mark(line).size(); ++i) {
      for (int n = 0; n <= 40; ++n) {
        const Vec3 p = mark(line)[i] + n / 40.0 * (mark(line)[i + 1] - mark(line)[i]);
        const double off = std::abs(upwards.dot(p) - height);
        if (off < least - 1e-9) {
          least = off;
          best = p;
        }
      }
    }
    return nearest(best);
  }
  Vec3 meet(const std::string& one, const std::string& other) const {
    Vec3 best = mark(one)[0];
    double least = 1e9;
    for (std::size_t i = 0; i + 1 < mark(one).size(); ++i)
      for (std::size_t j = 0; j + 1 < mark(other).size(); ++j)
        for (int n = 0; n <= 10; ++n)
          for (int m = 0; m <= 10; ++m) {
            const Vec3 p = mark(one)[i] + n / 10.0 * (mark(one)[i + 1] - mark(one)[i]);
            const Vec3 q = mark(other)[j] + m / 10.0 * (mark(other)[j + 1] - mark(other)[j]);
            if ((p - q).norm() < least) {
              least = (p - q).norm();
              best = p;
            }
          }
    return nearest(best);
  }
  static Vec3 face(const Row& row) {
    const std::string side = row.at("surface").substr(0, row.at("surface").find('+'));
    if (side == "anterior" || side == "palmar") return {0, -1, 0};
    if (side == "posterior") return {0, 1, 0};
    if (side == "medial") return {-1, 0, 0};
    if (side == "dorsal") return {0, 0, 1};
    if (side == "plantar") return {0, 0, -1};
    return {1, 0, 0};
  }
  Vec3 to_skin(const Vec3& p, const Row& row) const { return d(p) < -20.0 ? look(p, face(row)) : nearest(p); }
  // The skin at this height (and width, or depth for the side), seen from outside.
  Vec3 seen(const Vec3& p, const Row& row) const {
    const Vec3 side = face(row);
    if (side.x() > 0.5) return look(Vec3(0.0, p.y(), p.z()), Vec3(1, 0, 0));
    return look(Vec3(p.x(), 0.0, p.z()) + 350.0 * side, -side);
  }

  Vec3 locate(const Row& row) {
    const std::string &from = row.at("from"), &to = row.at("toward"), &along = row.at("along_cun"),
                      &level_of = row.at("level_of"), &across = row.at("across_cun");
    const double n = along.empty() ? 0.0 : std::stod(along);
    const char mode = along.empty() ? 'e' : along.back();
    static const std::map<std::string, int> ways = {{"cranial", 0},  {"caudal", 1}, {"anterior", 2}, {"posterior", 3},
                                                    {"lateral", 4},  {"medial", 5}, {"radial", 6},   {"ulnar", 7},
                                                    {"proximal", 8}, {"distal", 9}};
    const bool is_way = ways.contains(to);
    Vec3 way = Vec3::Zero();
    if (is_way) {
      const Mat3& axes = shape_.arm_axes();
      const Vec3 out = arm(row) ? Vec3(axes.col(0)) : Vec3(1, 0, 0);
      const Vec3 list[] = {{0, 0, 1}, {0, 0, -1},  {0, -1, 0},   {0, 1, 0}, out,
                           -out,      axes.col(0), -axes.col(0), up(row),   -up(row)};
      way = list[ways.at(to)];
    }
    // Where it starts.
    Vec3 p;
    if (from == "anterior_median_line") {
      const double x = across.empty() ? 0.0 : std::stod(across) * mark("nipple")[0].x() / 4.0;
      double z = mark(level_of)[0].z();
      if (is_line(level_of)) z = on(level_of, Vec3(1, 0, 0), x).z();
      return look(Vec3(x, -350.0, z), Vec3(0, 1, 0));
    }
    if (!known(from)) {
      p = at(from);
    } else if (is_line(from)) {
      const bool counted = is_way && n > 0.0 && mode != 'f' && to != "anterior";
      if (counted) return on(from, up(row), level(row) + (to == "distal" ? -1.0 : 1.0) * n * cun(row));
      p = is_line(level_of) ? meet(from, level_of) : on(from, up(row), level(row));
    } else {
      p = mark(from)[0];
      const bool until = along.empty() && !to.empty();
      if (!level_of.empty() && !arm(row) && row.at("region") != "foot" && !is_line(to) && !until) {
        p.z() = level(row);
        p = seen(p, row);
      }
    }
    // Along.
    if (is_way && along.empty()) {
      p.z() = level(row);
      p = seen(p, row);
    } else if (is_way) {
      const double length = n == 0.0 ? 0.3 * finger() : mode == 'f' ? n * finger() : n * cun(row);
      p = compass(p, way, length, false);
    } else if (!to.empty()) {
      Vec3 end;
      if (!known(to))
        end = at(to);
      else if (!is_line(to))
        end = mark(to)[0];
      else
        end = on(to, up(row), level_of.empty() ? up(row).dot(p) : level(row));
      const double rise = up(row).dot(end - p);
      if (mode == '*' && n >= 1.0) {
        p = end;
      } else if (mode == '*') {
        Vec3 q = (1.0 - n) * p + n * end;
        if (!row.at("bow_cun").empty())
          q.y() += 4.0 * n * (1.0 - n) * std::stod(row.at("bow_cun")) *
                   over("glabella", "anterior_hairline_midpoint") / 3.0;
        p = to_skin(q, row);
      } else if (mode == 'e') {
        p = to_skin(p + (level(row) - up(row).dot(p)) / rise * (end - p), row);
      } else if (mode == 'f') {
        p = to_skin(p + n * finger() * (end - p).normalized(), row);
      } else if (row.at("region") == "head") {
        p = compass(p, Vec3(0, 0, 1), n * cun(row), true);
      } else {
        const double whole = (end - p).norm();
        p = to_skin(p + n * cun(row) / (std::abs(rise) < 0.6 * whole ? whole : std::abs(rise)) * (end - p), row);
      }
    }
    if (across.empty()) return p;
    const double x =
        p.x() + (row.at("across_direction") == "medial" ? -1.0 : 1.0) * std::stod(across) * cun_across(row);
    if (row.at("region") == "head" && !in(from, "occipital")) {
      Vec3 out = shape_.normal(p);
      out.x() = 0.0;
      return look(Vec3(x, p.y(), p.z()) + 60.0 * out, -out.normalized());
    }
    return seen(Vec3(x, p.y(), p.z()), row);
  }

  const bodkin::patient::BodyShape& shape_;
  const bodkin::patient::BodyLandmarks& marks_;
  std::map<std::string, Row> rows_;
  std::map<std::string, Vec3> done_;
};

}  // namespace bodkin_test
