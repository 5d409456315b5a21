#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace bodkin::io {

// Resource limits of a child process.
struct ChildLimits {
  std::uint64_t memory = 0;             // bytes of address space; 0 = no limit
  std::chrono::seconds processor{600};  // processor time
  std::chrono::seconds wall{1800};      // time on the clock
};

enum class ChildEnd { exited, killed, out_of_time, interrupted };

struct ChildResult {
  pid_t pid = 0;
  ChildEnd end = ChildEnd::exited;
  int exit_code = 0;  // if it exited
  int signal = 0;     // if a signal killed it
};

// Runs `program` with `arguments` and waits for it. `input` is written to its standard input, each line of its
// standard output is passed to `on_line` (without the line break), its standard error is discarded. `inherited`
// becomes its file descriptor 3 (-1 = none). The child gets the limits, no core file, and dies with this process, or
// is interrupted as soon as a DeferredTermination has noted a signal. An exception from `on_line` kills the child and
// propagates to the caller. Throws SystemError when the program cannot be started.
ChildResult run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      std::string_view input, int inherited, const ChildLimits& limits,
                      const std::function<void(std::string_view line)>& on_line);

}  // namespace bodkin::io
