#include "patient/planning/needle_choice.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

anatomy::Needle needle(int gauge, double length, anatomy::NeedleTip tip) {
  anatomy::Needle made;
  made.gauge = gauge;
  made.outer_diameter = anatomy::gauge_size(gauge)->outer_diameter;
  made.inner_diameter = tip == anatomy::NeedleTip::filiform ? 0.0 : anatomy::gauge_size(gauge)->inner_diameter;
  made.length = length;
  made.tip = tip;
  return made;
}

template <typename Number>
std::optional<Number> number_of(const std::string& text) {
  Number value{};
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

anatomy::Needle parse_needle(const std::string& text) {
  std::string tips;
  for (const std::string_view tip : anatomy::enumeration_names(anatomy::NeedleTip{}))
    tips += (tips.empty() ? "" : ", ") + std::string(tip);
  anatomy::Needle usual;
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    parts.push_back(text.substr(from, comma - from));
    from = comma + 1;
  }
  const auto refuse = [&](const std::string& expected) {
    throw InputError(fmt::format("--needle is '{}'; expected {}", text, expected));
  };
  if (parts.size() > 3) refuse("GAUGE,LENGTH,TIP, such as 18,90,tuohy or 18G,90,tuohy");
  if (parts[0].ends_with('G') || parts[0].ends_with('g')) parts[0].pop_back();
  const auto gauge = number_of<int>(parts[0]);
  if (!gauge || !anatomy::gauge_size(*gauge)) {
    refuse(fmt::format("a gauge from {} to {} first, such as 18,90,tuohy", anatomy::gauge_sizes().front().gauge,
                       anatomy::gauge_sizes().back().gauge));
  }
  if (parts.size() > 1) {
    const auto length = number_of<double>(parts[1]);
    if (!length || !(*length >= 1.0 && *length <= 1000.0)) refuse("a length of 1 to 1000 mm after the gauge");
    usual.length = *length;
  }
  if (parts.size() > 2) {
    const auto tip = anatomy::needle_tip_from(parts[2]);
    if (!tip) refuse(fmt::format("one of {} as the tip", tips));
    usual.tip = *tip;
  }
  return needle(*gauge, usual.length, usual.tip);
}

anatomy::NeedlePath ended_in_epidural_space(const anatomy::NeedlePath& path, const anatomy::TissueVolume& tissues) {
  constexpr double step = 0.1;  // mm
  double begin = -1.0, end = -1.0;
  for (double depth = 0.0; depth <= path.length(); depth += step) {
    const bool epidural = anatomy::nearest(tissues, Vec3(path.entry + depth * path.direction()),
                                           anatomy::tissue::air) == anatomy::tissue::epidural_fat;
    if (epidural && begin < 0.0) begin = depth;
    if (epidural) end = depth;
    if (!epidural && begin >= 0.0) break;
  }
  if (begin < 0.0) return path;
  return {path.entry, path.entry + 0.5 * (begin + end) * path.direction()};
}

}  // namespace bodkin::patient
