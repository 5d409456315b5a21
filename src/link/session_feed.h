#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "link/command.h"
#include "link/server.h"
#include "link/skin_sheet.h"
#include "link/step_watch.h"
#include "station/puncture_watch.h"
#include "station/station_observer.h"
#include "station/ultrasound_choice.h"

namespace bodkin::link {

// Tells the clients of a server what happens in a running session, and does what they ask of it. An observer of the
// station; hands on to another one, who shows the session on this machine. What is sent, and how it is named:
// docs/openigtlink.md.
class SessionFeed : public station::StationObserver {
 public:
  // `ultrasound`: that the station was given. `rate`: poses per second, 1 to 240. `steps`: of the procedure, to say
  // which of them was reached. The server and the screen must outlive this.
  SessionFeed(Server& server, station::StationObserver& screen,
              const std::optional<station::UltrasoundChoice>& ultrasound, double rate,
              std::vector<WatchedStep> steps = {});

  Progress progress() override { return screen_.progress(); }
  void note(const std::string& sentence) override { screen_.note(sentence); }
  std::vector<Vec3> prepare(const anatomy::Case& patient, const fem::BodyDescription* body) override;
  std::chrono::milliseconds interval() const override;
  void update(station::Station& station, const station::StationStatus& status) override;

 private:
  void greet(const anatomy::Case& patient, std::span<const forces::DiagnosticName> diagnostics, double now);
  void send_poses(const station::StationStatus& status, double now);
  void send_forces(const station::StationStatus& status, double now);
  void send_events(const station::StationStatus& status, const anatomy::TissueLibrary& library, double now);
  void send_skin(const station::StationStatus& status, std::span<const float> displacements, double now);
  void send_state(const station::StationStatus& status, const anatomy::TissueLibrary& library, double now);
  void send_picture(const station::LivePicture& picture, double now);
  void answer(station::Station& station, const station::StationStatus& status, double now);
  // The answer to a command; throws InputError when it cannot be done.
  std::string apply(const Command& command, station::Station& station, const station::StationStatus& status);

  Server& server_;
  station::StationObserver& screen_;
  std::optional<station::UltrasoundChoice> ultrasound_;
  double rate_;
  StepWatch steps_;
  std::optional<station::ScanOrder> order_;  // that clients have made
  std::uint64_t greeted_ = 0;                // clients accepted when all were told of the patient
  std::uint64_t picture_ = 0;                // number of the last one that was sent
  std::string state_;                        // that was sent last
  SkinSheet skin_;
  station::PunctureWatch contact_;
  std::size_t screen_points_ = 0;  // of a deformable body that the screen follows; those of the skin come after them
  double dimple_ = 0.0;            // mm, that was sent last
  std::string tissues_;            // fingerprint of the patient's tissue voxels
};

}  // namespace bodkin::link
