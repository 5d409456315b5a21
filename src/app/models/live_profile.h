#pragma once

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/models/parameter_model.h"
#include "views/force_curve.h"

namespace bodkin::app {

// Computes the curve of the newest settings on a thread of its own, through the same tick that a hand feels. Settings
// that came meanwhile replace those that wait. A deformable body is prepared first, and again only when a number has
// changed that it is made of. All calls from one thread; none waits.
class LiveProfile {
 public:
  explicit LiveProfile(std::shared_ptr<const OpenCase> patient);
  ~LiveProfile();
  LiveProfile(const LiveProfile&) = delete;
  LiveProfile& operator=(const LiveProfile&) = delete;

  void set(const ModelSettings& settings);
  // The newest curve; null before the first one.
  std::shared_ptr<const ForceCurve> curve() const;
  // The curve of the newest settings is not there yet.
  bool is_busy() const;
  // How far the body is, 0 to 1, whose curve is the next one; nothing: none is being prepared.
  std::optional<double> preparation() const;

 private:
  void prepare(anatomy::Case& part, const ModelSettings& settings, const std::filesystem::path& folder,
               const std::stop_token& stop);
  void run(const std::stop_token& stop, const std::shared_ptr<const OpenCase>& patient);

  mutable std::mutex lock_;  // guards all below but the thread
  std::condition_variable_any changed_;
  std::optional<ModelSettings> wanted_;
  bool works_ = false;
  std::optional<double> preparation_;
  std::shared_ptr<const ForceCurve> curve_;
  std::jthread thread_;
};

// The same at once. A deformable body must be prepared (patient::prepare_body).
ForceCurve force_curve(anatomy::Case& patient, const ModelSettings& settings);

}  // namespace bodkin::app
