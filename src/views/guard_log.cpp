#include "views/guard_log.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace bodkin::views {

void GuardLog::clear() {
  lines_.clear();
  state_ = haptics::GuardState::disarmed;
  limits_ = 0;
}

void GuardLog::add(double time, std::string words, bool bad) {
  if (!lines_.empty() && lines_.front().words == words) {
    lines_.front().time = time;
    ++lines_.front().times;
    return;
  }
  lines_.push_front({time, std::move(words), bad, 1});
  if (lines_.size() > most_lines) lines_.pop_back();
}

void GuardLog::note(double time, haptics::GuardState state, haptics::GuardReason fault, std::uint32_t limits) {
  if (state != state_) {
    const bool faulted = state == haptics::GuardState::faulted;
    add(time, faulted ? fmt::format("no force: {}", haptics::text_of(fault)) : std::string(haptics::text_of(state)),
        faulted);
  }
  // A limit is named when it begins, not in every frame of its duration.
  const std::uint32_t begun = limits & ~limits_;
  for (std::uint32_t bit = 0; bit < static_cast<std::uint32_t>(haptics::GuardReason::count_of_reasons); ++bit) {
    if ((begun >> bit & 1U) == 0) continue;
    add(time, fmt::format("limited: {}", haptics::text_of(static_cast<haptics::GuardReason>(bit))), false);
  }
  state_ = state;
  limits_ = limits;
}

void GuardLog::note(double time, const std::string& sentence) {
  constexpr std::string_view after = " s: ";
  const char* const end = sentence.data() + sentence.size();
  double own = 0.0;
  const auto [rest, problem] = std::from_chars(sentence.data(), end, own);
  const std::string_view words(rest, static_cast<std::size_t>(end - rest));
  if (problem == std::errc() && words.starts_with(after))
    add(own, std::string(words.substr(after.size())), false);
  else
    add(time, sentence, false);
}

std::vector<double> histogram_columns(const haptics::LatencyHistogram& histogram, double from, double to,
                                      std::size_t count) {
  std::vector<double> shares(count, 0.0);
  if (histogram.count() == 0 || count == 0) return shares;
  const double span = std::log(to / from), all = static_cast<double>(histogram.count());
  for (std::size_t bin = 0; bin < haptics::LatencyHistogram::bins; ++bin) {
    const std::uint64_t inside = histogram.count_in(bin);
    if (inside == 0) continue;
    const double edge = haptics::LatencyHistogram::upper_edge(bin);
    const double place = std::isfinite(edge) && edge > 0.0 ? std::log(edge / from) / span : edge > 0.0 ? 1.0 : 0.0;
    const double column = std::floor(place * static_cast<double>(count));
    const auto index = static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(count - 1)));
    shares[index] += static_cast<double>(inside) / all;
  }
  return shares;
}

}  // namespace bodkin::views
