#include "app/models/probe_machine.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <utility>

#include "station/pressed_scan.h"

#include "core/error.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::app {

namespace {

constexpr std::chrono::milliseconds settling{1500};  // of a body after the probe has moved
constexpr std::chrono::milliseconds pace{25};        // between its pictures meanwhile

bool same_request(const ProbeMachine::Request& a, const ProbeMachine::Request& b) {
  if (a.needle.has_value() != b.needle.has_value()) return false;
  if (a.needle && a.needle->pose.matrix() != b.needle->pose.matrix()) return false;
  return a.setup.probe.matrix() == b.setup.probe.matrix() && a.setup.settings == b.setup.settings;
}

}  // namespace

ProbeMachine::ProbeMachine(std::shared_ptr<const OpenCase> patient, const station::UltrasoundChoice& choice,
                           Request first, bool presses)
    : request_(std::move(first)),
      thread_([this, patient = std::move(patient), choice, presses](const std::stop_token& stop) {
        try {
          run(stop, patient, choice, presses);
        } catch (const std::exception& failure) {
          const std::lock_guard guard(lock_);
          trouble_ = failure.what();
        }
      }) {}

ProbeMachine::~ProbeMachine() {
  thread_.request_stop();
  changed_.notify_all();
  thread_.join();  // before what it uses goes
}

void ProbeMachine::run(const std::stop_token& stop, const std::shared_ptr<const OpenCase>& patient,
                       const station::UltrasoundChoice& choice, bool presses) {
  using Clock = std::chrono::steady_clock;
  station::PressedScan machine(patient->patient, presses ? patient->folder : std::filesystem::path(), choice,
                               [this](const std::string& sentence) {
                                 const std::lock_guard guard(lock_);
                                 trouble_ = sentence;
                               });
  Clock::time_point last = Clock::now(), changed = last;
  for (std::uint64_t number = 1; !stop.stop_requested(); ++number) {
    Request request;
    {
      std::unique_lock guard(lock_);
      const bool settles = machine.deforms() && Clock::now() - changed < settling;
      if (settles) changed_.wait_for(guard, stop, pace, [this] { return is_new_; });
      if (!settles && !changed_.wait(guard, stop, [this] { return is_new_; })) return;
      if (is_new_) changed = Clock::now();
      is_new_ = false;
      request = request_;
    }
    const Clock::time_point now = Clock::now();
    machine.advance(request.setup.probe, std::chrono::duration<double>(now - last).count());
    last = now;
    auto made = std::make_shared<station::LiveImage>();
    try {
      machine.set(request.setup.settings);
    } catch (const InputError& refused) {
      made->refused = true;
      const std::lock_guard guard(lock_);
      trouble_ = refused.what();
    }
    const Clock::time_point begin = Clock::now();
    made->frame = machine.image(request.setup.probe, request.needle);
    made->milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    made->number = number;
    made->setup = {request.setup.probe, machine.settings()};
    made->most = machine.most_moved();
    std::shared_ptr<const imaging::ImageRgb> ct;
    if (presses) ct = std::make_shared<const imaging::ImageRgb>(machine.slice(request.setup.probe));
    std::shared_ptr<const imaging::TissueDisplacement> moved = machine.moved_tissue();
    if (request.needle) made->needle = request.needle->pose;
    const std::lock_guard guard(lock_);
    picture_ = std::move(made);
    ct_ = std::move(ct);
    moved_ = std::move(moved);
  }
}

void ProbeMachine::set(const Request& request) {
  const std::lock_guard guard(lock_);
  if (same_request(request, request_)) return;
  request_ = request;
  is_new_ = true;
  changed_.notify_one();
}

std::shared_ptr<const station::LiveImage> ProbeMachine::picture() const {
  const std::lock_guard guard(lock_);
  return picture_;
}

std::shared_ptr<const imaging::ImageRgb> ProbeMachine::ct() const {
  const std::lock_guard guard(lock_);
  return ct_;
}

std::shared_ptr<const imaging::TissueDisplacement> ProbeMachine::moved_tissue() const {
  const std::lock_guard guard(lock_);
  return moved_;
}

std::string ProbeMachine::take_trouble() {
  const std::lock_guard guard(lock_);
  return std::exchange(trouble_, {});
}

}  // namespace bodkin::app
