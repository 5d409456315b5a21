#include "report/expert_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "session/operator_file.h"
#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel_for.h"
#include "training/simulated_attempt.h"

namespace bodkin::report {

namespace {

constexpr double bin = 0.5;       // mm of depth
constexpr double longest = 60.0;  // s of an attempt
constexpr int fewest = 5;         // attempts at a depth, minimum for a range

// N, the greatest resistance in each bin of depth while the tip was deeper than before; below 0: never there.
std::vector<double> felt_on_the_way_in(const session::Session& session) {
  std::vector<double> felt;
  double deepest = 0.0;
  for (const simulation::TickRecord& record : session.ticks) {
    const simulation::TickOutput& output = record.output;
    if (!output.in_contact || output.depth < deepest) continue;
    deepest = output.depth;
    const auto here = static_cast<std::size_t>(deepest / bin);
    if (felt.size() <= here) felt.resize(here + 1, -1.0);
    felt[here] = std::max(felt[here], output.resistance);
  }
  return felt;
}

}  // namespace

std::optional<PlotRange> expert_forces(const anatomy::Case& patient, const session::SessionHeader& header,
                                       const std::string& expert) {
  if (anatomy::body_of(header.haptics.resistance) != nullptr || header.path.length() <= 0.0) return std::nullopt;
  const simulation::OperatorScript script = session::load_operator(expert);
  anatomy::Case same = patient;
  same.description.haptics = header.haptics;
  if (header.device) same.description.device = *header.device;
  std::vector<std::vector<double>> attempts(expert_attempts);
  try {
    parallel_for(expert_attempts, [&](int attempt) {
      const auto seed = static_cast<std::uint64_t>(attempt) + 1;
      attempts[static_cast<std::size_t>(attempt)] =
          felt_on_the_way_in(training::simulate_attempt(same, script, header.path, seed, {.longest = longest}));
    });
  } catch (const InputError&) {
    return std::nullopt;  // a session's path from which no script can begin
  }
  PlotRange range;
  range.name = fmt::format("{} attempts of the simulated expert", expert_attempts);
  for (std::size_t here = 0;; ++here) {
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    int there = 0;
    bool any = false;
    for (const std::vector<double>& felt : attempts) {
      any = any || here < felt.size();
      if (here >= felt.size() || felt[here] < 0.0) continue;
      low = std::min(low, felt[here]);
      high = std::max(high, felt[here]);
      ++there;
    }
    if (!any) break;
    if (there < fewest) continue;
    range.x.push_back((static_cast<double>(here) + 0.5) * bin);
    range.low.push_back(low);
    range.high.push_back(high);
  }
  return range.x.size() > 1 ? std::optional(std::move(range)) : std::nullopt;
}

}  // namespace bodkin::report
