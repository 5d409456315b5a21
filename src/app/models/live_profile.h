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

// Computes the curve of the newest settings on a separate thread, with the same tick as a session. Newer settings
// replace waiting ones. A deformable body is prepared first, and again only after a change of a number that it
// depends on. All calls from one thread; none waits.
class LiveProfile {
 public:
  explicit LiveProfile(std::shared_ptr<const OpenCase> patient);
  ~LiveProfile();
  LiveProfile(const LiveProfile&) = delete;
  LiveProfile& operator=(const LiveProfile&) = delete;

  void set(const ModelSettings& settings);
  // The newest curve; null before the first one.
  std::shared_ptr<const ForceCurve> curve() const;
  // The curve of the newest settings is not ready yet.
  bool is_busy() const;
  // Progress of the body's preparation for the next curve, 0 to 1; empty: none is in progress.
  std::optional<double> preparation() const;

 private:
  void prepare(anatomy::Case& part, const ModelSettings& settings, const std::filesystem::path& folder,
               const std::stop_token& stop);
  void run(const std::stop_token& stop, const std::shared_ptr<const OpenCase>& patient);

  mutable std::mutex lock_;  // guards all members below except the thread
  std::condition_variable_any changed_;
  std::optional<ModelSettings> wanted_;
  bool works_ = false;
  std::optional<double> preparation_;
  std::shared_ptr<const ForceCurve> curve_;
  std::jthread thread_;
};

// The same, synchronously. A deformable body must be prepared (patient::prepare_body).
ForceCurve force_curve(anatomy::Case& patient, const ModelSettings& settings);

}  // namespace bodkin::app
