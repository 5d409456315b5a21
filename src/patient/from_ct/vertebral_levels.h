#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bodkin::patient {

// A place along the spine, in vertebrae: 1 is the upper edge of L1, 2 the upper edge of L2, 1.5 the middle of L1; T12
// is 0 to 1. The interspace L3_L4 counts as 4, where L3 ends and L4 begins.
using SpinePlace = double;

// Level of the conus, the lower end of the cord: the lower third of L1 in adults (mean of 504 MRI, Saifuddin et al.
// 1998, reference/conus_level.csv; range middle of T12 to upper third of L3). In the newborn it is the middle of L3
// and rises linearly to the adult level at two years, our reading of "within the first year or two". `age` in years,
// >= 0.
SpinePlace conus_at_age(double age);
inline constexpr SpinePlace adult_conus = 1.83;

// Parses the place of a vertebra ("L2": its middle) or of an interspace ("L1_L2"); T10 to L6 and S1. Empty for other
// words.
std::optional<SpinePlace> place_named(std::string_view name);
// Parses an interspace, "T12_L1" to "L5_S1" or "L6_S1". Empty for other words.
std::optional<SpinePlace> interspace_named(std::string_view name);
// "lower third of L1", "interspace L1_L2".
std::string describe_place(SpinePlace place);

// Whether a lumbar puncture, an epidural or a spinal anaesthesia may be planned at an interspace that the user has
// not named: L2/L3 and below ("accepted by some, above it the cord may be met", reference/conus_level.csv), and at
// least one whole vertebra below the conus.
bool may_plan_at(SpinePlace interspace, SpinePlace conus);

// Evidence of a spine's levels. Indices count interspaces from the head, 0 first.
struct LevelEvidence {
  struct Interspace {
    double z;  // LPS mm of its middle
    std::uint8_t above,
        below;  // spine_role of the labelled vertebrae next to it, 0 = none
  };
  std::vector<Interspace> interspaces;  // from head to foot
  std::optional<double> sacrum;         // LPS z of the top of the sacrum, by its wings
  std::optional<double> lowest_rib;     // LPS z at which the lowest ribs leave the spine
  std::optional<double> iliac_crest;    // LPS z of the highest point of the iliac crests
  std::string lowest_vertebra;  // stated by the user: the vertebra above the lowest interspace, "L5"; or empty
};

// Reliability of the names: none; by one end of the lumbar spine; by both ends or by labels; by the user's statement.
enum class LevelConfidence { unknown, moderate, high, stated };
const char* to_string(LevelConfidence confidence);

struct VertebralLevels {
  std::vector<std::string> names;                 // of the interspaces of the evidence; empty = above T10
  std::vector<std::optional<SpinePlace>> places;  // of the same interspaces; empty = unknown
  LevelConfidence confidence = LevelConfidence::unknown;
  std::string evidence;  // a sentence for people: the basis of the names, or why there are none
  bool known() const { return confidence != LevelConfidence::unknown; }
};

// Throws InputError when the user's statement is not the name of a vertebra.
void require_vertebra(const std::string& lowest_vertebra);

// Names the interspaces: by the user's statement, else by labels, else counted up from the sacrum and down from the
// lowest ribs; a single end must be confirmed by the iliac crests, or be a sacrum with L5/S1 visible above it. If the
// two ends, or the labels among each other, disagree (a transitional vertebra, a wrong label), or there is no
// evidence, names are "interspace_1", ... from below. Throws InputError when the user's statement is not the name of
// a vertebra.
VertebralLevels name_levels(const LevelEvidence& evidence);

}  // namespace bodkin::patient
