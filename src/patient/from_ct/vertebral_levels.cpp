#include "patient/from_ct/vertebral_levels.h"

#include <algorithm>
#include <cmath>

#include "patient/from_ct/spine_view.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

constexpr double newborn_conus = 3.5, adult_age = 2.0;
constexpr int usual_lumbar = 5;
constexpr double rib_reach = 8.0;    // mm below which the interspace under the vertebra of a rib lies
constexpr double crest_reach = 1.2;  // at most, vertebrae between the line of the iliac crests and L4/L5
constexpr SpinePlace crest_place = 5.0;

// The vertebra with the number n (L1 = 1, T12 = 0), as people write it. `last` is the last lumbar one.
std::string vertebra_name(int n, int last = usual_lumbar) {
  if (n > last) return "S1";
  return n >= 1 ? fmt::format("L{}", n) : fmt::format("T{}", 12 + n);
}

std::string interspace_name(int upper, int last = usual_lumbar) {
  return vertebra_name(upper, last) + "_" + vertebra_name(upper + 1, last);
}

// The number of a vertebra named "L3" or "T12"; nothing for other words.
std::optional<int> number_of_vertebra(std::string_view name) {
  for (int n = -2; n <= 6; ++n) {
    if (name == vertebra_name(n, 6)) return n;
  }
  return std::nullopt;
}

// The number of a role; nothing for the sacrum and parts without a level.
std::optional<int> number_of_role(std::uint8_t role) {
  if (role >= 1 && role <= 12) return role - 12;
  if (role >= spine_role::l1 && role < spine_role::sacrum) return role - spine_role::l1 + 1;
  return std::nullopt;
}

VertebralLevels unnamed(const LevelEvidence& evidence, std::string why) {
  VertebralLevels levels;
  const std::size_t count = evidence.interspaces.size();
  for (std::size_t n = 0; n < count; ++n) {
    levels.names.push_back(fmt::format("interspace_{}", count - n));
    levels.places.emplace_back();
  }
  levels.evidence = std::move(why);
  return levels;
}

// Names from the number of the vertebra above interspace `index`; `last` is the last lumbar vertebra.
VertebralLevels counted(const LevelEvidence& evidence, std::size_t index, int upper, int last,
                        LevelConfidence confidence, std::string why) {
  VertebralLevels levels;
  levels.confidence = confidence;
  levels.evidence = std::move(why);
  for (std::size_t n = 0; n < evidence.interspaces.size(); ++n) {
    const int here = upper + static_cast<int>(n) - static_cast<int>(index);
    const bool spine = here >= -2 && here <= last;
    levels.names.push_back(spine ? interspace_name(here, last) : "");
    levels.places.push_back(spine ? std::optional<SpinePlace>(here + 1) : std::nullopt);
  }
  return levels;
}

// By labels: every interspace whose two neighbours are labelled as consecutive vertebrae.
VertebralLevels by_labels(const LevelEvidence& evidence) {
  const auto wrong = [&](const LevelEvidence::Interspace& gap) {
    return unnamed(evidence,
                   fmt::format("the labels of the vertebrae do not follow each other: {} lies on {} at z = {:.0f}",
                               level_name(gap.above), level_name(gap.below), gap.z));
  };
  std::optional<std::size_t> index;
  int upper = 0, last = usual_lumbar;
  std::string transitional;
  for (std::size_t n = 0; n < evidence.interspaces.size(); ++n) {
    const auto& gap = evidence.interspaces[n];
    const auto above = number_of_role(gap.above), below = number_of_role(gap.below);
    if (!above || (!below && gap.below != spine_role::sacrum)) continue;
    if (index && *above - upper != static_cast<int>(n - *index)) return wrong(gap);
    if (below ? *below != *above + 1 : *above < 4 || *above > 6) return wrong(gap);
    if (!below) last = *above;
    index = n, upper = *above;
  }
  if (!index) return unnamed(evidence, "");
  if (last != usual_lumbar)
    transitional = fmt::format("; the sacrum follows L{}, so there is a transitional vertebra", last);
  return counted(evidence, *index, upper, last, LevelConfidence::high,
                 fmt::format("Levels are named by the labels of the vertebrae{}.", transitional));
}

// The position of L5/S1, from the top of the sacrum.
struct AboveSacrum {
  std::size_t index;  // of L5/S1; one past the interspace above it if it is not visible
  bool seen;
};

std::optional<AboveSacrum> above_sacrum(const LevelEvidence& evidence) {
  constexpr double most = 9.0;                             // mm between the top and the middle of L5/S1
  constexpr double least_above = 14.0, most_above = 40.0;  // mm from the top up to the middle of L4/L5
  if (!evidence.sacrum) return std::nullopt;
  for (std::size_t n = evidence.interspaces.size(); n-- > 0;) {
    const double above = evidence.interspaces[n].z - *evidence.sacrum;
    if (above < -most) continue;  // a gap within the sacrum
    if (above <= most) return AboveSacrum{n, true};
    if (above >= least_above && above <= most_above) return AboveSacrum{n + 1, false};
    return std::nullopt;
  }
  return std::nullopt;
}

// The interspace under the vertebra that carries the lowest ribs.
std::optional<std::size_t> below_ribs(const LevelEvidence& evidence) {
  if (!evidence.lowest_rib) return std::nullopt;
  for (std::size_t n = 0; n < evidence.interspaces.size(); ++n) {
    if (evidence.interspaces[n].z >= *evidence.lowest_rib - rib_reach) continue;
    // An interspace farther below is not the next one: those between were not found.
    return *evidence.lowest_rib - evidence.interspaces[n].z < 45.0 ? std::optional(n) : std::nullopt;
  }
  return std::nullopt;
}

// The level of the height z if interspace `index` has the place `place`; nothing beyond the interspaces.
std::optional<SpinePlace> place_at(const LevelEvidence& evidence, std::size_t index, SpinePlace place, double z) {
  const auto& gaps = evidence.interspaces;
  for (std::size_t n = 0; n + 1 < gaps.size(); ++n) {
    if (z > gaps[n].z || z < gaps[n + 1].z) continue;
    const double part = (gaps[n].z - z) / (gaps[n].z - gaps[n + 1].z);
    return place + static_cast<double>(n) - static_cast<double>(index) + part;
  }
  return std::nullopt;
}

}  // namespace

void require_vertebra(const std::string& lowest_vertebra) {
  if (number_of_vertebra(lowest_vertebra)) return;
  throw InputError(
      fmt::format("--lowest-vertebra is '{}'; expected the vertebra above the lowest interspace of the CT, "
                  "T10 to T12 or L1 to L6",
                  lowest_vertebra));
}

SpinePlace conus_at_age(double age) {
  const double grown = std::clamp(age / adult_age, 0.0, 1.0);
  return newborn_conus + grown * (adult_conus - newborn_conus);
}

std::optional<SpinePlace> interspace_named(std::string_view name) {
  for (int last = usual_lumbar; last <= 6; ++last) {
    for (int upper = 0; upper <= last; ++upper) {
      if (name == interspace_name(upper, last)) return upper + 1;
    }
  }
  return std::nullopt;
}

std::optional<SpinePlace> place_named(std::string_view name) {
  if (const auto interspace = interspace_named(name)) return interspace;
  if (name == "S1") return usual_lumbar + 1.5;
  if (const auto number = number_of_vertebra(name)) return *number + 0.5;
  return std::nullopt;
}

std::string describe_place(SpinePlace place) {
  const int vertebra = static_cast<int>(std::floor(place));
  const double part = place - vertebra;
  if (part < 0.02) return "interspace " + interspace_name(vertebra - 1);
  const char* third = part < 0.36 ? "upper third" : part < 0.64 ? "middle" : "lower third";
  return fmt::format("{} of {}", third, vertebra_name(vertebra));
}

bool may_plan_at(SpinePlace interspace, SpinePlace conus) {
  return interspace >= 3.0 && interspace - conus >= 1.0 - 1e-9;
}

const char* to_string(LevelConfidence confidence) {
  switch (confidence) {
    case LevelConfidence::unknown:
      return "unknown";
    case LevelConfidence::moderate:
      return "moderate";
    case LevelConfidence::high:
      return "high";
    case LevelConfidence::stated:
      return "stated";
  }
  return "unknown";
}

VertebralLevels name_levels(const LevelEvidence& evidence) {
  const auto& gaps = evidence.interspaces;
  if (!evidence.lowest_vertebra.empty()) {
    require_vertebra(evidence.lowest_vertebra);
    const auto number = number_of_vertebra(evidence.lowest_vertebra);
    if (gaps.empty()) return unnamed(evidence, "");
    return counted(
        evidence, gaps.size() - 1, *number, std::max(usual_lumbar, *number), LevelConfidence::stated,
        fmt::format("Levels are named by your word that {} lies above the lowest interspace, at z = {:.0f}.",
                    evidence.lowest_vertebra, gaps.back().z));
  }
  if (VertebralLevels labelled = by_labels(evidence); labelled.known() || !labelled.evidence.empty()) return labelled;

  const auto sacrum = above_sacrum(evidence);
  const auto ribs = below_ribs(evidence);
  // Whether the line of the iliac crests lies near L4/L5 when interspace `index` has this place.
  const auto crest_offset = [&](std::size_t index, SpinePlace place) -> std::optional<double> {
    if (!evidence.iliac_crest) return std::nullopt;
    const auto crest = place_at(evidence, index, place, *evidence.iliac_crest);
    return crest ? std::optional(std::abs(*crest - crest_place)) : std::nullopt;
  };
  if (sacrum && ribs) {
    const int lumbar = static_cast<int>(sacrum->index) - static_cast<int>(*ribs);
    if (lumbar != usual_lumbar) {
      return unnamed(
          evidence,
          fmt::format(
              "between the lowest ribs (z = {:.0f}) and the sacrum (z = {:.0f}) there are {} vertebrae instead "
              "of {}, a transitional vertebra or one that was not recognised",
              *evidence.lowest_rib, *evidence.sacrum, lumbar, usual_lumbar));
    }
    return counted(
        evidence, sacrum->index, usual_lumbar, usual_lumbar, LevelConfidence::high,
        fmt::format("Levels are counted up from the sacrum at z = {:.0f} and down from the lowest ribs, of "
                    "T12, at z = {:.0f}; both agree.",
                    *evidence.sacrum, *evidence.lowest_rib));
  }
  if (!sacrum && !ribs) return unnamed(evidence, "the CT shows neither the sacrum nor the lowest ribs");
  const std::size_t index = sacrum ? sacrum->index : *ribs;
  const int upper = sacrum ? usual_lumbar : 0;
  const std::string counting = sacrum ? fmt::format("up from the sacrum at z = {:.0f}", *evidence.sacrum)
                                      : fmt::format("down from the lowest ribs at z = {:.0f}", *evidence.lowest_rib);
  const auto offset = crest_offset(index, upper + 1);
  if (offset && *offset > crest_reach) {
    return unnamed(evidence, fmt::format("counted {} the iliac crests, at z = {:.0f}, would not lie near L4/L5",
                                         counting, *evidence.iliac_crest));
  }
  // Without the crests a twelfth rib too short to be visible would make every name one level too low, as would an
  // invisible L5/S1.
  if (!offset && !(sacrum && sacrum->seen)) {
    return unnamed(evidence, fmt::format("nothing confirms a count {}", counting));
  }
  return counted(
      evidence, index, upper, usual_lumbar, LevelConfidence::moderate,
      fmt::format("Levels are counted {}, assuming five lumbar vertebrae{}.", counting,
                  offset ? fmt::format("; the iliac crests, at z = {:.0f}, fit", *evidence.iliac_crest) : ""));
}

}  // namespace bodkin::patient
