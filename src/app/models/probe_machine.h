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

#include "imaging/tissue_displacement.h"

namespace bodkin::app {

using namespace views;

// The ultrasound machine of a patient without a needle insertion: computes an image on a separate thread after each
// change of probe, knobs or needle. If the patient has a mesh and the probe is set to press, the body deforms under
// it, and images follow until it is at rest. All calls from one thread; none waits for an image.
class ProbeMachine {
 public:
  struct Request {
    station::ScanSetup setup;
    std::optional<imaging::NeedleInUltrasound> needle;
  };

  // `presses`: the probe deforms the mesh of the patient's folder; else the tissue is compressed layer by layer.
  ProbeMachine(std::shared_ptr<const OpenCase> patient, const station::UltrasoundChoice& choice, Request first,
               bool presses = false);
  ~ProbeMachine();
  ProbeMachine(const ProbeMachine&) = delete;
  ProbeMachine& operator=(const ProbeMachine&) = delete;

  void set(const Request& request);
  // The newest image; null: none yet.
  std::shared_ptr<const station::LiveImage> picture() const;
  // The CT in the plane of the newest image, deformed like it; null: none yet, or the probe does not press.
  std::shared_ptr<const imaging::ImageRgb> ct() const;
  // The displacement of the tissue by that probe, everywhere; null: at rest.
  std::shared_ptr<const imaging::TissueDisplacement> moved_tissue() const;
  // Why there is no image, or why the newest settings are invalid: a sentence, reported once.
  std::string take_trouble();

 private:
  void run(const std::stop_token& stop, const std::shared_ptr<const OpenCase>& patient,
           const station::UltrasoundChoice& choice, bool presses);

  mutable std::mutex lock_;  // guards all members below except the thread
  std::condition_variable_any changed_;
  Request request_;
  bool is_new_ = true;
  std::shared_ptr<const station::LiveImage> picture_;
  std::shared_ptr<const imaging::ImageRgb> ct_;
  std::shared_ptr<const imaging::TissueDisplacement> moved_;
  std::string trouble_;
  std::jthread thread_;
};

}  // namespace bodkin::app
