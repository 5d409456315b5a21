#pragma once

#include <optional>
#include <string>

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

  // `ultrasound`: that the station was given.
  explicit SessionCommands(const std::optional<station::UltrasoundChoice>& ultrasound) : ultrasound_(ultrasound) {}

  // Throws InputError, one sentence, when it cannot be done.
  Answer apply(const Command& command, station::Station& station, const station::StationStatus& status);

  // Somebody asked for Reset: this session is to be saved, and another one to begin.
  bool wants_again() const { return again_; }
  // The numbers of the force model that it is to begin with; nothing: those of this one.
  const std::optional<forces::ModelSettings>& models() const { return models_; }

 private:
  std::string apply_to_needle(const Command& command, station::Station& station,
                              const station::StationStatus& status);
  std::string apply_to_ultrasound(const Command& command, station::Station& station,
                                  const station::StationStatus& status);
  Answer tell_parameters(const Command& command, const station::Station& station);

  std::optional<station::UltrasoundChoice> ultrasound_;
  std::optional<station::ScanOrder> order_;  // that clients have made
  std::optional<forces::ModelSettings> models_;
  bool again_ = false;
};

}  // namespace bodkin::link
