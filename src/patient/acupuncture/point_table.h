#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bodkin::patient {

// A distance as stated in the standard.
struct Cun {
  enum class Kind : std::uint8_t { none, body, finger, fraction };
  Kind kind = Kind::none;
  double amount = 0.0;  // cun, finger cun, or a fraction of the distance
};

// The location of a point (share/bodkin/acupuncture/points.csv).
struct PointRow {
  std::string code;    // "ST36"
  std::string pinyin;  // "Zusanli"
  std::string hanzi;
  std::string meridian;  // "Stomach", "Governor Vessel"
  bool bilateral = true;
  std::string region;   // "leg"
  std::string surface;  // "anterior+lateral": the first word is the side from which it is seen
  std::string from, toward;
  Cun along;
  std::optional<double> across;  // cun
  std::string across_direction, level_of;
  double bow = 0.0;  // cun
};

// The needling of a point, as published.
struct NeedlingRow {
  double shallowest = 0.0, deepest = 0.0;  // mm
  double angle = 90.0;                     // deg to the skin
  std::string direction, caution, source;
};

// A length of the body and its cun.
struct CunMeasure {
  std::string from, to;
  double cun = 1.0;
};

struct PointTable {
  std::vector<PointRow> points;  // in the order of the meridians
  std::map<std::string, NeedlingRow, std::less<>> needling;
  std::map<std::string, CunMeasure, std::less<>> measures;

  const PointRow* find(std::string_view code) const;
};

// The tables that come with Bodkin. Throws InputError naming file, line and field for an unreadable table.
PointTable read_point_table();

// "ST" of "ST36".
std::string_view meridian_code(std::string_view point);

}  // namespace bodkin::patient
