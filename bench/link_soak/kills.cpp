#include <algorithm>
#include <cstdio>
#include <vector>

#include "bench/link_soak/measurements.h"
#include "bench/link_soak/parts.h"
#include "tests/cli/killed_pair.h"
#include <sys/mman.h>
#include <sys/wait.h>

#include "core/error.h"

namespace link_soak {

using bodkin_test::KillCounts;

int measure_kills(int count, int pairs) {
  const CaseFolder folder;
  pairs = std::clamp(pairs, 1, std::max(count, 1));
  const std::size_t size = static_cast<std::size_t>(pairs) * sizeof(KillCounts);
  void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw bodkin::SystemError("there is no memory for the counts");
  auto* const found = static_cast<KillCounts*>(memory);
  // Each pair has a separate process, which forks itself as the client: it has one thread.
  std::vector<pid_t> processes;
  for (int pair = 0; pair < pairs; ++pair) {
    const pid_t process = ::fork();
    if (process == 0) {
      int exit_code = 0;
      try {
        const std::filesystem::path own = folder.path() / std::to_string(pair);
        std::filesystem::create_directories(own);
        bodkin_test::KilledPair killed(own, folder.path() / "slabs", static_cast<std::uint64_t>(20 + pair));
        for (int i = pair; i < count && killed.counts().faults() == 0;) {
          const int before = killed.counts().servers + killed.counts().clients;
          killed.kill_one();
          i += pairs * (killed.counts().servers + killed.counts().clients - before);
          found[pair] = killed.counts();
        }
      } catch (const std::exception& error) {
        std::fprintf(stderr, "pair %d: %s\n", pair, error.what());
        exit_code = 1;
      }
      ::_exit(exit_code);
    }
    processes.push_back(process);
  }
  int failed = 0;
  for (const pid_t process : processes) {
    int status = -1;
    ::waitpid(process, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) ++failed;
  }
  KillCounts all;
  for (int pair = 0; pair < pairs; ++pair) all.add(found[pair]);
  ::munmap(memory, size);
  std::printf("%s", all.text().c_str());
  return failed == 0 && all.faults() == 0 && all.servers + all.clients >= count ? 0 : 1;
}

}  // namespace link_soak
