#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "link/ct_message.h"
#include "link/server.h"
#include "link/session_commands.h"
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
  // which of them was reached. `models`: numbers of the force model in place of those of the case. The server and the
  // screen must outlive this.
  SessionFeed(Server& server, station::StationObserver& screen,
              const std::optional<station::UltrasoundChoice>& ultrasound, double rate,
              std::vector<WatchedStep> steps = {}, std::optional<forces::ModelSettings> models = {});

  Progress progress() override { return screen_.progress(); }
  void note(const std::string& sentence) override { screen_.note(sentence); }
  std::vector<Vec3> prepare(const anatomy::Case& patient, const fem::BodyDescription* body) override;
  std::chrono::milliseconds interval() const override;
  void update(station::Station& station, const station::StationStatus& status) override;

  // What clients have asked for beyond this session.
  const SessionCommands& commands() const { return commands_; }

 private:
  void greet(const anatomy::Case& patient, std::span<const forces::DiagnosticName> diagnostics, double now);
  void send_poses(const station::StationStatus& status, double now);
  void send_forces(const station::StationStatus& status, double now);
  void send_events(const station::StationStatus& status, const anatomy::TissueLibrary& library, double now);
  void send_skin(const station::StationStatus& status, std::span<const float> displacements, double now);
  void send_state(const station::StationStatus& status, const anatomy::TissueLibrary& library, double now);
  void send_picture(const station::LivePicture& picture, double now);
  bool is_query(const Received& received, const anatomy::Case& patient, double now);
  void answer(station::Station& station, const station::StationStatus& status, double now);

  Server& server_;
  station::StationObserver& screen_;
  double rate_;
  StepWatch steps_;
  SessionCommands commands_;
  bool has_begun_ = false;
  std::optional<CtMessage> ct_;  // once a client has asked for it
  std::vector<std::uint64_t> waiting_for_ct_;
  std::uint64_t greeted_ = 0;  // clients accepted when all were told of the patient
  std::uint64_t picture_ = 0;  // number of the last one that was sent
  std::string state_;          // that was sent last
  SkinSheet skin_;
  station::PunctureWatch contact_;
  std::size_t screen_points_ = 0;  // of a deformable body that the screen follows; those of the skin come after them
  double dimple_ = 0.0;            // mm, that was sent last
  std::string tissues_;            // fingerprint of the patient's tissue voxels
  bool deforms_ = false;           // the body is a deformable one
};

}  // namespace bodkin::link
