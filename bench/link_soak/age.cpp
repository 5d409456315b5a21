#include <algorithm>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <thread>
#include <vector>

#include "bench/link_soak/measurements.h"
#include "bench/link_soak/parts.h"
#include "link/contents.h"
#include "tests/cli/serve_process.h"

namespace link_soak {

using namespace bodkin::link;

int measure_age(double seconds) {
  const CaseFolder folder;
  bodkin_test::ServeProcess server(folder.path(), serve_arguments(seconds + 2.0, "age.bodkin"));
  std::mutex mutex;
  std::vector<double> ages;
  std::uint64_t rows = 0;
  {
    const Client client(client_of(server.port()), {.message = [&](const Message& message) {
                          const double now = time_now();
                          const std::lock_guard lock(mutex);
                          if (message.type == "TRANSFORM") ages.push_back(now - message.time);
                          if (message.type == "NDARRAY" && message.device == "Force")
                            rows += read_array(message.content).size.at(0);
                        }});
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }
  server.kill();
  const double most = 1e3 * percentile(ages, 0.99);
  std::printf(
      "%zu poses and %llu ticks of force in %.0f s; age of a pose: median %.3f ms, 99 %% %.3f ms, most %.3f ms\n",
      ages.size(), static_cast<unsigned long long>(rows), seconds, 1e3 * percentile(ages, 0.5), most,
      1e3 * percentile(ages, 1.0));
  return !ages.empty() && most < 2.0 ? 0 : 1;
}

}  // namespace link_soak
