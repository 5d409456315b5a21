#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "station/scan_thread.h"
#include "station/ultrasound_choice.h"
#include "views/open_case.h"

#include "imaging/moved_tissue.h"

namespace bodkin::app {

using namespace views;

// The ultrasound machine of a patient whom nobody needles: makes a picture, on a thread of its own, whenever probe,
// knobs or needle have changed. Where the patient has a mesh and the probe is to press him, he moves under it, and
// more pictures are made until he has come to rest. All calls from one thread; none waits for a picture.
class ProbeMachine {
 public:
  struct Wish {
    station::ScanOrder order;
    std::optional<imaging::NeedleInSound> needle;
  };

  // `presses`: the mesh of the patient's folder is deformed by the probe; else the tissue gives way layer by layer.
  ProbeMachine(std::shared_ptr<const OpenCase> patient, const station::UltrasoundChoice& choice, Wish first,
               bool presses = false);
  ~ProbeMachine();
  ProbeMachine(const ProbeMachine&) = delete;
  ProbeMachine& operator=(const ProbeMachine&) = delete;

  void set(const Wish& wish);
  // The newest picture; null: none yet.
  std::shared_ptr<const station::LivePicture> picture() const;
  // The CT in the plane of the newest picture, deformed like it; null: none yet, or the probe is not to press.
  std::shared_ptr<const imaging::ImageRgb> ct() const;
  // How that probe has moved the tissue, anywhere; null: it rests.
  std::shared_ptr<const imaging::MovedTissue> moved_tissue() const;
  // Why there is none, or why the newest settings cannot be: a sentence, said once.
  std::string take_trouble();

 private:
  void run(const std::stop_token& stop, const std::shared_ptr<const OpenCase>& patient,
           const station::UltrasoundChoice& choice, bool presses);

  mutable std::mutex lock_;  // guards all below but the thread
  std::condition_variable_any changed_;
  Wish wish_;
  bool is_new_ = true;
  std::shared_ptr<const station::LivePicture> picture_;
  std::shared_ptr<const imaging::ImageRgb> ct_;
  std::shared_ptr<const imaging::MovedTissue> moved_;
  std::string trouble_;
  std::jthread thread_;
};

}  // namespace bodkin::app
