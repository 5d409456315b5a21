#include <cstdio>
#include <memory>
#include <vector>

#include "bench/link_soak/measurements.h"
#include "bench/link_soak/parts.h"
#include "session/session_file.h"
#include "tests/cli/serve_process.h"
#include <fmt/format.h>

#include "core/error.h"

namespace link_soak {

using namespace bodkin::link;

namespace {

// Late ticks of a session of `bodkin serve`, in percent, as its recording counts them.
double late_share(const CaseFolder& folder, double seconds, bool with_clients) {
  const std::string session = with_clients ? "with.bodkin" : "without.bodkin";
  bodkin_test::ServeProcess server(folder.path(), serve_arguments(seconds, session + " --overwrite"));
  {
    const std::uint16_t port = server.port();
    std::vector<std::unique_ptr<Client>> clients;
    std::unique_ptr<HostileClient> hostile;
    if (with_clients) {
      for (int i = 0; i < 7; ++i) clients.push_back(std::make_unique<Client>(client_of(port), Client::Events{}));
      hostile = std::make_unique<HostileClient>(port);
    }
    if (server.wait() != 0) throw bodkin::SystemError("bodkin serve did not end well: " + server.notes());
  }
  const bodkin::session::Session recorded = bodkin::session::read_session(folder.path() / session);
  if (!recorded.timings) throw bodkin::SystemError("the recording has no timings");
  return 100.0 * static_cast<double>(recorded.timings->overruns) /
         static_cast<double>(bodkin::session::count_of(recorded.timings->lateness));
}

}  // namespace

int measure_late(int pairs, double seconds) {
  const CaseFolder folder;
  std::vector<double> without, with;
  for (int pair = 0; pair < pairs; ++pair) {
    without.push_back(late_share(folder, seconds, false));
    with.push_back(late_share(folder, seconds, true));
    std::printf("pair %d: %.3f %% late without clients, %.3f %% with 8, one hostile\n", pair + 1, without.back(),
                with.back());
    std::fflush(stdout);
  }
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  };
  const double more = mean(with) - mean(without);
  std::printf("mean %.3f %% without, %.3f %% with: %+.3f percentage points; median %.3f %% and %.3f %%\n",
              mean(without), mean(with), more, percentile(without, 0.5), percentile(with, 0.5));
  return more <= 0.5 ? 0 : 1;
}

}  // namespace link_soak
