#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "station/hand_session.h"
#include "station/pressed_patient.h"

#include "anatomy/case.h"
#include "cli/console.h"
#include "cli/second_device.h"

namespace bodkin {

// Adds --body.
void add_body_option(CLI::App& command, std::string& body);

// What --body says of a body that moves: its probe's face. None for a static one. Throws InputError for words that
// say nothing, and where no second device holds a probe or the resistance has no body that could move.
std::optional<ProbeFace> choose_body(const std::string& body, const std::optional<ChosenSecond>& second,
                                     const ResistanceSettings& resistance);

// What a session keeps of it: JSON.
std::string text_of(const ProbeFace& face, std::size_t nodes);

// Looks after a body that a probe presses while a session runs: hands its corridors to the tick and says what happens
// to it. All of it for one thread.
class MovingPatient {
 public:
  // Starts the body, and says so where it is too large to keep up. Throws InputError.
  MovingPatient(const Case& patient, const BodyDescription& body, const ProbeFace& face, Console& console);

  const std::shared_ptr<PressedPatient>& body() const noexcept { return body_; }
  // Some times a second; `said`: the newest sentence, where there is one. `patient`: of the constructor.
  void look(HandSession& session, const Case& patient, std::string& said, Console& console);
  // What there is to say of it at the end of `time` seconds of the session.
  void tell(double time, Console& console) const;

 private:
  void say(const std::string& sentence, std::string& said, Console& console);

  std::shared_ptr<PressedPatient> body_;
  std::uint64_t steps_ = 0;
  std::uint32_t corridors_ = 0;  // that the tick was given
  std::uint32_t most_met_ = 0;   // nodes by the probe
  bool corridor_failed_ = false, failed_ = false;
};

}  // namespace bodkin
