#pragma once

#include <optional>
#include <string>
#include <utility>

#include "link/command.h"
#include "station/station.h"
#include "station/ultrasound_choice.h"

#include "forces/model_settings.h"

namespace bodkin::link {

// Does what the commands of clients ask of a running session. docs/openigtlink.md has the list.
class SessionCommands {
 public:
  struct Answer {
    std::string sentence;
    std::optional<Message> besides;  // for the same client, before the answer
  };

  // `ultrasound`: that the station was given. `models`: numbers of the force model in place of those of the case.
  explicit SessionCommands(const std::optional<station::UltrasoundChoice>& ultrasound,
                           std::optional<forces::ModelSettings> models = {})
      : ultrasound_(ultrasound), models_(std::move(models)) {}

  // The session has begun.
  void begin(station::Station& station);

  // Throws InputError, one sentence, when it cannot be done.
  Answer apply(const Command& command, station::Station& station, const station::StationStatus& status);

  // Somebody asked for Reset: this session is to be saved, and another one to begin.
  bool wants_again() const { return again_; }
  // The numbers of the force model now, which it is to begin with; nothing: those of the case.
  const std::optional<forces::ModelSettings>& models() const { return models_; }

 private:
  std::string apply_to_needle(const Command& command, station::Station& station,
                              const station::StationStatus& status);
  std::string apply_to_ultrasound(const Command& command, station::Station& station,
                                  const station::StationStatus& status);
  // False: a deformable body keeps the numbers that it was prepared with.
  bool feel_models(station::Station& station) const;
  Answer tell_parameters(const Command& command, const station::Station& station);

  std::optional<station::UltrasoundChoice> ultrasound_;
  std::optional<station::ScanOrder> order_;  // that clients have made
  std::optional<forces::ModelSettings> models_;
  bool again_ = false;
};

}  // namespace bodkin::link
