#include "io/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "io/deferred_termination.h"

namespace bodkin::io {
namespace {

constexpr int inherited_descriptor = 3;
constexpr int could_not_start = 127;
constexpr std::size_t longest_line = 16U << 20U;  // bytes; more than this without a newline means a broken worker

class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor() { reset(); }
  Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    reset(std::exchange(other.value_, -1));
    return *this;
  }
  int get() const { return value_; }
  void reset(int value = -1) {
    if (value_ >= 0) close(value_);
    value_ = value;
  }

 private:
  int value_;
};

struct Pipe {
  Descriptor read_end, write_end;
};

// A descriptor above the standard ones and the inherited one, so that dup2 in the child never tramples on it.
Descriptor high_copy(const Descriptor& descriptor) {
  const int high = fcntl(descriptor.get(), F_DUPFD_CLOEXEC, 10);
  if (high < 0) throw SystemError(fmt::format("no file descriptor: {}", std::strerror(errno)));
  return Descriptor(high);
}

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw SystemError(fmt::format("no pipe: {}", std::strerror(errno)));
  const Descriptor read_end(ends[0]), write_end(ends[1]);
  return {high_copy(read_end), high_copy(write_end)};
}

// Kills and reaps the child in every exit of the parent.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  int wait() {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

 private:
  pid_t pid_;
};

void limit(int resource, rlim_t value) {
  const rlimit bound{value, value};
  setrlimit(static_cast<__rlimit_resource>(resource), &bound);
}

// Between fork and exec: only calls that are safe in a copy of a process with threads.
[[noreturn]] void become(const char* program, char* const* arguments, int input, int output, int null, int inherited,
                         const ChildLimits& limits, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(could_not_start);  // it died before the death signal was set
  if (limits.memory > 0) limit(RLIMIT_AS, limits.memory);
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.processor.count()));
  limit(RLIMIT_CORE, 0);
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  if (inherited == inherited_descriptor) {
    fcntl(inherited, F_SETFD, 0);
  } else if (inherited >= 0) {
    dup2(inherited, inherited_descriptor);
  }
  execv(program, arguments);
  _exit(could_not_start);
}

// The child's standard input: memory, so that neither process waits and no pipe can break.
Descriptor input_of(std::string_view text) {
  Descriptor memory(memfd_create("bodkin-request", MFD_CLOEXEC));
  const bool written = ::write(memory.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (!written || lseek(memory.get(), 0, SEEK_SET) != 0) {
    throw SystemError(fmt::format("no memory for a request: {}", std::strerror(errno)));
  }
  return high_copy(memory);
}

// Reads lines until the child closes its output (`exited`), time runs out or this process is told to end.
ChildEnd read_lines(const Descriptor& descriptor, std::chrono::steady_clock::time_point deadline,
                    const std::function<void(std::string_view)>& on_line) {
  std::string pending;
  std::array<char, 65536> buffer{};
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0) return ChildEnd::out_of_time;
    if (DeferredTermination::pending() != 0) return ChildEnd::interrupted;
    pollfd ready{descriptor.get(), POLLIN, 0};
    const int polled = poll(&ready, 1, static_cast<int>(std::min<std::int64_t>(left.count(), 200)));
    if (polled == 0 || (polled < 0 && errno == EINTR)) continue;
    const ssize_t count = read(descriptor.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return ChildEnd::exited;
    pending.append(buffer.data(), static_cast<std::size_t>(count));
    std::size_t start = 0;
    for (std::size_t end; (end = pending.find('\n', start)) != std::string::npos; start = end + 1) {
      on_line(std::string_view(pending).substr(start, end - start));
    }
    pending.erase(0, start);
    if (pending.size() > longest_line)
      throw SystemError("the child process wrote a line of more than 16 MiB; it is broken or of another version");
  }
}

}  // namespace

ChildResult run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      std::string_view input, int inherited, const ChildLimits& limits,
                      const std::function<void(std::string_view line)>& on_line) {
  std::string program_text = program.string();
  std::vector<std::string> texts = arguments;
  std::vector<char*> argv = {program_text.data()};
  for (std::string& text : texts) argv.push_back(text.data());
  argv.push_back(nullptr);

  const Descriptor request = input_of(input);
  Pipe from_child = make_pipe();
  const Descriptor null = high_copy(Descriptor(open("/dev/null", O_WRONLY | O_CLOEXEC)));
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) throw SystemError(fmt::format("{} cannot be started: {}", program_text, std::strerror(errno)));
  if (pid == 0) {
    become(program_text.c_str(), argv.data(), request.get(), from_child.write_end.get(), null.get(), inherited,
           limits, parent);
  }
  Child child(pid);
  from_child.write_end.reset();

  ChildResult result;
  result.pid = pid;
  result.end = read_lines(from_child.read_end, std::chrono::steady_clock::now() + limits.wall, on_line);
  if (result.end != ChildEnd::exited) return result;  // ~Child ends it
  const int status = child.wait();
  if (WIFSIGNALED(status)) {
    result.end = WTERMSIG(status) == SIGXCPU ? ChildEnd::out_of_time : ChildEnd::killed;
    result.signal = WTERMSIG(status);
  } else {
    result.exit_code = WEXITSTATUS(status);
    if (result.exit_code == could_not_start) throw SystemError(fmt::format("{} cannot be started", program_text));
  }
  return result;
}

}  // namespace bodkin::io
