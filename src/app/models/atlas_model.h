#pragma once

#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <thread>

#include "patient/acupuncture/body_case.h"
#include "scene/surfaces.h"

namespace bodkin::app {

// The body with its points and surfaces, and cases generated from it, prepared on a separate thread. Called from one
// thread.
class AtlasModel {
 public:
  // `folder`: of surfaces and cases.
  explicit AtlasModel(std::filesystem::path folder);
  ~AtlasModel();
  AtlasModel(const AtlasModel&) = delete;
  AtlasModel& operator=(const AtlasModel&) = delete;

  struct Status {
    double fraction = 0.0;
    std::string error;  // one sentence; empty: none
    bool working = false;
    std::filesystem::path made;  // the last generated case
  };
  Status status() const;
  // Null until they are available.
  std::shared_ptr<const patient::Atlas> atlas() const;
  std::shared_ptr<const scene::PatientSurfaces> surfaces() const;

  // Prepares the atlas, once.
  void prepare();
  // Generates a case of 160 mm about a point, or uses an existing one; not while another request runs.
  void make_case(const std::string& code);

 private:
  struct Shared;
  std::filesystem::path folder_;
  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

// The quiz: a point is named, the student shows it on the skin.
class PointQuiz {
 public:
  explicit PointQuiz(std::uint32_t seed) : random_(seed) {}

  // Names the next point, different from the last.
  void ask(const patient::Atlas& atlas);
  // The same point again.
  void ask_again();
  // Ends the quiz; the score stays.
  void stop();
  // Accepts an answer; the true point is shown from then on.
  void answer(const Vec3& place);

  bool asked() const { return point_ != nullptr && !answered_; }
  bool answered() const { return answered_; }
  const patient::AtlasPoint* point() const { return point_; }
  const Vec3& shown() const { return shown_; }
  double miss() const { return miss_; }  // mm, to the nearer of the left and the right one
  int rounds() const { return rounds_; }
  int found() const { return found_; }                                     // within `near`
  double mean_miss() const { return rounds_ > 0 ? sum_ / rounds_ : 0.0; }  // mm
  static constexpr double near = 10.0;                                     // mm; our choice

 private:
  std::mt19937 random_;
  const patient::AtlasPoint* point_ = nullptr;
  bool answered_ = false;
  Vec3 shown_ = Vec3::Zero();
  double miss_ = 0.0, sum_ = 0.0;
  int rounds_ = 0, found_ = 0;
};

}  // namespace bodkin::app
