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

// Sends the events of a running session to the clients of a server, and executes their commands. An observer of the
// station; forwards all calls to another one, which displays the session on this machine. Messages and their names:
// docs/openigtlink.md.
class SessionFeed : public station::StationObserver {
 public:
  // `ultrasound`: as given to the station. `rate`: poses per second, 1 to 240. `steps`: of the procedure, to report
  // those reached. `models`: numbers of the force model instead of the case's. The server and the screen must outlive
  // this object.
  SessionFeed(Server& server, station::StationObserver& screen,
              const std::optional<station::UltrasoundChoice>& ultrasound, double rate,
              std::vector<WatchedStep> steps = {}, std::optional<forces::ModelSettings> models = {});

  Progress progress() override { return screen_.progress(); }
  void note(const std::string& sentence) override { screen_.note(sentence); }
  std::vector<Vec3> prepare(const anatomy::Case& patient, const fem::BodyDescription* body) override;
  std::chrono::milliseconds interval() const override;
  void update(station::Station& station, const station::StationStatus& status) override;

  // The requests of clients beyond this session.
  const SessionCommands& commands() const { return commands_; }

 private:
  void greet(const anatomy::Case& patient, std::span<const forces::DiagnosticName> diagnostics, double now);
  void send_poses(const station::StationStatus& status, double now);
  void send_forces(const station::StationStatus& status, double now);
  void send_events(const station::StationStatus& status, const anatomy::TissueLibrary& library, double now);
  void send_skin(const station::StationStatus& status, std::span<const float> displacements, double now);
  void send_state(const station::StationStatus& status, const anatomy::TissueLibrary& library, double now);
  void send_picture(const station::LiveImage& picture, double now);
  bool is_query(const Received& received, const anatomy::Case& patient, double now);
  void answer(station::Station& station, const station::StationStatus& status, double now);

  Server& server_;
  station::StationObserver& screen_;
  double rate_;
  StepWatch steps_;
  SessionCommands commands_;
  bool has_begun_ = false;
  std::optional<CtMessage> ct_;  // once requested by a client
  std::vector<std::uint64_t> waiting_for_ct_;
  std::uint64_t greeted_ = 0;  // clients accepted when the patient was last sent to all
  std::uint64_t picture_ = 0;  // number of the last image sent
  std::string state_;          // last one sent
  SkinSheet skin_;
  station::PunctureWatch contact_;
  std::size_t screen_points_ = 0;  // of a deformable body displayed by the screen; followed by those of the skin
  double dimple_ = 0.0;            // mm, last one sent
  std::string tissues_;            // digest of the patient's tissue voxels
  bool deforms_ = false;           // the body is a deformable one
};

}  // namespace bodkin::link
