#pragma once

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bodkin_test {

// `bodkin serve` as a separate process, killed by the destructor unless it has ended. It also ends with its parent
// process.
class ServeProcess {
 public:
  // `arguments`: shell words after `bodkin`. The program runs in `folder`, where its notes go into the file `notes`,
  // and its answer into `notes` with the suffix .out.
  ServeProcess(std::filesystem::path folder, const std::string& arguments, const std::string& notes = "station.txt")
      : folder_(std::move(folder)), notes_(folder_ / notes) {
    std::filesystem::remove(notes_);  // those of a process before
    const std::string command = "cd '" + folder_.string() + "' && exec '" BODKIN_BUILD "/bin/bodkin' " + arguments +
                                " < /dev/null > " + notes + ".out 2> " + notes;
    process_ = ::fork();
    if (process_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
      ::_exit(127);
    }
  }
  ~ServeProcess() { kill(); }
  ServeProcess(const ServeProcess&) = delete;
  ServeProcess& operator=(const ServeProcess&) = delete;

  // "127.0.0.1:40123"; empty if none is printed within half a minute.
  std::string place() const {
    const std::string before = "port ";
    for (int i = 0; i < 6000; ++i) {
      const std::string text = notes();
      const std::size_t at = text.find(before), end = text.find('\n', at);
      if (at != std::string::npos && end != std::string::npos)
        return "127.0.0.1:" + text.substr(at + before.size(), end - at - before.size());
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return {};
  }
  // 0 if none is printed.
  std::uint16_t port() const {
    const std::string text = place();
    return text.empty() ? std::uint16_t{0} : static_cast<std::uint16_t>(std::stoi(text.substr(text.find(':') + 1)));
  }
  std::string notes() const { return text_of(notes_); }
  std::string output() const { return text_of(notes_.string() + ".out"); }

  // Waits until it ends by itself; the exit code, or -1 if a signal ended it.
  int wait() {
    if (process_ <= 0) return -1;
    int status = -1;
    ::waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  // Asks it to end, and waits.
  int end() {
    if (process_ > 0) ::kill(process_, SIGTERM);
    return wait();
  }
  // At once, without a message.
  void kill() {
    if (process_ > 0) ::kill(process_, SIGKILL);
    wait();
  }

 private:
  static std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  std::filesystem::path folder_, notes_;
  pid_t process_ = 0;
};

}  // namespace bodkin_test
