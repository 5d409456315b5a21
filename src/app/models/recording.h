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

// A session in memory, laid out so that any moment of it can be shown at once. Nothing is recomputed: a moment is
// what was recorded in its tick. Unchanged while somebody holds it.
class Recording {
 public:
  // Something that happened, for people.
  struct Happening {
    std::size_t tick = 0;  // index, not the number of the tick
    double time = 0.0;     // s
    double depth = 0.0;    // mm
    std::string words;     // "skin gives", "bone"
    bool is_bad = false;
  };
  // The tip was in one tissue from a tick to another one, both included.
  struct Stay {
    std::size_t first = 0, last = 0;
    anatomy::TissueId tissue = anatomy::tissue::air;
  };
  // A piece of the tip's way through one tissue, LPS mm.
  struct PathPiece {
    anatomy::TissueId tissue = anatomy::tissue::air;
    std::vector<Vec3> points;
  };

  // `patient`: null where he is not at hand; `note` then says why, and may also say that he has changed. `is_same`:
  // he is the one that the session was recorded on, so that the session can be judged by his voxels. Throws
  // InputError for a session without ticks.
  // `scan`: the pictures of its ultrasound; may be null.
  Recording(std::filesystem::path file, session::Session session, std::shared_ptr<const OpenCase> patient,
            bool is_same, std::string note, std::shared_ptr<ScanReplay> scan = nullptr);
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  const std::filesystem::path& file() const noexcept { return file_; }
  const session::Session& session() const noexcept { return session_; }
  const std::shared_ptr<const OpenCase>& patient() const noexcept { return patient_; }
  const std::string& note() const noexcept { return note_; }
  // Null: there was no ultrasound, or the patient is not at hand. Makes its pictures on the thread that asks.
  ScanReplay* scan() const noexcept { return scan_.get(); }
  // By the rules of its procedure; nothing where there is nothing to judge by, as not_judged() says.
  const std::optional<training::Score>& score() const noexcept { return score_; }
  const std::string& not_judged() const noexcept { return not_judged_; }

  std::size_t size() const noexcept { return session_.ticks.size(); }  // at least 1
  // s since the session began.
  double time(std::size_t index) const {
    return static_cast<double>(session_.ticks[index].tick) * session_.header.dt;
  }
  double begin() const { return time(0); }
  double end() const { return time(size() - 1); }
  // The last tick that is not after `time`; the first one before all.
  std::size_t index_at(double time) const;
  // s at which the needle touched the body first; begin() where it never did.
  double first_contact() const noexcept { return first_contact_; }

  // The moment of a tick as the views draw it. The spans in it live as long as the recording.
  Frame frame(std::size_t index) const;
  // Where needles that were left in the body are in that moment: moved by breath alone, for what else moved the
  // tissue is not in the session.
  std::vector<LeftNeedle> left_needles(std::size_t index) const;
  // Every tick, for the curves.
  std::span<const station::HandSample> samples() const noexcept { return samples_; }
  const std::vector<Happening>& happenings() const noexcept { return happenings_; }
  const std::vector<Stay>& stays() const noexcept { return stays_; }
  const std::vector<PathPiece>& path() const noexcept { return path_; }
  // As the session names it.
  std::string tissue_title(anatomy::TissueId tissue) const;
  // The planned path; nothing where none was planned.
  const std::optional<anatomy::NeedlePath>& plan() const noexcept { return plan_; }

 private:
  void find_happenings();
  void find_stays();
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
  std::vector<Happening> happenings_;
  std::vector<Stay> stays_;
  std::vector<float> drawn_in_;  // breath, 0 to 1, by tick; empty: the patient does not breathe
  std::vector<PathPiece> path_;
  std::vector<forces::DiagnosticName> diagnostic_names_;  // of session_
};

}  // namespace bodkin::app
