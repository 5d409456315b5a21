#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"
#include "io/child_process.h"

namespace bodkin::io {

// A separate program for work that must not happen in this process. It receives one JSON object on standard input and
// writes one JSON object per line: {"progress", "fraction"}, {"note"}, {"error", "kind"}, {"result"}.
struct WorkerProgram {
  std::string name;      // "bodkin-images"
  std::string variable;  // environment variable that may state its path
  std::string option;    // CMake option that builds it
};

// The complete output of a worker.
struct WorkerOutput {
  std::vector<std::string> notes;  // repairs and assumptions, one sentence each
  std::string result;              // JSON; empty: none
  std::string error, kind;         // its own message; kind is "input", "memory" or "system"
  ChildResult child;

  bool succeeded() const { return child.end == ChildEnd::exited && child.exit_code == 0 && !result.empty(); }
};

// The worker's file: the one stated in the environment, else next to this program or where Bodkin was installed.
// Throws SystemError when it is in none of these places.
std::filesystem::path find_worker(const WorkerProgram& program);

// Runs `program VERB` with `arguments` (a JSON object) on its standard input and `inherited` as descriptor 3 (-1 =
// none), and waits for it. Progress is passed on. Throws SystemError when it is missing or cannot be started.
WorkerOutput run_worker(const WorkerProgram& program, const std::string& verb, const std::string& arguments,
                        int inherited, const ChildLimits& limits, const Progress& progress);

}  // namespace bodkin::io
