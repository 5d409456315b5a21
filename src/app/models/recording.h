#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/models/scan_replay.h"
#include "session/session_file.h"
#include "views/frame.h"
#include "views/open_case.h"

#include "training/score.h"

namespace bodkin::app {

using namespace views;

// A session in memory, with immediate access to every tick. Nothing is recomputed: a frame shows the recorded values
// of its tick. Immutable while shared.
class Recording {
 public:
  // An event for display.
  struct ShownEvent {
    std::size_t tick = 0;  // index, not the number of the tick
    double time = 0.0;     // s
    double depth = 0.0;    // mm
    std::string words;     // "skin gives", "bone"
    bool is_bad = false;
  };
  // An interval of ticks with the tip in one tissue, both ends included.
  struct TissueInterval {
    std::size_t first = 0, last = 0;
    anatomy::TissueId tissue = anatomy::tissue::air;
  };
  // A part of the tip's path through one tissue, LPS mm.
  struct PathPiece {
    anatomy::TissueId tissue = anatomy::tissue::air;
    std::vector<Vec3> points;
  };

  // `patient`: null if unavailable; `note` then says why, and may also say that the patient has changed. `is_same`:
  // this is the patient of the session, so that its voxels can be used for the verdict. Throws InputError for a
  // session without ticks. `scan`: its ultrasound images; may be null.
  Recording(std::filesystem::path file, session::Session session, std::shared_ptr<const OpenCase> patient,
            bool is_same, std::string note, std::shared_ptr<ScanReplay> scan = nullptr);
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  const std::filesystem::path& file() const noexcept { return file_; }
  const session::Session& session() const noexcept { return session_; }
  const std::shared_ptr<const OpenCase>& patient() const noexcept { return patient_; }
  const std::string& note() const noexcept { return note_; }
  // Null: there was no ultrasound, or the patient is unavailable. Computes its images on the calling thread.
  ScanReplay* scan() const noexcept { return scan_.get(); }
  // By the rules of its procedure; empty if it cannot be scored, for the reason in not_judged().
  const std::optional<training::Score>& score() const noexcept { return score_; }
  const std::string& not_judged() const noexcept { return not_judged_; }

  std::size_t size() const noexcept { return session_.ticks.size(); }  // at least 1
  // s since the session began.
  double time(std::size_t index) const {
    return static_cast<double>(session_.ticks[index].tick) * session_.header.dt;
  }
  double begin() const { return time(0); }
  double end() const { return time(size() - 1); }
  // The last tick not after `time`; the first one for earlier times.
  std::size_t index_at(double time) const;
  // s, first contact of the needle with the body; begin() if there was none.
  double first_contact() const noexcept { return first_contact_; }

  // The frame of a tick for the views. Its spans live as long as the recording.
  Frame frame(std::size_t index) const;
  // The positions of left needles at that tick: moved only by breathing, because the session does not contain other
  // displacements of the tissue.
  std::vector<LeftNeedle> left_needles(std::size_t index) const;
  // Every tick, for the curves.
  std::span<const station::HandSample> samples() const noexcept { return samples_; }
  const std::vector<ShownEvent>& shown_events() const noexcept { return shown_events_; }
  const std::vector<TissueInterval>& tissue_intervals() const noexcept { return tissue_intervals_; }
  const std::vector<PathPiece>& path() const noexcept { return path_; }
  // The title in the session.
  std::string tissue_title(anatomy::TissueId tissue) const;
  // The planned path; empty: none.
  const std::optional<anatomy::NeedlePath>& plan() const noexcept { return plan_; }

 private:
  void find_shown_events();
  void find_tissue_intervals();
  void judge(bool is_same);

  std::filesystem::path file_;
  session::Session session_;
  std::shared_ptr<const OpenCase> patient_;
  std::string note_, not_judged_;
  std::shared_ptr<ScanReplay> scan_;
  std::optional<training::Score> score_;
  std::optional<anatomy::NeedlePath> plan_;
  double first_contact_ = 0.0;
  std::vector<station::HandSample> samples_;
  std::vector<float> in_body_;  // s until each tick
  std::vector<ShownEvent> shown_events_;
  std::vector<TissueInterval> tissue_intervals_;
  std::vector<float> drawn_in_;  // inspiration, 0 to 1, by tick; empty: the patient does not breathe
  std::vector<PathPiece> path_;
  std::vector<forces::DiagnosticName> diagnostic_names_;  // of session_
};

}  // namespace bodkin::app
