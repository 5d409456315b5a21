#pragma once

#include "core/progress.h"

namespace bodkin::io {

// While one lives, a signal that would end this process (SIGINT, SIGTERM, SIGHUP) is only noted, so that a child can
// be stopped and what it was making be removed. The last one to go ends the process by the signal that was noted.
// Signals that the program handles itself or ignores are left alone. Any thread may hold one; run_child() looks at
// it.
class DeferredTermination {
 public:
  DeferredTermination();
  ~DeferredTermination();
  DeferredTermination(const DeferredTermination&) = delete;
  DeferredTermination& operator=(const DeferredTermination&) = delete;

  // The signal that was noted, or 0.
  static int pending() noexcept;
};

// `progress`, which ends the work by SystemError as soon as a DeferredTermination has noted a signal.
Progress until_told_to_end(const Progress& progress);

}  // namespace bodkin::io
