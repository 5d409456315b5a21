#pragma once

#include <optional>
#include <string>
#include <utility>

#include "link/command.h"
#include "station/station.h"
#include "station/ultrasound_choice.h"

#include "forces/model_settings.h"

namespace bodkin::link {

// Executes the commands of clients in a running session. docs/openigtlink.md has the list.
class SessionCommands {
 public:
  struct Answer {
    std::string sentence;
    std::optional<Message> besides;  // for the same client, before the reply
  };

  // `ultrasound`: as given to the station. `models`: numbers of the force model instead of the case's.
  explicit SessionCommands(const std::optional<station::UltrasoundChoice>& ultrasound,
                           std::optional<forces::ModelSettings> models = {})
      : ultrasound_(ultrasound), models_(std::move(models)) {}

  // The session has begun.
  void begin(station::Station& station);

  // Throws InputError, one sentence, when it is impossible.
  Answer apply(const Command& command, station::Station& station, const station::StationStatus& status);

  // Whether a client requested Reset: this session is to be saved, and another one started.
  bool wants_again() const { return again_; }
  // The present numbers of the force model, for the next session; empty: those of the case.
  const std::optional<forces::ModelSettings>& models() const { return models_; }

 private:
  std::string apply_to_needle(const Command& command, station::Station& station,
                              const station::StationStatus& status);
  std::string apply_to_ultrasound(const Command& command, station::Station& station,
                                  const station::StationStatus& status);
  // False: a deformable body keeps the numbers with which it was prepared.
  bool apply_models(station::Station& station) const;
  Answer report_parameters(const Command& command, const station::Station& station);

  std::optional<station::UltrasoundChoice> ultrasound_;
  std::optional<station::ScanSetup> setup_;  // by clients
  std::optional<forces::ModelSettings> models_;
  bool again_ = false;
};

}  // namespace bodkin::link
