#include "training/store/cohort_table.h"

#include <algorithm>
#include <span>

namespace bodkin::training {

namespace {

std::vector<Cusum::Point> curve_of(std::span<const AttemptSummary> attempts, const Cusum& cusum) {
  std::vector<char> failed;
  failed.reserve(attempts.size());
  for (const AttemptSummary& each : attempts) failed.push_back(each.verdict >= Grade::fail ? 1 : 0);
  return cusum.curve(failed);
}

CohortRow row_of(std::span<const AttemptSummary> attempts, const Cusum& cusum) {
  CohortRow row{.trainee = attempts.front().trainee, .procedure = attempts.front().procedure};
  row.attempts = static_cast<int>(attempts.size());
  row.last_at = attempts.back().started_at;
  for (const AttemptSummary& each : attempts) {
    row.passed += each.verdict == Grade::pass ? 1 : 0;
    row.borderline += each.verdict == Grade::borderline ? 1 : 0;
    row.failed += each.verdict == Grade::fail ? 1 : 0;
    row.dangerous += each.verdict == Grade::dangerous ? 1 : 0;
    row.last_in_a_row = each.verdict == Grade::pass ? row.last_in_a_row + 1 : 0;
  }
  const std::size_t recent = std::min(attempts.size(), static_cast<std::size_t>(recent_attempts));
  for (const AttemptSummary& each : attempts.last(recent)) row.score += each.score / static_cast<double>(recent);
  for (const Cusum::Point& point : curve_of(attempts, cusum)) {
    if (point.mastery) row.mastery = true;
    if (point.failing) row.mastery = false;
  }
  return row;
}

}  // namespace

std::vector<CohortRow> cohort_table(const std::vector<AttemptSummary>& attempts, const CusumSettings& settings) {
  const Cusum cusum(settings);
  std::vector<CohortRow> rows;
  for (std::size_t first = 0; first < attempts.size();) {
    std::size_t last = first + 1;
    while (last < attempts.size() && attempts[last].trainee == attempts[first].trainee &&
           attempts[last].procedure == attempts[first].procedure)
      ++last;
    rows.push_back(row_of(std::span(attempts).subspan(first, last - first), cusum));
    first = last;
  }
  std::sort(rows.begin(), rows.end(), [](const CohortRow& a, const CohortRow& b) {
    return std::tie(a.trainee, a.procedure) < std::tie(b.trainee, b.procedure);
  });
  return rows;
}

std::vector<Cusum::Point> learning_curve(const std::vector<AttemptSummary>& attempts, const CusumSettings& settings) {
  return curve_of(attempts, Cusum(settings));
}

}  // namespace bodkin::training
