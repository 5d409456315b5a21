#pragma once

#include <csignal>
#include <cstdlib>
#include <string>

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bodkin::scene {

// An X11 display of our own without a screen (Xvfb), whose OpenGL Mesa computes on the processor; DISPLAY names it as
// long as it is there.
class SoftwareDisplay {
 public:
  SoftwareDisplay() {
    const char* const before = std::getenv("DISPLAY");
    had_display_ = before != nullptr;
    if (had_display_) display_before_ = before;
    int ends[2];
    if (pipe(ends) != 0) return;
    server_ = fork();
    if (server_ == 0) {
      const std::string number = std::to_string(ends[1]);
      if (freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "640x480x24", "-nolisten", "tcp",
             "-noreset", static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    char letter = 0;
    std::string number;
    while (read(ends[0], &letter, 1) == 1 && letter != '\n') number += letter;
    close(ends[0]);
    is_there_ = !number.empty();
    if (is_there_) setenv("DISPLAY", (":" + number).c_str(), 1);
  }
  ~SoftwareDisplay() {
    if (server_ > 0) {
      kill(server_, SIGTERM);
      waitpid(server_, nullptr, 0);
    }
    if (had_display_) {
      setenv("DISPLAY", display_before_.c_str(), 1);
    } else {
      unsetenv("DISPLAY");
    }
  }
  SoftwareDisplay(const SoftwareDisplay&) = delete;
  SoftwareDisplay& operator=(const SoftwareDisplay&) = delete;

  bool is_there() const { return is_there_; }

 private:
  pid_t server_ = -1;
  bool is_there_ = false, had_display_ = false;
  std::string display_before_;
};

}  // namespace bodkin::scene
