#include "app/close_on_signal.h"

#include <QApplication>
#include <atomic>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.h"

namespace bodkin::app {

namespace {

std::atomic<int> pipe_end{-1};

void pass_on(int signal) {
  const int error = errno;
  const auto number = static_cast<unsigned char>(signal);
  // A full pipe already has enough bytes.
  [[maybe_unused]] const ssize_t written = write(pipe_end.load(), &number, 1);
  errno = error;
}

}  // namespace

CloseOnSignal::CloseOnSignal() {
  if (pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    throw SystemError(fmt::format("no pipe for the signals: {}", std::strerror(errno)));
  pipe_end.store(pipe_[1]);
  notifier_ = std::make_unique<QSocketNotifier>(pipe_[0], QSocketNotifier::Read);
  QObject::connect(notifier_.get(), &QSocketNotifier::activated, notifier_.get(), [this] { close_windows(); });
  struct sigaction own {};
  own.sa_handler = &pass_on;
  own.sa_flags = SA_RESTART;
  sigemptyset(&own.sa_mask);
  for (std::size_t i = 0; i < ending_signals.size(); ++i) sigaction(ending_signals[i], &own, &before_[i]);
}

CloseOnSignal::~CloseOnSignal() {
  for (std::size_t i = 0; i < ending_signals.size(); ++i) sigaction(ending_signals[i], &before_[i], nullptr);
  notifier_.reset();
  pipe_end.store(-1);
  for (const int end : pipe_) close(end);
}

void CloseOnSignal::close_windows() {
  unsigned char number = 0;
  if (read(pipe_[0], &number, 1) != 1) return;
  QApplication::closeAllWindows();
  QCoreApplication::exit(number == SIGINT ? 0 : 128 + number);
}

}  // namespace bodkin::app
