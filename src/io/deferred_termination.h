#pragma once

#include "core/progress.h"

namespace bodkin::io {

// During the lifetime of an object, a signal that would end this process (SIGINT, SIGTERM, SIGHUP) is only noted, so
// that a child can be stopped and its incomplete output removed. The last object to be destroyed ends the process by
// the noted signal. Signals that the program handles itself or ignores are not affected. Usable on any thread;
// run_child() checks it.
class DeferredTermination {
 public:
  DeferredTermination();
  ~DeferredTermination();
  DeferredTermination(const DeferredTermination&) = delete;
  DeferredTermination& operator=(const DeferredTermination&) = delete;

  // The noted signal, or 0.
  static int pending() noexcept;
};

// Wraps `progress` to end the work by SystemError as soon as a DeferredTermination has noted a signal.
Progress until_interrupted(const Progress& progress);

}  // namespace bodkin::io
