#include "cli/end_on_signal.h"

namespace bodkin::cli {

namespace {

std::atomic<station::Station*> running_station{nullptr};
std::atomic<int> ended_by{0};

void end_running(int signal) {
  ended_by.store(signal);
  if (station::Station* const station = running_station.load()) station->end();
}

}  // namespace

EndOnSignal::EndOnSignal() {
  listen();
}

EndOnSignal::EndOnSignal(station::Station& station) {
  running_station.store(&station);
  listen();
}

void EndOnSignal::listen() {
  for (std::size_t i = 0; i < signals.size(); ++i) before_[i] = std::signal(signals[i], &end_running);
}

EndOnSignal::~EndOnSignal() {
  for (std::size_t i = 0; i < signals.size(); ++i) std::signal(signals[i], before_[i]);
  running_station.store(nullptr);
}

int EndOnSignal::reason() noexcept {
  return ended_by.load() == SIGINT ? 0 : ended_by.load();
}

int EndOnSignal::signal() noexcept {
  return ended_by.load();
}

}  // namespace bodkin::cli
