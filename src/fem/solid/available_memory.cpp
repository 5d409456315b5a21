#include "fem/solid/available_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace bodkin::fem {

namespace {

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

std::size_t left_on_machine() {
  std::ifstream lines("/proc/meminfo");
  std::string name, unit;
  for (std::size_t kibibytes = 0; lines >> name >> kibibytes && std::getline(lines, unit);)
    if (name == "MemAvailable:") return 1024 * kibibytes;
  return unlimited;
}

std::size_t left_in_container() {
  std::size_t most = 0, taken = 0;
  std::ifstream limit("/sys/fs/cgroup/memory.max"), present("/sys/fs/cgroup/memory.current");
  if (!(limit >> most && present >> taken)) return unlimited;  // "max" is no number
  return most > taken ? most - taken : 0;
}

}  // namespace

std::size_t available_memory() {
  return std::min(left_on_machine(), left_in_container());
}

}  // namespace bodkin::fem
