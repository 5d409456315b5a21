#include "session/left_needles.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::session {

namespace {

constexpr double shortest_left = 1.0, longest_left = 500.0;  // mm
constexpr double furthest_left = 1e4;                        // mm

bool is_possible(const anatomy::NeedlePath& left) {
  const double length = left.length();
  return left.entry.cwiseAbs().maxCoeff() <= furthest_left && length >= shortest_left && length <= longest_left;
}

}  // namespace

std::string left_needles_text(const std::vector<anatomy::NeedlePath>& left) {
  std::string text;
  for (const anatomy::NeedlePath& one : left)
    text += fmt::format("{} {} {} {} {} {}\n", one.entry.x(), one.entry.y(), one.entry.z(), one.target.x(),
                        one.target.y(), one.target.z());
  return text;
}

std::optional<std::vector<anatomy::NeedlePath>> parse_left_needles(const std::string& text) {
  std::vector<anatomy::NeedlePath> left;
  const char* cursor = text.data();
  const char* const last = cursor + text.size();
  while (cursor != last) {
    std::array<double, 6> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto [end, error] = std::from_chars(cursor, last, numbers[i]);
      if (error != std::errc() || end == last || *end != (i + 1 < numbers.size() ? ' ' : '\n')) return std::nullopt;
      cursor = end + 1;
    }
    left.push_back({Vec3(numbers[0], numbers[1], numbers[2]), Vec3(numbers[3], numbers[4], numbers[5])});
    if (left.size() > most_left_needles || !is_possible(left.back())) return std::nullopt;
  }
  return left;
}

void check_left_needles(const std::vector<anatomy::NeedlePath>& left) {
  if (left.size() > most_left_needles) {
    throw InputError(fmt::format("{} needles were left in the body, expected at most {}; take some out", left.size(),
                                 most_left_needles));
  }
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (is_possible(left[i])) continue;
    throw InputError(fmt::format(
        "needle {} that was left in the body is {} mm long from its entry to its tip, expected {} to {} mm "
        "and places within {} mm; give entry and tip in mm as the case has them",
        i + 1, left[i].length(), shortest_left, longest_left, furthest_left));
  }
}

}  // namespace bodkin::session
